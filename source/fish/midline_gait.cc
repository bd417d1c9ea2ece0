// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/fish/gait.h>
#include <caudal/fish/least_squares.h>
#include <caudal/fish/measured_midline.h>
#include <caudal/fish/spline.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

namespace caudal
{
  namespace
  {
    /**
     * A measured midline: theta = sum_k c_k(t) (P_k(2 s/L - 1) - P_k(-1)), k = 1 to n, in which the
     * c_k are filtered in time. Of a periodic one the Fourier series up to some harmonic of the
     * period is taken, by least squares over all rows; of any other one the mean of the rows,
     * weighted by exp(-(t - t_k)^2/(2 T^2)), and a cubic spline through these means. Swimming
     * decides on place and heading of the head.
     */
    class MidlineGait : public ModalGait
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("File", file,
                          "Table with a row for each time [s] and then the points x1, y1, x2, y2, "
                          "... of the midline from nose to tail, in any unit, or its curvatures "
                          "[1/m] at equal distances.",
                          Patterns::FileName(Patterns::FileName::input));
        prm.add_parameter("Quantity", quantity, "What the rows hold.",
                          Patterns::Selection("points|curvature"));
        prm.add_parameter("Modes", n_modes,
                          "Filter in space: degree of the polynomial that the midline's "
                          "inclination is along the body.",
                          Patterns::Integer(1, 20));
        prm.add_parameter("Periodic", periodic, "Whether the motion repeats.");
        prm.add_parameter("Period", period,
                          "Of a periodic motion [s]; 0: the time from the first row to the last.");
        prm.add_parameter("Harmonics", n_harmonics,
                          "Filter in time of a periodic motion: how many harmonics it has.",
                          Patterns::Integer(1, 20));
        prm.add_parameter("Smoothing time", smoothing_time,
                          "Filter in time of any other motion: standard deviation T of the weights "
                          "with which rows are averaged [s]; 0: none.");
      }

      void check(const std::string &path) const override
      {
        check_not_negative(path + "/Period", period, "Give a positive time [s], or 0.");
        check_not_negative(path + "/Smoothing time", smoothing_time,
                           "Give a positive time [s], or 0.");
        const std::vector<double> times  = read(path + "/File", 1.).times;
        const std::size_t         n_rows = times.size();
        AssertThrow(!periodic || n_rows >= 2 * n_harmonics + 2,
                    ExcMessage(path + "/Harmonics: there are " + std::to_string(n_rows) +
                               " midlines in " + file + ", which are too few for " +
                               std::to_string(n_harmonics) +
                               " harmonics. Give two for each harmonic and two more, or fewer "
                               "harmonics."));
        const std::size_t n_phases = periodic ? count_phases(times) : 0;
        AssertThrow(!periodic || n_phases > 2 * n_harmonics,
                    ExcMessage(path + "/Period: the midlines in " + file + " are at " +
                               std::to_string(n_phases) +
                               " different phases of it only, which are too few for " +
                               std::to_string(n_harmonics) +
                               " harmonics. Give two for each harmonic and one more, or fewer "
                               "harmonics."));
      }

      void set_up(const SharedGaitParameters &shared_parameters, const double length) override
      {
        Gait::set_up(shared_parameters, length);
        const MeasuredMidline midline = read("Gait/Midline/File", length);
        start                         = midline.times.front();
        end                           = midline.times.back();
        if (periodic && period > 0.)
          end = start + period;
        series.clear();
        splines.clear();
        for (unsigned int k = 1; k <= n_modes; ++k)
        {
          std::vector<double> values;
          for (const auto &coefficients : midline.coefficients)
            values.push_back(coefficients[k]);
          if (periodic)
            series.push_back(fit_series(midline.times, values));
          else
            splines.push_back(std::make_shared<Spline>(midline.times, smooth(midline.times, values),
                                                       Spline::Kind::natural));
        }
        measure_errors(midline);
      }

      std::vector<double> get_frequencies() const override
      {
        return {1. / (end - start)};
      }

      double get_end() const override
      {
        return periodic ? Gait::get_end() : end - start;
      }

      unsigned int n_coordinates() const override
      {
        return n_modes;
      }

      std::string describe() const override
      {
        std::ostringstream text;
        text << "midline of " << file << ", " << n_modes << " modes, ";
        if (periodic)
          text << n_harmonics << " harmonics of " << end - start << " s";
        else
          text << "smoothed over " << smoothing_time << " s";
        text << "; off the measured points by " << std::round(1e5 * mean_error) / 1e3
             << " % of the length (root mean square; " << std::round(1e5 * largest_error) / 1e3
             << " % at the worst time)";
        if (longest > shortest)
          text << ", whose length was " << std::round(1e4 * shortest) / 1e4 << " to "
               << std::round(1e4 * longest) / 1e4 << " of its mean";
        return text.str();
      }

    protected:
      bool has_period() const override
      {
        return periodic;
      }

      GaitState evaluate_stroke(const double argument) const override
      {
        GaitState state;
        for (unsigned int k = 0; k < n_modes; ++k)
        {
          const auto [value, rate] =
              periodic ? evaluate_series(series[k], argument)
                       : splines[k]->evaluate(std::clamp(start + argument, start, end));
          state.c.push_back(value);
          state.rates.push_back(rate);
        }
        return state;
      }

      double mode(const unsigned int i, const double s) const override
      {
        return compute_inclination_mode(i + 1, s / length);
      }

    private:
      MeasuredMidline read(const std::string &entry, const double length) const
      {
        return read_midline(entry, file, quantity == "curvature", length, n_modes);
      }

      /** How many of the @p times are at different phases of the period, apart by more than 1e-6.
       */
      std::size_t count_phases(const std::vector<double> &times) const
      {
        const double        length = period > 0. ? period : times.back() - times.front();
        std::vector<double> phases;
        for (const double time : times)
        {
          const double turns = (time - times.front()) / length;
          phases.push_back(turns - std::floor(turns + 1e-6));
        }
        std::sort(phases.begin(), phases.end());
        return std::unique(phases.begin(), phases.end(),
                           [](const double a, const double b) { return b - a < 1e-6; }) -
               phases.begin();
      }

      double get_phase(const double time) const
      {
        return 2. * numbers::PI * (time - start) / (end - start);
      }

      /** The mean, and the coefficients of cos(j psi) and sin(j psi), j from 1 on. */
      Vector<double> fit_series(const std::vector<double> &times,
                                const std::vector<double> &values) const
      {
        return fit_least_squares(times, values, 2 * n_harmonics + 1,
                                 [&](const double time, const unsigned int i) {
                                   const double psi = (i + 1) / 2 * get_phase(time);
                                   return i % 2 == 1 ? std::cos(psi) : i == 0 ? 1. : std::sin(psi);
                                 });
      }

      std::pair<double, double> evaluate_series(const Vector<double> &coefficients,
                                                const double          psi) const
      {
        double value = coefficients[0], rate = 0.;
        for (unsigned int j = 1; j <= n_harmonics; ++j)
        {
          const double a = coefficients[2 * j - 1], b = coefficients[2 * j];
          value += a * std::cos(j * psi) + b * std::sin(j * psi);
          rate += j * (b * std::cos(j * psi) - a * std::sin(j * psi));
        }
        return {value, rate};
      }

      std::vector<double> smooth(const std::vector<double> &times,
                                 const std::vector<double> &values) const
      {
        if (smoothing_time == 0.)
          return values;
        std::vector<double> result;
        for (const double time : times)
        {
          double sum = 0., weights = 0.;
          for (std::size_t i = 0; i < times.size(); ++i)
          {
            const double x      = (times[i] - time) / smoothing_time;
            const double weight = std::exp(-0.5 * x * x);
            sum += weight * values[i];
            weights += weight;
          }
          result.push_back(sum / weights);
        }
        return result;
      }

      void measure_errors(const MeasuredMidline &midline)
      {
        shortest   = midline.shortest;
        longest    = midline.longest;
        mean_error = largest_error = 0.;
        for (std::size_t i = 0; i < midline.times.size(); ++i)
        {
          const GaitState state =
              evaluate_stroke(periodic ? get_phase(midline.times[i]) : midline.times[i] - start);
          const double error = compute_distance(midline, i, [&](const double x) {
            double theta = 0.;
            for (unsigned int k = 0; k < n_modes; ++k)
              theta += state.c[k] * mode(k, x * length);
            return theta;
          });
          mean_error += error * error / midline.times.size();
          largest_error = std::max(largest_error, error);
        }
        mean_error = std::sqrt(mean_error);
      }

      std::string  file, quantity = "points";
      unsigned int n_modes = 6, n_harmonics = 2;
      bool         periodic = true;
      double       period = 0., smoothing_time = 0.; // [s]

      double                                     start = 0., end = 1.; // [s]
      std::vector<Vector<double>>                series;               // by mode, if periodic
      std::vector<std::shared_ptr<const Spline>> splines;              // by mode, otherwise
      double mean_error = 0., largest_error = 0., shortest = 1., longest = 1.;
    };

    const Registration<Gait, MidlineGait>
        registration("midline", "a measured midline, points or curvatures over time");
  } // namespace
} // namespace caudal
