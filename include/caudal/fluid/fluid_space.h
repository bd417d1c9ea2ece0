// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_fluid_space_h
#define caudal_fluid_fluid_space_h

#include <caudal/base/compatibility.h>
#include <caudal/base/types.h>
#include <caudal/fluid/body_force.h>
#include <caudal/fluid/cell_matrices.h>
#include <caudal/fluid/fluid_parameters.h>
#include <caudal/fluid/side_loads.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include <functional>
#include <optional>

namespace caudal
{
  /**
   * The fluid's discrete spaces on the present grid: velocity Q2, pressure
   * P1-discontinuous (inf-sup stable and locally mass conservative; Boffi &
   * Gastaldi 2002, doi:10.1007/s002110200009), hanging nodes and conditions
   * on the sides. The pressure space has no constraints.
   */
  template <int dim>
  class FluidSpace
  {
  public:
    /** @p grad_div is the coefficient of the grad-div term [m^2/s]. */
    FluidSpace(parallel::distributed::Triangulation<dim> &triangulation,
               const DomainParameters<dim> &domain, const FluidParameters<dim> &parameters,
               double grad_div);

    /** To be called after each change of the grid. */
    void reinit();

    /**
     * Hanging nodes and the boundary values at this @p instant. They are kept until another one is
     * asked for. Collective.
     */
    const AffineConstraints<double> &get_constraints(const Instant &instant) const;

    /**
     * Whether velocities are prescribed on all sides, so that what they bring into the domain has
     * to flow out of it.
     */
    bool balances_fluxes() const;

    /**
     * The factor by which prescribed outflows are multiplied at this @p instant, so that they are
     * what flows in: one but for errors of interpolation and small ones of the user. Throws a
     * sentence if it is farther from one than a hundredth. Collective.
     */
    double get_outflow_factor(const Instant &instant) const;

    /** The constraints with zero boundary values, for corrections. */
    const AffineConstraints<double> &get_homogeneous_constraints() const
    {
      return homogeneous_constraints;
    }

    const parallel::distributed::Triangulation<dim> &get_triangulation() const
    {
      return triangulation;
    }
    MPI_Comm get_communicator() const
    {
      return compatibility::get_communicator(triangulation);
    }
    const FluidParameters<dim> &get_parameters() const
    {
      return parameters;
    }

    /** Whether the sides in this direction are one. */
    bool is_periodic(const unsigned int direction) const
    {
      return domain.is_periodic(direction);
    }

    double get_grad_div() const
    {
      return grad_div;
    }

    /** The condition on the side of the domain with this boundary id. */
    const BoundaryCondition<dim> &get_boundary_condition(const types::boundary_id side) const
    {
      return *boundary_conditions[side];
    }

    /** Adds a uniform @p velocity, also on the sides, to a velocity with ghost values. */
    void add_uniform(const Tensor<1, dim> &velocity, FieldVector &field) const;

    /** A zero vector with ghost entries for all locally relevant unknowns. */
    FieldVector make_velocity_vector() const
    {
      return FieldVector(velocity_layout);
    }
    FieldVector make_pressure_vector() const
    {
      return FieldVector(pressure_layout);
    }
    const std::shared_ptr<const Utilities::MPI::Partitioner> &get_velocity_layout() const
    {
      return velocity_layout;
    }

    /** The domain's volume over the number of velocity nodes [m^dim]. */
    double get_mean_nodal_volume() const;

    const CellMatrices<dim> &get_cell_matrices(const unsigned int level) const
    {
      return cell_matrices[level];
    }
    const Tensor<1, dim> &get_cell_size(const unsigned int level) const
    {
      return cell_matrices[level].get_cell_size();
    }

    /** The body force's loads of this rank's cells; throws if it is not finite in one of them. */
    const BodyForceLoads<dim> &get_body_force_loads(const Instant &instant) const
    {
      body_force_loads.update(velocity_dofs, instant);
      return body_force_loads;
    }

    /** Loads of tractions on the sides, likewise. */
    const SideLoads<dim> &get_side_loads(const Instant &instant) const
    {
      side_loads.update(velocity_dofs, instant);
      return side_loads;
    }

    const FESystem<dim> velocity_element;
    const FE_DGP<dim>   pressure_element;
    DoFHandler<dim>     velocity_dofs;
    DoFHandler<dim>     pressure_dofs;

  private:
    parallel::distributed::Triangulation<dim> &triangulation;
    const FluidParameters<dim>                &parameters;
    const double                               grad_div;
    const DomainParameters<dim>               &domain;

    const std::vector<std::unique_ptr<BoundaryCondition<dim>>> boundary_conditions;

    std::vector<CellMatrices<dim>>    cell_matrices;
    mutable BodyForceLoads<dim>       body_force_loads;
    mutable SideLoads<dim>            side_loads;
    AffineConstraints<double>         homogeneous_constraints;
    mutable AffineConstraints<double> constraints; // at constraints_instant
    mutable std::optional<Instant>    constraints_instant;
    mutable double                    outflow_factor = 1; // likewise

    std::shared_ptr<const Utilities::MPI::Partitioner> velocity_layout, pressure_layout;

    using Velocities = std::function<std::unique_ptr<Function<dim>>(unsigned int side)>;

    AffineConstraints<double> make_constraints(const Velocities &velocities) const;
    AffineConstraints<double> make_constraints(const Instant &instant, double outflow_factor) const;
    bool                      has_velocity() const;
    double                    compute_outflow_factor(const Instant &instant) const;
  };
} // namespace caudal

#endif
