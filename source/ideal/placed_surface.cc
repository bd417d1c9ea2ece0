// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/ideal/placed_surface.h>

#include <algorithm>

namespace caudal::ideal
{
  namespace
  {
    // Each Gauss rule serves points that are farther from the centre of the part than this, in
    // its radii. With m points in each direction the error falls as (d + sqrt(d^2 - 1))^(-2m).
    const double nearest[ReferenceRules::n_gauss] = {2.5, 1.85, 1.5, 1.35};

    // What was far away at rest counts as near if it comes nearer than this.
    const double too_near = 2.;

    // No cell is halved more often than this in either direction.
    const unsigned int finest_level = 6;

    bool is_within(const Point<3> &x, const Point<3> &centre, const double distance)
    {
      return x.distance_square(centre) < distance * distance;
    }
  } // namespace

  PlacedSurface::PlacedSurface(const Surface &surface, const SurfaceMotion &motion,
                               ReferenceRules &rules)
      : surface(surface)
      , places(motion.positions)
      , rest_places(motion.rest.empty() ? motion.positions : motion.rest)
      , rules(rules)
      , cells(surface.n_cells())
  {
    for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
    {
      cells[cell].now     = make_geometry(cell, places);
      cells[cell].at_rest = make_geometry(cell, rest_places);
      use_rule(cells[cell], 0, CellPart());
    }
    found.clear();
  }

  PlacedSurface::Geometry PlacedSurface::make_geometry(const unsigned int           cell,
                                                       const std::vector<Point<3>> &nodes) const
  {
    const CellArray<Point<3>> cell_nodes = extract_cell(nodes, surface.get_nodes(cell));
    return {cell_nodes, make_ball(cell_nodes, CellPart()), {}};
  }

  PlacedSurface::Ball PlacedSurface::make_ball(const CellArray<Point<3>> &nodes,
                                               const CellPart            &part) const
  {
    const PlacedRule outline(rules.get(ReferenceRules::outline, part), nodes);
    const Point<3>   centre = outline.get_point(4);
    double           radius = 0.;
    for (unsigned int q = 0; q < outline.size(); ++q)
      radius = std::max(radius, centre.distance(outline.get_point(q)));
    const double width  = outline.get_point(3).distance(outline.get_point(5));
    const double height = outline.get_point(1).distance(outline.get_point(7));
    return {centre, radius, width > height ? 0u : 1u};
  }

  const std::vector<unsigned int> &PlacedSurface::find_rules(const unsigned int cell,
                                                             const unsigned int node)
  {
    Cell       &at    = cells[cell];
    const auto &nodes = surface.get_nodes(cell);
    const auto  own   = std::find(nodes.begin(), nodes.end(), node);
    found.clear();
    if (own != nodes.end())
      use_rule(at, ReferenceRules::get_singular_kind(own - nodes.begin()), CellPart());
    else if (is_within(rest_places[node], at.at_rest.ball.centre,
                       nearest[0] * at.at_rest.ball.radius))
      find_rules(at, at.at_rest, CellPart(), rest_places[node]);
    else if (is_within(places[node], at.now.ball.centre, too_near * at.now.ball.radius))
      find_rules(at, at.now, CellPart(), places[node]);
    else
      found.push_back(regular);
    return found;
  }

  /** The rules on a part as seen from @p x; both are in the position that decides. */
  void PlacedSurface::find_rules(Cell &cell, Geometry &decisive, const CellPart &part,
                                 const Point<3> &x)
  {
    auto known = decisive.balls.find(part);
    if (known == decisive.balls.end())
      known = decisive.balls.insert({part, make_ball(decisive.nodes, part)}).first;
    const Ball  &ball = known->second;
    unsigned int kind = 0;
    while (kind < ReferenceRules::n_gauss && is_within(x, ball.centre, nearest[kind] * ball.radius))
      ++kind;
    if (kind == ReferenceRules::n_gauss && part.levels[ball.longer_side] < finest_level)
      for (unsigned int half = 0; half < 2; ++half)
        find_rules(cell, decisive, part.get_half(ball.longer_side, half), x);
    else
      use_rule(cell, std::min(kind, ReferenceRules::n_gauss - 1), part);
  }

  void PlacedSurface::use_rule(Cell &cell, const unsigned int kind, const CellPart &part)
  {
    const unsigned int n_rules = cell.rules.size();
    const auto [entry, is_new] = cell.numbers.insert({{kind, part}, n_rules});
    if (is_new)
      cell.rules.emplace_back(rules.get(kind, part), cell.now.nodes);
    found.push_back(entry->second);
  }
} // namespace caudal::ideal
