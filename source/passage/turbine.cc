// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/passage/endurance_curve.h>
#include <caudal/passage/turbine.h>

#include <algorithm>
#include <cmath>

namespace caudal::passage
{
  using namespace dealii;

  void TurbineParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Turbine");
    prm.add_parameter(
        "Discharge", discharge,
        "Discharge of a Kaplan turbine that fish go down through [m^3/s]; 0: there is "
        "none.");
    prm.add_parameter("Head", head, "Its head [m].");
    prm.add_parameter("Diameter", diameter, "Diameter of its runner [m].");
    prm.add_parameter("Speed", speed, "Its speed of rotation [1/min].");
    prm.add_parameter("Blades", n_blades, "Number of its blades [1].", Patterns::Integer(1, 20));
    prm.add_parameter("Efficiency", efficiency, "Its efficiency [1].");
    prm.add_parameter("Correlation factor", correlation,
                      "lambda of Franke's formula, the share of strikes that count [1]; 0.2 fits "
                      "measured mortalities.");
    prm.leave_subsection();
  }

  void TurbineParameters::check() const
  {
    check_not_negative("Turbine/Discharge", discharge, "Give a discharge, or 0 [m^3/s].");
    check_positive("Turbine/Head", head, "Give a positive head [m].");
    check_positive("Turbine/Diameter", diameter, "Give a positive diameter [m].");
    check_positive("Turbine/Speed", speed, "Give a positive speed [1/min].");
    check_value(0. < efficiency && efficiency <= 1., "Turbine/Efficiency", efficiency,
                "Give a number up to 1.");
    check_positive("Turbine/Correlation factor", correlation);
  }

  double TurbineParameters::compute_strike(const double length, const double place) const
  {
    const double omega  = 2. * numbers::PI * speed / 60.; // [1/s]
    const double energy = gravity * head / std::pow(omega * diameter, 2);
    const double flow   = discharge / (omega * std::pow(diameter, 3));
    const double alpha  = std::atan(numbers::PI * efficiency * energy / (2. * flow * place));
    const double strike = correlation * n_blades * length / diameter *
                          (std::cos(alpha) / (8. * flow) + std::sin(alpha) / (numbers::PI * place));
    return std::min(strike, 1.);
  }

  std::vector<std::pair<double, double>> list_strikes(const TurbineParameters &turbine,
                                                      const double             length)
  {
    std::vector<std::pair<double, double>> strikes;
    for (const double place : {0.5, 0.75, 1.})
      strikes.emplace_back(place, turbine.compute_strike(length, place));
    return strikes;
  }
} // namespace caudal::passage
