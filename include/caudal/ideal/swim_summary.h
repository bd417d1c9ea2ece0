// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_swim_summary_h
#define caudal_ideal_swim_summary_h

#include <caudal/ideal/ideal_state.h>

#include <string>
#include <vector>

namespace caudal
{
  /** The result of a swim at one frequency. */
  struct SwimSummary
  {
    /** What the state of a swim at its end tells; the rest is to be set. */
    explicit SwimSummary(const SwimState &swim);

    std::string coordinate; ///< what tables call a coordinate of the gait

    double frequency   = 0.;    ///< f [Hz]; 0 for a gait without period
    double length      = 0.;    ///< L of the body [m]
    double mass        = 0.;    ///< of the body [kg]
    bool   has_torques = false; ///< so that powers are known

    double       duration  = 0.; ///< T [s]
    double       distance  = 0.; ///< of the centre of mass from its start, at T [m]
    unsigned int n_strokes = 0;  ///< whole ones
    double       stroke    = 0.; ///< distance from stroke to stroke, mean of all whole ones [m]
    double       turn      = 0.; ///< in a stroke, about e_3 [rad]

    ideal::EnergyAverages energy; ///< over whole strokes, if there are any
  };

  /** What an ideal fluid leaves out: a paragraph that stands in every summary. */
  std::string get_ideal_fluid_statement();

  /**
   * All results with units, for the eye: a row for each quantity, a column for each swim. What is
   * not known of a swim that makes no whole stroke, beside others that do, is left blank in all of
   * these tables (- here, null in JSON).
   */
  std::string print_text(const std::vector<SwimSummary> &summaries);

  /** A table for programs: a row for each swim, the names of the columns first. */
  std::string print_csv(const std::vector<SwimSummary> &summaries);

  /** An object of JSON with the units, the constants of the body and all swims. */
  std::string print_json(const std::vector<SwimSummary> &summaries);
} // namespace caudal

#endif
