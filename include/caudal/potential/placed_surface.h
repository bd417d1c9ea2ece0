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

    /** Whether a node is so far from the cell that the regular rule is accurate. */
    bool is_far(unsigned int cell, unsigned int node) const;

    /**
     * Adds the kernels' moments of a cell, seen from a node of another one, by rules whose
     * points are the denser the nearer the part of the cell is to the node. The body at rest
     * decides, unless the deformation brings together what was far apart.
     */
    void add_near(unsigned int cell, unsigned int node, CellMoments &moments);

    /** The same for the cell of which the node is the one with this number. */
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

    /** Nodes by cell. */
    using Positions = std::vector<std::vector<Point<3>>>;

    Positions             extract_positions(const std::vector<Point<3>> &nodes) const;
    std::unique_ptr<Part> make_part(const std::vector<Point<3>> &nodes, const CellPart &place);

    /** @p decisive are the nodes and the place of @p x by which the rule is chosen. */
    void add_part(unsigned int cell, Part &part, const std::vector<Point<3>> &decisive,
                  const Point<3> &decisive_x, const Point<3> &x, CellMoments &moments);
    void compute_fluxes();

    ReferenceRules                    &rules;
    const std::vector<Point<3>>       &rest; // by node
    const Positions                    positions, rest_positions;
    std::vector<CellRule>              regular; // by cell
    std::vector<std::unique_ptr<Part>> cells;   // as parts of themselves, at rest
    std::vector<std::unique_ptr<Part>> now;     // as they are
    FullMatrix<double>                 fluxes;
    CellRule                           singular; // the last one
  };
} // namespace caudal::potential

#endif
