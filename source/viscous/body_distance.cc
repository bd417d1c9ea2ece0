#include <caudal/viscous/body_distance.h>

#include <deal.II/base/bounding_box.h>

namespace caudal
{
  namespace
  {
    template <int dim>
    std::vector<Point<dim>> get_points(const SwimmingBody<dim> &body)
    {
      std::vector<Point<dim>> points;
      for (const auto &node : body.solid.get_nodes())
      {
        points.emplace_back();
        for (unsigned int d = 0; d < dim; ++d)
          points.back()[d] = body.new_positions[node[d]];
      }
      return points;
    }

    template <int dim>
    void check_pair(const SwimmingBody<dim> &one, const SwimmingBody<dim> &other,
                    const double smallest)
    {
      const std::vector<Point<dim>> points = get_points(one), others = get_points(other);
      BoundingBox<dim>              reach(others);
      reach.extend(smallest);
      for (const Point<dim> &point : points)
        if (reach.point_inside(point))
          for (const Point<dim> &neighbour : others)
          {
            if (point.distance_square(neighbour) >= smallest * smallest)
              continue;
            std::ostringstream text;
            text << "Bodies " << one.get_name() << " and " << other.get_name() << " are "
                 << point.distance(neighbour) << " m apart near (" << point << "), less than the "
                 << smallest << " m that grid and kernel resolve. Place them further apart (Body "
                 << other.get_name()
                 << "/Shape/Position), steer them (Body/Controller) or refine the grid "
                    "(Domain/Levels).";
            AssertThrow(false, ExcBodiesMeet(text.str()));
          }
    }
  } // namespace

  template <int dim>
  void check_distances(const std::vector<std::unique_ptr<SwimmingBody<dim>>> &bodies,
                       const CellLattice<dim>                                &lattice)
  {
    const double cell_size =
        lattice.get_cell_size(lattice.get_finest_level()).norm() / std::sqrt(dim);
    for (unsigned int i = 0; i < bodies.size(); ++i)
      for (unsigned int j = 0; j < i; ++j)
      {
        const double support =
            std::max(bodies[i]->interaction.get_support(), bodies[j]->interaction.get_support());
        check_pair(*bodies[j], *bodies[i], cell_size * std::max(1., 2 * support));
      }
  }

  template void check_distances(const std::vector<std::unique_ptr<SwimmingBody<2>>> &,
                                const CellLattice<2> &);
  template void check_distances(const std::vector<std::unique_ptr<SwimmingBody<3>>> &,
                                const CellLattice<3> &);
} // namespace caudal
