// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_fluid_parameters_h
#define caudal_fluid_fluid_parameters_h

#include <caudal/fluid/boundary_condition.h>

#include <deal.II/base/point.h>

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace caudal
{
  /** Section `Fluid`. */
  template <int dim>
  struct FluidParameters
  {
    double      density                  = 1000;
    double      kinematic_viscosity      = 1e-6;
    std::string grad_div                 = "automatic";
    double      convection_stabilisation = 0.1;
    bool        backflow_stabilisation   = true;
    std::string initial_velocity;
    std::string body_force;

    Tensor<1, dim> gravity; // g [m/s^2]

    SharedInflow                               inflow;
    std::deque<Choice<BoundaryCondition<dim>>> sides; // by boundary id

    FluidParameters();
    void add_parameters(ParameterHandler &prm);
    void check() const;

    double get_viscosity() const
    {
      return density * kinematic_viscosity;
    }
    /** The coefficient of the grad-div term [m^2/s], unless it is left to the program. */
    std::optional<double> get_grad_div() const;

    /** Whether Body force says more than zero. */
    bool has_body_force_function() const;

    bool has_body_force() const
    {
      return gravity.norm() > 0. || has_body_force_function();
    }

    /** The conditions on the sides, by boundary id. */
    std::vector<std::unique_ptr<BoundaryCondition<dim>>> create_boundary_conditions() const;
  };
} // namespace caudal

#endif
