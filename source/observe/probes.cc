// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/observer.h>

#include <deal.II/base/geometry_info.h>
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
        prm.add_parameter(
            "Probes", points,
            "Points of the domain at which velocity and pressure become part of the "
            "statistics; coordinates separated by ',', points by ';' [m]. They move with "
            "Domain/Frame.");
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
          const std::string place         = " at probe " + std::to_string(k + 1);
          const auto [velocity, pressure] = evaluate(observation, points[k]);
          for (unsigned int d = 0; d < dim; ++d)
            statistics.set("uvw"[d] + place, "m/s", velocity[d]);
          statistics.set("p" + place, "Pa", pressure);
        }
      }

    private:
      std::vector<Point<dim>> points;

      /**
       * Velocity and pressure; the pressure, which jumps from cell to cell, is the mean of those of
       * all cells that meet at the point.
       */
      static std::pair<Tensor<1, dim>, double> evaluate(const Observation<dim> &observation,
                                                        const Point<dim>       &point)
      {
        const FluidSpace<dim> &space = observation.space;
        Vector<double>         velocities(space.velocity_element.n_dofs_per_cell());
        Vector<double>         pressures(space.pressure_element.n_dofs_per_cell());
        Tensor<1, dim>         velocity;
        double                 pressure = 0, n_cells = 0;
        for (const auto &cell : space.velocity_dofs.active_cell_iterators())
        {
          // Place in the cell, which is a box; a little outside is on its side.
          Point<dim> place;
          for (unsigned int d = 0; d < dim; ++d)
            place[d] = (point[d] - cell->vertex(0)[d]) / space.get_cell_size(cell->level())[d];
          if (!cell->is_locally_owned() || !GeometryInfo<dim>::is_inside_unit_cell(place, 1e-8))
            continue;
          ++n_cells;
          cell->get_dof_values(observation.fluid.velocity, velocities);
          for (unsigned int i = 0; i < velocities.size(); ++i)
            velocity[space.velocity_element.system_to_component_index(i).first] +=
                velocities[i] * space.velocity_element.shape_value(i, place);
          typename DoFHandler<dim>::active_cell_iterator(*cell, &space.pressure_dofs)
              ->get_dof_values(observation.fluid.pressure, pressures);
          for (unsigned int i = 0; i < pressures.size(); ++i)
            pressure += pressures[i] * space.pressure_element.shape_value(i, place);
        }
        const MPI_Comm communicator = space.get_communicator();
        n_cells                     = Utilities::MPI::sum(n_cells, communicator);
        Assert(n_cells > 0, ExcMessage("The point is outside of the domain."));
        return {Utilities::MPI::sum(velocity, communicator) / n_cells,
                Utilities::MPI::sum(pressure, communicator) / n_cells};
      }
    };

    const DimensionalRegistration<Observer, Probes> probes("probes",
                                                           "velocity and pressure at points");
  } // namespace
} // namespace caudal
