// SPDX-License-Identifier: LGPL-2.1-or-later
// Muscles: when the bang-bang muscle switches, and that neither the step size
// nor a rejected step changes its impulse; values of wave, fibres and table,
// in the middle of their periods and at their edges; controllers; bad input.

#include <caudal/base/archive.h>
#include <caudal/fish/muscle.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>

#include "../entries.h"

using namespace caudal;

const double omega = 2. * numbers::PI;

// A tail point in the motion 0.1 m sin(2 pi t/s): it reaches +-0.05 m, the
// switching position, while driven there at t = 1/12, 7/12, 13/12, ... s.
SwimmerState get_state(const double time, const double step)
{
  SwimmerState state;
  state.time             = time;
  state.step             = step;
  state.lateral_position = 0.1 * std::sin(omega * time);
  state.lateral_velocity = 0.1 * omega * std::cos(omega * time);
  return state;
}

template <int dim = 2>
std::unique_ptr<Muscle<dim>>
make_muscle(const Entries &entries, const double length = 1.,
            const std::map<std::string, types::material_id> &regions = {})
{
  MuscleParameters<dim> parameters;
  set_entries(parameters, "Muscle", entries);
  parameters.check("Body fish");
  return parameters.create(length, regions);
}

Entries get_bang_bang(const double switching_duration = 0.)
{
  return {{"Type", "bang-bang"},
          {"Bang-bang/Maximum force density", "1"},
          {"Bang-bang/Switching position", "0.05"},
          {"Bang-bang/Switching duration", Patterns::Tools::to_string(switching_duration)}};
}

// A step of which nothing but the command matters.
Contraction command(const Muscle<2> &muscle, const MuscleCommand &command)
{
  return muscle.contract(muscle.get_initial_memory(), SwimmerState(), command);
}

const MaterialPoint<2> point{Point<2>(0.7, 0.), 0};

struct Impulses
{
  double midpoint; // force in the middle of each step
  double bdf2;     // velocity of a unit mass by BDF2, force at the end of each step
};

// Impulse until @p end in @p n_steps steps; some steps are rejected first.
Impulses compute_impulses(const double end, const unsigned int n_steps,
                          const double switching_duration = 0., const bool reject = false)
{
  const auto   muscle  = make_muscle(get_bang_bang(switching_duration));
  MuscleMemory memory  = muscle->get_initial_memory();
  const double step    = end / n_steps;
  double       impulse = 0., u = 0., u_old = 0.;
  for (unsigned int n = 0; n < n_steps; ++n)
  {
    const double time = n * step;
    if (reject)
      muscle->contract(memory, get_state(time, 3.3 * step), MuscleCommand());
    const Contraction now = muscle->contract(memory, get_state(time, step), MuscleCommand());
    impulse += step * muscle->force_density(now, point, time + 0.5 * step)[1];
    const double force = muscle->force_density(now, point, time + step)[1];
    const double u_new = n == 0 ? u + step * force : (4. * u - u_old + 2. * step * force) / 3.;
    u_old              = u;
    u                  = u_new;
    memory             = now.after;
  }
  return {impulse, u};
}

// As a checkpoint keeps it and gives it back.
Contraction unpack_contraction(const Contraction &contraction)
{
  Contraction result;
  unpack(pack(contraction), result);
  return result;
}

void test_bang_bang()
{
  std::cout << "Largest error of the impulse (-0.2) until 1.8 s: steps, midpoint, BDF2"
            << std::endl;
  for (const unsigned int n : {100, 200, 400, 800})
  {
    double midpoint = 0., bdf2 = 0., difference = 0.;
    // Steps of many sizes, so that the crossings fall anywhere in a step
    for (unsigned int i = 0; i < n / 5; ++i)
    {
      const Impulses impulses = compute_impulses(1.8, n + i);
      const Impulses again    = compute_impulses(1.8, n + i, 0., true);
      midpoint                = std::max(midpoint, std::abs(impulses.midpoint + 0.2));
      bdf2                    = std::max(bdf2, std::abs(impulses.bdf2 + 0.2));
      difference +=
          std::abs(impulses.midpoint - again.midpoint) + std::abs(impulses.bdf2 - again.bdf2);
    }
    std::cout << n << std::scientific << std::setprecision(2) << "  " << midpoint << "  " << bdf2
              << std::defaultfloat << std::setprecision(6)
              << (difference == 0. ? "  rejected steps leave no trace" : "  rejected steps matter")
              << std::endl;
  }
  const auto rounded = [](const double x) { return std::round(x * 1e4) / 1e4; };
  std::cout << "Impulse until 1.3 s (-2/15 + switching duration): "
            << rounded(compute_impulses(1.3, 2000).midpoint) << ", "
            << rounded(compute_impulses(1.3, 2000, 0.05).midpoint) << ", "
            << rounded(compute_impulses(1.3, 2000, 0.05).bdf2) << std::endl;

  // A crossing at a known place in a step; resuming; command and distribution
  Entries entries               = get_bang_bang();
  entries["Force distribution"] = "2*s + 10*y";
  entries["Regions"]            = "tail";
  entries["Start-up ramp"]      = "4";
  const std::map<std::string, types::material_id> regions{{"head", 1}, {"tail", 7}};
  const auto                                      muscle = make_muscle(entries, 2., regions);
  SwimmerState                                    state;
  state.time             = 1.9;
  state.step             = 0.2;
  state.lateral_position = 0.04;
  state.lateral_velocity = 0.2;
  const Contraction now  = muscle->contract(muscle->get_initial_memory(), state, {0.5, 0.75});
  std::cout << "Switching at a quarter of the step, mean sign -0.5, gain 0.5, bias 0.75, half "
               "way up the ramp: activation "
            << muscle->activation(now) << "\n  force "
            << muscle->force_density(now, {Point<2>(1., 0.1), 7}, 2.) << ", outside its region "
            << muscle->force_density(now, {Point<2>(1., 0.1), 1}, 2.) << std::endl;
  state.time                = 2.1;
  state.lateral_position    = 0.08;
  const Contraction resumed = unpack_contraction(now);
  std::cout << "Driven back while beyond the position it does not switch: activation "
            << muscle->activation(muscle->contract(now.after, state, {0.5, 0.75})) << ", resumed "
            << muscle->activation(muscle->contract(resumed.after, state, {0.5, 0.75})) << std::endl;
}

void test_travelling_wave()
{
  const auto        muscle = make_muscle<3>({{"Type", "travelling wave"},
                                             {"Travelling wave/Maximum active stress", "100"},
                                             {"Travelling wave/Envelope", "s^2"},
                                             {"Travelling wave/Wave number", "1.5"},
                                             {"Travelling wave/Frequency", "2"},
                                             {"Travelling wave/Reference half thickness", "0.05"}},
                                     2.);
  const Contraction now;
  const Point<3>    s(1., 0.02, 0.3);
  // 100 Pa * 0.5^2 * (0.02/0.1) * sin(2 pi (2*0.1 - 1.5*0.5))
  std::cout << "Wave: " << muscle->active_stress(now, {s, 0}, 0.1)[0][0] << " = "
            << 5. * std::sin(omega * (0.2 - 0.75)) << ", on the other side "
            << muscle->active_stress(now, {Point<3>(1., -0.02, 0.3), 0}, 0.1)[0][0]
            << ", with the crest's speed later and further back "
            << muscle->active_stress(now, {Point<3>(1.2, 0.02, 0.), 0}, 0.175)[0][0] / 0.36 * 0.25
            << "\n  lateral stress " << muscle->active_stress(now, {s, 0}, 0.1)[1][1] << ", force "
            << muscle->has_force() << ", active stress " << muscle->has_active_stress()
            << std::endl;
}

void test_fibres()
{
  const auto         muscle = make_muscle({{"Type", "fibres"},
                                           {"Regions", "wall"},
                                           {"Fibres/Tension", "5*x*t"},
                                           {"Fibres/Direction", "-y; x"}},
                                          1., {{"wall", 3}});
  const Contraction  now;
  const Point<2>     s(0.4, 0.3);
  const Tensor<2, 2> stress = muscle->active_stress(now, {s, 3}, 2.);
  // 5*0.4*2 Pa along (-0.6, 0.8)
  std::cout << "Fibres: " << stress << ", outside their region "
            << muscle->active_stress(now, {s, 0}, 2.).norm() << std::endl;
  try
  {
    muscle->active_stress(now, {Point<2>(), 3}, 1.);
  }
  catch (const ExceptionBase &exception)
  {
    exception.print_info(std::cout);
  }
}

void write(const std::string &text)
{
  std::ofstream("muscle_table.txt") << text;
}

template <class Action>
void expect_sentence(const Action &action)
{
  try
  {
    action();
    std::cout << "    no complaint" << std::endl;
  }
  catch (const ExceptionBase &exception)
  {
    exception.print_info(std::cout);
  }
}

// The muscle that the file says, with or without a period.
std::unique_ptr<Muscle<2>> make_table_muscle(const bool periodic)
{
  return make_muscle({{"Type", "table"},
                      {"Table/File", "muscle_table.txt"},
                      {"Table/Periodic", periodic ? "true" : "false"}});
}

// Its force on a body of unit length, where the distribution is 1.
double get_force(const Muscle<2> &muscle, const double time, const double s,
                 const MuscleCommand &given = MuscleCommand())
{
  return muscle.force_density(command(muscle, given), {Point<2>(s, 0.), 0}, time)[1];
}

void test_table()
{
  write("# a comment\ntime, 0.5, 0.75, 1\r\n0, 1, 2, 4\r\n\n0.1, 3, 4, 8 # and another\n"
        "0.4, 1, 2, 4\n");
  const auto table = make_table_muscle(true);
  std::cout << "Table: " << get_force(*table, 0., 0.5) << ' ' << get_force(*table, 0.05, 0.75)
            << ' ' << get_force(*table, 0.1, 0.875) << ' ' << get_force(*table, 0.25, 0.2) << ' '
            << get_force(*table, 0.4 * 7. + 0.1, 1.) << ' ' << get_force(*table, 0.5, 2.)
            << ", largest " << get_force(*table, 0., 0., {0., 1.}) << std::endl;

  const auto muscle = make_muscle({{"Type", "table"},
                                   {"Table/File", "muscle_table.txt"},
                                   {"Table/Periodic", "true"},
                                   {"Force distribution", "s"}},
                                  2.);
  std::cout << "  force "
            << muscle->force_density(command(*muscle, {2., 0.5}), {Point<2>(1.5, 0.), 0}, 0.05)
            << " = (2*3 + 0.5*8)*0.75" << std::endl;

  write("0 1\n1 2\n");
  const auto single = make_table_muscle(false);
  std::cout << "  one column: " << get_force(*single, 0.25, 0.9) << std::endl;
  expect_sentence([&] { get_force(*single, 1.5, 0.); });
  expect_sentence([] { make_muscle({{"Type", "table"}, {"Table/File", "no_such_table.txt"}}); });
  for (const std::string text : {"0 1\n0.5 2 3\n1 2\n", "time, 0.5, 1\n0, 1, 2\n1, , 2\n",
                                 "0 1\n0.5 nan\n", "0 1\n0.5 2\n0.5 3\n", "0 1\n0.5 two\n",
                                 "time 0.5 0.4\n", "# nothing\n0 1\n", "0 1\n1 2\n"})
  {
    write(text);
    expect_sentence([] { make_table_muscle(true); });
  }
}

void test_controllers()
{
  SwimmerState state;
  state.heading  = 0.2;
  state.yaw_rate = -0.1;
  state.speed    = 1.25;
  for (const std::string type : {"none", "heading", "speed"})
  {
    ControllerParameters parameters;
    set_entries(parameters, "Controller",
                {{"Type", type},
                 {"Heading/Target heading", "0.1"},
                 {"Heading/Heading gain", "2"},
                 {"Heading/Yaw rate gain", "0.5"},
                 {"Speed/Target speed", "1"}});
    const auto   controller = parameters.type.create();
    SwimmerState far        = state;
    far.heading             = 3.;
    far.speed               = -5.;
    const MuscleCommand a   = controller->compute_command(state),
                        b   = controller->compute_command(far);
    std::cout << "Controller " << type << ": gain " << a.gain << ", bias " << a.bias
              << "; far off: gain " << b.gain << ", bias " << b.bias << std::endl;
  }
  ControllerParameters parameters;
  set_entries(parameters, "Controller", {{"Type", "speed"}, {"Speed/Largest gain", "0.5"}});
  expect_sentence([&] { parameters.check("Body fish"); });
}

void test_bad_parameters()
{
  const std::map<std::string, types::material_id> regions{{"head", 1}, {"tail", 7}};
  Entries                                         entries = get_bang_bang();
  entries["Regions"]                                      = "tail, tongue";
  entries["Bang-bang/Switching position"]                 = "-0.1";
  expect_sentence([&] { make_muscle(entries, 1., regions); });
  entries["Bang-bang/Switching position"] = "0.05";
  expect_sentence([&] { make_muscle(entries, 1., regions); });
  entries["Force distribution"] = "s*(";
  expect_sentence([&] { make_muscle(entries, 1., regions); });
  entries["Force distribution"] = "1/(s-0.5)";
  expect_sentence([&] { make_muscle(entries, 1., regions); });
}

int main()
{
  // deal.II repeats the parser's complaints there, and tests merge it with stdout.
  std::cerr.rdbuf(nullptr);

  test_bang_bang();
  test_travelling_wave();
  test_fibres();
  test_table();
  test_controllers();
  test_bad_parameters();
}
