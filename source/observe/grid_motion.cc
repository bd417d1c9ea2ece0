// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/observer.h>

namespace caudal
{
  namespace
  {
    /** Columns with place and velocity of a grid that moves. */
    template <int dim>
    class GridMotion : public Observer<dim>
    {
    public:
      GridMotion()
          : Observer<dim>(75)
      {}

      void set_columns(const Observation<dim> &observation, Statistics &statistics) const override
      {
        if (!observation.grid_moves)
          return;
        for (unsigned int d = 0; d < dim; ++d)
          statistics.set(std::string(1, "xyz"[d]) + " of the grid", "m", observation.origin[d]);
        for (unsigned int d = 0; d < dim; ++d)
          statistics.set(std::string(1, "uvw"[d]) + " of the grid", "m/s",
                         observation.report.grid_velocity[d]);
      }
    };

    const DimensionalRegistration<Observer, GridMotion>
        registration("grid motion", "place and velocity of a grid that moves");
  } // namespace
} // namespace caudal
