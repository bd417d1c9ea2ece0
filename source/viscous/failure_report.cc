// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/viscous/body_resolution.h>
#include <caudal/viscous/failure_report.h>

#include <boost/serialization/utility.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>

namespace caudal
{
  namespace
  {
    /** An extreme value and where it is. */
    template <int dim>
    struct Extreme
    {
      double       value = 0;
      unsigned int cell  = 0;
      Point<dim>   place;
    };

    /** The smallest det F at the quadrature points, where the element's nodes are on average. */
    template <int dim>
    Extreme<dim> find_smallest_jacobian(const SolidBody<dim> &solid, const Vector<double> &x)
    {
      Extreme<dim> smallest;
      smallest.value = std::numeric_limits<double>::max();
      for (const auto &cell : solid.get_dof_handler().active_cell_iterators())
      {
        const auto nodes = get_cell_nodes<dim>(cell, x);
        Point<dim> mean;
        for (const Point<dim> &node : nodes)
          mean += node / static_cast<double>(nodes.size());
        for (const auto &point : solid.get_quadrature_points(cell->active_cell_index()))
        {
          const double J = determinant(compute_deformation_gradient(nodes, point.gradients));
          if (!(J >= smallest.value))
            smallest = {J, cell->active_cell_index(), mean};
        }
      }
      return smallest;
    }

    template <int dim>
    Extreme<dim> find_fastest_flow(const FluidSpace<dim> &space, const FieldVector &velocity)
    {
      Vector<double> values(space.velocity_element.n_dofs_per_cell());
      Extreme<dim>   fastest;
      for (const auto &cell : space.velocity_dofs.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          cell->get_dof_values(velocity, values);
          std::vector<Tensor<1, dim>> nodes(values.size() / dim);
          for (unsigned int i = 0; i < values.size(); ++i)
          {
            const auto [d, a] = space.velocity_element.system_to_component_index(i);
            nodes[a][d]       = values[i];
          }
          for (const Tensor<1, dim> &u : nodes)
            if (u.norm() > fastest.value)
              fastest = {u.norm(), 0, cell->center()};
        }
      for (const auto &[value, place] : Utilities::MPI::all_gather(
               space.get_communicator(), std::make_pair(fastest.value, fastest.place)))
        if (value > fastest.value)
          fastest = {value, 0, place};
      return fastest;
    }

    /** The node of the body that is nearest to a side. */
    template <int dim>
    Extreme<dim> find_nearest_to_side(const SolidBody<dim> &solid, const Vector<double> &x,
                                      const BoundingBox<dim> &domain)
    {
      Extreme<dim> nearest;
      nearest.value = std::numeric_limits<double>::max();
      for (const auto &node : solid.get_nodes())
      {
        const Point<dim> point = get_value(x, node);
        for (unsigned int d = 0; d < dim; ++d)
          for (const double distance :
               {point[d] - domain.lower_bound(d), domain.upper_bound(d) - point[d]})
            if (distance < nearest.value)
              nearest = {distance, 0, point};
      }
      return nearest;
    }

    /** What the body has that may make a solver fail, and what to change: sentences. */
    template <int dim>
    std::string describe_stiffness(const Body<dim> &body, const RunParameters<dim> &parameters)
    {
      const SolidParameters<dim> &entries = body.get_solid().get_parameters();
      const double                ratio = measure_resolution(body, parameters.domain).spacing_ratio;
      std::ostringstream          text;
      text << std::setprecision(2);
      if (ratio < finest_ratio)
        text << " The nodes of body " << body.get_name() << " are only " << ratio
             << " of the fluid's finest cells apart, so that it has more motions than the fluid "
                "has there, and the coupled equations are nearly singular: give fewer "
             << entries.get_path() << "/Shape/Elements, or more Domain/Levels.";
      for (unsigned int r = 0; r < entries.regions.size(); ++r)
        if (entries.region_parameters[r]->feedback_stiffness > 0)
          text << " Soften the springs of region " << entries.regions[r] << " of body "
               << body.get_name() << " (Feedback stiffness) if they are the cause.";
      return text.str();
    }

    /** The likely cause of a failure, and what to change. */
    template <int dim>
    std::string advise(const StepFailure &failure, const Operators<dim> &operators)
    {
      const auto &parameters = operators.parameters;
      std::string advice;
      for (const auto &body : operators.bodies)
        advice += describe_stiffness(*body, parameters);
      const std::string smaller_step =
          parameters.time.adaptive ? "" : "reduce Time/Step (or set Time/Adaptive), ";
      const bool has_muscles = std::any_of(operators.bodies.begin(), operators.bodies.end(),
                                           [](const auto &body) { return body->swims(); });
      switch (failure.kind)
      {
      case StepFailure::Kind::not_converged:
        return "Likely " +
               std::string(operators.bodies.empty() ? "the flow changes"
                                                    : "the forces on a body change") +
               " too much within a step, or the tolerance is below the round-off: " + smaller_step +
               "increase Solver/Tolerance or Solver/Largest number of iterations." + advice;
      case StepFailure::Kind::stalled:
        return "Likely the forces change too much within a step: " + smaller_step +
               "or choose Solver/Method = direct." + advice;
      case StepFailure::Kind::inverted_element:
        return "Likely the body is pushed together there faster than the step or its elements "
               "resolve: reduce Time/Step" +
               std::string(has_muscles ? ", the force of the muscle" : "") +
               ", or increase Body/Region/Volumetric stabilisation; a finer fluid grid "
               "(Domain/Levels) keeps volumes better." +
               advice;
      default:
        return "Likely the flow or a force grew without bound: " + smaller_step +
               "look at the forces and at the inflow that the parameters prescribe, and at the "
               "last rows of statistics.txt." +
               advice;
      }
    }
  } // namespace

  template <int dim>
  std::string describe_failure(const StepFailure &failure, const Operators<dim> &operators,
                               const State<dim> &state)
  {
    std::ostringstream   text;
    const Tensor<1, dim> origin = restrict_to<dim>(state.frame.origin);
    const Extreme<dim>   flow   = find_fastest_flow(operators.space, state.fluid.velocity);
    text << advise(failure, operators)
         << " Where to look: the fastest flow of the last good state, " << flow.value
         << " m/s, is in the cell at (" << flow.place + origin << ") m";
    for (unsigned int b = 0; b < operators.bodies.size(); ++b)
    {
      const SolidBody<dim> &solid   = operators.bodies[b]->get_solid();
      const Vector<double> &x       = state.bodies[b].positions;
      const Extreme<dim>    before  = find_smallest_jacobian(solid, x);
      const Extreme<dim>    nearest = find_nearest_to_side(
             solid, place_on_grid(solid, x, state.frame.origin), operators.get_domain());
      text << "; body " << solid.get_name() << " has its smallest J, " << before.value
           << ", in element " << before.cell << " at (" << before.place << ") m";
      if (b < failure.trial_bodies.size())
      {
        const auto trial = find_smallest_jacobian(solid, failure.trial_bodies[b].positions);
        if (!(std::abs(trial.value - before.value) < 1e-3))
          text << ", in the failed step " << trial.value << " in element " << trial.cell << " at ("
               << trial.place << ") m";
      }
      text << ", and is nearest to a side at (" << nearest.place + origin << ") m, "
           << nearest.value << " m from it";
    }
    text << ".";
    return text.str();
  }

  template std::string describe_failure(const StepFailure &, const Operators<2> &,
                                        const State<2> &);
  template std::string describe_failure(const StepFailure &, const Operators<3> &,
                                        const State<3> &);
} // namespace caudal
