#include <caudal/fluid/fluid_space.h>

#include <caudal/base/collective.h>
#include <caudal/base/expression.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/numerics/vector_tools_boundary.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    const std::string inflow_path = "Fluid/Inflow velocity";

    /** The inflow velocity times the ramp, refused where it is not finite. */
    template <int dim>
    class RampedInflow : public Function<dim>
    {
    public:
      RampedInflow(const Function<dim> &velocity, const double ramp, const std::string &expression)
          : Function<dim>(dim)
          , velocity(velocity)
          , ramp(ramp)
          , expression(expression)
      {}

      double value(const Point<dim> &point, const unsigned int component) const override
      {
        check_finite(inflow_path, expression, velocity, point);
        return ramp * velocity.value(point, component);
      }

    private:
      const Function<dim> &velocity;
      const double         ramp;
      const std::string   &expression;
    };
  } // namespace

  template <int dim>
  FluidSpace<dim>::FluidSpace(parallel::distributed::Triangulation<dim> &triangulation,
                              const DomainParameters<dim>               &domain,
                              const FluidParameters<dim>                &parameters)
      : velocity_element(FE_Q<dim>(2), dim)
      , pressure_element(1)
      , velocity_dofs(triangulation)
      , pressure_dofs(triangulation)
      , triangulation(triangulation)
      , parameters(parameters)
      , domain_size(domain.size)
      , body_force_loads(parameters)
  {
    for (unsigned int level = 0; level < domain.levels; ++level)
      cell_matrices.emplace_back(velocity_element, pressure_element, domain.get_cell_size(level));
  }

  template <int dim>
  void FluidSpace<dim>::reinit()
  {
    body_force_loads.clear();
    velocity_dofs.distribute_dofs(velocity_element);
    pressure_dofs.distribute_dofs(pressure_element);
    homogeneous_constraints.copy_from(make_constraints(0, true));
    constraints.copy_from(homogeneous_constraints);
  }

  template <int dim>
  void FluidSpace<dim>::set_boundary_values(const double time)
  {
    if (parameters.has_condition(BoundaryCondition::inflow))
      constraints.copy_from(make_constraints(time, false));
  }

  template <int dim>
  AffineConstraints<double> FluidSpace<dim>::make_constraints(const double time,
                                                              const bool   homogeneous) const
  {
    AffineConstraints<double> result = compatibility::make_constraints(
        velocity_dofs.locally_owned_dofs(), DoFTools::extract_locally_relevant_dofs(velocity_dofs));
    DoFTools::make_hanging_node_constraints(velocity_dofs, result);

    const Functions::ZeroFunction<dim> zero(dim);
    const auto inflow = make_expression<dim>(inflow_path, parameters.inflow_velocity, dim);
    inflow->set_time(time);
    const double            ramp = time < parameters.inflow_ramp
                                       ? 0.5 * (1 - std::cos(numbers::PI * time / parameters.inflow_ramp))
                                       : 1;
    const RampedInflow<dim> ramped_inflow(*inflow, ramp, parameters.inflow_velocity);

    const std::vector<BoundaryCondition> conditions = parameters.get_boundary_conditions();
    // Walls come first: where they meet an inflow, the corner is at rest.
    run_on_all(get_communicator(), [&]() {
      for (const BoundaryCondition condition :
           {BoundaryCondition::wall, BoundaryCondition::inflow, BoundaryCondition::free_slip})
        for (unsigned int side = 0; side < conditions.size(); ++side)
          if (conditions[side] == condition)
          {
            ComponentMask components(dim, condition != BoundaryCondition::free_slip);
            components.set(side / 2, true);
            const bool is_inflow = condition == BoundaryCondition::inflow && !homogeneous;
            VectorTools::interpolate_boundary_values(
                velocity_dofs, side,
                is_inflow ? static_cast<const Function<dim> &>(ramped_inflow) : zero, result,
                components);
          }
    });
    result.close();
    return result;
  }

  template <int dim>
  double FluidSpace<dim>::get_mean_nodal_volume() const
  {
    double volume = 1;
    for (unsigned int d = 0; d < dim; ++d)
      volume *= domain_size[d];
    return volume * dim / velocity_dofs.n_dofs();
  }

  template <int dim>
  FieldVector FluidSpace<dim>::make_velocity_vector() const
  {
    return FieldVector(velocity_dofs.locally_owned_dofs(),
                       DoFTools::extract_locally_relevant_dofs(velocity_dofs), get_communicator());
  }

  template <int dim>
  FieldVector FluidSpace<dim>::make_pressure_vector() const
  {
    return FieldVector(pressure_dofs.locally_owned_dofs(),
                       DoFTools::extract_locally_relevant_dofs(pressure_dofs), get_communicator());
  }

  template class FluidSpace<2>;
  template class FluidSpace<3>;
} // namespace caudal
