// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/control_volume.h>

#include <caudal/fluid/external_forces.h>

#include <cmath>
#include <limits>

namespace caudal
{
  namespace
  {
    const double unknown = std::numeric_limits<double>::quiet_NaN();

    /** int_B rho u [N s/m] */
    template <int dim>
    Tensor<1, dim> compute_body_momentum(const Observation<dim> &observation)
    {
      Tensor<1, dim> sum;
      for (const auto &[body, state, report] : observation.bodies)
        sum += observation.space.get_parameters().density *
               body.get_solid().get_reference_volume() * body.get_mean_velocity(state);
      return sum;
    }

    const DimensionalRegistration<Observer, ControlVolume>
        registration("control volume", "the fluid's force by the momentum balance of a volume");
  } // namespace

  template <int dim>
  void ControlVolume<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Fluid");
    prm.add_parameter("Control volume", corners,
                      "Lower and upper corner of a box round all bodies. The momentum balance of "
                      "the coarse cells with a centre in it gives the force on the bodies once "
                      "more, in the statistics and, if there is one body that stays in it, as "
                      "the mean of each tail beat; once a body has left the box, which the log "
                      "tells, it means nothing. Coordinates separated by ',', corners by ';' [m]. "
                      "None: not done.");
    prm.leave_subsection();
  }

  template <int dim>
  void ControlVolume<dim>::check(const std::string & /*path*/) const
  {
    AssertThrow(corners.empty() || corners.size() == 2,
                ExcMessage("Fluid/Control volume: there are " + std::to_string(corners.size()) +
                           " points. Give two, the lower and the upper corner, or none."));
    for (unsigned int d = 0; d < dim && is_active(); ++d)
      AssertThrow(corners[0][d] < corners[1][d],
                  ExcMessage("Fluid/Control volume: the first corner is not below the second in "
                             "direction " +
                             std::to_string(d) + ". Exchange them."));
  }

  template <int dim>
  void ControlVolume<dim>::check_case(const Observation<dim> &start) const
  {
    AssertThrow(!is_active() || start.step_number > 0 || has_all_bodies(start),
                ExcMessage("Fluid/Control volume: the coarse cells with their centre in it do not "
                           "hold all bodies with their kernels. Give a larger one."));
  }

  template <int dim>
  void ControlVolume<dim>::observe_step(const Observation<dim>     &observation,
                                        const ObserverContext<dim> &context)
  {
    if (!is_active())
      return;
    const auto balance =
        compute_momentum_balance(observation.space, observation.fluid, get_box(),
                                 observation.get_instant(), observation.report.grid_velocity);
    momentum.add(observation.time, balance.momentum - compute_body_momentum(observation));
    impulse += 0.5 * momentum.get_step() * (other_forces + balance.force) - momentum.get_change();
    other_forces = balance.force;
    force        = other_forces - momentum.get_derivative();
    if (std::isnan(impulse[0]) || has_all_bodies(observation))
      return;
    impulse[0] = unknown;
    context.log << "Warning: a body has left Fluid/Control volume at t = " << observation.time
                << " s; the force by control volume is none on the bodies from here on."
                << std::endl;
  }

  template <int dim>
  void ControlVolume<dim>::observe_new_grid(const Observation<dim> &observation,
                                            const ObserverContext<dim> &)
  {
    if (!is_active() || momentum.is_empty())
      return;
    const auto balance =
        compute_momentum_balance(observation.space, observation.fluid, get_box(),
                                 observation.get_instant(), observation.report.grid_velocity);
    momentum.shift(balance.momentum - compute_body_momentum(observation) - momentum.get_last());
  }

  template <int dim>
  Tensor<1, dim> ControlVolume<dim>::get_impulse() const
  {
    Tensor<1, dim> result = impulse;
    if (!is_active())
      result[0] = unknown;
    return result;
  }

  template <int dim>
  bool ControlVolume<dim>::has_all_bodies(const Observation<dim> &observation) const
  {
    const CellLattice<dim> &lattice = observation.lattice;
    const BoundingBox<dim>  box     = get_box();
    const auto              is_in   = [&](const Point<dim> &point) {
      return box.point_inside(lattice.get_lower_corner(lattice.get_coordinates(point, 0), 0) +
                                             0.5 * lattice.get_cell_size(0));
    };
    const Tensor<1, dim> support =
        observation.kernel_support * lattice.get_cell_size(lattice.get_finest_level());
    for (const auto &[body, state, report] : observation.bodies)
      for (const auto &node : body.get_solid().get_nodes())
      {
        const Point<dim> point =
            get_value(state.positions, node) - restrict_to<dim>(observation.origin);
        if (!is_in(point - support) || !is_in(point + support))
          return false;
      }
    return true;
  }

  template <int dim>
  void ControlVolume<dim>::set_columns(const Observation<dim> &, Statistics &statistics) const
  {
    for (unsigned int d = 0; d < dim && is_active(); ++d)
      statistics.set(std::string("force ") + "xyz"[d] + " by control volume",
                     get_extensive_unit<dim>("N"), force[d]);
  }

  template <int dim>
  void ControlVolume<dim>::exchange_state(StateArchive &archive)
  {
    archive &momentum &other_forces &impulse;
  }

  template class ControlVolume<2>;
  template class ControlVolume<3>;
} // namespace caudal
