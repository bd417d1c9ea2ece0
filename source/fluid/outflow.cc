// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fluid/boundary_condition.h>

namespace caudal
{
  namespace
  {
    /** -p n + mu du/dn = 0. */
    template <int dim>
    class Outflow : public OpenSide<dim>
    {
    public:
      bool resists_backflow() const override
      {
        return true;
      }
    };

    const DimensionalRegistration<BoundaryCondition, Outflow> registration("outflow",
                                                                           "no traction");
  } // namespace
} // namespace caudal
