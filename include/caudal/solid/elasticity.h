// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_solid_elasticity_h
#define caudal_solid_elasticity_h

#include <caudal/solid/solid_body.h>

#include <string>
#include <utility>

namespace caudal
{
  /** The deformation gradient F of a cell's nodal positions @p x and gradients of its functions. */
  template <int dim>
  Tensor<2, dim> compute_deformation_gradient(const std::vector<Point<dim>>     &x,
                                              const std::vector<Tensor<1, dim>> &gradients)
  {
    Tensor<2, dim> F;
    for (unsigned int a = 0; a < x.size(); ++a)
      F += outer_product(x[a], gradients[a]);
    return F;
  }

  /** Integral quantities of a deformed body. */
  struct DeformationSummary
  {
    /** Smallest and largest det F at the quadrature points [1]. */
    double smallest_jacobian = 1, largest_jacobian = 1;
    /** int J ds / int ds - 1 [1] */
    double volume_change = 0;
    /** int W ds + sum over the cells of kappa_v/2 V (ln(v/V))^2 [J, in 2D J/m] */
    double elastic_energy = 0;

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &smallest_jacobian &largest_jacobian &volume_change &elastic_energy;
    }
  };

  /** Throws ExcInvertedElement if det F <= 0 somewhere. */
  template <int dim>
  DeformationSummary summarise_deformation(const SolidBody<dim> &body,
                                           const Vector<double> &positions);

  /**
   * Cell means for pictures, by name: J, the elastic Cauchy stress [Pa] by component, P F^T / J and
   * the pressure of the cells' volume stabilisation, and the region.
   */
  template <int dim>
  std::vector<std::pair<std::string, Vector<float>>>
  compute_cell_means(const SolidBody<dim> &body, const Vector<double> &positions);
} // namespace caudal

#endif
