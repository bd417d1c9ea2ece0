// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/fish/gait.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  namespace
  {
    /**
     * A wave of the lateral displacement,
     *   y = r(t) a L (s/L + b)/(1 + b) sin(2 pi (k s/L - f t)), r the start-up ramp:
     * a = 0.125, b = 0.03125, k = 1 is the eel of Kern and Koumoutsakos, J. Exp.
     * Biol. 209, 2006, and of Carling et al., J. Exp. Biol. 201, 1998. Since s is the arc length,
     * sin theta = dy/ds.
     */
    class TravellingWaveGait : public Gait
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Amplitude", amplitude,
                          "Lateral amplitude a of the tail, over the body length [-], in y = a L "
                          "(s/L + b)/(1 + b) sin(2 pi (k s/L - f t)).");
        prm.add_parameter("Offset", offset, "b, of which the nose's amplitude is a b/(1 + b) [-].");
        prm.add_parameter("Wave number", wave_number, "k, the waves on the body [-].");
        prm.add_parameter("Frequency", frequency, "f, the tail-beat frequency [Hz].");
      }

      void check(const std::string &path) const override
      {
        check_value(offset > -1., path + "/Offset", offset, "Give more than -1.");
        check_positive(path + "/Frequency", frequency, "Give a positive frequency [Hz].");
        // The slope of the midline is largest at one of the ends, in the course of a beat.
        const double k = 2. * numbers::PI * wave_number;
        const double steepest =
            std::max(std::hypot(1., k * offset), std::hypot(1., k * (1. + offset))) / (1. + offset);
        const double slope = std::abs(amplitude) * steepest;
        check_value(slope < 1., path + "/Amplitude", amplitude,
                    "The slope of the midline reaches " + Patterns::Tools::to_string(slope) +
                        ", and a midline of constant length allows less than 1. Give an amplitude "
                        "below " +
                        Patterns::Tools::to_string(1. / steepest) + ", or a smaller wave number.");
      }

      std::vector<double> get_frequencies() const override
      {
        return {frequency};
      }

    protected:
      std::vector<Motion> compute_inclinations(const std::vector<double> &s,
                                               const double               argument) const override
      {
        const double omega = 2. * numbers::PI * frequency, k = 2. * numbers::PI * wave_number;
        const double psi      = is_periodic() ? argument : omega * argument;
        const double psi_rate = is_periodic() ? 1. : omega;
        // At the phase of a periodic gait there is no start-up.
        const double growth      = shared.ramp.duration > 0. ? shared.ramp.value(argument) : 1.;
        const double growth_rate = shared.ramp.duration > 0. ? shared.ramp.rate(argument) : 0.;
        const double slope       = amplitude / (1. + offset);

        std::vector<Motion> inclinations;
        for (const double place : s)
        {
          const double x = place / length, phase = k * x - psi;
          const double wave = slope * (std::sin(phase) + (x + offset) * k * std::cos(phase));
          const double wave_rate =
              -psi_rate * slope * (std::cos(phase) - (x + offset) * k * std::sin(phase));
          const double sine      = growth * wave;
          const double sine_rate = growth * wave_rate + growth_rate * wave;
          AssertThrow(std::abs(sine) < 1.,
                      ExcMessage("Gait: the slope of the midline reaches " + std::to_string(sine) +
                                 ", and a midline of constant length allows less than 1. Reduce "
                                 "the amplitude or the wave number."));
          inclinations.push_back({std::asin(sine), sine_rate / std::sqrt(1. - sine * sine)});
        }
        return inclinations;
      }

    private:
      double amplitude   = 0.125;
      double offset      = 0.03125;
      double wave_number = 1.;
      double frequency   = 1.;
    };

    const Registration<Gait, TravellingWaveGait> registration("travelling wave",
                                                              "a wave of the lateral displacement");
  } // namespace
} // namespace caudal
