// SPDX-License-Identifier: LGPL-2.1-or-later
// Swimming against known answers and exact identities: see the comment at each of them.

#include <caudal/ideal/kirchhoff.h>
#include <caudal/ideal/motion_sample.h>
#include <caudal/ideal/resistance.h>

#include "../round_off.h"
#include "bodies.h"

#include <cmath>
#include <iomanip>
#include <iostream>
#include <numeric>

using namespace caudal;
using namespace caudal::ideal;

const std::string salmon =
    "0.0714, 2.5e-3, 3.5e-3; 0.2143, 5e-3, 9e-3; 0.3571, 6e-3, 11e-3; 0.5, 5e-3, 9.5e-3; "
    "0.6429, 3.2e-3, 6.5e-3; 0.7857, 1.7e-3, 3.5e-3; 0.9286, 1e-3, 10e-3";

// Calls observe at each of the times, the first of which is that of the start.
template <class Observe>
void integrate_motion(const MotionProblem &problem, BodyState body,
                      const std::vector<double> &times, const Observe &observe)
{
  observe(body, times[0]);
  for (std::size_t k = 1; k < times.size(); ++k)
  {
    body = advance_motion(problem, body, times[k - 1], times[k]);
    observe(body, times[k]);
  }
}

// A body with its gait, and the table of its stroke.
struct Swimmer
{
  Swimmer(const SurfaceParameters &cells, const Entries &shape, const Entries &gait,
          const unsigned int n_phases, const Torques torques = Torques::none)
      : surface(cells)
      , body(surface, shape, gait)
      , swimming_shape(surface, *body.deformation, *body.gait, Densities(), torques, MPI_COMM_SELF)
      , table(swimming_shape, n_phases, MPI_COMM_WORLD)
  {}

  // The pulsating sphere of unit radius.
  Swimmer(const unsigned int n_cells, const double amplitude, const unsigned int n_phases)
      : surface({n_cells, n_cells})
      , body(surface, 1., amplitude)
      , swimming_shape(surface, *body.deformation, *body.gait, Densities(), Torques::none,
                       MPI_COMM_SELF)
      , table(swimming_shape, n_phases, MPI_COMM_WORLD)
  {}

  // Where the nose is after some strokes from rest [m].
  Tensor<1, 3> swim(const double frequency, const unsigned int n_strokes,
                    StrokeModel *model = nullptr, const unsigned int steps = 0,
                    const ResistanceParameters &resistance = {})
  {
    MotionProblem problem;
    problem.force      = create_resistance(resistance, swimming_shape);
    problem.model      = model != nullptr ? model : &table;
    problem.rate       = 2. * numbers::PI * frequency;
    problem.length     = body.deformation->get_length();
    problem.integrator = steps > 0 ? Integrator::given_steps : Integrator::adaptive;
    std::vector<double> times{0.};
    const unsigned int  n = std::max(1u, steps) * n_strokes;
    for (unsigned int k = 1; k <= n; ++k)
      times.push_back(n_strokes / frequency * k / n);
    Tensor<1, 3> place;
    integrate_motion(problem, BodyState(), times,
                     [&](const BodyState &body, double) { place = body.position; });
    return place;
  }

  const Surface  surface;
  const TestBody body;
  SwimmingShape  swimming_shape;
  PhaseTable     table;
};

// The mean velocity of the deforming sphere, over a eps^2 omega, at finite amplitude.
void check_deforming_sphere()
{
  const std::pair<double, double> references[] = {
      {0.05, -0.2137189665}, {0.1, -0.212036547}, {0.2, -0.205559}};
  for (const auto &[epsilon, reference] : references)
  {
    double results[2];
    for (const unsigned int n : {3, 6})
      results[n / 6] =
          Swimmer(n, epsilon, 16).swim(1., 1)[0] / (2. * numbers::PI * epsilon * epsilon);
    const double extrapolated = results[1] + (results[1] - results[0]) / 15.;
    std::cout << "deforming sphere, eps = " << epsilon << ": with 866 panels "
              << as_multiple(1e-3, results[1] / reference - 1.) << ", extrapolated "
              << as_multiple(1e-3, extrapolated / reference - 1.) << std::endl;
  }
}

// A spheroid bent by a wave of curvature: displacement and energy of another code.
void check_bent_spheroid()
{
  Swimmer      swimmer({12, 6}, {{"Type", "ellipsoid"}, {"Ellipsoid/Axes", "0.5, 0.125, 0.125"}},
                       {{"Type", "curvature wave"}}, 16);
  const double mass =
      swimmer.body.deformation->compute_body_mass(swimmer.body.gait->evaluate(0.).c)(3, 3) * 1000.;
  const EnergyAverages energy = average_stroke(swimmer.table, 64, false);
  std::cout << "bent spheroid: displacement "
            << as_multiple(1e-3, swimmer.swim(1., 1).norm() / 1.101e-2 - 1.) << ", energy "
            << as_multiple(1e-3, energy.mean_energy() / mass / 5.304e-4 - 1.) << std::endl;
}

// A stroke without phase lag is reciprocal; the path does not depend on the frequency.
void check_strokes()
{
  const Entries fish = {{"Stations/Table", salmon}};
  Entries       gait;
  Swimmer       swimmer({4, 3}, fish, gait, 32);
  const double  slow  = swimmer.swim(0.64, 12).norm() / 12.,
               fast   = swimmer.swim(1.43, 28).norm() / 28.;
  gait["Wave number"] = "0";
  const double none   = Swimmer({4, 3}, fish, gait, 32).swim(1., 3).norm();
  std::cout << "salmon: displacement a stroke at .64 and 1.43 Hz the same "
            << in_units(1e-6, std::abs(slow / fast - 1.)) << ", without phase lag none "
            << in_units(1e-6, none / slow) << std::endl;

  // psi -> psi + pi maps (omega_z, v_x, v_y) to (-, +, -): without use of the symmetry, since
  // an odd number of phases is not mirrored.
  gait = {{"Type", "sine"}};
  Swimmer     odd({4, 3}, fish, gait, 33);
  const Screw q = odd.table.compute_motion(0.4).compute_velocity(Screw(), 1.);
  const Screw p = odd.table.compute_motion(0.4 + numbers::PI).compute_velocity(Screw(), 1.);
  std::cout << "glide symmetry: phases computed " << odd.table.get_n_computed() << ", omega_z "
            << in_units(1e-6, std::abs(q[2] + p[2]) / std::abs(q[2])) << ", v_x "
            << in_units(1e-6, std::abs(q[3] - p[3]) / std::abs(q[3])) << ", v_y "
            << in_units(1e-6, std::abs(q[4] + p[4]) / std::abs(q[4])) << ", others "
            << in_units(1e-9, std::abs(q[0]) + std::abs(q[1]) + std::abs(q[5]) / 0.1) << std::endl;
}

// The work of the joints is the change of the kinetic energy; table against new surfaces.
void check_energy_and_table()
{
  const Entries fish = {{"Stations/Table", salmon}};
  Entries       gait;
  gait["Type"] = "sine";
  for (const double amplitude : {10., 30.})
  {
    gait["Sine/Amplitude"] = Patterns::Tools::to_string(amplitude);
    Swimmer      swimmer({4, 3}, fish, gait, 32, Torques::from_rest);
    double       error = 0., largest = 0., work = 0.;
    const double h      = 1e-3;
    const auto   energy = [&](const double psi) { // T_dd - P.M^-1 P/2
      const StrokeState state = swimmer.table.compute_state(psi);
      return state.deformation_energy +
             0.5 * (state.motion.momentum * state.motion.compute_velocity(Screw(), 1.));
    };
    const unsigned int n = 48;
    for (unsigned int k = 0; k < n; ++k)
    {
      const double psi     = 2. * numbers::PI * (k + 0.5) / n;
      const auto   torques = swimmer.table.compute_torques(psi, Drive());
      const auto   rates   = swimmer.body.gait->evaluate(psi).rates;
      double       power   = 0.;
      for (unsigned int i = 0; i < 6; ++i)
        power += torques[i] * rates[i];
      const double rate = (8. * (energy(psi + h) - energy(psi - h)) -
                           (energy(psi + 2. * h) - energy(psi - 2. * h))) /
                          (12. * h);
      error   = std::max(error, std::abs(power - rate));
      largest = std::max(largest, std::abs(rate));
      work += power / n;
    }
    std::cout << "sine gait of " << amplitude << " degrees: energy balance "
              << as_multiple(1e-6, error / largest) << ", no net work "
              << in_units(1e-8, work / largest);
    if (amplitude == 30.)
    {
      const auto         brute = create_brute_force(swimmer.swimming_shape, 1e-3);
      const unsigned int steps = 24;
      const Tensor<1, 3> table = swimmer.swim(1., 1, nullptr, steps);
      std::cout << ", table against new surfaces "
                << in_units(1e-6,
                            (swimmer.swim(1., 1, brute.get(), steps) - table).norm() / table.norm())
                << ", torques "
                << in_units(1e-4, std::abs(brute->compute_torques(0.4, Drive())[3] /
                                               swimmer.table.compute_torques(0.4, Drive())[3] -
                                           1.));
    }
    std::cout << std::endl;
  }
}

// Resistance follows from a dissipation function D, F_i = dD/dc_i' and f_x = dD/dv_x: by
// differences, d^2 D/(d rate dv_x) from both.
void check_load(const ExternalForce &force, const std::vector<double> &rates)
{
  MotionInstant at{0.7, 2., Screw({0.1, -0.2, 0.3, -0.02, 0.01, 0.03})};
  const auto    change = [&](double &variable, const auto &get) {
    const double middle = variable, step = 1e-4 * std::abs(middle);
    variable           = middle + step;
    const double above = get(force(at));
    variable           = middle - step;
    const double under = get(force(at));
    variable           = middle;
    return (above - under) / (2. * step);
  };
  const double by_rate = change(at.rate, [](const Load &load) { return load.screw[3]; });
  const double by_v    = change(at.velocity[3], [&](const Load &load) {
    return std::inner_product(rates.begin(), rates.end(), load.on_modes.begin(), 0.);
  });
  std::cout << "resistance: of body and joints from one function "
            << in_units(1e-4, std::abs(by_v / by_rate - 1.)) << std::endl;
}

// The two forces on a sphere that is towed, by integration of the formulas over its surface, and
// what they do to a salmon: friction slows it down, the cross-flow force drives it.
void check_friction_and_cross_flow()
{
  const double R = 0.05, u = 0.3, rho = 1000.;
  Swimmer      sphere({8, 8}, {{"Type", "ellipsoid"}, {"Ellipsoid/Axes", "0.05, 0.05, 0.05"}},
                      {{"Type", "sine"}, {"Sine/Amplitude", "0"}}, 4);
  ResistanceParameters friction, cross_flow;
  friction.active = cross_flow.active = true;
  friction.friction                   = 0.01;
  cross_flow.friction                 = 1e-12; // as 0 asks for Blasius's law
  cross_flow.drag                     = 1.;
  const auto compute_drag             = [&](const ResistanceParameters &resistance) {
    const ExternalForce force = create_resistance(resistance, sphere.swimming_shape);
    return -force({0., 0., Screw({0., 0., 0., u, 0., 0.})}).screw[3];
  };
  const double dynamic = 0.5 * rho * u * u * R * R, pi = numbers::PI;
  std::cout << std::fixed << std::setprecision(2) << "towed sphere, over the exact force: friction "
            << compute_drag(friction) / (0.75 * pi * pi * 0.01 * dynamic) << ", cross-flow "
            << compute_drag(cross_flow) / (pi * dynamic) << std::endl;

  Swimmer    fish({4, 3}, {{"Stations/Table", salmon}}, {}, 32);
  const auto swim = [&](const ResistanceParameters &resistance) {
    return fish.swim(1., 10, nullptr, 0, resistance).norm();
  };
  const double none = swim({});
  std::cout << "salmon, distance over that without resistance: with friction "
            << swim(friction) / none << ", with the cross-flow force " << swim(cross_flow) / none
            << std::defaultfloat << std::setprecision(6) << std::endl;
}

// With a push at the start and with resistance: the work of joints and external forces is the
// change of the kinetic energy; torques of the table are those of new surfaces.
void check_torques_in_motion()
{
  const Entries fish = {{"Stations/Table", salmon}};
  Entries       gait;
  gait["Type"]           = "sine";
  gait["Sine/Amplitude"] = "10"; // of which a coarse surface needs no more phases
  Swimmer              swimmer({3, 2}, fish, gait, 32, Torques::any);
  ResistanceParameters resistance;
  resistance.drag     = 1.;
  resistance.friction = 0.1; // Blasius's law has no dissipation function
  for (const bool active : {false, true})
  {
    resistance.active = active;
    MotionProblem problem;
    problem.model     = &swimmer.table;
    problem.rate      = 2. * numbers::PI;
    problem.length    = 0.1;
    problem.tolerance = 1e-12;
    problem.force     = create_resistance(resistance, swimmer.swimming_shape);
    BodyState start;
    start.impulse = Screw({1e-6, -2e-6, 3e-6, -4e-4, 1e-4, 2e-4});

    std::vector<MotionSample> samples;
    std::vector<double>       times, powers;
    const double              step = 5e-3;
    for (unsigned int k = 0; k <= 100; ++k)
      times.push_back(k * step);
    integrate_motion(problem, start, times, [&](const BodyState &body, const double time) {
      samples.push_back(compute_sample(problem, body, time, true));
      const Screw &velocity = samples.back().velocity;
      powers.push_back(samples.back().get_power());
      if (!active)
        return;
      const Load load  = problem.force({problem.rate * time, problem.rate, velocity});
      const auto rates = swimmer.body.gait->evaluate(problem.rate * time).rates;
      powers.back() += load.screw * velocity;
      for (unsigned int i = 0; i < rates.size(); ++i)
        powers.back() += load.on_modes[i] * problem.rate * rates[i];
    });
    double error = 0., largest = 0.;
    for (unsigned int k = 3; k + 3 < times.size(); ++k)
    {
      const auto change = [&](const unsigned int n) {
        return (samples[k + n].energy - samples[k - n].energy) / step;
      };
      const double rate = (45. * change(1) - 9. * change(2) + change(3)) / 60.;
      error             = std::max(error, std::abs(powers[k] - rate));
      largest           = std::max(largest, std::abs(rate));
    }
    if (active)
      check_load(problem.force, swimmer.body.gait->evaluate(0.7).rates);
    const auto   brute = create_brute_force(swimmer.swimming_shape, 1e-3);
    const Drive  drive{problem.rate, samples[50].body.impulse, start.impulse};
    const double argument = problem.rate * times[50];
    const double of_new   = brute->compute_torques(argument, drive)[3],
                 of_table = swimmer.table.compute_torques(argument, drive)[3];
    std::cout << "pushed" << (active ? ", with resistance" : "") << ": energy balance "
              << as_multiple(1e-6, error / largest) << ", torques against new surfaces "
              << in_units(1e-4, std::abs(of_table / of_new - 1.)) << std::endl;
  }
}

// A rigid ellipsoid that tumbles keeps |Pi|, Pi.Lambda, T and, in the inertial frame, R Pi and
// R Lambda + r x R Pi.
void check_free_ellipsoid()
{
  Swimmer       swimmer({3, 3}, {{"Type", "ellipsoid"}, {"Ellipsoid/Axes", "4, 2, 1"}},
                        {{"Type", "none"}}, 1);
  MotionProblem problem;
  problem.model  = &swimmer.table;
  problem.length = 8.;
  BodyState start;
  start.impulse[1] = 3e4;
  start.impulse[2] = 5e4;
  start.impulse[3] = 1e4;
  start.impulse[4] = 2e4;
  start.impulse[5] = -1e4;
  std::vector<double> times;
  for (unsigned int k = 0; k <= 100; ++k)
    times.push_back(k);
  Tensor<1, 5> errors;
  Tensor<1, 3> first_Pi, first_Lambda, path;
  double       first_energy = 0.;
  integrate_motion(problem, start, times, [&](const BodyState &body, const double time) {
    const Screw       &p      = body.impulse;
    const Tensor<1, 3> Lambda = Point<3>(p[0], p[1], p[2]), Pi = Point<3>(p[3], p[4], p[5]);
    const Tensor<1, 3> inertial_Pi = body.rotate(Pi);
    const Tensor<1, 3> inertial_Lambda =
        body.rotate(Lambda) + cross_product_3d(body.position, inertial_Pi);
    const double energy = compute_sample(problem, body, time, false).energy;
    if (time == 0.)
    {
      first_Pi     = inertial_Pi;
      first_Lambda = inertial_Lambda;
      first_energy = energy;
    }
    errors[0] = std::max(errors[0], std::abs(Pi.norm() / first_Pi.norm() - 1.));
    errors[1] = std::max(errors[1], std::abs(Pi * Lambda / (first_Pi * first_Lambda) - 1.));
    errors[2] = std::max(errors[2], std::abs(energy / first_energy - 1.));
    errors[3] = std::max(errors[3], (inertial_Pi - first_Pi).norm() / first_Pi.norm());
    errors[4] = std::max(errors[4], (inertial_Lambda - first_Lambda).norm() / first_Lambda.norm());
    path      = body.position;
  });
  std::cout << "free ellipsoid: |Pi| " << in_units(1e-7, errors[0]) << ", Pi.Lambda "
            << in_units(1e-7, errors[1]) << ", T " << in_units(1e-7, errors[2]) << ", R Pi "
            << in_units(1e-7, errors[3]) << ", R Lambda + r x R Pi " << in_units(1e-6, errors[4])
            << ", it moved by " << std::lround(path.norm()) << std::endl;
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_deforming_sphere();
  check_bent_spheroid();
  check_strokes();
  check_energy_and_table();
  check_friction_and_cross_flow();
  check_torques_in_motion();
  check_free_ellipsoid();
}
