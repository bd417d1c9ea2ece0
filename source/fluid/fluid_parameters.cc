// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fluid/fluid_parameters.h>

#include <caudal/base/checks.h>
#include <caudal/base/expression.h>
#include <caudal/mesh/domain.h>

#include <algorithm>

namespace caudal
{
  template <int dim>
  FluidParameters<dim>::FluidParameters()
      : initial_velocity(dim == 2 ? "0; 0" : "0; 0; 0")
      , body_force(initial_velocity)
  {
    inflow.velocity = initial_velocity;
    for (const std::string &side : get_side_names(dim))
      sides.emplace_back(side, "wall", "Condition on this side:", side + " ");
  }

  template <int dim>
  void FluidParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Fluid");
    prm.add_parameter("Density", density, "Density rho of the fluid [kg/m^3].");
    prm.add_parameter("Kinematic viscosity", kinematic_viscosity,
                      "Kinematic viscosity nu = mu/rho of the fluid [m^2/s].");
    prm.add_parameter(
        "Grad-div stabilisation", grad_div,
        "Coefficient gamma of the term rho gamma (div u, div v) [m^2/s]; automatic: a tenth of "
        "speed times length, of inflows, initial velocity and swimming bodies as far as the "
        "parameters tell, else 1; in 3D at most three times the square of the finest spacing of "
        "nodes over Time/Step, which the iterative solver bears. More stiffens the cells that the "
        "bodies' faces cut. Flows at Reynolds numbers of 1e6 may need more.",
        Patterns::Anything());
    prm.add_parameter("Convection stabilisation", convection_stabilisation,
                      "Coefficient c of the local projection stabilisation of the streamline "
                      "derivative, c rho h/|u| (k(u.grad u), k(u.grad v)), k = identity minus the "
                      "projection on linear functions in the cell [1].");
    prm.add_parameter(
        "Backflow stabilisation", backflow_stabilisation,
        "Let no kinetic energy enter through an outflow side where the flow reverses.");
    prm.add_parameter("Inflow velocity", inflow.velocity,
                      "Velocity on inflow sides that have none of their own, as function of x, y, "
                      "(z,) t, components separated by ';' [m/s].");
    prm.add_parameter("Inflow ramp", inflow.ramp,
                      "Time during which the inflow velocity grows as (1-cos(pi t/ramp))/2 [s].");
    prm.add_parameter("Initial velocity", initial_velocity,
                      "Velocity at t = 0, components separated by ';' [m/s].");
    prm.add_parameter("Body force", body_force,
                      "Force per volume on the whole domain, components separated by ';' [N/m^3].");
    prm.add_parameter(
        "Gravity", gravity,
        "Acceleration g of gravity, which acts on fluid and bodies by their densities "
        "[m/s^2]. A side that is open then needs the pressure of the fluid outside.");
    prm.enter_subsection("Boundary conditions");
    for (auto &side : sides)
      side.add_parameters(prm);
    prm.leave_subsection();
    prm.leave_subsection();
  }

  template <int dim>
  void FluidParameters<dim>::check() const
  {
    check_positive("Fluid/Density", density);
    check_positive("Fluid/Kinematic viscosity", kinematic_viscosity);
    get_grad_div();
    check_not_negative("Fluid/Convection stabilisation", convection_stabilisation);
    check_not_negative("Fluid/Inflow ramp", inflow.ramp);
    Expression<dim>("Fluid/Inflow velocity", inflow.velocity, dim);
    for (const auto &side : sides)
      side.check("Fluid/Boundary conditions");
    AssertThrow(std::any_of(sides.begin(), sides.end(),
                            [](const auto &side) { return side.get().has_velocity(); }) ||
                    inflow.velocity == FluidParameters<dim>().inflow.velocity,
                ExcMessage("Fluid/Inflow velocity: no side is an inflow. Set one to inflow in "
                           "Fluid/Boundary conditions, or leave the velocity out."));
    Expression<dim>("Fluid/Initial velocity", initial_velocity, dim);
    Expression<dim>("Fluid/Body force", body_force, dim);
  }

  template <int dim>
  std::vector<std::unique_ptr<BoundaryCondition<dim>>>
  FluidParameters<dim>::create_boundary_conditions() const
  {
    std::vector<std::unique_ptr<BoundaryCondition<dim>>> conditions;
    for (const auto &side : sides)
    {
      conditions.push_back(side.create());
      conditions.back()->set_up(inflow, side.get_path("Fluid/Boundary conditions"));
    }
    return conditions;
  }

  template <int dim>
  std::optional<double> FluidParameters<dim>::get_grad_div() const
  {
    const std::string path = "Fluid/Grad-div stabilisation";
    const auto value = read_unless_automatic(path, grad_div, "Give automatic or a number [m^2/s].");
    if (value)
      check_not_negative(path, *value);
    return value;
  }

  template <int dim>
  bool FluidParameters<dim>::has_body_force_function() const
  {
    return body_force.find_first_not_of("0; ") != std::string::npos;
  }

  template struct FluidParameters<2>;
  template struct FluidParameters<3>;
} // namespace caudal
