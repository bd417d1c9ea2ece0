// SPDX-License-Identifier: LGPL-2.1-or-later
// Measured midlines: a known wave comes back from its points, in any unit and place, and from its
// curvatures; noise is filtered; what is left of it is told; bad tables.

#include <caudal/base/collective.h>
#include <caudal/fish/gait.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>

#include "../entries.h"

using namespace caudal;

namespace
{
  const double L = 0.3, period = 0.5;

  /** theta(s/L, t), with the harmonics and modes that the fits have. */
  double compute_inclination(const double x, const double time)
  {
    const double psi = 2. * numbers::PI * time / period, y = 2. * x - 1.;
    return 0.4 * y * std::sin(psi) + 0.2 * (y * y - 1.) * std::cos(2. * psi) + 0.1 * (y + 1.);
  }

  /** A number that looks random, from -1 to 1. */
  double get_noise()
  {
    static unsigned int state = 1;
    state                     = 1664525u * state + 1013904223u;
    return state / 2147483648. - 1.;
  }

  /** Rows of points in millimetres of a fish elsewhere that also turns, which grows by 2 %. */
  void write_points(const std::string &name, const unsigned int n_rows, const double noise)
  {
    std::ofstream file(name);
    file << "time,x1,y1\n" << std::setprecision(12);
    for (unsigned int i = 0; i < n_rows; ++i)
    {
      const double time = i * period / (n_rows - 1), length = 300. * (1. + 0.02 * i / n_rows);
      const double turn = 3. + 0.5 * std::sin(2. * numbers::PI * time / period);
      double       x = 70. + 1000. * time, y = -20.;
      file << time;
      const unsigned int n_pieces = 4000, n_points = 20;
      for (unsigned int p = 0; p <= n_pieces; ++p)
      {
        if (p % (n_pieces / n_points) == 0)
          file << ", " << x + noise * length * get_noise() << ", "
               << y + noise * length * get_noise();
        const double theta = turn + compute_inclination((p + 0.5) / n_pieces, time);
        x += length / n_pieces * std::cos(theta);
        y += length / n_pieces * std::sin(theta);
      }
      file << '\n';
    }
  }

  void write_curvatures(const std::string &name)
  {
    std::ofstream file(name);
    file << std::setprecision(12);
    for (unsigned int i = 0; i <= 20; ++i)
    {
      const double time = i * period / 20.;
      file << time;
      for (unsigned int p = 0; p <= 400; ++p)
      {
        const double x = p / 400., step = 1e-4;
        file << "; "
             << (compute_inclination(x + step, time) - compute_inclination(x - step, time)) /
                    (2. * step * L);
      }
      file << '\n';
    }
  }

  std::unique_ptr<Gait> make_gait(const Entries &entries)
  {
    GaitParameters parameters;
    Entries all = {{"Type", "midline"}, {"Midline/File", "points.csv"}, {"Midline/Modes", "4"}};
    for (const auto &entry : entries)
      all[entry.first] = entry.second;
    set_entries(parameters, "Gait", all);
    parameters.check("Body fish");
    return parameters.create(L);
  }

  void check(const std::string &name, const Entries &entries)
  {
    const auto          gait = make_gait(entries);
    std::vector<double> places;
    for (unsigned int p = 0; p <= 10; ++p)
      places.push_back(p * L / 10);
    double error = 0., rate_error = 0.;
    for (const double time : {0.03, 0.1, 0.22, 0.41})
    {
      const double      rate   = gait->get_argument_rate(gait->get_frequencies()[0]);
      const GaitState   state  = gait->evaluate(rate * time);
      const SpineAngles angles = gait->compute_angles(places, state.c);
      for (unsigned int p = 0; p < places.size(); ++p)
      {
        const auto exact = [&](const double t) {
          return compute_inclination(p / 10., t) - compute_inclination(0., t);
        };
        double by_time = 0.;
        for (unsigned int k = 0; k < state.rates.size(); ++k)
          by_time += rate * state.rates[k] * angles.by_c[k][p];
        error      = std::max(error, std::abs(angles.theta[p] - exact(time)));
        rate_error = std::max(rate_error,
                              std::abs(by_time - (exact(time + 1e-5) - exact(time - 1e-5)) / 2e-5));
      }
    }
    std::cout << name << ": " << gait->describe() << "\n  inclination off by "
              << std::setprecision(2) << error << ", its rate by " << rate_error << std::endl;
  }

  void print_error(const std::string &text, const Entries &entries)
  {
    std::ofstream("bad.csv") << text;
    Entries all = {{"Midline/File", "bad.csv"}};
    for (const auto &entry : entries)
      all[entry.first] = entry.second;
    std::cout << catch_error([&] { make_gait(all); }) << std::endl;
  }
} // namespace

int main()
{
  write_points("points.csv", 21, 0.);
  write_points("noisy.csv", 81, 0.005);
  write_curvatures("curvatures.csv");
  check("points", {});
  check("points with noise of half a percent", {{"Midline/File", "noisy.csv"}});
  check("the same, not periodic", {{"Midline/File", "noisy.csv"},
                                   {"Midline/Periodic", "false"},
                                   {"Midline/Smoothing time", "0.01"}});
  check("curvatures", {{"Midline/File", "curvatures.csv"}, {"Midline/Quantity", "curvature"}});

  const std::string row = ";0;0;1;0;2;0;3;0;4;0;5;0\n";
  print_error("0" + row + "1" + row, {});
  print_error("0" + row + "1" + row + "2" + row + "3" + row, {});
  print_error("0" + row + "1" + row + "1" + row + "3" + row, {{"Midline/Harmonics", "1"}});
  print_error("0" + row + "1;0;0\n2" + row + "3" + row, {{"Midline/Harmonics", "1"}});
  print_error("0" + row + "1;0;0;1;0;1;0;3;0;4;0;5;0\n2" + row + "3" + row,
              {{"Midline/Harmonics", "1"}});
  print_error("0" + row + "1" + row + "2" + row + "3" + row,
              {{"Midline/Modes", "5"}, {"Midline/Harmonics", "1"}});
  print_error("0" + row + "1" + row + "2" + row + "3" + row,
              {{"Midline/Period", "2"}, {"Midline/Harmonics", "1"}});
  print_error("0;1\n1;1\n2;1\n3;1\n", {});
}
