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
    unsigned int interior_levels         = 0;
    double       vorticity_threshold     = 0;
    unsigned int vorticity_levels        = 0;
    unsigned int largest_number_of_cells = 100000;
    std::string  level_expression        = "0";

    void add_parameters(ParameterHandler &prm);
    void check(unsigned int levels) const;

    /** The coarsest level on which a body may meet the grid in its interior. */
    unsigned int get_interior_level(const unsigned int finest_level) const
    {
      return interior_levels == 0 ? finest_level : interior_levels - 1;
    }

    /** Where the interior of a body begins: its depth below the surface, in cells of the finest
     * level. */
    static constexpr double interior_depth = 3;
  };

  /**
   * Sets the refinement and coarsening flags of the locally owned cells:
   * fine near the bodies (@p body_cells); elsewhere by the @p indicator of
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
