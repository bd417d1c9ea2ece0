// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_endurance_law_h
#define caudal_passage_endurance_law_h

#include <caudal/base/plugin.h>
#include <caudal/passage/endurance_curve.h>

#include <utility>

namespace caudal::passage
{
  /** A fish of the population. */
  struct Fish
  {
    std::string species; // or group, as the law calls it
    double      length;  // [m]
    /**
     * How able it is among those of its length, as a quantile of the standard normal distribution:
     * 0 is the median, and Phi(-ability) is the share of those that are better.
     */
    double ability = 0.;
  };

  /** How long a fish can swim at which speed: a law with its coefficients and their spread. */
  class EnduranceLaw : public Plugin
  {
  public:
    /** Throws a sentence, which begins with @p entry, if the law does not know the species. */
    virtual void check_species(const std::string & /*species*/, const std::string & /*entry*/) const
    {}

    /** T(U) of this fish. */
    virtual EnduranceCurve make_curve(const Fish &fish) const = 0;

    /** The shortest and longest fish [m] of the data; 0 and infinity where nothing is known. */
    virtual std::pair<double, double> get_length_range(const std::string &species) const = 0;

    /** Equation, coefficients and source in words, for reports. */
    virtual std::string describe(const std::string &species) const = 0;
  };

  /** The entries `Shortest duration` and `Longest duration` that laws share. */
  struct DurationRange
  {
    double shortest, longest; // [s]

    void add_parameters(ParameterHandler &prm);
    void check(const std::string &path) const;

    std::string describe() const;
  };

  /** The entries `Shortest length` and `Longest length` that laws share. */
  struct LengthRange
  {
    double shortest = 0., longest = 0.; // [m]

    void add_parameters(ParameterHandler &prm);
    void check(const std::string &path) const;

    /** 0 stands for no limit. */
    std::pair<double, double> get() const;
  };
} // namespace caudal::passage

#endif
