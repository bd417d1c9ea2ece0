// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/passage/answer_output.h>
#include <caudal/passage/print.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace caudal::passage
{
  namespace
  {
    std::string print_discharge(const double discharge)
    {
      return discharge > 0. ? "At " + print_number(discharge) + " m^3/s" : "On the way";
    }

    void print_bands(std::ostream &out, const Verdict &verdict)
    {
      out << "  fish                  better [%]  fatigue  cause                place [m]  time [s]"
             "  largest velocity [m/s]  smallest length [m]\n";
      for (std::size_t k = 0; k < verdict.bands.size(); ++k)
      {
        const BandAnswer &answer = verdict.bands[k];
        out << "  " << std::left << std::setw(20) << get_bands()[k].name << std::right
            << std::setw(12) << 100. * get_bands()[k].share << std::setw(9)
            << print_number(answer.ascent.fatigue) << "  " << std::left << std::setw(20)
            << (answer.ascent.passes() ? "passes" : describe(answer.ascent.cause)) << std::right
            << std::setw(10) << print_number(answer.ascent.place) << std::setw(10)
            << print_number(answer.ascent.time) << std::setw(24)
            << (answer.velocity_factor == 0.             ? "none"
                : std::isfinite(answer.largest_velocity) ? print_number(answer.largest_velocity)
                                                         : "unknown")
            << std::setw(21)
            << (answer.smallest_length > 0. ? print_number(answer.smallest_length) : "none")
            << '\n';
      }
    }
  } // namespace

  std::string print_text(const PassageParameters &parameters, const Answers &answers)
  {
    const Population  &population = parameters.population;
    const std::string  energy     = parameters.power.get().describe();
    std::ostringstream out;
    out << "Can this fish pass? " << population.species << " of "
        << print_number(population.compute_mean_length()) << " m\n"
        << "  endurance  " << parameters.law.get().describe(population.species) << '\n'
        << "  way        " << parameters.way.source.get().describe() << '\n'
        << "  strategy   " << parameters.strategy.get().describe() << '\n';
    if (!energy.empty())
      out << "  energy     " << energy << '\n';
    for (std::size_t k = 0; k < answers.verdicts.size(); ++k)
    {
      const Verdict &verdict = answers.verdicts[k];
      out << '\n'
          << print_discharge(verdict.waterway.discharge) << ": " << verdict.sentence << '\n';
      print_bands(out, verdict);
      if (!energy.empty())
        out << "  The median fish spends " << print_number(verdict.bands[median_band].ascent.energy)
            << " J.\n";
      if (k < answers.designs.size())
        out << "  " << answers.designs[k].sentence << '\n';
      for (const std::string &mark : verdict.marks)
        out << "Warning: " << mark << '\n';
    }
    if (!answers.batch.empty())
      out << "\nBatch: " << answers.batch.size() << " answers in batch.csv.\n";
    if (parameters.turbine.is_asked_for())
    {
      out << "\nDown through the turbine (Franke et al. 1997), probability of a strike at r/R =";
      for (const auto &[place, strike] :
           list_strikes(parameters.turbine, population.compute_mean_length()))
        out << ' ' << place << ": " << print_number(strike) << (place < 1. ? "," : ".\n");
    }
    out << "\nLimits of validity\n";
    for (const std::string &limit : get_limits())
      out << "  " << limit << '\n';
    return out.str();
  }
} // namespace caudal::passage
