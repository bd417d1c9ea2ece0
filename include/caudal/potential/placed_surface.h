#ifndef caudal_potential_placed_surface_h
#define caudal_potential_placed_surface_h

#include <caudal/potential/cell_integrals.h>

#include <deal.II/lac/full_matrix.h>

#include <memory>

namespace caudal::potential
{
  /**
   * A surface in one position, with quadrature rules on its cells and on their parts, which
   * are made when they are asked for. It refers to the motion and to the rules.
   */
  class PlacedSurface
  {
  public:
    PlacedSurface(const Surface &surface, const SurfaceMotion &motion, ReferenceRules &rules);

    unsigned int n_motions() const
    {
      return 6 + motion.modes.size();
    }

    /** Of the cell's nodes [m]. */
    const std::vector<Point<3>> &get_positions(const unsigned int cell) const
    {
      return positions[cell];
    }

    /** The rule for smooth functions. */
    const CellRule &get_regular(const unsigned int cell) const
    {
      return regular[cell];
    }

    /** u_l.N at the points of the regular rules, by cell and point, then motion l. */
    const FullMatrix<double> &get_fluxes() const
    {
      return fluxes;
    }

    /** Whether x is so far from the cell that the regular rule is accurate. */
    bool is_far(unsigned int cell, const Point<3> &x) const;

    /**
     * Adds the kernels' moments of a cell that does not contain x, by rules whose points are
     * the denser the nearer the part of the cell is to x.
     */
    void add_near(unsigned int cell, const Point<3> &x, CellMoments &moments)
    {
      add_part(cell, *cells[cell], x, moments);
    }

    /** The same for the cell of which x is the node with this number. */
    void add_singular(unsigned int cell, unsigned int node, CellMoments &moments);

    const Surface       &surface;
    const SurfaceMotion &motion;

  private:
    /** A part of a cell: a ball around it, the rules on it, and its halves. */
    struct Part
    {
      CellPart                                                             place;
      Point<3>                                                             centre;
      double                                                               radius = 0.;
      unsigned int                                                         longer = 0;
      std::array<std::unique_ptr<CellRule>, ReferenceRules::n_gauss_rules> rules;
      std::array<std::unique_ptr<Part>, 2>                                 halves;
    };

    std::unique_ptr<Part> make_part(unsigned int cell, const CellPart &place);
    void add_part(unsigned int cell, Part &part, const Point<3> &x, CellMoments &moments);
    void compute_fluxes();

    ReferenceRules                    &rules;
    std::vector<std::vector<Point<3>>> positions; // by cell
    std::vector<CellRule>              regular;   // by cell
    std::vector<std::unique_ptr<Part>> cells;     // as parts of themselves
    FullMatrix<double>                 fluxes;
    CellRule                           singular; // the last one
  };
} // namespace caudal::potential

#endif
