// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/collective.h>
#include <caudal/base/expression.h>
#include <caudal/observe/observer.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/numerics/vector_tools_integrate_difference.h>

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

      /** The pressure may have any mean, which is removed from its error. */
      void set_columns(const Observation<dim> &observation, Statistics &statistics) const override
      {
        if (solution.empty())
          return;
        Expression<dim> exact = make_solution();
        exact.set_time(observation.time);
        const Tensor<1, dim> origin   = restrict_to<dim>(observation.origin);
        const auto           get_part = [&](const unsigned int begin, const unsigned int end) {
          std::vector<std::function<double(const Point<dim> &)>> components;
          for (unsigned int c = begin; c < end; ++c)
            components.push_back(
                [&exact, origin, c](const Point<dim> &x) { return exact.value(x + origin, c); });
          return FunctionFromFunctionObjects<dim>(components);
        };
        const auto velocity = get_part(0, dim), pressure = get_part(dim, dim + 1);

        const FluidSpace<dim> &space = observation.space;
        const FluidState<dim> &fluid = observation.fluid;
        const auto compute_error     = [&](const DoFHandler<dim> &dofs, const FieldVector &field,
                                       const Function<dim>        &function,
                                       const VectorTools::NormType norm) {
          Vector<double> errors(space.get_triangulation().n_active_cells());
          run_on_all(space.get_communicator(), [&]() {
            VectorTools::integrate_difference(dofs, field, function, errors, QGauss<dim>(5), norm);
          });
          return VectorTools::compute_global_error(space.get_triangulation(), errors, norm);
        };
        const double velocity_error =
            compute_error(space.velocity_dofs, fluid.velocity, velocity, VectorTools::L2_norm);
        const double pressure_norm =
            compute_error(space.pressure_dofs, fluid.pressure, pressure, VectorTools::L2_norm);
        const double integral =
            compute_error(space.pressure_dofs, fluid.pressure, pressure, VectorTools::mean);
        const double square = pressure_norm * pressure_norm -
                              integral * integral / GridTools::volume(space.get_triangulation());
        statistics.set("velocity error", dim == 2 ? "m^2/s" : "m^2.5/s", velocity_error);
        statistics.set("pressure error", dim == 2 ? "Pa m" : "Pa m^1.5",
                       std::sqrt(std::max(square, 0.)));
      }

    private:
      std::string solution;

      Expression<dim> make_solution() const
      {
        return Expression<dim>("Fluid/Exact solution", solution, dim + 1);
      }
    };

    const DimensionalRegistration<Observer, ErrorNorms>
        error_norms("error norms", "errors against an exact solution");
  } // namespace
} // namespace caudal
