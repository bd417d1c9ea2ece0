// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fluid/boundary_condition.h>

namespace caudal
{
  namespace
  {
    /** u = 0. Where a wall meets an inflow, the corner is at rest. */
    template <int dim>
    class Wall : public BoundaryCondition<dim>
    {
    public:
      ComponentMask get_prescribed_components(const unsigned int) const override
      {
        return ComponentMask(dim, true);
      }

      unsigned int get_rank() const override
      {
        return 0;
      }
    };

    const DimensionalRegistration<BoundaryCondition, Wall> registration("wall", "no slip");
  } // namespace
} // namespace caudal
