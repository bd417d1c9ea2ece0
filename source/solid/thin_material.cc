// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/solid/material_tools.h>

namespace caudal
{
  namespace
  {
    /** F* and what its derivatives need. */
    template <int dim>
    struct Stretch
    {
      Stretch(const Tensor<2, dim> &F, const Tensor<1, dim> &normal)
          : J(positive_determinant(F))
          , inverse(inverse_transpose(F))
          , cofactor(J * inverse)
          , c(cofactor * normal)
          , stretched_F(F + (1. - J) / c.norm_square() * outer_product(c, normal))
      {}

      /** t.c/|c|^2, the work of the traction t on a unit change of volume. */
      double get_normal_stress(const Tensor<1, dim> &t) const
      {
        return t * c / c.norm_square();
      }

      /** w.dc/dF with w = (t - 2 (t.c) c/|c|^2)/|c|^2, the derivative of t.c/|c|^2 by c. */
      Tensor<2, dim> get_turning_stress(const Tensor<1, dim> &t) const
      {
        const Tensor<1, dim> w = (t - 2. * get_normal_stress(t) * c) / c.norm_square();
        return (w * c) * inverse - outer_product(c, w * inverse);
      }

      const double         J;
      const Tensor<2, dim> inverse; // transposed
      const Tensor<2, dim> cofactor;
      const Tensor<1, dim> c;
      const Tensor<2, dim> stretched_F;
    };

    template <int dim>
    class ThinMaterial : public Material<dim>
    {
    public:
      ThinMaterial(std::unique_ptr<Material<dim>> material, const Tensor<1, dim> &normal)
          : material(std::move(material))
          , normal(normal)
      {}

      double strain_energy(const Tensor<2, dim> &F, const Point<dim> &s) const override
      {
        return material->strain_energy(Stretch<dim>(F, normal).stretched_F, s);
      }

      /** With t = P(F*) N: P(F*) - t.c/|c|^2 cof F + (1 - J) w.dc/dF, see Stretch. */
      Tensor<2, dim> first_piola_kirchhoff_stress(const Tensor<2, dim> &F,
                                                  const Point<dim>     &s) const override
      {
        const Stretch<dim>   stretch(F, normal);
        const Tensor<2, dim> P = material->first_piola_kirchhoff_stress(stretch.stretched_F, s);
        const Tensor<1, dim> t = P * normal;
        return P - stretch.get_normal_stress(t) * stretch.cofactor +
               (1. - stretch.J) * stretch.get_turning_stress(t);
      }

      /** The second derivative of the energy where J = 1. */
      Tensor<4, dim> tangent(const Tensor<2, dim> &F, const Point<dim> &s) const override
      {
        const Stretch<dim>    stretch(F, normal);
        const Tensor<2, dim>  P   = material->first_piola_kirchhoff_stress(stretch.stretched_F, s);
        const Tensor<4, dim>  A   = material->tangent(stretch.stretched_F, s);
        const Tensor<1, dim>  t   = P * normal;
        const Tensor<2, dim> &cof = stretch.cofactor;
        const double          normal_stress = stretch.get_normal_stress(t);

        // A applied to the stretch of a unit change of volume
        Tensor<2, dim> by_volume;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int J = 0; J < dim; ++J)
            by_volume[i][J] = stretch.get_normal_stress(A[i][J] * normal);
        const double         twice = stretch.get_normal_stress(by_volume * normal);
        const Tensor<2, dim> mixed = by_volume + stretch.get_turning_stress(t);
        return make_tangent<dim>([&](auto i, auto J, auto k, auto L) {
          return A[i][J][k][L] - cof[i][J] * mixed[k][L] - mixed[i][J] * cof[k][L] +
                 twice * cof[i][J] * cof[k][L] -
                 normal_stress / stretch.J * (cof[i][J] * cof[k][L] - cof[i][L] * cof[k][J]);
        });
      }

    private:
      const std::unique_ptr<Material<dim>> material;
      const Tensor<1, dim>                 normal;
    };
  } // namespace

  template <int dim>
  std::unique_ptr<Material<dim>> make_thin(std::unique_ptr<Material<dim>> material,
                                           const Tensor<1, dim>          &normal)
  {
    return std::make_unique<ThinMaterial<dim>>(std::move(material), normal);
  }

  template std::unique_ptr<Material<2>> make_thin(std::unique_ptr<Material<2>>,
                                                  const Tensor<1, 2> &);
  template std::unique_ptr<Material<3>> make_thin(std::unique_ptr<Material<3>>,
                                                  const Tensor<1, 3> &);
} // namespace caudal
