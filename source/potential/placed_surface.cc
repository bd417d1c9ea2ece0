#include <caudal/potential/placed_surface.h>

namespace caudal::potential
{
  namespace
  {
    constexpr unsigned int n = Surface::n_nodes_per_cell;

    // Each Gauss rule serves points that are farther from the centre of the part than this, in
    // its radii. With m points in each direction the error falls as (d + sqrt(d^2 - 1))^(-2m).
    const double nearest[ReferenceRules::n_gauss_rules] = {3., 2.2, 1.5};

    /** The first rule that serves this distance, or the number of rules. */
    unsigned int find_rule(const double distance_square, const double radius)
    {
      unsigned int rule = 0;
      while (rule < ReferenceRules::n_gauss_rules &&
             distance_square < nearest[rule] * nearest[rule] * radius * radius)
        ++rule;
      return rule;
    }
  } // namespace

  PlacedSurface::PlacedSurface(const Surface &surface, const SurfaceMotion &motion,
                               ReferenceRules &rules)
      : surface(surface)
      , motion(motion)
      , rules(rules)
      , parts(surface.n_cells())
  {
    for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
    {
      positions.emplace_back();
      for (const auto node : surface.get_nodes(cell))
        positions.back().push_back(motion.positions[node]);
      regular.emplace_back(rules.get_gauss(0, 0, 0, 0), positions.back());
      parts[cell].push_back(std::make_unique<Part>(make_part(cell, 0, 0, 0)));
    }
    compute_fluxes();
  }

  void PlacedSurface::compute_fluxes()
  {
    const ReferenceRule &rule     = regular[0].get_reference();
    const unsigned int   n_points = rule.n_points;
    fluxes.reinit(surface.n_cells() * n_points, n_motions());
    for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
      for (unsigned int q = 0; q < n_points; ++q)
      {
        double *const      row    = &fluxes(cell * n_points + q, 0);
        const Tensor<1, 3> N      = regular[cell].get_area(q);
        const Tensor<1, 3> moment = cross_product_3d(regular[cell].get_point(q), N);
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

  PlacedSurface::Part PlacedSurface::make_part(const unsigned int cell, const unsigned int level,
                                               const unsigned int i, const unsigned int j)
  {
    const CellRule outline(rules.get_outline(level, i, j), positions[cell]);
    Part           part;
    part.centre = outline.get_point(4);
    part.radius = 0.;
    for (unsigned int q = 0; q < outline.get_reference().n_points; ++q)
      part.radius = std::max(part.radius, part.centre.distance(outline.get_point(q)));
    return part;
  }

  bool PlacedSurface::is_far(const unsigned int cell, const Point<3> &x) const
  {
    const Part &whole = *parts[cell][0];
    return find_rule(x.distance_square(whole.centre), whole.radius) == 0;
  }

  void PlacedSurface::add_part(const unsigned int cell, const unsigned int level,
                               const unsigned int i, const unsigned int j, const Point<3> &x,
                               CellMoments &moments)
  {
    const unsigned int number = ReferenceRules::get_number(level, i, j);
    if (number >= parts[cell].size())
      parts[cell].resize(ReferenceRules::get_number(level + 1, 0, 0));
    if (!parts[cell][number])
      parts[cell][number] = std::make_unique<Part>(make_part(cell, level, i, j));
    Part        &part = *parts[cell][number];
    unsigned int rule = find_rule(x.distance_square(part.centre), part.radius);
    if (rule == ReferenceRules::n_gauss_rules && level < ReferenceRules::finest_level)
    {
      for (unsigned int child = 0; child < 4; ++child)
        add_part(cell, level + 1, 2 * i + child % 2, 2 * j + child / 2, x, moments);
      return;
    }
    rule = std::min(rule, ReferenceRules::n_gauss_rules - 1);
    if (!part.rules[rule])
      part.rules[rule] =
          std::make_unique<CellRule>(rules.get_gauss(rule, level, i, j), positions[cell]);
    add_moments(*part.rules[rule], x, moments);
  }

  void PlacedSurface::add_singular(const unsigned int cell, const unsigned int node,
                                   CellMoments &moments)
  {
    singular.place(rules.get_singular(node), positions[cell]);
    add_moments(singular, positions[cell][node], moments);
  }
} // namespace caudal::potential
