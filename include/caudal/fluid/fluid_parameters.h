#ifndef caudal_fluid_fluid_parameters_h
#define caudal_fluid_fluid_parameters_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace caudal
{
  using namespace dealii;

  /** Condition on a side of the domain. */
  enum class BoundaryCondition
  {
    wall,     // u = 0
    inflow,   // u = inflow velocity
    outflow,  // -p n + mu du/dn = 0
    free_slip // u.n = 0, no tangential stress
  };

  /** Section `Fluid`. */
  template <int dim>
  struct FluidParameters
  {
    double      density                  = 1000;
    double      kinematic_viscosity      = 1e-6;
    double      grad_div                 = 1;
    double      convection_stabilisation = 0.1;
    bool        backflow_stabilisation   = true;
    std::string inflow_velocity;
    double      inflow_ramp = 0;
    std::string initial_velocity;
    std::string body_force;

    std::vector<std::string> boundary_names = std::vector<std::string>(2 * dim, "wall");

    FluidParameters();
    void add_parameters(ParameterHandler &prm);
    void check() const;

    double get_viscosity() const
    {
      return density * kinematic_viscosity;
    }
    std::vector<BoundaryCondition> get_boundary_conditions() const;
    bool                           has_condition(BoundaryCondition condition) const;
    bool                           has_body_force() const;
  };
} // namespace caudal

#endif
