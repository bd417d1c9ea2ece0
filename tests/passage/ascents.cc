// SPDX-License-Identifier: LGPL-2.1-or-later
// Ways of fish: the sums that can be made by hand, refined and reversed profiles, rests, drops and
// slots, and each decision of FishXing.

#include <caudal/passage/endurance_law.h>
#include <caudal/passage/strategy.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <random>

using namespace caudal;
using namespace caudal::passage;

EnduranceCurve make_curve(const std::string &law, const Fish &fish)
{
  return Registry<EnduranceLaw>::get_members().at(law).create()->make_curve(fish);
}

std::unique_ptr<Strategy> make_strategy(const std::string &name)
{
  return Registry<Strategy>::get_members().at(name).create();
}

Waterway make_waterway(const std::vector<WaterPoint> &points)
{
  Waterway waterway;
  waterway.points = points;
  return waterway;
}

Waterway make_uniform(const double velocity, const double length, const double depth = 1.)
{
  return make_waterway({{0., velocity, depth}, {length, velocity, depth}});
}

void print(const std::string &text, const Ascent &ascent)
{
  std::cout << text << ": " << describe(ascent.cause) << " at " << ascent.place << " m, fatigue "
            << ascent.fatigue << ", " << ascent.time << " s\n";
}

const AscentOptions details{true, {}, 0.};
const Needs         no_needs;

void test_hand()
{
  const auto   salmon = make_curve("Katopodis-Gervais", {"Salmon & Walleye", 0.6});
  const auto   best   = make_strategy("best speed");
  const auto   way = make_waterway({{0., 1., 1.}, {30., 1., 1.}, {30., 2.2, 1.}, {32., 2.2, 1.}});
  const auto   ascent  = best->ascend(way, salmon, no_needs, details);
  const double by_hand = 30. / salmon.compute_distance(1.) + 2. / salmon.compute_distance(2.2);
  print("two reaches", ascent);
  std::cout << "  over the sum by hand " << ascent.fatigue / by_hand << ", time over "
            << ascent.time / (30. / (1. / 0.75 - 1.) + 2. / (2.2 / 0.75 - 2.2)) << '\n';

  // Velocity that grows linearly: int V^p ds in closed form, X ~ V^(1 + 1/b) = V^-3.
  const auto   ramp = make_waterway({{0., 1., 1.}, {10., 2.5, 1.}});
  const double X    = salmon.compute_distance(1.);
  std::cout << "a ramp over its closed form "
            << best->ascend(ramp, salmon, no_needs).fatigue /
                   (10. / 1.5 * (std::pow(2.5, 4) - 1.) / 4. / X)
            << '\n';
}

void test_refinement()
{
  const auto                             salmon = make_curve("Katopodis-Gervais", {"Eel", 0.6});
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> uniform;
  double                                 refined = 0., reversed = 0.;
  for (const std::string name : {"best speed", "constant ground speed", "FishXing"})
  {
    const auto strategy = make_strategy(name);
    for (int n = 0; n < 20; ++n)
    {
      Waterway coarse, fine, back;
      double   s = 0.;
      for (int k = 0; k < 6; ++k)
      {
        coarse.points.push_back({s, 0.8 * uniform(random), 1.});
        s += 0.5 + uniform(random);
      }
      const double length = coarse.get_length();
      for (std::size_t k = 0; k < coarse.points.size(); ++k)
      {
        const WaterPoint a = coarse.points[k];
        back.points.insert(back.points.begin(), {length - a.distance, a.velocity, 1.});
        fine.points.push_back(a);
        if (k + 1 < coarse.points.size())
        {
          const WaterPoint b = coarse.points[k + 1];
          for (const double share : {0.1, 0.45, 0.8})
            fine.points.push_back({a.distance + share * (b.distance - a.distance),
                                   a.velocity + share * (b.velocity - a.velocity), 1.});
        }
      }
      const double D = strategy->ascend(coarse, salmon, no_needs).fatigue;
      refined =
          std::max(refined, std::abs(strategy->ascend(fine, salmon, no_needs).fatigue / D - 1.));
      reversed =
          std::max(reversed, std::abs(strategy->ascend(back, salmon, no_needs).fatigue / D - 1.));
    }
  }
  std::cout << "60 random profiles, change of fatigue by refining "
            << (refined < 1e-8 ? "none" : "some") << ", by reversing "
            << (reversed < 1e-8 ? "none" : "some") << '\n';
  if (refined >= 1e-8 || reversed >= 1e-8)
    std::cout << "  " << 1e6 * refined << "e-6, " << 1e6 * reversed << "e-6\n";
}

void test_rests()
{
  const auto salmon = make_curve("Katopodis-Gervais", {"Salmon & Walleye", 0.4});
  const auto best   = make_strategy("best speed");
  auto       way    = make_uniform(1.6, 16.);
  print("without a rest", best->ascend(way, salmon, no_needs, details));
  way.rests = {{8., 0.5}};
  print("half a rest in the middle", best->ascend(way, salmon, no_needs, details));
  print("whole rests every 4 m",
        best->ascend(make_uniform(1.6, 16.).add_rests(4.), salmon, no_needs, details));
}

void test_drops()
{
  const auto salmon = make_curve("Katopodis-Gervais", {"Salmon & Walleye", 0.4});
  const auto best   = make_strategy("best speed");
  auto       way    = make_uniform(0.5, 10.);
  way.drops         = {{4., 0.3, 0.}};
  print("a leap", best->ascend(way, salmon, no_needs, details));
  way.drops = {{4., 2., 0.}};
  print("too high a leap", best->ascend(way, salmon, no_needs, details));
  Needs needs;
  needs.leap_speed = 2.;
  way.drops        = {{4., 0.3, 0.}};
  print("a slow leaper", best->ascend(way, salmon, needs, details));
  needs              = no_needs;
  needs.largest_drop = 0.2;
  print("a drop that is not allowed", best->ascend(way, salmon, needs, details));
  way.drops         = {{4., 0.15, 0.5}};
  const Ascent slot = best->ascend(way, salmon, no_needs, details);
  const double jet  = std::sqrt(2. * gravity * 0.15);
  print("a slot", slot);
  std::cout << "  over the sum by hand "
            << slot.fatigue /
                   (10. / salmon.compute_distance(0.5) + 0.5 / salmon.compute_distance(jet))
            << '\n';
  way.drops = {{10., 2., 0.5}};
  print("a slot at the end that is too fast", best->ascend(way, salmon, no_needs, details));
}

void test_barriers()
{
  const auto salmon = make_curve("Katopodis-Gervais", {"Salmon & Walleye", 0.4});
  for (const std::string name : {"best speed", "constant ground speed"})
    print("faster water than it can swim, " + name,
          make_strategy(name)->ascend(
              make_waterway({{0., 1., 1.}, {10., 2. * salmon.get_fastest() - 1., 1.}}), salmon,
              no_needs, details));
  Needs needs;
  needs.depth = 0.2;
  print("water that gets too shallow",
        make_strategy("best speed")
            ->ascend(make_waterway({{0., 0.5, 0.3}, {10., 0.5, 0.1}}), salmon, needs, details));
}

// Prolonged 1800 s, burst 5 s: the speeds are 13.3 0.5^0.52 5^-0.65 and 3.02 0.5^0.52 1800^-0.1.
void test_fishxing()
{
  const auto   coho      = make_curve("Hunter-Mayor", {"coho salmon", 0.5});
  const auto   fishxing  = make_strategy("FishXing");
  const double prolonged = coho.compute_speed(1800.), burst = coho.compute_speed(5.);
  std::cout << "FishXing: prolonged speed " << prolonged << ", burst speed " << burst << " m/s\n";
  print("  prolonged",
        fishxing->ascend(make_uniform(0.5 * prolonged, 100.), coho, no_needs, details));
  print("  too long",
        fishxing->ascend(make_uniform(0.5 * prolonged, 1000.), coho, no_needs, details));
  print("  burst", fishxing->ascend(make_uniform(0.5 * burst, 5.), coho, no_needs, details));
  print("  exhausted at burst",
        fishxing->ascend(make_uniform(0.5 * burst, 20.), coho, no_needs, details));
  print("  velocity barrier",
        fishxing->ascend(make_uniform(1.1 * burst, 5.), coho, no_needs, details));
  auto both = make_waterway({{0., 0.5 * prolonged, 1.},
                             {100., 0.5 * prolonged, 1.},
                             {100., 0.5 * burst, 1.},
                             {105., 0.5 * burst, 1.}});
  print("  both, counted apart", fishxing->ascend(both, coho, no_needs, details));
  both.drops = {{50., 1., 0.}};
  print("  and a leap", fishxing->ascend(both, coho, no_needs, details));
  Needs needs;
  needs.leap_speed = 4.;
  print("  leap barrier", fishxing->ascend(both, coho, needs, details));
  needs.largest_drop = 0.5;
  print("  drop", fishxing->ascend(both, coho, needs, details));
  needs       = no_needs;
  needs.depth = 1.5;
  print("  depth barrier", fishxing->ascend(both, coho, needs, details));
}

int main()
{
  std::cout << std::setprecision(6);
  test_hand();
  test_refinement();
  test_rests();
  test_drops();
  test_barriers();
  test_fishxing();
}
