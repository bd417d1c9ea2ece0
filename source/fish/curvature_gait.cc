// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/body_function.h>
#include <caudal/fish/gait.h>

#include <boost/math/interpolators/cubic_hermite.hpp>

#include <algorithm>
#include <memory>

namespace caudal
{
  namespace
  {
    /**
     * A given curvature kappa(s,t) times the start-up ramp. theta is its integral from the nose
     * on, by the trapezoidal rule on equal pieces, between whose ends it is a cubic polynomial.
     */
    class CurvatureGait : public Gait
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Function", text,
                          "Curvature of the midline [1/m], a function of the arc length s over the "
                          "body length (0 nose, 1 tail) and the time t [s]; positive to the left "
                          "of the way from nose to tail.");
      }

      void check(const std::string &path) const override
      {
        BodyFunction(path + "/Function", "s,t", text).check_along();
      }

      void set_up(const SharedGaitParameters &shared_parameters, const double length) override
      {
        Gait::set_up(shared_parameters, length);
        curvature = std::make_shared<BodyFunction>("Gait/Curvature/Function", "s,t", text);
      }

    protected:
      bool has_period() const override
      {
        return false; // not known
      }

      std::vector<Motion> compute_inclinations(const std::vector<double> &s,
                                               const double               time) const override
      {
        const double        spacing = length / n_pieces;
        std::vector<double> theta(1, 0.), rate(1, 0.), kappa, kappa_rate;
        for (unsigned int i = 0; i <= n_pieces; ++i)
        {
          const Motion bend = compute_bend(static_cast<double>(i) / n_pieces, time);
          kappa.push_back(bend.value);
          kappa_rate.push_back(bend.rate);
          if (i > 0)
          {
            theta.push_back(theta.back() + 0.5 * spacing * (kappa[i - 1] + kappa[i]));
            rate.push_back(rate.back() + 0.5 * spacing * (kappa_rate[i - 1] + kappa_rate[i]));
          }
        }
        using Interpolation =
            boost::math::interpolators::cardinal_cubic_hermite<std::vector<double>>;
        const Interpolation value(std::move(theta), std::move(kappa), 0., spacing);
        const Interpolation derivative(std::move(rate), std::move(kappa_rate), 0., spacing);

        std::vector<Motion> inclinations;
        for (const double place : s)
        {
          const double inside = std::clamp(place, 0., spacing * n_pieces);
          inclinations.push_back({value(inside), derivative(inside)});
        }
        return inclinations;
      }

    private:
      /** The curvature [1/m] at s/L and its rate. */
      Motion compute_bend(const double s, const double time) const
      {
        const double       value = curvature->value(s, time), rate = curvature->rate(s, time);
        const StartUpRamp &ramp = shared.ramp;
        return {ramp.value(time) * value, ramp.value(time) * rate + ramp.rate(time) * value};
      }

      static constexpr unsigned int n_pieces = 400;

      std::string                         text = "0";
      std::shared_ptr<const BodyFunction> curvature;
    };

    const Registration<Gait, CurvatureGait>
        registration("curvature", "the curvature of the midline, a given function");
  } // namespace
} // namespace caudal
