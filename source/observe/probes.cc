// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/observer.h>

#include <deal.II/grid/grid_tools.h>

#include <sstream>

namespace caudal
{
  namespace
  {
    /** Columns with velocity and pressure at points of the domain. */
    template <int dim>
    class Probes : public Observer<dim>
    {
    public:
      Probes()
          : Observer<dim>(70)
      {}

      void add_parameters(ParameterHandler &prm) override
      {
        prm.enter_subsection("Fluid");
        prm.add_parameter("Probes", points,
                          "Points of the domain at which velocity and pressure become part of the "
                          "statistics; coordinates separated by ',', points by ';' [m].");
        prm.leave_subsection();
      }

      void check_case(const Observation<dim> &start) const override
      {
        const BoundingBox<dim> domain =
            GridTools::compute_bounding_box(start.space.get_triangulation());
        for (const Point<dim> &point : points)
        {
          std::ostringstream place;
          place << "(" << point << ")";
          AssertThrow(domain.point_inside(point),
                      ExcMessage("Fluid/Probes: the point " + place.str() +
                                 " is outside of the domain. Move it, or change Domain/Size."));
        }
      }

      void set_columns(const Observation<dim> &observation, Statistics &statistics) const override
      {
        for (unsigned int k = 0; k < points.size(); ++k)
        {
          const std::string place  = " at probe " + std::to_string(k + 1);
          const auto        values = evaluate_at(observation.space, observation.fluid, points[k]);
          for (unsigned int d = 0; d < dim; ++d)
            statistics.set("uvw"[d] + place, "m/s", values.velocity[d]);
          statistics.set("p" + place, "Pa", values.pressure);
        }
      }

    private:
      std::vector<Point<dim>> points;
    };

    const DimensionalRegistration<Observer, Probes> probes("probes",
                                                           "velocity and pressure at points");
  } // namespace
} // namespace caudal
