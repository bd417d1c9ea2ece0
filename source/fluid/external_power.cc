// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fluid/external_power.h>
#include <caudal/fluid/face_flow.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

namespace caudal
{
  namespace
  {
    /** Evaluates what acts on the fluid at faces of its sides. */
    template <int dim>
    class SidePower
    {
    public:
      using Cell = typename DoFHandler<dim>::active_cell_iterator;

      SidePower(const FluidSpace<dim> &space, const FluidState<dim> &state)
          : space(space)
          , state(state)
          , quadrature(space.velocity_element.degree + 2)
          , velocities(space.velocity_element, quadrature,
                       update_values | update_gradients | update_normal_vectors | update_JxW_values)
          , pressures(space.pressure_element, quadrature, update_values)
      {}

      /** Power through face @p f of @p cell; none at walls and symmetry planes. */
      double compute(const Cell &cell, const unsigned int f)
      {
        const auto &condition = space.get_boundary_condition(cell->face(f)->boundary_id());
        if (!condition.has_velocity() && !condition.is_open())
          return 0.;
        velocities.reinit(cell, f);
        pressures.reinit(Cell(*cell, &space.pressure_dofs), f);
        flow.evaluate(velocities, pressures, state);

        const auto &parameters = space.get_parameters();
        double      power      = 0.;
        for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const Tensor<1, dim> &n = velocities.normal_vector(q), &u = flow.velocity[q];
          double                flux = u * n, stress_power = 0.;
          if (condition.is_open())
            flux = parameters.backflow_stabilisation ? std::max(flux, 0.) : flux;
          else
            stress_power = parameters.get_viscosity() * (u * (flow.gradient[q] * n)) -
                           (flow.pressure[q] -
                            parameters.density * parameters.grad_div * trace(flow.gradient[q])) *
                               flux;
          power += (stress_power - 0.5 * parameters.density * u.norm_square() * flux) *
                   velocities.JxW(q);
        }
        return power;
      }

    private:
      const FluidSpace<dim> &space;
      const FluidState<dim> &state;
      const QGauss<dim - 1>  quadrature;
      FEFaceValues<dim>      velocities, pressures;
      FaceFlow<dim>          flow;
    };

    /** int f.u over the cells of this rank */
    template <int dim>
    double compute_body_force_power(const FluidSpace<dim> &space, const FieldVector &velocity,
                                    const double time)
    {
      const BodyForceLoads<dim> &body_force = space.get_body_force_loads(time);
      if (body_force.are_zero())
        return 0.;
      Vector<double> values(space.velocity_element.n_dofs_per_cell());
      double         power = 0.;
      for (const auto &cell : space.velocity_dofs.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          cell->get_dof_values(velocity, values);
          const auto loads = body_force.get(cell);
          for (unsigned int i = 0; i < loads.size(); ++i)
            power += loads[i] * values[i];
        }
      return power;
    }
  } // namespace

  template <int dim>
  double compute_external_power(const FluidSpace<dim> &space, const FluidState<dim> &state,
                                const double time)
  {
    SidePower<dim> sides(space, state);
    double         power = compute_body_force_power(space, state.velocity, time);
    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary())
            power += sides.compute(cell, f);
    return Utilities::MPI::sum(power, space.get_communicator());
  }

  template double compute_external_power(const FluidSpace<2> &, const FluidState<2> &, double);
  template double compute_external_power(const FluidSpace<3> &, const FluidState<3> &, double);
} // namespace caudal
