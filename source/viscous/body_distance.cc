// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/viscous/body_distance.h>

namespace caudal
{
  namespace
  {
    template <int dim>
    std::vector<Point<dim>> get_points(const Body<dim> &body, const BodyState &state)
    {
      std::vector<Point<dim>> points;
      for (const auto &node : body.get_solid().get_nodes())
        points.push_back(get_value(state.positions, node));
      return points;
    }

    /** A sentence on two bodies if a point of each is closer to one of the other than @p smallest.
     */
    template <int dim>
    void check_pair(const std::string &name, const std::vector<Point<dim>> &points,
                    const std::string &other_name, const std::vector<Point<dim>> &others,
                    const double smallest)
    {
      BoundingBox<dim> reach(others);
      reach.extend(smallest);
      for (const Point<dim> &point : points)
        if (reach.point_inside(point))
          for (const Point<dim> &neighbour : others)
          {
            if (point.distance_square(neighbour) >= smallest * smallest)
              continue;
            std::ostringstream text;
            text << "Bodies " << name << " and " << other_name << " are "
                 << point.distance(neighbour) << " m apart near (" << point << "), less than the "
                 << smallest << " m that grid and kernel resolve. Place them further apart (Body "
                 << other_name
                 << "/Shape/Position), steer them (Body/Controller) or refine the grid "
                    "(Domain/Levels).";
            AssertThrow(false, ExcBodiesMeet(text.str()));
          }
    }
  } // namespace

  template <int dim>
  void check_distances(const Operators<dim> &operators, const std::vector<BodyState> &states)
  {
    const auto  &lattice = operators.lattice;
    const double cell_size =
        lattice.get_cell_size(lattice.get_finest_level()).norm() / std::sqrt(dim);
    const double smallest = cell_size * std::max(1., 2 * operators.coupling.get_support());
    for (unsigned int i = 0; i < states.size(); ++i)
      for (unsigned int j = 0; j < i; ++j)
        check_pair(operators.bodies[j]->get_name(), get_points(*operators.bodies[j], states[j]),
                   operators.bodies[i]->get_name(), get_points(*operators.bodies[i], states[i]),
                   smallest);
  }

  template void check_distances(const Operators<2> &, const std::vector<BodyState> &);
  template void check_distances(const Operators<3> &, const std::vector<BodyState> &);
} // namespace caudal
