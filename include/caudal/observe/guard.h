// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_guard_h
#define caudal_observe_guard_h

#include <caudal/observe/observer.h>

#include <optional>

namespace caudal
{
  /**
   * A limit within which the results of a run can be believed: an entry of section `Guards`, what
   * it is about in the words of a warning, and how it is measured after each step. All guards that
   * are registered are at work, unless their limit is 0.
   */
  template <int dim>
  class Guard : public Plugin
  {
  public:
    /** How the entry and a warning are worded. */
    struct Words
    {
      std::string entry, documentation;
      std::string quantity;  // "the area change"
      std::string unit = ""; // behind a value: " cells"
      std::string hint;      // what a violation may come from and what to do about it
    };

    /** Warnings come in the order of the places. */
    Guard(const Words &words, const double limit, const unsigned int place = last_place)
        : words(words)
        , place(place)
        , limit(limit)
    {}

    unsigned int get_place() const
    {
      return place;
    }

    void add_parameters(ParameterHandler &prm) override
    {
      prm.add_parameter(words.entry, limit, words.documentation);
    }

    void check(const std::string &path) const override;

    const Words &get_words() const
    {
      return words;
    }
    double get_limit() const
    {
      return limit;
    }

    /** The value for a body; none if the guard is not about single bodies. */
    virtual std::optional<double> measure_body(const Observation<dim> &,
                                               unsigned int /*body*/) const
    {
      return {};
    }

    /** The value for fluid and bodies together; none if the guard is not about these. */
    virtual std::optional<double> measure(const Observation<dim> &,
                                          const ObserverContext<dim> &) const
    {
      return {};
    }

    virtual bool is_violated(const double value) const
    {
      return limit > 0 && value > limit;
    }

  private:
    const Words        words;
    const unsigned int place;
    double             limit;
  };
} // namespace caudal

#endif
