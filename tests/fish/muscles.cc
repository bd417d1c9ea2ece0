// Muscles: when the bang-bang muscle switches, and that neither the step size
// nor a rejected step changes its impulse; values of wave, fibres and table,
// in the middle of their periods and at their edges; controllers; bad input.

#include <caudal/fish/force_table.h>
#include <caudal/fish/muscle.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>

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

MuscleParameters get_bang_bang(const double switching_duration = 0.)
{
  MuscleParameters parameters;
  parameters.type                            = "bang-bang";
  parameters.bang_bang.maximum_force_density = 1.;
  parameters.bang_bang.switching_position    = 0.05;
  parameters.bang_bang.switching_duration    = switching_duration;
  return parameters;
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
  const auto   muscle  = create_muscle<2>(get_bang_bang(switching_duration), 1.);
  const double step    = end / n_steps;
  double       impulse = 0., u = 0., u_old = 0.;
  for (unsigned int n = 0; n < n_steps; ++n)
  {
    const double time = n * step;
    if (reject)
      muscle->prepare_step(get_state(time, 3.3 * step));
    muscle->prepare_step(get_state(time, step));
    impulse += step * muscle->force_density(point, time + 0.5 * step)[1];
    const double force = muscle->force_density(point, time + step)[1];
    const double u_new = n == 0 ? u + step * force : (4. * u - u_old + 2. * step * force) / 3.;
    u_old              = u;
    u                  = u_new;
    muscle->accept_step();
  }
  return {impulse, u};
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
  MuscleParameters parameters   = get_bang_bang();
  parameters.force_distribution = "2*s + 10*y";
  parameters.regions            = {"tail"};
  parameters.ramp.duration      = 4.;
  const std::map<std::string, types::material_id> regions{{"head", 1}, {"tail", 7}};
  const auto   muscle  = create_muscle<2>(parameters, 2., regions);
  const auto   resumed = create_muscle<2>(parameters, 2., regions);
  SwimmerState state;
  state.time             = 1.9;
  state.step             = 0.2;
  state.lateral_position = 0.04;
  state.lateral_velocity = 0.2;
  muscle->set_command({0.5, 0.75});
  muscle->prepare_step(state);
  std::cout << "Switching at a quarter of the step, mean sign -0.5, gain 0.5, bias 0.75, half "
               "way up the ramp: activation "
            << muscle->activation() << "\n  force "
            << muscle->force_density({Point<2>(1., 0.1), 7}, 2.) << ", outside its region "
            << muscle->force_density({Point<2>(1., 0.1), 1}, 2.) << std::endl;
  muscle->accept_step();
  resumed->set_command({0.5, 0.75});
  resumed->set_state(muscle->get_state());
  state.time             = 2.1;
  state.lateral_position = 0.08;
  muscle->prepare_step(state);
  resumed->prepare_step(state);
  std::cout << "Driven back while beyond the position it does not switch: activation "
            << muscle->activation() << ", resumed " << resumed->activation() << std::endl;
}

void test_travelling_wave()
{
  MuscleParameters parameters;
  parameters.type                                     = "travelling wave";
  parameters.travelling_wave.maximum_active_stress    = 100.;
  parameters.travelling_wave.envelope                 = "s^2";
  parameters.travelling_wave.wave_number              = 1.5;
  parameters.travelling_wave.frequency                = 2.;
  parameters.travelling_wave.reference_half_thickness = 0.05;
  const auto     muscle                               = create_muscle<3>(parameters, 2.);
  const Point<3> s(1., 0.02, 0.3);
  // 100 Pa * 0.5^2 * (0.02/0.1) * sin(2 pi (2*0.1 - 1.5*0.5))
  std::cout << "Wave: " << muscle->active_stress({s, 0}, 0.1)[0][0] << " = "
            << 5. * std::sin(omega * (0.2 - 0.75)) << ", on the other side "
            << muscle->active_stress({Point<3>(1., -0.02, 0.3), 0}, 0.1)[0][0]
            << ", with the crest's speed later and further back "
            << muscle->active_stress({Point<3>(1.2, 0.02, 0.), 0}, 0.175)[0][0] / 0.36 * 0.25
            << "\n  lateral stress " << muscle->active_stress({s, 0}, 0.1)[1][1] << ", force "
            << muscle->has_force() << ", active stress " << muscle->has_active_stress()
            << std::endl;
}

void test_fibres()
{
  MuscleParameters parameters;
  parameters.type             = "fibres";
  parameters.regions          = {"wall"};
  parameters.fibres.tension   = "5*x*t";
  parameters.fibres.direction = "-y; x";
  const auto         muscle   = create_muscle<2>(parameters, 1., {{"wall", 3}});
  const Point<2>     s(0.4, 0.3);
  const Tensor<2, 2> stress = muscle->active_stress({s, 3}, 2.);
  // 5*0.4*2 Pa along (-0.6, 0.8)
  std::cout << "Fibres: " << stress << ", outside their region "
            << muscle->active_stress({s, 0}, 2.).norm() << std::endl;
  try
  {
    muscle->active_stress({Point<2>(), 3}, 1.);
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

void test_table()
{
  write("# a comment\ntime, 0.5, 0.75, 1\r\n0, 1, 2, 4\r\n\n0.1, 3, 4, 8 # and another\n"
        "0.4, 1, 2, 4\n");
  const ForceTable table("muscle_table.txt", true);
  std::cout << "Table: " << table.value(0., 0.5) << ' ' << table.value(0.05, 0.75) << ' '
            << table.value(0.1, 0.875) << ' ' << table.value(0.25, 0.2) << ' '
            << table.value(0.4 * 7. + 0.1, 1.) << ' ' << table.value(-0.3, 2.) << ", largest "
            << table.get_maximum() << std::endl;

  MuscleParameters parameters;
  parameters.type               = "table";
  parameters.table.file         = "muscle_table.txt";
  parameters.table.periodic     = true;
  parameters.force_distribution = "s";
  const auto muscle             = create_muscle<2>(parameters, 2.);
  muscle->set_command({2., 0.5});
  std::cout << "  force " << muscle->force_density({Point<2>(1.5, 0.), 0}, 0.05)
            << " = (2*3 + 0.5*8)*0.75" << std::endl;

  write("0 1\n1 2\n");
  const ForceTable single("muscle_table.txt", false);
  std::cout << "  one column: " << single.value(0.25, 0.9) << std::endl;
  expect_sentence([&] { single.value(1.5, 0.); });
  expect_sentence([] { ForceTable("no_such_table.txt", false); });
  for (const std::string text : {"0 1\n0.5 2 3\n1 2\n", "time, 0.5, 1\n0, 1, 2\n1, , 2\n",
                                 "0 1\n0.5 nan\n", "0 1\n0.5 2\n0.5 3\n", "0 1\n0.5 two\n",
                                 "time 0.5 0.4\n", "# nothing\n0 1\n", "0 1\n1 2\n"})
  {
    write(text);
    expect_sentence([] { ForceTable("muscle_table.txt", true); });
  }
}

void test_controllers()
{
  ControllerParameters parameters;
  parameters.target_heading = 0.1;
  parameters.heading_gain   = 2.;
  parameters.yaw_rate_gain  = 0.5;
  parameters.target_speed   = 1.;
  SwimmerState state;
  state.heading  = 0.2;
  state.yaw_rate = -0.1;
  state.speed    = 1.25;
  for (const std::string type : {"none", "heading", "speed"})
  {
    parameters.type         = type;
    const auto   controller = create_controller(parameters);
    SwimmerState far        = state;
    far.heading             = 3.;
    far.speed               = -5.;
    const MuscleCommand a   = controller->compute_command(state),
                        b   = controller->compute_command(far);
    std::cout << "Controller " << type << ": gain " << a.gain << ", bias " << a.bias
              << "; far off: gain " << b.gain << ", bias " << b.bias << std::endl;
  }
  parameters.largest_gain = 0.5;
  expect_sentence([&] { parameters.check("Body fish"); });
}

void test_bad_parameters()
{
  ParameterHandler prm;
  MuscleParameters parameters;
  parameters.add_parameters(prm);
  prm.parse_input_from_string("subsection Muscle\n"
                              "  set Type = bang-bang\n"
                              "  set Regions = tail, tongue\n"
                              "  subsection Bang-bang\n    set Switching position = -0.1\n  end\n"
                              "end");
  const std::map<std::string, types::material_id> regions{{"head", 1}, {"tail", 7}};
  expect_sentence([&] { parameters.check("Body fish"); });
  expect_sentence([&] { create_muscle<2>(parameters, 1., regions); });
  parameters.force_distribution = "s*(";
  expect_sentence([&] { parameters.check("Body fish"); });
  parameters.force_distribution = "1/(s-0.5)";
  expect_sentence([&] { parameters.check("Body fish"); });
  parameters.type = "steam engine";
  expect_sentence([&] { create_muscle<2>(parameters, 1., regions); });
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
