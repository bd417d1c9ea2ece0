// SPDX-License-Identifier: LGPL-2.1-or-later
// Tail beats of synthetic signals with known period, amplitude, speed, power, thrust and
// energies; the table on the screen and in both files.

#include <caudal/observe/swim_report.h>

#include <boost/archive/text_iarchive.hpp>
#include <boost/archive/text_oarchive.hpp>

#include <cmath>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <sstream>

using namespace caudal;

namespace
{
  using Signal = std::function<double(double)>;

  void print_cycles(const std::string &title, const Signal &signal, const double end)
  {
    std::cout << title << ":\n" << std::fixed << std::setprecision(3);
    TailCycleDetector detector(0.005);
    for (unsigned int i = 0; 0.002 * i < end; ++i)
      if (const auto cycle = detector.add(0.002 * i, signal(0.002 * i)))
        std::cout << "  start " << cycle->start << " end " << cycle->end << " amplitude "
                  << cycle->amplitude << '\n';
  }

  void swim(SwimReport &report, const double begin, const double end)
  {
    // Speed v = 2 (1 - exp(-3 t)) + 0.01 sin(4 pi t / T), power 50 (1 + cos(4 pi t / T)): 50
    // on average, 100 at most. In the end the fluid's force is 80 0.01 4 pi / T cos(4 pi t / T):
    // thrust and drag are 8. Something pulls at the body with 3. The control volume finds a
    // force of 0.5 too much. Of the power 5 become
    // kinetic energy, 40 heat (10 by stabilisation), 4 go to springs, and 1 is lost.
    const double T = 0.4;
    // No sample lies at a crossing or a peak, where round-off would decide.
    const double step = 0.0037;
    for (unsigned int i = std::ceil(begin / step); step * i < end; ++i)
    {
      const double t     = step * i;
      const double phase = 4 * M_PI * t / T;
      SwimSample   sample;
      sample.time = t;
      // The fish swims at an angle of 0.5 to its axis and yaws: seen from its head, the tail swings
      // 2.5 times as far as from the path.
      sample.tail_position    = -0.25 * std::sin(phase / 2);
      sample.forward_position = 2 * (t + (std::exp(-3 * t) - 1) / 3);
      const Tensor<1, 2> path = Point<2>(std::cos(0.5), std::sin(0.5));
      const Tensor<1, 2> side = Point<2>(-path[1], path[0]);
      sample.centre           = 2 * t * path;
      sample.tail             = sample.centre - 0.5 * path - 0.1 * std::sin(phase / 2) * side;
      sample.muscle_work      = 50 * (t + T / (4 * M_PI) * std::sin(phase));
      sample.forward_momentum = 80 * (2 * (1 - std::exp(-3 * t)) + 0.01 * std::sin(phase)) + 3 * t;
      sample.body_impulse     = 3 * t;
      sample.fluid_impulse    = sample.forward_momentum - 2.5 * t;
      sample.ledger.muscle_work           = sample.muscle_work;
      sample.ledger.feedback_work         = -4 * t;
      sample.ledger.external_work         = 2 * t;
      sample.ledger.kinetic_energy        = 5 * t;
      sample.ledger.dissipation           = 40 * t;
      sample.ledger.numerical_dissipation = 10 * t;
      report.add(sample);
    }
  }
} // namespace

int main()
{
  const double omega = 2 * M_PI / 0.4;
  print_cycles(
      "Sine, up first", [&](double t) { return 0.1 * std::sin(omega * t); }, 1.4);
  print_cycles(
      "Sine, down first", [&](double t) { return -0.1 * std::sin(omega * t); }, 1.4);
  print_cycles(
      "Drifting sideways", [&](double t) { return 0.05 * t + 0.1 * std::sin(omega * t); }, 1.4);
  print_cycles(
      "With ripples",
      [&](double t) { return 0.1 * std::sin(omega * t) + 0.01 * std::sin(9 * omega * t); }, 1.4);
  print_cycles(
      "Noise only", [&](double t) { return 0.002 * std::sin(omega * t); }, 1.4);

  SwimmerConstants fish{"fish", 1., 80., 1e-6, 1000., 2.};
  fish.has_control_volume = true;
  SwimReport report(fish, std::cout, "");
  swim(report, 0., 1.6);

  // Half of the way: the rest is reported by a resumed run.
  std::stringstream archive;
  boost::archive::text_oarchive(archive) << report;
  SwimReport resumed(fish, std::cout, "swim.txt");
  {
    boost::archive::text_iarchive in(archive);
    in >> resumed;
  }
  swim(resumed, 1.6, 3.5);
  resumed.finish();
  for (const char *file : {"swim.txt", "swim.json"})
    std::cout << '\n' << std::ifstream(file).rdbuf();

  // A solid in three dimensions that has not beaten its tail yet.
  SwimmerConstants ball = fish;
  ball.is_per_span      = false;
  SwimReport(ball, std::cout, "").finish();
}
