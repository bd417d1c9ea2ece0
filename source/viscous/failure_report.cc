#include <caudal/viscous/failure_report.h>

#include <boost/serialization/utility.hpp>

#include <cmath>
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
      const auto                          &data    = solid.get_quadrature_data();
      const auto                          &element = solid.get_dof_handler().get_fe();
      std::vector<types::global_dof_index> dofs(element.n_dofs_per_cell());
      Extreme<dim>                         smallest;
      smallest.value = std::numeric_limits<double>::max();
      for (const auto &cell : solid.get_dof_handler().active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int q = 0; q < data.n_q; ++q)
        {
          Tensor<2, dim> F;
          Point<dim>     mean;
          for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const auto [d, a] = element.system_to_component_index(i);
            F[d] += x[dofs[i]] * data.shape_gradients[cell->active_cell_index() * data.n_q + q][a];
            mean[d] += x[dofs[i]] * dim / dofs.size();
          }
          const double J = determinant(F);
          if (!(J >= smallest.value))
            smallest = {J, cell->active_cell_index(), mean};
        }
      }
      return smallest;
    }

    template <int dim>
    Extreme<dim> find_fastest_flow(const FluidSpace<dim> &space, const FieldVector &velocity)
    {
      const FESystem<dim>                 &element = space.velocity_element;
      std::vector<types::global_dof_index> dofs(element.n_dofs_per_cell());
      Extreme<dim>                         fastest;
      for (const auto &cell : space.velocity_dofs.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          cell->get_dof_indices(dofs);
          std::vector<Tensor<1, dim>> nodes(dofs.size() / dim);
          for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const auto [d, a] = element.system_to_component_index(i);
            nodes[a][d]       = velocity(dofs[i]);
          }
          for (const Tensor<1, dim> &u : nodes)
            if (u.norm() > fastest.value)
              fastest = {u.norm(), 0, cell->center()};
        }
      const MPI_Comm communicator = space.get_communicator();
      const auto     all =
          Utilities::MPI::all_gather(communicator, std::make_pair(fastest.value, fastest.place));
      for (const auto &[value, place] : all)
        if (value > fastest.value)
          fastest = {value, 0, place};
      return fastest;
    }

    /** The node of the body that is nearest to a side. */
    template <int dim>
    Extreme<dim> find_nearest_to_side(const SolidBody<dim> &solid, const BoundingBox<dim> &domain)
    {
      Extreme<dim> nearest;
      nearest.value = std::numeric_limits<double>::max();
      for (const auto &node : solid.get_nodes())
      {
        Point<dim> point;
        for (unsigned int d = 0; d < dim; ++d)
          point[d] = solid.positions[node[d]];
        for (unsigned int d = 0; d < dim; ++d)
          for (const double distance :
               {point[d] - domain.lower_bound(d), domain.upper_bound(d) - point[d]})
            if (distance < nearest.value)
              nearest = {distance, 0, point};
      }
      return nearest;
    }

    std::string get_advice(const FailureKind kind)
    {
      switch (kind)
      {
      case FailureKind::no_convergence:
        return "Likely the forces on a body change too much within a step, or the tolerance is "
               "below the round-off: reduce Time/Step (or set Time/Adaptive), soften the feedback "
               "springs, or increase Solver/Tolerance or Solver/Largest number of iterations.";
      case FailureKind::inverted_element:
        return "Likely the body is pushed together there faster than the step or its elements "
               "resolve: reduce Time/Step, the force of the muscle, or increase Body/Region/"
               "Volumetric stabilisation; a finer fluid grid (Domain/Levels) keeps volumes better.";
      case FailureKind::not_finite:
        return "Likely the flow or a force grew without bound: reduce Time/Step, look at the "
               "forces and at the inflow that the parameters prescribe, and at the last rows of "
               "statistics.txt.";
      case FailureKind::other:
        break;
      }
      return "";
    }
  } // namespace

  template <int dim>
  std::string describe_failure(const FailureKind kind, const ImmersedSystem<dim> &system,
                               const BoundingBox<dim> &domain)
  {
    std::ostringstream text;
    text << get_advice(kind) << (kind == FailureKind::other ? "" : " ") << "Where to look:";
    const Extreme<dim> flow = find_fastest_flow(system.space, system.fluid.velocity);
    text << " the fastest flow of the last good state, " << flow.value
         << " m/s, is in the cell at (" << flow.place << ") m";
    for (const auto &body : system.bodies)
    {
      const Extreme<dim> before  = find_smallest_jacobian(body->solid, body->solid.positions);
      const Extreme<dim> trial   = find_smallest_jacobian(body->solid, body->new_positions);
      const Extreme<dim> nearest = find_nearest_to_side(body->solid, domain);
      text << "; body " << body->get_name() << " has its smallest J, " << before.value
           << ", in element " << before.cell << " at (" << before.place << ") m";
      if (!(std::abs(trial.value - before.value) < 1e-3))
        text << ", in the failed step " << trial.value << " in element " << trial.cell << " at ("
             << trial.place << ") m";
      text << ", and is nearest to a side at (" << nearest.place << ") m, " << nearest.value
           << " m from it";
    }
    text << ".";
    return text.str();
  }

  template std::string describe_failure(FailureKind, const ImmersedSystem<2> &,
                                        const BoundingBox<2> &);
  template std::string describe_failure(FailureKind, const ImmersedSystem<3> &,
                                        const BoundingBox<3> &);
} // namespace caudal
