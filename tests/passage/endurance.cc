// SPDX-License-Identifier: LGPL-2.1-or-later
// Endurance laws against closed forms: the coefficients M and a of Katopodis and Gervais's distance
// curves follow from k and b, their 75 % bands from those of 95 %; the best speeds are V/(1 + b)
// and V - 1/b; X(V) is what its formula says; the modes of a law meet where they should; bands are
// ordered.

#include <caudal/passage/endurance_law.h>
#include <caudal/passage/swim_groups.h>
#include <caudal/passage/verdict.h>

#include <cmath>
#include <iomanip>
#include <iostream>

using namespace caudal;
using namespace caudal::passage;

// What the report of 2016 prints beside k and b.
struct Printed
{
  std::string name;
  double      M, a, lower_k, upper_k; // of the 75 % band
};

const Printed printed[] = {{"Salmon & Walleye", 26.919, -2.994, 2.719, 5.897},
                           {"Eel", 5.982, -1.723, 2.735, 5.066},
                           {"Pike", 8.512, -2.040, 2.935, 4.950},
                           {"Herring", 59.340, -1.489, 8.895, 11.511},
                           {"Catfish & Sunfish", 3.892, -3.953, 1.696, 2.791},
                           {"Sturgeon", 0.006, -6.669, 0.635, 0.900}};

EnduranceCurve make_curve(const std::string &law, const Fish &fish)
{
  return Registry<EnduranceLaw>::get_members().at(law).create()->make_curve(fish);
}

void test_groups()
{
  std::cout
      << "groups: M and a from k and b, and the 75 % band from that of 95 %, over the printed\n";
  const double length = 0.5, speed = std::sqrt(gravity * length);
  for (const Printed &group : printed)
  {
    const SwimGroup     &g     = find_swim_group(group.name, "");
    const EnduranceCurve curve = make_curve("Katopodis-Gervais", {group.name, length});
    // Two velocities between those of the longest and the shortest endurance.
    const double V1 = 0.55 * curve.get_fastest(), V2 = 0.6 * curve.get_fastest();
    const double X1 = curve.compute_distance(V1), X2 = curve.compute_distance(V2);
    const double a      = std::log(X2 / X1) / std::log(V2 / V1);
    const double M      = X1 / length / std::pow(V1 / speed, a);
    const double z      = get_bands()[median_band + 1].ability;
    const double closed = -g.b / (1. + g.b) * std::pow((1. + g.b) * g.k, -1. / g.b);
    std::cout << "  " << group.name << ": M " << std::setprecision(3) << std::round(1e3 * M) / 1e3
              << " a " << a << ", printed " << group.M << " and " << group.a << "; closed form "
              << (std::abs(M / closed - 1.) < 1e-9 ? "met" : "missed") << "; band "
              << std::setprecision(4) << g.k * std::exp(-z * g.compute_spread()) << " to "
              << g.k * std::exp(z * g.compute_spread()) << ", printed " << group.lower_k << " to "
              << group.upper_k << '\n';
  }
  for (const char *species : {"brown trout", "Salmo trutta", "esox lucius"})
    std::cout << "  " << species << ": " << find_swim_group(species, "").name << '\n';
}

void test_distance()
{
  const double l = 0.6, u = std::sqrt(gravity * l), t = std::sqrt(l / gravity);
  const double k = 4.004, b = -0.25;
  const auto   curve = make_curve("Katopodis-Gervais", {"Salmon & Walleye", l});
  double       error = 0., speed_error = 0.;
  for (const double V : {0.9, 1., 1.5, 2.2, 3.})
  {
    const double U = V / (1. + b), T = t * std::pow(U / (k * u), 1. / b);
    error       = std::max(error, std::abs(curve.compute_distance(V) / ((U - V) * T) - 1.));
    speed_error = std::max(speed_error, std::abs(curve.compute_best_effort(V)->speed / U - 1.));
  }
  std::cout << "X(V) and the best speed of a power law, errors in 1e-12: "
            << std::floor(error * 1e12) << ", " << std::floor(speed_error * 1e12) << '\n'
            << "  slow water: at the speed of 1800 s, "
            << std::abs(curve.compute_endurance(curve.compute_best_effort(0.1)->speed) - 1800.) *
                   1e-3
            << "; in water of the speed of 3 s it gets "
            << curve.compute_distance(curve.get_fastest()) << " m far\n";
}

void test_castro_santos()
{
  const double l     = 0.42;
  const auto   curve = make_curve("Castro-Santos", {"American shad", l});
  std::cout << "Castro-Santos: speed over ground in lengths/s, prolonged "
            << (curve.compute_best_effort(4. * l)->speed - 4. * l) / l << ", sprint "
            << (curve.compute_best_effort(9. * l)->speed - 9. * l) / l;
  // The modes meet where 10.7 - U = 6.16 - 0.33 U.
  const double U = 4.54 / 0.67;
  std::cout << "; ln T where they meet " << std::log(curve.compute_endurance(U * l)) << ", before "
            << std::log(curve.compute_endurance((U - 1.) * l)) << ", after "
            << std::log(curve.compute_endurance((U + 1.) * l)) << '\n';
}

void test_hunter_mayor()
{
  const auto burst = make_curve("Hunter-Mayor", {"rainbow trout", 0.3});
  const auto coho  = make_curve("Hunter-Mayor", {"coho salmon", 0.5});
  std::cout << "Hunter-Mayor: rainbow trout of 0.3 m holds 10 s " << burst.compute_speed(10.)
            << " m/s (" << 7.16 * std::pow(0.3, 0.77) * std::pow(10., -0.46)
            << "); best speed over V " << burst.compute_best_effort(1.)->speed << " ("
            << 1. / (1. - 0.46) << ")\n  coho salmon of 0.5 m: 5 s by burst "
            << coho.compute_speed(5.) / (13.3 * std::pow(0.5, 0.52) * std::pow(5., -0.65))
            << ", 600 s by prolonged swimming "
            << coho.compute_speed(600.) / (3.02 * std::pow(0.5, 0.52) * std::pow(600., -0.1))
            << '\n';
}

void test_bands()
{
  std::cout << "bands: abilities";
  for (const Band &band : get_bands())
    std::cout << ' ' << std::setprecision(5) << band.ability;
  std::cout << "\n  speed held for 60 s by a sturgeon of 1 m";
  for (const Band &band : get_bands())
    std::cout
        << ' '
        << make_curve("Katopodis-Gervais", {"lake sturgeon", 1., band.ability}).compute_speed(60.);
  std::cout << '\n';
}

int main()
{
  std::cout << std::setprecision(8);
  test_groups();
  std::cout << std::setprecision(8);
  test_distance();
  test_castro_santos();
  test_hunter_mayor();
  test_bands();
}
