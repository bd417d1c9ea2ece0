// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_coupling_interaction_operator_h
#define caudal_coupling_interaction_operator_h

#include <caudal/base/types.h>
#include <caudal/coupling/line_weights.h>
#include <caudal/mesh/cell_lattice.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/vector.h>

namespace caudal
{
  /** Section `Coupling`. */
  struct CouplingParameters
  {
    Choice<DeltaKernel> kernel{"Kernel", "dirac", "Regularised delta function:"};
    double              quadrature_density       = 1.5;
    bool                accept_unresolved_bodies = false;

    void add_parameters(ParameterHandler &prm);
    void check() const;
  };

  /** What the interaction of all bodies with the fluid has in common: the kernel, with its tables.
   */
  class Coupling
  {
  public:
    explicit Coupling(const CouplingParameters &parameters);

    /** Half the width of the kernel's support, in cells of the finest level. */
    double get_support() const
    {
      return 0.5 * std::max(kernel->radius, kernel->across().radius);
    }

    const std::unique_ptr<DeltaKernel> kernel;
    const LineTable                    along, across;
    const double                       quadrature_density;
  };

  /**
   * The interaction of a body with the fluid,
   *   G_ai = sum_r N_a(s_r) w_r int delta_h(x - X(s_r)) phi_i(x) dx,
   * with the body's quadrature points s_r and exact integrals over the fluid (see
   * integrate_line_weights()). With the kernel `dirac` the integral is phi_i(X(s_r)), the
   * variational limit (Boffi et al. 2008, doi:10.1016/j.cma.2007.09.015).
   * Points on the body's surface with a share of the weight of its first layer of elements make
   * the force reach the surface: without them the wall acts too far inside of the body.
   * Interpolation, C U = G u with SolidBody::get_coupling_mass(), and spreading, f = G^T Phi, are
   * adjoint to each other, so that Phi.(C U) = f.u: no power is lost between the two
   * descriptions (Peskin 2002, doi:10.1017/S0962492902000077).
   * The body is replicated on all ranks; each holds the part of G that its
   * own cells contribute.
   */
  template <int dim>
  class InteractionOperator
  {
  public:
    /** The fluid's side of the interaction; its velocities have the layout @p partitioner. */
    struct Fluid
    {
      const ActiveCells<dim>                                   &cells;
      const DoFHandler<dim>                                    &velocity_dofs;
      const AffineConstraints<double>                          &constraints;
      const std::shared_ptr<const Utilities::MPI::Partitioner> &partitioner;
    };

    /** The body's side, at the nodal positions @p positions. */
    struct Body
    {
      const DoFHandler<dim>   &dofs;
      const Vector<double>    &positions;
      double                   surface_weight; ///< beside the first layer of elements
      const std::vector<bool> &interior;       ///< cells that may meet coarser ones; none: no cell
      const std::string       &name;           ///< for messages
    };

    /**
     * Computes G. Throws if part of the kernel's support lies outside the finest level, or, in the
     * interior, outside of the cells that are known. Collective.
     */
    InteractionOperator(const Coupling &coupling, const Fluid &fluid, const Body &body);

    /** Quadrature points of the body. */
    unsigned int n_points() const
    {
      return n_quadrature_points;
    }

    /**
     * G u (without the division by the body's coupling mass), u having
     * up-to-date ghost values; @p homogeneous: as if all boundary values were zero; collective.
     */
    Vector<double> interpolate(const FieldVector &velocity, bool homogeneous = false) const;

    /** result += G^T Phi on the unconstrained velocity unknowns; collective. */
    void spread(const Vector<double> &force_density, FieldVector &result) const;

    /** The power of Phi on velocities that are prescribed on sides, which spread() leaves out. */
    double compute_power_on_sides(const Vector<double> &force_density) const
    {
      return inhomogeneity * force_density;
    }

    /** Calls operation(body dof, global velocity dof, value) for this rank's entries. */
    template <class Operation>
    void for_each_entry(const Operation &operation) const
    {
      for (unsigned int row = 0; row + 1 < row_start.size(); ++row)
        for (std::size_t k = row_start[row]; k < row_start[row + 1]; ++k)
          operation(row, columns[k], entries[k]);
    }

  private:
    std::shared_ptr<const Utilities::MPI::Partitioner> partitioner;
    unsigned int                                       n_quadrature_points = 0;

    // Compressed rows: global columns, and the same as indices into a ghosted vector.
    std::vector<std::size_t>             row_start;
    std::vector<types::global_dof_index> columns;
    std::vector<unsigned int>            local_columns;
    std::vector<double>                  entries;

    // What the inhomogeneous constraints contribute to G u.
    Vector<double> inhomogeneity;

    /** An entry before those with the same row and column are added up. */
    struct LooseEntry
    {
      unsigned int            row;
      types::global_dof_index column;
      double                  value;
    };

    class Assembler;
    void compress(const std::vector<LooseEntry> &loose_entries, unsigned int n_rows,
                  const std::string &name);
  };
} // namespace caudal

#endif
