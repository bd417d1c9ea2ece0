// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/solid/material.h>

namespace caudal
{
  namespace
  {
    template <int dim>
    class NoStress : public Material<dim>
    {
    public:
      double strain_energy(const Tensor<2, dim> &, const Point<dim> &) const override
      {
        return 0.;
      }

      Tensor<2, dim> first_piola_kirchhoff_stress(const Tensor<2, dim> &,
                                                  const Point<dim> &) const override
      {
        return Tensor<2, dim>();
      }

      Tensor<4, dim> tangent(const Tensor<2, dim> &, const Point<dim> &) const override
      {
        return Tensor<4, dim>();
      }
    };

    const DimensionalRegistration<Material, NoStress> registration("none",
                                                                   "there is no elastic stress");
  } // namespace
} // namespace caudal
