// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fluid/boundary_condition.h>

namespace caudal
{
  namespace
  {
    /** -p n + mu du/dn = 0. */
    template <int dim>
    class Outflow : public BoundaryCondition<dim>
    {
    public:
      ComponentMask get_prescribed_components(const unsigned int) const override
      {
        return ComponentMask(dim, false);
      }

      bool is_open() const override
      {
        return true;
      }

      bool resists_backflow() const override
      {
        return true;
      }
    };

    const DimensionalRegistration<BoundaryCondition, Outflow> registration("outflow",
                                                                           "no traction");
  } // namespace
} // namespace caudal
