// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fluid/control_volume.h>
#include <caudal/fluid/face_flow.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <map>

namespace caudal
{
  namespace
  {
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

    /** Evaluates forces and fluxes on faces of the control volume. */
    template <int dim>
    class SurfaceForce
    {
    public:
      using Cell = typename Triangulation<dim>::active_cell_iterator;

      SurfaceForce(const FluidSpace<dim> &space, const FluidState<dim> &state)
          : space(space)
          , state(state)
          , quadrature(space.velocity_element.degree + 2)
          , velocity_face(space.velocity_element, quadrature,
                          update_values | update_gradients | update_normal_vectors |
                              update_JxW_values)
          , pressure_face(space.pressure_element, quadrature, update_values)
          , velocity_subface(space.velocity_element, quadrature, update_values | update_gradients)
          , pressure_subface(space.pressure_element, quadrature, update_values)
          , neighbour_velocity_face(space.velocity_element, quadrature,
                                    update_values | update_gradients)
          , neighbour_pressure_face(space.pressure_element, quadrature, update_values)
      {}

      /** The force through face @p f of @p cell, its neighbour being as fine, coarser or none. */
      Tensor<1, dim> compute(const Cell &cell, const unsigned int f)
      {
        velocity_face.reinit(on(space.velocity_dofs, cell), f);
        pressure_face.reinit(on(space.pressure_dofs, cell), f);
        inside.evaluate(velocity_face, pressure_face, state);
        evaluate_neighbour(cell, f);

        const auto    &parameters = space.get_parameters();
        Tensor<1, dim> force;
        for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const Tensor<1, dim> &n        = velocity_face.normal_vector(q);
          const Tensor<2, dim>  gradient = 0.5 * (inside.gradient[q] + outside.gradient[q]);
          const double          pressure = 0.5 * (inside.pressure[q] + outside.pressure[q]) -
                                  parameters.density * parameters.grad_div * trace(gradient);
          const Tensor<1, dim> &u = inside.velocity[q];
          force += (parameters.get_viscosity() * (gradient * n) - pressure * n -
                    parameters.density * (u * n) * u) *
                   velocity_face.JxW(q);
        }
        return force;
      }

    private:
      const FluidSpace<dim> &space;
      const FluidState<dim> &state;
      const QGauss<dim - 1>  quadrature;
      FEFaceValues<dim>      velocity_face, pressure_face;
      FESubfaceValues<dim>   velocity_subface, pressure_subface;
      FEFaceValues<dim>      neighbour_velocity_face, neighbour_pressure_face;
      FaceFlow<dim>          inside, outside;

      static typename DoFHandler<dim>::active_cell_iterator on(const DoFHandler<dim> &dofs,
                                                               const Cell            &cell)
      {
        return typename DoFHandler<dim>::active_cell_iterator(&dofs.get_triangulation(),
                                                              cell->level(), cell->index(), &dofs);
      }

      void evaluate_neighbour(const Cell &cell, const unsigned int f)
      {
        if (cell->at_boundary(f))
        {
          outside = inside;
          return;
        }
        const Cell neighbour = cell->neighbor(f);
        if (cell->neighbor_is_coarser(f))
        {
          const auto [face, subface] = cell->neighbor_of_coarser_neighbor(f);
          velocity_subface.reinit(on(space.velocity_dofs, neighbour), face, subface);
          pressure_subface.reinit(on(space.pressure_dofs, neighbour), face, subface);
          outside.evaluate(velocity_subface, pressure_subface, state);
          return;
        }
        const unsigned int face = cell->neighbor_of_neighbor(f);
        neighbour_velocity_face.reinit(on(space.velocity_dofs, neighbour), face);
        neighbour_pressure_face.reinit(on(space.pressure_dofs, neighbour), face);
        outside.evaluate(neighbour_velocity_face, neighbour_pressure_face, state);
      }
    };

    /** rho int_V u of this rank's cells */
    template <int dim>
    Tensor<1, dim> integrate_momentum(const FluidSpace<dim> &space, const FieldVector &velocity,
                                      const BoundingBox<dim> &box)
    {
      const FESystem<dim> &element = space.velocity_element;
      const unsigned int   n = element.n_dofs_per_cell(), n_s = n / dim;
      Vector<double>       values(n), one(n_s);
      one = 1;
      std::map<int, Vector<double>> integrals; // of the shape functions, by level
      Tensor<1, dim>                momentum;
      for (const auto &cell : space.velocity_dofs.active_cell_iterators())
        if (cell->is_locally_owned() && is_in(box, *cell))
        {
          Vector<double> &integral = integrals[cell->level()];
          if (integral.size() == 0)
          {
            integral.reinit(n_s);
            space.get_cell_matrices(cell->level()).get_mass().vmult(integral, one);
          }
          cell->get_dof_values(velocity, values);
          for (unsigned int i = 0; i < n; ++i)
          {
            const auto [component, shape] = element.system_to_component_index(i);
            momentum[component] += integral[shape] * values[i];
          }
        }
      return space.get_parameters().density * momentum;
    }

    /** int_V f of this rank's cells: the shape functions of a component add up to one. */
    template <int dim>
    Tensor<1, dim> integrate_body_force(const FluidSpace<dim> &space, const BoundingBox<dim> &box,
                                        const double time)
    {
      Tensor<1, dim>             force;
      const BodyForceLoads<dim> &body_force = space.get_body_force_loads(time);
      if (body_force.are_zero())
        return force;
      for (const auto &cell : space.velocity_dofs.active_cell_iterators())
        if (cell->is_locally_owned() && is_in(box, *cell))
        {
          const auto loads = body_force.get(cell);
          for (unsigned int i = 0; i < loads.size(); ++i)
            force[space.velocity_element.system_to_component_index(i).first] += loads[i];
        }
      return force;
    }
  } // namespace

  template <int dim>
  MomentumBalance<dim> compute_momentum_balance(const FluidSpace<dim>  &space,
                                                const FluidState<dim>  &state,
                                                const BoundingBox<dim> &box, const double time)
  {
    MomentumBalance<dim> balance;
    balance.momentum = integrate_momentum(space, state.velocity, box);
    balance.force    = integrate_body_force(space, box, time);
    SurfaceForce<dim> surface(space, state);
    for (const auto &cell : space.get_triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
      {
        const bool is_inside = is_in(box, *cell);
        for (const unsigned int f : cell->face_indices())
        {
          // The finer side of a face counts it, or the inner one of two alike.
          if (cell->face(f)->has_children())
            continue;
          const bool at_boundary   = cell->at_boundary(f);
          const bool leads_outside = at_boundary || !is_in(box, *cell->neighbor(f));
          if (is_inside && leads_outside)
            balance.force += surface.compute(cell, f);
          else if (!is_inside && !leads_outside && cell->neighbor_is_coarser(f))
            balance.force -= surface.compute(cell, f);
        }
      }
    const MPI_Comm communicator = space.get_communicator();
    balance.momentum            = Utilities::MPI::sum(balance.momentum, communicator);
    balance.force               = Utilities::MPI::sum(balance.force, communicator);
    return balance;
  }

  template MomentumBalance<2> compute_momentum_balance(const FluidSpace<2> &, const FluidState<2> &,
                                                       const BoundingBox<2> &, double);
  template MomentumBalance<3> compute_momentum_balance(const FluidSpace<3> &, const FluidState<3> &,
                                                       const BoundingBox<3> &, double);
} // namespace caudal
