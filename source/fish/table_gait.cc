// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/joint_gait.h>
#include <caudal/fish/number_table.h>
#include <caudal/fish/spline.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace caudal
{
  namespace
  {
    const double degree = numbers::PI / 180.;

    /**
     * Joint angles from a control file, rows of a time [s] and six angles [degrees], with cubic
     * splines between the rows.
     */
    class TableGait : public JointGait
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("File", file,
                          "The control file: rows of a time [s] and the angles of the six joints "
                          "[degrees].",
                          Patterns::FileName(Patterns::FileName::input));
        prm.add_parameter("Periodic", periodic,
                          "Whether the table is one period, which its last row closes; otherwise "
                          "(in an ideal fluid) a new surface is computed in each step.");
      }

      void check(const std::string &path) const override
      {
        read(path + "/File");
      }

      void set_up(const SharedGaitParameters &shared_parameters, const double length) override
      {
        Gait::set_up(shared_parameters, length);
        const NumberTable   table = read("Gait/Table/File");
        std::vector<double> times;
        for (const auto &row : table.rows)
          times.push_back(row.values[0]);
        start = times.front();
        end   = times.back();
        splines.clear();
        for (unsigned int i = 1; i <= n_joints; ++i)
        {
          std::vector<double> angles;
          for (const auto &row : table.rows)
            angles.push_back(row.values[i] * degree);
          splines.push_back(std::make_shared<Spline>(
              times, angles, periodic ? Spline::Kind::periodic : Spline::Kind::natural));
        }
      }

      std::vector<double> get_frequencies() const override
      {
        return {1. / (end - start)};
      }

      double get_end() const override
      {
        return periodic ? Gait::get_end() : end - start;
      }

    protected:
      bool has_period() const override
      {
        return periodic;
      }

      GaitState evaluate_stroke(const double argument) const override
      {
        const double scale = periodic ? (end - start) / (2. * numbers::PI) : 1.;
        double       time  = start + scale * argument;
        if (!periodic)
          time = std::clamp(time, start, end);
        GaitState state;
        for (const auto &spline : splines)
        {
          const auto [angle, rate] = spline->evaluate(time);
          state.c.push_back(angle + shared.bias * degree);
          state.rates.push_back(rate * scale);
        }
        return state;
      }

    private:
      NumberTable read(const std::string &entry) const
      {
        NumberTable       table = read_number_table(entry, file, 1 + n_joints);
        const auto       &rows  = table.rows;
        const std::string place = entry + ": " + file + ": ";
        AssertThrow(rows.size() >= 4,
                    ExcMessage(place + "there are " + std::to_string(rows.size()) +
                               " rows of numbers. Give at least four."));
        std::vector<double> steps;
        for (std::size_t i = 1; i < rows.size(); ++i)
        {
          steps.push_back(rows[i].values[0] - rows[i - 1].values[0]);
          AssertThrow(steps.back() > 0.,
                      ExcMessage(place + "the time " +
                                 Patterns::Tools::to_string(rows[i].values[0]) +
                                 " s is not later than that of the row before. Sort the rows by "
                                 "time."));
        }
        std::vector<double> sorted = steps;
        std::sort(sorted.begin(), sorted.end());
        const double median = sorted[sorted.size() / 2];
        for (std::size_t i = 0; i < steps.size(); ++i)
          AssertThrow(steps[i] <= 10. * median,
                      ExcMessage(place + "there is a gap after the time " +
                                 Patterns::Tools::to_string(rows[i].values[0]) +
                                 " s, more than ten times as long as the usual step of " +
                                 Patterns::Tools::to_string(median) + " s. Add the missing rows."));
        for (unsigned int i = 1; i <= n_joints; ++i)
          AssertThrow(!periodic || std::abs(rows.front().values[i] - rows.back().values[i]) < 1e-6,
                      ExcMessage(place + "the table is periodic, and its last row differs from "
                                         "its first. End it with the first row's angles, at "
                                         "the time where the period ends."));
        return table;
      }

      std::string                                file;
      bool                                       periodic = true;
      double                                     start = 0., end = 1.; // [s]
      std::vector<std::shared_ptr<const Spline>> splines;              // by joint
    };

    const Registration<Gait, TableGait> registration("table", "joint angles from a control file");
  } // namespace
} // namespace caudal
