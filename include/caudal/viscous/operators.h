// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_operators_h
#define caudal_viscous_operators_h

#include <caudal/viscous/coupled_solver.h>
#include <caudal/viscous/flow_scales.h>

namespace caudal
{
  /**
   * What a step works with: bodies, grid, spaces, and the operators on them. It does not change but
   * for the grid, after whose changes reinit() is called; what a step leaves in the operators is
   * work space, on which no result depends.
   */
  template <int dim>
  class Operators
  {
  public:
    /** On the coarse grid of the domain. @p parameters have to outlive the object. */
    Operators(const RunParameters<dim> &parameters, MPI_Comm communicator);

    /** Brings the grid into its canonical order, and everything else to the grid. Collective. */
    void reinit();

    /**
     * The interaction with the fluid of the body with the number @p b, at its nodal positions @p x
     * and with grid and boundary values of this @p instant.
     */
    InteractionOperator<dim> compute_interaction(unsigned int b, const Vector<double> &x,
                                                 const Instant &instant) const;

    /** Augmentation gamma of the momentum equation for a weight @p inertia [Pa s]. */
    double get_augmentation(double inertia) const;

    BoundingBox<dim> get_domain() const;

    const RunParameters<dim>                 &parameters;
    const MPI_Comm                            communicator;
    const CellLattice<dim>                    lattice;
    const Coupling                            coupling;
    const Bodies<dim>                         bodies;
    const std::vector<std::vector<bool>>      interiors; // by body, cell: meets coarser cells
    const FlowScales                          scales;
    parallel::distributed::Triangulation<dim> triangulation;
    FluidSpace<dim>                           space;
    MomentumOperator<dim>                     momentum;
    mutable TimerOutput                       timer; // of rank 0
    CoupledSolver<dim>                        solver;

  private:
    std::unique_ptr<const ActiveCells<dim>> cells;
  };
} // namespace caudal

#endif
