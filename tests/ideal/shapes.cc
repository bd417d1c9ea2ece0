// SPDX-License-Identifier: LGPL-2.1-or-later
// The straight and the bent body: profiles do not overshoot and are smooth; modes are the
// derivatives of positions; a bend keeps the volume and the body's mass matrix is that of the
// moving matter; symmetries of the gaits; the deforming sphere keeps its volume; splines.

#include <caudal/fish/spline.h>
#include <caudal/ideal/exterior_flow.h>
#include <caudal/ideal/mesh_body.h>

#include "../round_off.h"
#include "bodies.h"

#include <cmath>
#include <fstream>
#include <iostream>

using namespace caudal;
using namespace caudal::ideal;

const std::string salmon =
    "0.0714, 2.5e-3, 3.5e-3; 0.2143, 5e-3, 9e-3; 0.3571, 6e-3, 11e-3; 0.5, 5e-3, 9.5e-3; "
    "0.6429, 3.2e-3, 6.5e-3; 0.7857, 1.7e-3, 3.5e-3; 0.9286, 1e-3, 10e-3";

void check_profiles()
{
  const std::vector<double> x = {0, 1, 1.3, 4, 4.2, 5}, y = {0, 5, 5.1, -3, -3, 7};
  const Spline              spline(x, y, Spline::Kind::limited);
  const auto                profile   = [&](const double at) { return spline.evaluate(at).first; };
  double                    overshoot = 0., jump = 0., miss = 0.;
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    for (double t = 0.; t <= 1.; t += 0.01)
    {
      const double value = profile(x[i] + t * (x[i + 1] - x[i]));
      overshoot =
          std::max({overshoot, value - std::max(y[i], y[i + 1]), std::min(y[i], y[i + 1]) - value});
    }
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    const double h      = 1e-3;
    const auto   second = [&](const double at) {
      return (profile(at + h) - 2. * profile(at) + profile(at - h)) / (h * h);
    };
    miss = std::max(miss, std::abs(profile(x[i]) - y[i]));
    jump = std::max(jump, std::abs(second(x[i] + 2. * h) - second(x[i] - 2. * h)));
  }
  std::cout << "profile: points " << in_units(1e-12, miss) << ", no overshoot "
            << in_units(1e-12, overshoot) << ", second derivative continuous "
            << with_two_decimals(jump) << std::endl;

  std::vector<double> angles, sines;
  for (unsigned int i = 0; i <= 40; ++i)
  {
    angles.push_back(2. * numbers::PI * i / 40.);
    sines.push_back(std::sin(angles.back()));
  }
  sines.back() = sines.front();
  const Spline periodic(angles, sines, Spline::Kind::periodic);
  const auto [value, rate] = periodic.evaluate(13.);
  std::cout << "spline of a sine: " << as_multiple(1e-5, value - std::sin(13.)) << ", its rate "
            << as_multiple(1e-4, rate - std::cos(13.)) << std::endl;
}

// Half-widths of the paper's fish one: both interpolations go through the stations; `spline` is
// the natural cubic spline of ln(a/E) and overshoots, `limited` stays between its neighbours.
void check_interpolation()
{
  const std::vector<double> s = {0.03, 0.35, 0.8, 0.93, 0.99},
                            a = {0.4e-3, 10e-3, 1.7e-3, 1e-3, 0.4e-3};
  std::string         table;
  const auto          round = [](const double x) { return 2. * std::sqrt(x * (1. - x)); };
  std::vector<double> logarithms;
  for (unsigned int i = 0; i < s.size(); ++i)
  {
    table += (i > 0 ? "; " : "") + Patterns::Tools::to_string(s[i]) + ", " +
             Patterns::Tools::to_string(a[i]) + ", 1e-3";
    logarithms.push_back(std::log(a[i] / round(s[i])));
  }
  const Spline spline(s, logarithms, Spline::Kind::natural);
  for (const std::string type : {"spline", "limited"})
  {
    const auto shape = make_body({{"Stations/Table", table}, {"Stations/Interpolation", type}});
    double     miss = 0., overshoot = 0., from_spline = 0.;
    for (unsigned int i = 0; i < s.size(); ++i)
    {
      const double length = shape->get_length();
      miss                = std::max(miss, std::abs(shape->half_width(s[i] * length) / a[i] - 1.));
      for (double t = 0.; i + 1 < s.size() && t <= 1.; t += 0.01)
      {
        const double x         = s[i] + t * (s[i + 1] - s[i]);
        const double value     = std::log(shape->half_width(x * length) / round(x));
        const auto [low, high] = std::minmax(logarithms[i], logarithms[i + 1]);
        overshoot              = std::max({overshoot, value - high, low - value});
        from_spline            = std::max(from_spline, std::abs(value - spline.evaluate(x).first));
      }
    }
    std::cout << "stations, " << type << ": passed through " << in_units(1e-12, miss)
              << ", overshoots by " << with_two_decimals(overshoot)
              << ", off the natural spline by " << with_two_decimals(from_spline) << std::endl;
  }
}

// The body's kinetic energy for given rates of all motions, by sampling points inside. They
// are moved by differences of the positions of the section that they belong to.
void check_body(const std::string &name, const Surface &surface, const TestBody &body)
{
  const auto &[straight, gait, deformation] = body;
  const GaitState at                        = gait->evaluate(0.7);

  double mode_error = 0.;
  for (unsigned int i = 0; i < at.c.size(); ++i)
  {
    const double step  = 1e-5;
    auto         above = at.c, under = at.c;
    above[i] += step;
    under[i] -= step;
    const SurfaceMotion motion = deformation->place(at.c), up = deformation->place(above),
                        down = deformation->place(under);
    for (unsigned int node = 0; node < surface.n_nodes(); ++node)
      mode_error = std::max(mode_error, (motion.modes[i][node] -
                                         (up.positions[node] - down.positions[node]) / (2. * step))
                                            .norm());
  }
  const double length     = deformation->get_length();
  double       rate_error = 0.;
  for (std::size_t i = 0; i < at.c.size(); ++i)
    rate_error = std::max(
        rate_error, std::abs(at.rates[i] -
                             (gait->evaluate(0.70001).c[i] - gait->evaluate(0.69999).c[i]) / 2e-5));

  BoundaryElements         elements(surface, MPI_COMM_SELF);
  const FullMatrix<double> bent = deformation->compute_body_mass(at.c);
  const double             straight_volume =
      deformation->compute_body_mass(std::vector<double>(at.c.size(), 0.))(3, 3);
  const double volume = elements.solve(deformation->place(at.c)).get_potentials().volume;
  std::cout << name << ": modes " << in_units(1e-8, mode_error / length) << ", rates "
            << in_units(1e-8, rate_error) << ", volume of the body "
            << in_units(1e-7, std::abs(bent(3, 3) / straight_volume - 1.)) << ", of its surface "
            << as_multiple(1e-4, volume / straight_volume - 1.) << ", bend "
            << with_two_decimals(deformation->compute_bend(at.c)) << ", reciprocal "
            << is_reciprocal(*gait) << ", glide symmetry " << has_glide_symmetry(*gait)
            << std::endl;
}

// Against the moments of an ellipsoid about its nose.
void check_ellipsoid()
{
  const Surface            surface({2, 2});
  const TestBody           body(surface, {{"Type", "ellipsoid"}, {"Ellipsoid/Axes", "3, 2, 1"}},
                                {{"Type", "none"}});
  const FullMatrix<double> mass   = body.deformation->compute_body_mass({});
  const double             volume = 4. / 3. * numbers::PI * 6.;
  std::cout << "ellipsoid: volume " << in_units(1e-8, std::abs(mass(3, 3) / volume - 1.))
            << ", moments about the nose "
            << in_units(1e-7, std::abs(mass(0, 0) / volume - (4. + 1.) / 5.)) << ' '
            << in_units(1e-6, std::abs(mass(1, 1) / volume - (9. + 1.) / 5. - 9.)) << ' '
            << in_units(1e-6, std::abs(mass(2, 2) / volume - (9. + 4.) / 5. - 9.))
            << ", first moment " << in_units(1e-7, std::abs(mass(2, 4) / volume - 3.)) << std::endl;
}

// A cube of flat quadrilaterals as a surface file.
void check_file()
{
  std::ofstream("cube.ucd") << "8 6 0 0 0\n"
                               "1 2 -1 -1\n2 4 -1 -1\n3 4 1 -1\n4 2 1 -1\n"
                               "5 2 -1 1\n6 4 -1 1\n7 4 1 1\n8 2 1 1\n"
                               "1 0 quad 1 4 3 2\n2 0 quad 5 6 7 8\n3 0 quad 1 2 6 5\n"
                               "4 0 quad 3 4 8 7\n5 0 quad 1 5 8 4\n6 0 quad 2 3 7 6\n";
  const Surface     surface({1, 1}, "cube.ucd");
  const MeshBody    shape(surface);
  const auto        gait = make_gait({{"Type", "none"}}, shape.get_length());
  const BendingBody body(surface, shape, *gait);
  const auto        mass = body.compute_body_mass({});
  std::cout << "cube from a file: length " << shape.get_length() << ", volume "
            << in_units(1e-12, std::abs(mass(3, 3) - 8.)) << ", moments about the nose "
            << in_units(1e-12, std::abs(mass(0, 0) - 8. * 2. / 3.)) << ' '
            << in_units(1e-12, std::abs(mass(2, 2) - 8. * (1. + 2. / 3.))) << ", added mass "
            << std::lround(100. *
                           BoundaryElements(surface, MPI_COMM_SELF)
                               .solve(body.place({}))
                               .get_potentials()
                               .added_mass(3, 3) /
                           8.)
            << " %" << std::endl;
}

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_profiles();
  check_interpolation();
  check_ellipsoid();
  check_file();

  const Surface surface({12, 8});
  const Entries fish       = {{"Stations/Table", salmon}};
  const auto    check_fish = [&](const std::string &name, const Entries &gait) {
    check_body(name, surface, TestBody(surface, fish, gait));
  };
  check_fish("arctangent", {});
  check_fish("without lag", {{"Wave number", "0"}});
  check_fish("biased", {{"Bias", "5"}});
  check_fish("sine", {{"Type", "sine"}, {"Growth", "0.7"}});
  check_fish("curvature",
             {{"Type", "curvature wave"}, {"Growth", "0.7"}, {"Curvature wave/Amplitude", "3"}});
  check_fish("curvature without lag", {{"Type", "curvature wave"},
                                       {"Growth", "0.7"},
                                       {"Curvature wave/Amplitude", "3"},
                                       {"Wave number", "0"}});
  check_fish("started", {{"Type", "sine"}, {"Start-up ramp", "1"}});
  check_fish("displacement", {{"Type", "travelling wave"}});
  check_fish("displacement without lag",
             {{"Type", "travelling wave"}, {"Travelling wave/Wave number", "0"}});
  check_fish("given curvature",
             {{"Type", "curvature"}, {"Curvature/Function", "10*(0.5 + s)*sin(2*pi*(t - s))"}});

  std::ofstream table("table.csv");
  table << "time,a,b,c,d,e,f\n";
  for (unsigned int k = 0; k <= 24; ++k)
  {
    table << k / 12.;
    for (unsigned int i = 0; i < 6; ++i)
      table << "," << 20. * std::sin(2. * numbers::PI * (k % 24) / 24. - i);
    table << "\n";
  }
  table.close();
  const Entries control = {{"Type", "table"}, {"Table/File", "table.csv"}};
  check_fish("table", control);
  std::cout << "  frequency " << make_gait(control, 0.1)->get_frequencies()[0] << " Hz"
            << std::endl;
  check_body("deforming sphere", surface, TestBody(surface, 0.1, 0.1));
}
