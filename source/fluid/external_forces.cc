// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fluid/external_forces.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_interface_values.h>

#include <type_traits>

namespace caudal
{
  namespace
  {
    template <int dim>
    using Cell = typename DoFHandler<dim>::active_cell_iterator;

    /** The flow in the quadrature points of a face, as the mean from both sides. */
    template <int dim>
    class FaceFlow
    {
    public:
      FaceFlow(const FluidSpace<dim> &space, const FluidState<dim> &state)
          : space(space)
          , state(state)
          , quadrature(space.velocity_element.degree + 2)
          , velocities(space.velocity_element, quadrature,
                       update_values | update_gradients | update_normal_vectors | update_JxW_values)
          , pressures(space.pressure_element, quadrature, update_values)
          , velocity(quadrature.size())
          , gradient(quadrature.size())
          , pressure(quadrature.size())
      {}

      /** On face @p f of @p cell, whose neighbour there is as fine, coarser or none. */
      void reinit(const Cell<dim> &cell, const unsigned int f)
      {
        const Cell<dim> pressure_cell(*cell, &space.pressure_dofs);
        if (cell->at_boundary(f))
        {
          velocities.reinit(cell, f);
          pressures.reinit(pressure_cell, f);
        }
        else
        {
          std::pair<unsigned int, unsigned int> other{0, numbers::invalid_unsigned_int};
          if (cell->neighbor_is_coarser(f))
            other = cell->neighbor_of_coarser_neighbor(f);
          else
            other.first = cell->neighbor_of_neighbor(f);
          velocities.reinit(cell, f, numbers::invalid_unsigned_int, Cell<dim>(cell->neighbor(f)),
                            other.first, other.second);
          pressures.reinit(pressure_cell, f, numbers::invalid_unsigned_int,
                           Cell<dim>(pressure_cell->neighbor(f)), other.first, other.second);
        }
        const auto components = velocities[FEValuesExtractors::Vector(0)];
        components.get_average_of_function_values(state.velocity, velocity);
        components.get_average_of_function_gradients(state.velocity, gradient);
        pressures.get_average_of_function_values(state.pressure, pressure);
      }

      /** The integral of @p integrand(u, n, -p n + mu du/dn + rho gamma (div u) n) over the face.
       */
      template <class Integrand>
      auto integrate(const Integrand &integrand) const
      {
        const auto &parameters = space.get_parameters();
        std::invoke_result_t<Integrand, Tensor<1, dim>, Tensor<1, dim>, Tensor<1, dim>> sum{};
        for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const Tensor<1, dim> n = velocities.get_normal_vectors()[q];
          const Tensor<1, dim> traction =
              parameters.get_viscosity() * (gradient[q] * n) -
              (pressure[q] - parameters.density * space.get_grad_div() * trace(gradient[q])) * n;
          sum += integrand(velocity[q], n, traction) * velocities.JxW(q);
        }
        return sum;
      }

    private:
      const FluidSpace<dim>      &space;
      const FluidState<dim>      &state;
      const QGauss<dim - 1>       quadrature;
      FEInterfaceValues<dim>      velocities, pressures;
      std::vector<Tensor<1, dim>> velocity;
      std::vector<Tensor<2, dim>> gradient;
      std::vector<double>         pressure;
    };

    /** Whether the coarse cell round @p cell has its centre in the box: so V is the same on all
     * grids. */
    template <int dim>
    bool is_in(const BoundingBox<dim> &box, const CellAccessor<dim> &cell)
    {
      TriaIterator<CellAccessor<dim>> ancestor(&cell.get_triangulation(), cell.level(),
                                               cell.index());
      while (ancestor->level() > 0)
        ancestor = ancestor->parent();
      return box.point_inside(ancestor->center());
    }
  } // namespace

  template <int dim>
  double compute_external_power(const FluidSpace<dim> &space, const FluidState<dim> &state,
                                const Instant &instant, const Tensor<1, dim> &grid_velocity)
  {
    const auto                &parameters = space.get_parameters();
    const BodyForceLoads<dim> &body_force = space.get_body_force_loads(instant);
    const SideLoads<dim>      &tractions  = space.get_side_loads(instant);
    FaceFlow<dim>              flow(space, state);
    Vector<double>             values(space.velocity_element.n_dofs_per_cell());
    double                     power     = 0;
    const auto                 add_loads = [&](const ArrayView<const double> &loads) {
      for (unsigned int i = 0; i < loads.size(); ++i)
        power += loads[i] * values[i];
    };
    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    {
      if (!cell->is_locally_owned())
        continue;
      if (!body_force.are_zero() || !tractions.are_zero())
        cell->get_dof_values(state.velocity, values);
      if (!body_force.are_zero())
        add_loads(body_force.get(cell));
      if (!tractions.are_zero())
        add_loads(tractions.get(cell));
      for (const unsigned int f : cell->face_indices())
      {
        if (!cell->face(f)->at_boundary() || space.is_periodic(f / 2))
          continue;
        // There is none through walls and symmetry planes, unless they move through the fluid.
        const auto &condition = space.get_boundary_condition(cell->face(f)->boundary_id());
        if (!condition.has_velocity() && !condition.is_open() && grid_velocity.norm() == 0.)
          continue;
        flow.reinit(cell, f);
        power += flow.integrate([&](const auto &u, const auto &n, const auto &traction) {
          const bool is_closed = condition.resists_backflow() && parameters.backflow_stabilisation;
          const double through = (u - grid_velocity) * n;
          const double flux    = is_closed ? std::max(through, 0.) : through;
          return (condition.is_open() ? 0. : u * traction) -
                 0.5 * parameters.density * u.norm_square() * flux;
        });
      }
    }
    return Utilities::MPI::sum(power, space.get_communicator());
  }

  template <int dim>
  MomentumBalance<dim> compute_momentum_balance(const FluidSpace<dim>  &space,
                                                const FluidState<dim>  &state,
                                                const BoundingBox<dim> &box, const Instant &instant,
                                                const Tensor<1, dim> &grid_velocity)
  {
    const double               density    = space.get_parameters().density;
    const BodyForceLoads<dim> &body_force = space.get_body_force_loads(instant);
    const FESystem<dim>       &element    = space.velocity_element;
    const unsigned int         n = element.n_dofs_per_cell(), n_s = n / dim;
    FaceFlow<dim>              flow(space, state);
    Vector<double>             values(n), integrals(n_s), one(n_s); // of the shape functions
    one = 1;
    MomentumBalance<dim> balance;
    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    {
      if (!cell->is_locally_owned())
        continue;
      const bool is_inside = is_in(box, *cell);
      if (is_inside)
      {
        cell->get_dof_values(state.velocity, values);
        space.get_cell_matrices(cell->level()).get_mass().vmult(integrals, one);
        for (unsigned int i = 0; i < n; ++i)
        {
          const auto [component, shape] = element.system_to_component_index(i);
          balance.momentum[component] += density * integrals[shape] * values[i];
          if (!body_force.are_zero()) // the shape functions of a component add up to one
            balance.force[component] += body_force.get(cell)[i];
        }
      }
      for (const unsigned int f : cell->face_indices())
      {
        // The finer side of a face counts it, or the inner one of two alike.
        if (cell->face(f)->has_children())
          continue;
        const bool leads_outside = cell->at_boundary(f) || !is_in(box, *cell->neighbor(f));
        if (is_inside != leads_outside || (!is_inside && !cell->neighbor_is_coarser(f)))
          continue;
        flow.reinit(cell, f);
        balance.force += (is_inside ? 1. : -1.) *
                         flow.integrate([&](const auto &u, const auto &n, const auto &traction) {
                           return traction - density * ((u - grid_velocity) * n) * u;
                         });
      }
    }
    const MPI_Comm communicator = space.get_communicator();
    balance.momentum            = Utilities::MPI::sum(balance.momentum, communicator);
    balance.force               = Utilities::MPI::sum(balance.force, communicator);
    return balance;
  }

#define INSTANTIATE(dim)                                                                           \
  template double compute_external_power(const FluidSpace<dim> &, const FluidState<dim> &,         \
                                         const Instant &, const Tensor<1, dim> &);                 \
  template MomentumBalance<dim> compute_momentum_balance(                                          \
      const FluidSpace<dim> &, const FluidState<dim> &, const BoundingBox<dim> &, const Instant &, \
      const Tensor<1, dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
