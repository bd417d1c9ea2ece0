// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_cell_matrices_h
#define caudal_fluid_cell_matrices_h

#include <caudal/mesh/domain.h>

#include <deal.II/fe/fe_dgp.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>

namespace caudal
{
  /** Weights of the constant terms of the momentum operator. */
  struct MomentumWeights
  {
    /** of (u, v): rho times the weight of the time derivative [kg/(m^3 s)] */
    double inertia = 0;
    /** of (grad u, grad v): mu [Pa s] */
    double viscosity = 0;
    /** of (div u, div v) [Pa s] */
    double grad_div = 0;
    /** of the augmentation (pi div u, pi div v), pi the projection on the pressure space [Pa s] */
    double augmentation = 0;

    bool operator==(const MomentumWeights &other) const
    {
      return inertia == other.inertia && viscosity == other.viscosity &&
             grad_div == other.grad_div && augmentation == other.augmentation;
    }
  };

  /**
   * The matrices of a cell of one refinement level. All cells of a level are
   * congruent, so that these are computed once. Vector shape functions are
   * numbered as in the FESystem, scalar ones as in its base element.
   */
  template <int dim>
  class CellMatrices
  {
  public:
    CellMatrices(const FESystem<dim> &velocity_element, const FE_DGP<dim> &pressure_element,
                 const Tensor<1, dim> &cell_size);

    /** Constant part of the momentum matrix. */
    void get_momentum_matrix(const MomentumWeights &weights, FullMatrix<double> &matrix) const;

    /**
     * The convection matrix of a scalar component,
     * C_ij = 1/2 rho [(w.grad phi_j, phi_i) - (w.grad phi_i, phi_j)]
     *        + tau (k(w.grad phi_j), k(w.grad phi_i)),
     * skew-symmetric but for the local projection stabilisation
     * (Matthies, Skrzypacz & Tobiska 2007, doi:10.1051/m2an:2007038), for which
     * tau = rho c min(h/|w|, 1/rate). @p transport holds the nodal values of w.
     */
    void get_convection_matrix(const Vector<double> &transport, double density,
                               double stabilisation, double rate, FullMatrix<double> &matrix) const;

    /**
     * What the local projection stabilisation dissipates in the cell, tau |k(u.grad u)|^2 [W, in
     * 2D W/m]: that of get_convection_matrix() with u for w. @p velocity: the nodal values of u.
     */
    double compute_stabilisation_dissipation(const Vector<double> &velocity, double density,
                                             double stabilisation, double rate,
                                             const Tensor<1, dim> &grid_velocity) const;

    const FullMatrix<double> &get_mass() const
    {
      return mass;
    }
    const FullMatrix<double> &get_stiffness() const
    {
      return stiffness;
    }
    const FullMatrix<double> &get_grad_div() const
    {
      return grad_div;
    }
    /** (psi_k, div phi_i), rows k. */
    const FullMatrix<double> &get_divergence() const
    {
      return divergence;
    }
    const FullMatrix<double> &get_inverse_pressure_mass() const
    {
      return inverse_pressure_mass;
    }
    const Tensor<1, dim> &get_cell_size() const
    {
      return cell_size;
    }

  private:
    const FESystem<dim> &velocity_element;
    const Tensor<1, dim> cell_size;

    FullMatrix<double> mass, stiffness; // scalar
    FullMatrix<double> grad_div, augmentation, divergence, inverse_pressure_mass;

    // Tables at the quadrature points of the convection term.
    FullMatrix<double>                       values;    // (point, scalar shape function)
    std::vector<std::vector<Tensor<1, dim>>> gradients; // [point][scalar shape function]
    FullMatrix<double> linear_values; // orthonormal linear functions (point, function)
    double             point_weight[64] = {};

    /** The nodal values as vectors, one for each scalar shape function. */
    using NodalVectors = std::array<Tensor<1, dim>, 27>;
    NodalVectors get_nodal_vectors(const Vector<double> &dof_values) const;

    /** tau, see get_convection_matrix() [kg s/m^3]. */
    double compute_stabilisation_weight(const NodalVectors &transport, double density,
                                        double stabilisation, double rate) const;
  };
} // namespace caudal

#endif
