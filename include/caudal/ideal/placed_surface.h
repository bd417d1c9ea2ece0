// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_placed_surface_h
#define caudal_ideal_placed_surface_h

#include <caudal/ideal/surface_quadrature.h>

namespace caudal::ideal
{
  /**
   * A surface in one position, with quadrature rules on its cells and on their parts, which are
   * made when they are asked for.
   *
   * A kernel 1/|y - x| over a part of a cell needs the more points the nearer x is: by the
   * distance in radii of the part, one of Gauss's rules is chosen, or the part is halved. The
   * body at rest decides, so that what is integrated depends smoothly on the shape, unless the
   * deformation brings together what was far apart.
   */
  class PlacedSurface
  {
  public:
    /** Refers to all three. */
    PlacedSurface(const Surface &surface, const SurfaceMotion &motion, ReferenceRules &rules);

    /** The cell's nodes [m]. */
    const CellArray<Point<3>> &get_nodes(const unsigned int cell) const
    {
      return cells[cell].now.nodes;
    }

    /** The number of the rule for smooth functions on each cell. */
    static constexpr unsigned int regular = 0;

    const PlacedRule &get_rule(const unsigned int cell, const unsigned int number) const
    {
      return cells[cell].rules[number];
    }

    /**
     * The numbers of the rules that together integrate kernels over the cell, as seen from a
     * node of the surface. Valid until the next call.
     */
    const std::vector<unsigned int> &find_rules(unsigned int cell, unsigned int node);

  private:
    /** The smallest ball around the middle of a part of a cell that holds its outline. */
    struct Ball
    {
      Point<3>     centre;
      double       radius;
      unsigned int longer_side; // direction in which the part is longer
    };

    /** A cell in one position, with the balls around its parts that have been asked for. */
    struct Geometry
    {
      CellArray<Point<3>>      nodes;
      Ball                     ball;
      std::map<CellPart, Ball> balls;
    };

    struct Cell
    {
      Geometry                                                  now, at_rest;
      std::vector<PlacedRule>                                   rules;
      std::map<std::pair<unsigned int, CellPart>, unsigned int> numbers; // by kind and part
    };

    Geometry make_geometry(unsigned int cell, const std::vector<Point<3>> &nodes) const;
    Ball     make_ball(const CellArray<Point<3>> &nodes, const CellPart &part) const;
    void     find_rules(Cell &cell, Geometry &decisive, const CellPart &part, const Point<3> &x);
    void     use_rule(Cell &cell, unsigned int kind, const CellPart &part);

    const Surface               &surface;
    const std::vector<Point<3>> &places, &rest_places; // of the nodes
    ReferenceRules              &rules;
    std::vector<Cell>            cells;
    std::vector<unsigned int>    found;
  };
} // namespace caudal::ideal

#endif
