// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/observer.h>

namespace caudal
{
  namespace
  {
    /** Columns with positions and velocities of the monitored points and the centre of mass. */
    template <int dim>
    class Motion : public Observer<dim>
    {
    public:
      Motion()
          : Observer<dim>(10)
      {}

      void set_body_columns(const Observation<dim> &observation, const unsigned int b,
                            Statistics &statistics) const override
      {
        const auto &[body, state, report] = observation.bodies[b];
        const SolidBody<dim> &solid       = body.get_solid();
        const auto            set = [&, &name = body.get_name()](const std::string    &place,
                                                      const Tensor<1, dim> &position,
                                                      const Tensor<1, dim> &velocity) {
          for (unsigned int d = 0; d < dim; ++d)
            statistics.set(name + ": " + "xyz"[d] + place, "m", position[d]);
          for (unsigned int d = 0; d < dim; ++d)
            statistics.set(name + ": " + "uvw"[d] + place, "m/s", velocity[d]);
        };
        for (unsigned int k = 0; k < solid.get_parameters().monitored_points.size(); ++k)
          set(" of point " + std::to_string(k + 1), solid.evaluate(state.positions, k),
              solid.evaluate(state.velocity, k));
        set(" of centre of mass", solid.compute_mean(state.positions),
            solid.compute_mean(state.velocity));
      }
    };

    /** Columns with the changes of volume. */
    template <int dim>
    class Deformation : public Observer<dim>
    {
    public:
      Deformation()
          : Observer<dim>(30)
      {}

      void set_body_columns(const Observation<dim> &observation, const unsigned int b,
                            Statistics &statistics) const override
      {
        const std::string         prefix      = observation.bodies[b].body.get_name() + ": ";
        const DeformationSummary &deformation = observation.bodies[b].report.deformation;
        statistics.set(prefix + "area change", "", deformation.volume_change);
        statistics.set(prefix + "min J", "", deformation.smallest_jacobian);
        statistics.set(prefix + "max J", "", deformation.largest_jacobian);
      }
    };

    /** Columns with what the muscle is told and what it does. */
    template <int dim>
    class Swimming : public Observer<dim>
    {
    public:
      Swimming()
          : Observer<dim>(40)
      {}

      void set_body_columns(const Observation<dim> &observation, const unsigned int b,
                            Statistics &statistics) const override
      {
        const auto &[body, state, report] = observation.bodies[b];
        const std::string prefix          = body.get_name() + ": ";
        statistics.set(prefix + "lateral position", "m", body.get_lateral_position(state));
        statistics.set(prefix + "activation", "", body.get_activation(state));
      }
    };

    const DimensionalRegistration<Observer, Motion> motion("motion",
                                                           "places and velocities of the bodies");
    const DimensionalRegistration<Observer, Deformation>
        deformation("deformation", "changes of the bodies' volume");
    const DimensionalRegistration<Observer, Swimming>
        swimming("swimming", "the tail's lateral position and the muscle's activation");
  } // namespace
} // namespace caudal
