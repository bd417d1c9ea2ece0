#include <caudal/fluid/fluid_parameters.h>

#include <caudal/base/expression.h>
#include <caudal/mesh/domain.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  template <int dim>
  FluidParameters<dim>::FluidParameters()
      : inflow_velocity(dim == 2 ? "0; 0" : "0; 0; 0")
      , initial_velocity(inflow_velocity)
      , body_force(inflow_velocity)
  {}

  template <int dim>
  void FluidParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Fluid");
    prm.add_parameter("Density", density, "Density rho of the fluid [kg/m^3].");
    prm.add_parameter("Kinematic viscosity", kinematic_viscosity,
                      "Kinematic viscosity nu = mu/rho of the fluid [m^2/s].");
    prm.add_parameter(
        "Grad-div stabilisation", grad_div,
        "Coefficient gamma of the term rho gamma (div u, div v) [m^2/s]. About a tenth of "
        "speed times length suits immersed bodies: more stiffens the cells that "
        "their faces cut. Flows at Reynolds numbers of 1e6 may need more.");
    prm.add_parameter("Convection stabilisation", convection_stabilisation,
                      "Coefficient c of the local projection stabilisation of the streamline "
                      "derivative, c rho h/|u| (k(u.grad u), k(u.grad v)), k = identity minus the "
                      "projection on linear functions in the cell [1].");
    prm.add_parameter(
        "Backflow stabilisation", backflow_stabilisation,
        "Let no kinetic energy enter through an outflow side where the flow reverses.");
    prm.add_parameter(
        "Inflow velocity", inflow_velocity,
        "Velocity on inflow sides as function of x, y, (z,) t, components separated by ';' [m/s].");
    prm.add_parameter("Inflow ramp", inflow_ramp,
                      "Time during which the inflow velocity grows as (1-cos(pi t/ramp))/2 [s].");
    prm.add_parameter("Initial velocity", initial_velocity,
                      "Velocity at t = 0, components separated by ';' [m/s].");
    prm.add_parameter("Body force", body_force,
                      "Force per volume on the whole domain, components separated by ';' [N/m^3].");
    prm.enter_subsection("Boundary conditions");
    const std::vector<std::string> sides = get_side_names(dim);
    for (unsigned int side = 0; side < sides.size(); ++side)
      prm.add_parameter(sides[side], boundary_names[side],
                        "wall: no slip; inflow: the inflow velocity; outflow: no traction; free "
                        "slip: no flow through it, no friction on it.",
                        Patterns::Selection("wall|inflow|outflow|free slip"));
    prm.leave_subsection();
    prm.leave_subsection();
  }

  template <int dim>
  void FluidParameters<dim>::check() const
  {
    const auto check_range = [](const char *entry, const double value, const bool may_be_zero) {
      AssertThrow(std::isfinite(value) && (value > 0 || (may_be_zero && value == 0)),
                  ExcMessage(std::string("Fluid/") + entry + ": the value is " +
                             std::to_string(value) + ". Give a positive number" +
                             (may_be_zero ? " or 0." : ".")));
    };
    check_range("Density", density, false);
    check_range("Kinematic viscosity", kinematic_viscosity, false);
    check_range("Grad-div stabilisation", grad_div, true);
    check_range("Convection stabilisation", convection_stabilisation, true);
    check_range("Inflow ramp", inflow_ramp, true);
    make_expression<dim>("Fluid/Inflow velocity", inflow_velocity, dim);
    AssertThrow(has_condition(BoundaryCondition::inflow) ||
                    inflow_velocity == FluidParameters<dim>().inflow_velocity,
                ExcMessage("Fluid/Inflow velocity: no side is an inflow. Set one to inflow in "
                           "Fluid/Boundary conditions, or leave the velocity out."));
    make_expression<dim>("Fluid/Initial velocity", initial_velocity, dim);
    make_expression<dim>("Fluid/Body force", body_force, dim);
  }

  template <int dim>
  std::vector<BoundaryCondition> FluidParameters<dim>::get_boundary_conditions() const
  {
    std::vector<BoundaryCondition> conditions;
    for (const std::string &name : boundary_names)
      conditions.push_back(name == "wall"      ? BoundaryCondition::wall
                           : name == "inflow"  ? BoundaryCondition::inflow
                           : name == "outflow" ? BoundaryCondition::outflow
                                               : BoundaryCondition::free_slip);
    return conditions;
  }

  template <int dim>
  bool FluidParameters<dim>::has_condition(const BoundaryCondition condition) const
  {
    const auto conditions = get_boundary_conditions();
    return std::find(conditions.begin(), conditions.end(), condition) != conditions.end();
  }

  template <int dim>
  bool FluidParameters<dim>::has_body_force() const
  {
    return body_force.find_first_not_of("0; ") != std::string::npos;
  }

  template struct FluidParameters<2>;
  template struct FluidParameters<3>;
} // namespace caudal
