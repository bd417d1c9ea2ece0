// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/backward_difference.h>
#include <caudal/observe/observer.h>
#include <caudal/solid/rigid_motion.h>

#include <boost/serialization/vector.hpp>

namespace caudal
{
  namespace
  {
    /** Whether feedback forces are all that can have a resultant on the body. */
    template <int dim>
    bool is_merely_held(const Body<dim> &body)
    {
      const SolidBody<dim> &solid = body.get_solid();
      return !body.swims() && solid.get_excess_density() == 0 &&
             solid.get_parameters().traction.empty() &&
             (solid.get_feedback_stiffness().linfty_norm() > 0 ||
              solid.get_feedback_damping().linfty_norm() > 0);
    }

    /**
     * Columns with the force of the surrounding fluid on the bodies, by two accounts that should
     * agree with each other and with ControlVolume (per metre of span in 2D):
     * - body force: d/dt int_B rho u - int_B f, f the force density on the fluid;
     * - feedback force: the same with the feedback forces alone, and what fixed nodes bear of the
     *   elastic ones; for bodies that are held and neither swim nor have another density than the
     *   fluid.
     * With gravity neither holds the buoyancy -rho g V.
     * The inertia of the fluid in the place of the bodies B is part of both.
     * The moment of the fluid about the centre of mass is that of the body force.
     */
    template <int dim>
    class BodyForces : public Observer<dim>
    {
    public:
      BodyForces()
          : Observer<dim>(20)
      {}

      void start(const Observation<dim> &observation, const ObserverContext<dim> &) override
      {
        momenta.resize(observation.bodies.size());
        angular_momenta.resize(observation.bodies.size());
      }

      void observe_step(const Observation<dim> &observation, const ObserverContext<dim> &) override
      {
        for (unsigned int b = 0; b < momenta.size(); ++b)
        {
          const auto &[body, state, report] = observation.bodies[b];
          const SolidBody<dim> &solid       = body.get_solid();
          const double          density     = observation.space.get_parameters().density;
          momenta[b].add(observation.time,
                         density * solid.get_reference_volume() * body.get_mean_velocity(state));
          Vector<double> nodal_momenta(solid.n_dofs());
          solid.get_mass_matrix().vmult(nodal_momenta, state.velocity);
          nodal_momenta *= density;
          angular_momenta[b].add(observation.time,
                                 compute_moment(solid, state.positions, nodal_momenta));
        }
      }

      void set_body_columns(const Observation<dim> &observation, const unsigned int b,
                            Statistics &statistics) const override
      {
        const auto &[body, state, report] = observation.bodies[b];
        const Tensor<1, dim> change       = momenta[b].get_derivative();
        const auto           set = [&, &name = body.get_name()](const std::string    &cause,
                                                      const Tensor<1, dim> &force) {
          for (unsigned int d = 0; d < dim; ++d)
            statistics.set(name + ": force " + "xyz"[d] + cause, get_extensive_unit<dim>("N"),
                                     change[d] - force[d]);
        };
        const Vector<double> on_fluid = body.compute_forces_on_fluid(state);
        set(" of the fluid", sum_up(body.get_solid(), on_fluid));
        const auto moment = angular_momenta[b].get_derivative() -
                            compute_moment(body.get_solid(), state.positions, on_fluid);
        for (unsigned int k = 0; k < n_rotations; ++k)
          statistics.set(body.get_name() + ": moment" +
                             (dim == 2 ? "" : std::string(" ") + "xyz"[k]) + " of the fluid",
                         get_extensive_unit<dim>("N m"), moment[k]);
        if (!is_merely_held(body))
          return;
        // Where nodes are fixed, the support takes what the elastic forces of the others lack.
        const BodyMotion motion = body.get_motion(state, observation.time, observation.step);
        set(" by feedback",
            sum_up(body.get_solid(), body.compute_force(LoadAccount::feedback, motion)) +
                sum_up(body.get_solid(), body.compute_force(LoadAccount::elastic, motion)));
      }

      void exchange_state(StateArchive &archive) override
      {
        archive &momenta &angular_momenta;
      }

    private:
      static constexpr unsigned int n_rotations = dim * (dim - 1) / 2;

      std::vector<BackwardDifference<dim>>         momenta;
      std::vector<BackwardDifference<n_rotations>> angular_momenta;

      /** The moment of nodal forces about the centre of mass. */
      static Tensor<1, n_rotations> compute_moment(const SolidBody<dim> &solid,
                                                   const Vector<double> &positions,
                                                   const Vector<double> &forces)
      {
        const auto             modes = make_rigid_velocities(solid, positions);
        Tensor<1, n_rotations> moment;
        for (unsigned int k = 0; k < n_rotations; ++k)
          moment[k] = modes[dim + k] * forces;
        return moment;
      }
    };

    const DimensionalRegistration<Observer, BodyForces>
        registration("body forces", "the force of the fluid on each body");
  } // namespace
} // namespace caudal
