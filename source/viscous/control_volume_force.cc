#include <caudal/fluid/control_volume.h>
#include <caudal/viscous/control_volume_force.h>

#include <limits>

namespace caudal
{
  template <int dim>
  ControlVolumeForce<dim>::ControlVolumeForce(const BoundingBox<dim> &box)
      : box(box)
  {}

  template <int dim>
  void ControlVolumeForce<dim>::update(const Observation<dim> &observation)
  {
    const auto balance =
        compute_momentum_balance(observation.space, observation.fluid, box, observation.time);
    momentum.add(observation.time, balance.momentum - compute_body_momentum(observation));
    impulse += 0.5 * momentum.get_step() * (other_forces + balance.force) - momentum.get_change();
    other_forces = balance.force;
    force        = other_forces - momentum.get_derivative();
    if (is_valid() && !has_all_bodies(observation))
      impulse[0] = std::numeric_limits<double>::quiet_NaN();
  }

  template <int dim>
  void ControlVolumeForce<dim>::adapt(const Observation<dim> &observation)
  {
    if (momentum.is_empty())
      return;
    const auto balance =
        compute_momentum_balance(observation.space, observation.fluid, box, observation.time);
    momentum.shift(balance.momentum - compute_body_momentum(observation) - momentum.get_last());
  }

  template <int dim>
  Tensor<1, dim>
  ControlVolumeForce<dim>::compute_body_momentum(const Observation<dim> &observation) const
  {
    Tensor<1, dim> sum;
    for (const auto &[body, state, report] : observation.bodies)
      sum += observation.space.get_parameters().density * body.get_solid().get_reference_volume() *
             body.get_mean_velocity(state);
    return sum;
  }

  template <int dim>
  bool ControlVolumeForce<dim>::has_all_bodies(const Observation<dim> &observation) const
  {
    const auto is_in = [&](const Point<dim> &point) {
      const auto cell = observation.lattice.get_coordinates(point, 0);
      return box.point_inside(observation.lattice.get_lower_corner(cell, 0) +
                              0.5 * observation.lattice.get_cell_size(0));
    };
    for (const auto &[body, state, report] : observation.bodies)
    {
      const Tensor<1, dim> support =
          observation.kernel_support *
          observation.lattice.get_cell_size(observation.lattice.get_finest_level());
      for (const auto &node : body.get_solid().get_nodes())
      {
        const Point<dim> point = get_value(state.positions, node);
        if (!is_in(point - support) || !is_in(point + support))
          return false;
      }
    }
    return true;
  }

  template class ControlVolumeForce<2>;
  template class ControlVolumeForce<3>;
} // namespace caudal
