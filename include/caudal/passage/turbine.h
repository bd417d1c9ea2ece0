// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_turbine_h
#define caudal_passage_turbine_h

#include <deal.II/base/parameter_handler.h>

#include <utility>
#include <vector>

namespace caudal::passage
{
  /**
   * Section `Turbine`: a Kaplan turbine that the fish goes down through. The probability of a
   * strike by its blades at the radius r of the runner, of the diameter D and N blades, that turns
   * at omega under the head H with the discharge Q and the efficiency eta:
   *   p = lambda N l/D (cos alpha/(8 Q_wd) + sin alpha/(pi r/R)),
   *   tan alpha = pi eta E_wd/(2 Q_wd r/R), E_wd = g H/(omega D)^2, Q_wd = Q/(omega D^3)
   * (Franke et al. 1997, Development of environmentally advanced hydropower turbine system design
   * concepts, INEEL/EXT-97-00639, doi:10.2172/563213), all in SI units, l the fish's length.
   */
  struct TurbineParameters
  {
    double       discharge   = 0.;   // Q [m^3/s]; 0: there is no turbine
    double       head        = 10.;  // H [m]
    double       diameter    = 4.;   // D [m]
    double       speed       = 100.; // of rotation [1/min]
    unsigned int n_blades    = 4;
    double       efficiency  = 0.9;
    double       correlation = 0.2; // lambda

    void add_parameters(dealii::ParameterHandler &prm);
    void check() const;

    bool is_asked_for() const
    {
      return discharge > 0.;
    }

    /** p for a fish of this length [m] at the radius @p place = r/R; at most 1. */
    double compute_strike(double length, double place) const;
  };

  /** Some places r/R and the probability of a strike there. */
  std::vector<std::pair<double, double>> list_strikes(const TurbineParameters &turbine,
                                                      double                   length);
} // namespace caudal::passage

#endif
