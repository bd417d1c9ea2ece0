// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/fish/gait.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  void Gait::set_up(const SharedGaitParameters &shared_parameters, const double body_length)
  {
    shared = shared_parameters;
    length = body_length;
  }

  GaitState Gait::evaluate(const double argument) const
  {
    return {{argument}, {1.}};
  }

  std::vector<double> Gait::describe_shape(const double argument) const
  {
    std::vector<double> places;
    for (unsigned int i = 0; i <= 20; ++i)
      places.push_back(length * i / 20);
    return compute_angles(places, evaluate(argument).c).theta;
  }

  std::vector<Gait::Motion> Gait::compute_shifts(const std::vector<double> &x, const double) const
  {
    return std::vector<Motion>(x.size());
  }

  std::vector<Gait::Motion> Gait::compute_inclinations(const std::vector<double> &s,
                                                       const double) const
  {
    return std::vector<Motion>(s.size());
  }

  SpineAngles Gait::compute_angles(const std::vector<double> &s, const std::vector<double> &c,
                                   const std::vector<double> &rates) const
  {
    SpineAngles angles;
    angles.by_c.resize(1);
    for (const Motion &inclination : compute_inclinations(s, c[0]))
    {
      angles.theta.push_back(inclination.value);
      angles.by_c[0].push_back(inclination.rate);
    }
    if (!rates.empty())
    {
      const double                    step      = 1e-3;
      const std::pair<double, double> stencil[] = {
          {-2., 1. / 12.}, {-1., -8. / 12.}, {1., 8. / 12.}, {2., -1. / 12.}};
      angles.by_c_rate.assign(1, std::vector<double>(s.size(), 0.));
      for (const auto &[distance, weight] : stencil)
      {
        const auto moved = compute_inclinations(s, c[0] + distance * step);
        for (std::size_t p = 0; p < s.size(); ++p)
          angles.by_c_rate[0][p] += rates[0] * weight / step * moved[p].rate;
      }
    }
    return angles;
  }

  std::vector<double> Gait::compute_curvature(const std::vector<double> &s,
                                              const std::vector<double> &c) const
  {
    // The curvature may have a kink at s: the distance decides on the error.
    const double        distance = 1e-8 * length;
    std::vector<double> ends;
    for (const double place : s)
      for (const double side : {-1., 1.})
        ends.push_back(std::clamp(place + side * distance, 0., length));
    const SpineAngles   angles = compute_angles(ends, c);
    std::vector<double> curvature;
    for (std::size_t p = 0; p < ends.size(); p += 2)
      curvature.push_back((angles.theta[p + 1] - angles.theta[p]) / (ends[p + 1] - ends[p]));
    return curvature;
  }

  GaitState ModalGait::evaluate(const double argument) const
  {
    if (is_periodic() || shared.ramp.duration == 0.)
      return evaluate_stroke(argument);
    const double rate   = has_period() ? 2. * numbers::PI * get_frequencies()[0] : 1.;
    GaitState    state  = evaluate_stroke(rate * argument);
    const double growth = shared.ramp.value(argument), growth_rate = shared.ramp.rate(argument);
    for (std::size_t i = 0; i < state.c.size(); ++i)
    {
      state.rates[i] = growth * rate * state.rates[i] + growth_rate * state.c[i];
      state.c[i] *= growth;
    }
    return state;
  }

  std::vector<double> ModalGait::describe_shape(const double argument) const
  {
    return evaluate(argument).c;
  }

  SpineAngles ModalGait::compute_angles(const std::vector<double> &s, const std::vector<double> &c,
                                        const std::vector<double> &) const
  {
    SpineAngles angles;
    angles.theta.assign(s.size(), 0.);
    angles.by_c.resize(c.size());
    for (unsigned int i = 0; i < c.size(); ++i)
      for (std::size_t p = 0; p < s.size(); ++p)
      {
        angles.by_c[i].push_back(mode(i, s[p]));
        angles.theta[p] += c[i] * angles.by_c[i][p];
      }
    return angles;
  }

  GaitParameters::GaitParameters(const std::string &default_type)
      : type("Type", default_type, "What motion is prescribed to the spine")
  {}

  void GaitParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Gait");
    type.add_parameters(prm);
    prm.add_parameter("Start-up ramp", shared.ramp.duration,
                      "Time [s] in which the motion grows from zero, as (1 - cos)/2.");
    prm.add_parameter("Frequency", shared.frequencies,
                      "Strokes a second f [Hz] of arctangent, sine and curvature wave; in an ideal "
                      "fluid several, separated by commas, are simulated one after the other from "
                      "one table of phases.");
    prm.add_parameter("Wave number", shared.wave_number,
                      "k, the waves on the body [1], of arctangent, sine and curvature wave; with "
                      "0 the stroke is reciprocal.");
    prm.add_parameter("Bias", shared.bias,
                      "Constant angle gamma added to each joint [degrees], which steers; Yao et "
                      "al. print 5, with which their fish would swim in circles.");
    prm.add_parameter("Growth", shared.growth,
                      "g [1]: the amplitude (sine, curvature wave) is in proportion to (1 - g) + "
                      "g s/L.");
    prm.leave_subsection();
  }

  void GaitParameters::check(const std::string &path) const
  {
    const std::string section = path + "/Gait";
    check_not_negative(section + "/Start-up ramp", shared.ramp.duration,
                       "Give a duration that is not negative [s].");
    check_finite(section + "/Wave number", shared.wave_number);
    check_finite(section + "/Bias", shared.bias);
    check_finite(section + "/Growth", shared.growth);
    std::vector<double> sorted = shared.frequencies;
    AssertThrow(!sorted.empty(), ExcMessage(section + "/Frequency: the list is empty. Give one "
                                                      "frequency or more [Hz]."));
    for (const double frequency : sorted)
      check_positive(section + "/Frequency", frequency,
                     "Give a positive frequency [Hz]; a body at rest or without joints has "
                     "Gait/Type = none.");
    std::sort(sorted.begin(), sorted.end());
    AssertThrow(std::adjacent_find(sorted.begin(), sorted.end(),
                                   [](const double a, const double b) {
                                     return b - a < 1e-5 * b;
                                   }) == sorted.end(),
                ExcMessage(section + "/Frequency: two values are the same; their results would be "
                                     "written to the same files. Leave one out."));
    type.check(section);
  }

  std::unique_ptr<Gait> GaitParameters::create(const double length) const
  {
    std::unique_ptr<Gait> gait = type.create();
    gait->set_up(shared, length);
    return gait;
  }

  namespace
  {
    // The phases at which the symmetries of a gait are looked for.
    const unsigned int n_samples = 120;

    double get_phase(const unsigned int k)
    {
      return 2. * numbers::PI * k / n_samples;
    }

    /** Whether a = factor b. */
    bool are_equal(const std::vector<double> &a, const std::vector<double> &b, const double factor)
    {
      return std::equal(a.begin(), a.end(), b.begin(), [factor](const double x, const double y) {
        return std::abs(x - factor * y) < 1e-9;
      });
    }
  } // namespace

  bool is_reciprocal(const Gait &gait)
  {
    std::vector<std::vector<double>> shapes;
    for (unsigned int k = 0; k < n_samples && gait.is_periodic(); ++k)
      shapes.push_back(gait.describe_shape(get_phase(k)));
    // Played backwards from one phase and forwards from another one it is the same.
    for (unsigned int shift = 0; shift < shapes.size(); ++shift)
    {
      unsigned int k = 0;
      while (k < n_samples && are_equal(shapes[k], shapes[(shift + n_samples - k) % n_samples], 1.))
        ++k;
      if (k == n_samples)
        return true;
    }
    return false;
  }

  bool has_glide_symmetry(const Gait &gait)
  {
    for (unsigned int k = 0; k < n_samples / 2 && gait.is_periodic(); ++k)
      if (!are_equal(gait.evaluate(get_phase(k)).c, gait.evaluate(get_phase(k + n_samples / 2)).c,
                     -1.))
        return false;
    return gait.is_periodic();
  }
} // namespace caudal
