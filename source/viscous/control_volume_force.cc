#include <caudal/fluid/control_volume.h>
#include <caudal/viscous/control_volume_force.h>

#include <limits>

namespace caudal
{
  template <int dim>
  ControlVolumeForce<dim>::ControlVolumeForce(const ImmersedSystem<dim> &system,
                                              const BoundingBox<dim>    &box)
      : system(system)
      , box(box)
  {}

  template <int dim>
  void ControlVolumeForce<dim>::update(const double time)
  {
    const auto balance = compute_momentum_balance(system.space, system.fluid, box, time);
    momentum.add(time, balance.momentum - compute_body_momentum());
    impulse += 0.5 * momentum.get_step() * (other_forces + balance.force) - momentum.get_change();
    other_forces = balance.force;
    force        = other_forces - momentum.get_derivative();
    if (is_valid() && !has_all_bodies())
      impulse[0] = std::numeric_limits<double>::quiet_NaN();
  }

  template <int dim>
  void ControlVolumeForce<dim>::adapt(const double time)
  {
    if (momentum.is_empty())
      return;
    const auto balance = compute_momentum_balance(system.space, system.fluid, box, time);
    momentum.shift(balance.momentum - compute_body_momentum() - momentum.get_last());
  }

  template <int dim>
  Tensor<1, dim> ControlVolumeForce<dim>::compute_body_momentum() const
  {
    Tensor<1, dim> sum;
    for (const auto &body : system.bodies)
      sum += system.space.get_parameters().density * body->solid.get_reference_volume() *
             body->get_mean_velocity();
    return sum;
  }

  template <int dim>
  bool ControlVolumeForce<dim>::has_all_bodies() const
  {
    const auto is_in = [this](const Point<dim> &point) {
      const auto cell = system.lattice.get_coordinates(point, 0);
      return box.point_inside(system.lattice.get_lower_corner(cell, 0) +
                              0.5 * system.lattice.get_cell_size(0));
    };
    for (const auto &body : system.bodies)
    {
      const Tensor<1, dim> support =
          body->interaction.get_support() *
          system.lattice.get_cell_size(system.lattice.get_finest_level());
      for (const auto &node : body->solid.get_nodes())
      {
        Point<dim> point;
        for (unsigned int d = 0; d < dim; ++d)
          point[d] = body->solid.positions[node[d]];
        if (!is_in(point - support) || !is_in(point + support))
          return false;
      }
    }
    return true;
  }

  template class ControlVolumeForce<2>;
  template class ControlVolumeForce<3>;
} // namespace caudal
