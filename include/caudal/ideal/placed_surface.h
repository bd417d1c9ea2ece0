#ifndef caudal_ideal_placed_surface_h
#define caudal_ideal_placed_surface_h

#include <caudal/ideal/cell_integrals.h>

#include <deal.II/lac/full_matrix.h>

#include <functional>
#include <memory>

namespace caudal::ideal
{
  /** A rule on a part of a cell, with the derivatives of a number by what is at its points. */
  struct PlacedRule
  {
    CellRule       rule;
    PointGradients gradients;
  };

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
      return regular[cell].rule;
    }

    /** The same, with what is differentiated by its points. */
    PlacedRule &get_regular(const unsigned int cell)
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
     * The rules on a cell for kernels as seen from a node of another one; their points are the
     * denser the nearer the part of the cell is to the node. The body at rest decides, unless
     * the deformation brings together what was far apart.
     */
    const std::vector<PlacedRule *> &find_near(unsigned int cell, unsigned int node);

    /** The one for the cell of which the node is the one with this number; until the next call. */
    PlacedRule &get_singular(unsigned int cell, unsigned int node);

    /** Calls @p visit for all rules on a cell that were in use, but the singular ones. */
    void visit_rules(unsigned int cell, const std::function<void(PlacedRule &)> &visit);

    const Surface       &surface;
    const SurfaceMotion &motion;

  private:
    /** A part of a cell: a ball around it, the rules on it, and its halves. */
    struct Part
    {
      CellPart                                                               place;
      Point<3>                                                               centre;
      double                                                                 radius = 0.;
      unsigned int                                                           longer = 0;
      std::array<std::unique_ptr<PlacedRule>, ReferenceRules::n_gauss_rules> rules;
      std::array<std::unique_ptr<Part>, 2>                                   halves;
    };

    /** Nodes by cell. */
    using Positions = std::vector<std::vector<Point<3>>>;

    Positions             extract_positions(const std::vector<Point<3>> &nodes) const;
    std::unique_ptr<Part> make_part(const std::vector<Point<3>> &nodes, const CellPart &place);

    /** @p decisive are the nodes and the place of x by which the rules are chosen. */
    void        find_rules(unsigned int cell, Part &part, const std::vector<Point<3>> &decisive,
                           const Point<3> &x);
    static void visit_part(Part &part, const std::function<void(PlacedRule &)> &visit);
    void        compute_fluxes();

    ReferenceRules                    &rules;
    const std::vector<Point<3>>       &rest; // by node
    const Positions                    positions, rest_positions;
    std::vector<PlacedRule>            regular; // by cell
    std::vector<std::unique_ptr<Part>> cells;   // as parts of themselves, at rest
    std::vector<std::unique_ptr<Part>> now;     // as they are
    FullMatrix<double>                 fluxes;
    PlacedRule                         singular; // the last one
    std::vector<PlacedRule *>          found;
  };
} // namespace caudal::ideal

#endif
