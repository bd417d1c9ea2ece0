#ifndef caudal_observe_guard_parameters_h
#define caudal_observe_guard_parameters_h

#include <deal.II/base/parameter_handler.h>

namespace caudal
{
  /** Section `Guards`: limits whose violation is warned of; 0 switches one off. */
  struct GuardParameters
  {
    double largest_area_change         = 0.02;
    double smallest_jacobian           = 0.5;
    double largest_jacobian            = 2;
    double largest_tether_displacement = 2;
    double largest_power_identity      = 1e-6;
    double largest_energy_residual     = 0.1;

    void add_parameters(dealii::ParameterHandler &prm);
    void check() const;
  };
} // namespace caudal

#endif
