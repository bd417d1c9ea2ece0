// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fluid/boundary_condition.h>

namespace caudal
{
  namespace
  {
    /** u.n = 0, and no tangential stress. */
    template <int dim>
    class FreeSlip : public BoundaryCondition<dim>
    {
    public:
      ComponentMask get_prescribed_components(const unsigned int normal) const override
      {
        ComponentMask components(dim, false);
        components.set(normal, true);
        return components;
      }
    };

    const DimensionalRegistration<BoundaryCondition, FreeSlip>
        registration("free slip", "no flow through it, no friction on it");
  } // namespace
} // namespace caudal
