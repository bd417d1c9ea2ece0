// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/collective.h>
#include <caudal/base/expression.h>
#include <caudal/observe/observer.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    /** Columns with the L2 norms of the errors against an exact solution. */
    template <int dim>
    class ErrorNorms : public Observer<dim>
    {
    public:
      ErrorNorms()
          : Observer<dim>(80)
      {}

      void add_parameters(ParameterHandler &prm) override
      {
        prm.enter_subsection("Fluid");
        prm.add_parameter("Exact solution", solution,
                          "For verification: velocity components [m/s] and pressure [Pa], "
                          "separated by ';'. Their errors become part of the statistics.");
        prm.leave_subsection();
      }

      void check(const std::string & /*path*/) const override
      {
        if (!solution.empty())
          make_solution();
      }

      void set_columns(const Observation<dim> &observation, Statistics &statistics) const override
      {
        if (solution.empty())
          return;
        const auto [velocity_error, pressure_error] = compute_errors(observation);
        statistics.set("velocity error", dim == 2 ? "m^2/s" : "m^2.5/s", velocity_error);
        statistics.set("pressure error", dim == 2 ? "Pa m" : "Pa m^1.5", pressure_error);
      }

    private:
      std::string solution;

      Expression<dim> make_solution() const
      {
        return Expression<dim>("Fluid/Exact solution", solution, dim + 1);
      }

      /** Errors of velocity and pressure; the pressure's may have any mean, which is removed. */
      std::pair<double, double> compute_errors(const Observation<dim> &observation) const
      {
        Expression<dim> exact = make_solution();
        exact.set_time(observation.time);
        const FluidSpace<dim> &space = observation.space;
        const QGauss<dim>      quadrature(5);
        FEValues<dim>          velocity(space.velocity_element, quadrature, update_values);
        FEValues<dim>          pressure(space.pressure_element, quadrature,
                                        update_values | update_quadrature_points | update_JxW_values);
        const FEValuesExtractors::Vector all_components(0);
        std::vector<Tensor<1, dim>>      velocities(quadrature.size());
        std::vector<double>              pressures(quadrature.size());
        std::vector<Vector<double>>      exact_values(quadrature.size(), Vector<double>(dim + 1));

        double volume = 0, velocity_square = 0, mean = 0, square = 0;
        run_on_all(space.get_communicator(), [&]() {
          auto pressure_cell = space.pressure_dofs.begin_active();
          for (const auto &cell : space.velocity_dofs.active_cell_iterators())
          {
            if (cell->is_locally_owned())
            {
              velocity.reinit(cell);
              pressure.reinit(pressure_cell);
              velocity[all_components].get_function_values(observation.fluid.velocity, velocities);
              pressure.get_function_values(observation.fluid.pressure, pressures);
              exact.vector_value_list(pressure.get_quadrature_points(), exact_values);
              for (unsigned int q = 0; q < quadrature.size(); ++q)
              {
                const double weight = pressure.JxW(q);
                const double error  = pressures[q] - exact_values[q][dim];
                volume += weight;
                mean += error * weight;
                square += error * error * weight;
                for (unsigned int d = 0; d < dim; ++d)
                  velocity_square +=
                      weight * Utilities::fixed_power<2>(velocities[q][d] - exact_values[q][d]);
              }
            }
            ++pressure_cell;
          }
        });
        const auto sum = [&](const double value) {
          return Utilities::MPI::sum(value, space.get_communicator());
        };
        volume = sum(volume);
        mean   = sum(mean) / volume;
        square = sum(square);
        return {std::sqrt(sum(velocity_square)),
                std::sqrt(std::max(square - mean * mean * volume, 0.))};
      }
    };

    const DimensionalRegistration<Observer, ErrorNorms>
        error_norms("error norms", "errors against an exact solution");
  } // namespace
} // namespace caudal
