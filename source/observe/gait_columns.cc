// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/observer.h>
#include <caudal/solid/bending.h>

namespace caudal
{
  namespace
  {
    /** Columns of bodies with a gait: how they follow it, and the torques and power that it takes.
     */
    template <int dim>
    class GaitColumns : public Observer<dim>
    {
    public:
      GaitColumns()
          : Observer<dim>(45)
      {}

      void set_body_columns(const Observation<dim> &observation, const unsigned int b,
                            Statistics &statistics) const override
      {
        const auto &[body, state, report] = observation.bodies[b];
        if (!body.has_gait())
          return;
        const std::string prefix = body.get_name() + ": ";
        const Bending bending    = compute_bending(body, state, observation.time, observation.step);
        statistics.set(prefix + "distance from the gait", "", bending.distance);
        if (bending.torques.empty())
          return;
        for (unsigned int k = 0; k < bending.torques.size(); ++k)
          statistics.set(prefix + "torque at 0." + std::to_string(k + 1) + " L",
                         get_extensive_unit<dim>("N m"), bending.torques[k]);
        statistics.set(prefix + "power of the torques", get_extensive_unit<dim>("W"),
                       bending.power);
      }
    };

    const DimensionalRegistration<Observer, GaitColumns>
        registration("gait", "how bodies follow their gait, torques and power");
  } // namespace
} // namespace caudal
