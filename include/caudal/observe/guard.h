// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_guard_h
#define caudal_observe_guard_h

#include <caudal/observe/observer.h>

#include <cmath>
#include <functional>
#include <variant>

namespace caudal
{
  /**
   * A limit within which the results of a run can be believed: an entry of section `Guards`, the
   * words of its warning, and what is measured after each step, of each body or of everything
   * together. All guards that are registered are at work, unless their limit is 0; warnings come
   * in the order of their places.
   */
  template <int dim>
  class Guard : public Plugin
  {
  public:
    /** How the entry and a warning are worded. */
    struct Words
    {
      std::string entry, documentation;
      std::string quantity; // "the area change"
      std::string unit;     // behind a value: " cells"
      std::string hint;     // what a violation may come from and what to do about it
    };

    /** On which side of the limit the results can't be believed any more. */
    enum class Side
    {
      above, ///< of the value's modulus
      below
    };

    using BodyMeasure =
        std::function<double(const Observation<dim> &, const BodyObservation<dim> &)>;
    using Measure = std::function<double(const Observation<dim> &, const ObserverContext<dim> &)>;

    Guard(const Words &words, const double limit, const std::variant<BodyMeasure, Measure> &measure,
          const unsigned int place = last_place, const Side side = Side::above)
        : words(words)
        , measure(measure)
        , place(place)
        , side(side)
        , limit(limit)
    {}

    const Words words;
    /** The measure of each body, or of fluid and bodies together. */
    const std::variant<BodyMeasure, Measure> measure;
    const unsigned int                       place;

    void add_parameters(ParameterHandler &prm) override
    {
      prm.add_parameter(words.entry, limit, words.documentation);
    }

    void check(const std::string &path) const override;

    double get_limit() const
    {
      return limit;
    }

    bool is_violated(const double value) const
    {
      return side == Side::below ? value < limit : limit > 0 && std::abs(value) > limit;
    }

  private:
    const Side side;
    double     limit;
  };
} // namespace caudal

#endif
