#include <caudal/ideal/placed_surface.h>

namespace caudal::ideal
{
  namespace
  {
    constexpr unsigned int n = Surface::n_nodes_per_cell;

    // Each Gauss rule serves points that are farther from the centre of the part than this, in
    // its radii. With m points in each direction the error falls as (d + sqrt(d^2 - 1))^(-2m).
    const double nearest[ReferenceRules::n_gauss_rules] = {2.5, 1.85, 1.5, 1.35};

    // What was far away at rest counts as near if it comes nearer than this.
    const double too_near = 2.;

    double square(const double value)
    {
      return value * value;
    }

    // No cell is halved more often than this in either direction.
    const unsigned int finest_level = 6;

    /** The first rule that serves this distance, or the number of rules. */
    unsigned int find_rule(const double distance_square, const double radius)
    {
      unsigned int rule = 0;
      while (rule < ReferenceRules::n_gauss_rules &&
             distance_square < square(nearest[rule] * radius))
        ++rule;
      return rule;
    }
  } // namespace

  PlacedSurface::PlacedSurface(const Surface &surface, const SurfaceMotion &motion,
                               ReferenceRules &rules)
      : surface(surface)
      , motion(motion)
      , rules(rules)
      , rest(motion.rest.empty() ? motion.positions : motion.rest)
      , positions(extract_positions(motion.positions))
      , rest_positions(extract_positions(rest))
  {
    for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
    {
      regular.push_back({CellRule(rules.get_gauss(0, CellPart()), positions[cell]), {}});
      cells.push_back(make_part(rest_positions[cell], CellPart()));
      now.push_back(make_part(positions[cell], CellPart()));
    }
    compute_fluxes();
  }

  PlacedSurface::Positions
  PlacedSurface::extract_positions(const std::vector<Point<3>> &nodes) const
  {
    Positions result(surface.n_cells());
    for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
      for (const auto node : surface.get_nodes(cell))
        result[cell].push_back(nodes[node]);
    return result;
  }

  void PlacedSurface::compute_fluxes()
  {
    const ReferenceRule &rule     = regular[0].rule.get_reference();
    const unsigned int   n_points = rule.n_points;
    fluxes.reinit(surface.n_cells() * n_points, n_motions());
    for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
      for (unsigned int q = 0; q < n_points; ++q)
      {
        double *const      row    = &fluxes(cell * n_points + q, 0);
        const Tensor<1, 3> N      = regular[cell].rule.get_area(q);
        const Tensor<1, 3> moment = cross_product_3d(regular[cell].rule.get_point(q), N);
        const auto        &nodes  = surface.get_nodes(cell);
        for (unsigned int d = 0; d < 3; ++d)
        {
          row[d]     = moment[d];
          row[3 + d] = N[d];
        }
        for (unsigned int mode = 0; mode < motion.modes.size(); ++mode)
          for (unsigned int k = 0; k < n; ++k)
            row[6 + mode] += rule.values[q * rule.stride + k] * (motion.modes[mode][nodes[k]] * N);
      }
  }

  std::unique_ptr<PlacedSurface::Part> PlacedSurface::make_part(const std::vector<Point<3>> &nodes,
                                                                const CellPart              &place)
  {
    const CellRule outline(rules.get_outline(place), nodes);
    auto           part = std::make_unique<Part>();
    part->place         = place;
    part->centre        = outline.get_point(4);
    for (unsigned int q = 0; q < outline.get_reference().n_points; ++q)
      part->radius = std::max(part->radius, part->centre.distance(outline.get_point(q)));
    const double width  = outline.get_point(3).distance(outline.get_point(5));
    const double height = outline.get_point(1).distance(outline.get_point(7));
    part->longer        = width > height ? 0 : 1;
    return part;
  }

  bool PlacedSurface::is_far(const unsigned int cell, const unsigned int node) const
  {
    const Part &at_rest = *cells[cell], &at_present = *now[cell];
    return rest[node].distance_square(at_rest.centre) >= square(nearest[0] * at_rest.radius) &&
           motion.positions[node].distance_square(at_present.centre) >=
               square(too_near * at_present.radius);
  }

  const std::vector<PlacedRule *> &PlacedSurface::find_near(const unsigned int cell,
                                                            const unsigned int node)
  {
    found.clear();
    if (rest[node].distance_square(cells[cell]->centre) < square(nearest[0] * cells[cell]->radius))
      find_rules(cell, *cells[cell], rest_positions[cell], rest[node]);
    else
      find_rules(cell, *now[cell], positions[cell], motion.positions[node]);
    return found;
  }

  void PlacedSurface::find_rules(const unsigned int cell, Part &part,
                                 const std::vector<Point<3>> &decisive, const Point<3> &x)
  {
    unsigned int rule = find_rule(x.distance_square(part.centre), part.radius);
    if (rule == ReferenceRules::n_gauss_rules && part.place.levels[part.longer] < finest_level)
    {
      for (unsigned int half = 0; half < 2; ++half)
      {
        if (!part.halves[half])
          part.halves[half] = make_part(decisive, part.place.get_half(part.longer, half));
        find_rules(cell, *part.halves[half], decisive, x);
      }
      return;
    }
    rule = std::min(rule, ReferenceRules::n_gauss_rules - 1);
    if (!part.rules[rule])
      part.rules[rule] = std::make_unique<PlacedRule>(
          PlacedRule{CellRule(rules.get_gauss(rule, part.place), positions[cell]), {}});
    found.push_back(part.rules[rule].get());
  }

  PlacedRule &PlacedSurface::get_singular(const unsigned int cell, const unsigned int node)
  {
    singular.rule.place(rules.get_singular(node), positions[cell]);
    return singular;
  }

  void PlacedSurface::visit_rules(const unsigned int                       cell,
                                  const std::function<void(PlacedRule &)> &visit)
  {
    visit(regular[cell]);
    visit_part(*cells[cell], visit);
    visit_part(*now[cell], visit);
  }

  void PlacedSurface::visit_part(Part &part, const std::function<void(PlacedRule &)> &visit)
  {
    for (const auto &rule : part.rules)
      if (rule)
        visit(*rule);
    for (const auto &half : part.halves)
      if (half)
        visit_part(*half, visit);
  }
} // namespace caudal::ideal
