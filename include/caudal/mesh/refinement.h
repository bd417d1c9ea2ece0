// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_mesh_refinement_h
#define caudal_mesh_refinement_h

#include <caudal/mesh/cell_lattice.h>

#include <deal.II/lac/vector.h>

namespace caudal
{
  /** Section `Refinement`: where the fluid's grid is fine. */
  struct RefinementParameters
  {
    unsigned int interval                = 10;
    double       body_margin             = 3;
    double       vorticity_threshold     = 0;
    unsigned int vorticity_levels        = 0;
    unsigned int largest_number_of_cells = 100000;
    std::string  level_expression        = "0";

    void add_parameters(ParameterHandler &prm);
    void check(unsigned int levels) const;
  };

  /**
   * Sets the refinement and coarsening flags of the locally owned cells:
   * finest near the bodies (@p body_cells); elsewhere by the @p indicator of
   * each active cell, h |vorticity| [m/s] at its largest (refine above the
   * threshold, coarsen below an eighth of it); never coarser than the level
   * expression at @p time [s]. If the cells would become too many, those with the smallest
   * indicator are not refined; if they are too many, coarsened. Returns whether any flag is set
   * (collective).
   */
  template <int dim>
  bool flag_cells(parallel::distributed::Triangulation<dim> &triangulation,
                  const CellLattice<dim> &lattice, const CellSet<dim> &body_cells,
                  const Vector<float> &indicator, const RefinementParameters &parameters,
                  double time);
} // namespace caudal

#endif
