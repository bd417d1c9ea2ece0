// SPDX-License-Identifier: LGPL-2.1-or-later
// Gaits: the midline keeps its length, a symmetric body its area and each part of it its own,
// sections stay normal, velocities are time derivatives, with and without a start-up; a known
// displacement, shifted sections and an arc of a circle come out; bad input.

#include <caudal/fish/number_table.h>
#include <caudal/fish/prescribed_motion.h>

#include <cmath>
#include <fstream>
#include <iostream>

#include "../entries.h"
#include "../round_off.h"

using namespace caudal;

const double L = 2.;

std::unique_ptr<Gait> make_gait(const Entries &entries)
{
  GaitParameters parameters;
  set_entries(parameters, "Gait", entries);
  parameters.check("Body eel");
  return parameters.create(L);
}

/** A point of the outline. */
template <int dim>
BodyPoint<dim> on_outline(const Point<dim> &s)
{
  return {s, -std::abs(s[1]), std::abs(s[1])};
}

template <int dim>
Point<dim> get_position(const Gait &gait, const double time, const Point<dim> &s)
{
  return PrescribedMotion<dim>(gait, {on_outline(s)}).compute(time).positions[0];
}

// Half the thickness of a NACA0012 outline of length L
double half_thickness(const double x)
{
  const double s = x / L;
  return 0.6 * L * (0.2969 * std::sqrt(s) - s * (0.126 + s * (0.3516 - s * (0.2843 - s * 0.1036))));
}

/** The largest |det(dX/ds) - 1| in the body, by differences of fourth order. */
double compute_volume_error(const Gait &gait, const double time)
{
  const double eps   = 1e-3 * L;
  double       error = 0.;
  for (const double s : {0.103, 0.305, 0.555, 0.703, 0.905})
    for (const double share : {-0.9, -0.5, 0., 0.7})
    {
      Tensor<2, 2> gradient;
      for (unsigned int d = 0; d < 2; ++d)
        for (const auto &[step, weight] : {std::pair<double, double>(-2., 1. / 12.),
                                           {-1., -8. / 12.},
                                           {1., 8. / 12.},
                                           {2., -1. / 12.}})
        {
          Point<2> place(s * L, share * half_thickness(s * L));
          place[d] += step * eps;
          const double       h = half_thickness(place[0]);
          const Tensor<1, 2> X =
              PrescribedMotion<2>(gait, {{place, -h, h}}).compute(time).positions[0];
          for (unsigned int c = 0; c < 2; ++c)
            gradient[c][d] += weight / eps * X[c];
        }
      error = std::max(error, std::abs(determinant(gradient) - 1.));
    }
  return error;
}

void check_gait(const std::string &name, const Entries &entries)
{
  const auto                gait = make_gait(entries);
  const unsigned int        n    = 3000;
  std::vector<BodyPoint<2>> outline;
  for (unsigned int i = 0; i <= n; ++i)
    for (const double side : {-1., 0., 1.})
      outline.push_back(on_outline(Point<2>(i * L / n, side * half_thickness(i * L / n))));
  const PrescribedMotion<2> motion(*gait, outline);

  double length_error = 0., area_error = 0., volume_error = 0., velocity_error = 0.,
         angle_error = 0.;
  for (const double time : {0.05, 0.3, 0.61, 0.97})
  {
    const auto X      = motion.compute(time).positions;
    double     length = 0., area = 0., reference = 0.;
    for (unsigned int i = 0; i < n; ++i)
    {
      const unsigned int left = 3 * i, right = 3 * (i + 1);
      length += X[right + 1].distance(X[left + 1]);

      // Shoelace formula for the quadrilateral between two cross sections
      const unsigned int corners[] = {left, right, right + 2, left + 2};
      for (unsigned int c = 0; c < 4; ++c)
      {
        const unsigned int a = corners[c], b = corners[(c + 1) % 4];
        const Point<2>    &at_a = outline[a].place, &at_b = outline[b].place;
        reference += 0.5 * (at_a[0] * at_b[1] - at_a[1] * at_b[0]);
        area += 0.5 * (X[a][0] * X[b][1] - X[a][1] * X[b][0]);
      }
    }
    length_error = std::max(length_error, std::abs(length / L - 1.));
    area_error   = std::max(area_error, std::abs(area / reference - 1.));
    volume_error = std::max(volume_error, compute_volume_error(*gait, time));

    // The last two points lie beyond the ends of the midline.
    for (const Point<2> s : {Point<2>(0.3, 0.05), Point<2>(1.1, -0.07), Point<2>(1.99, 0.01),
                             Point<2>(-0.01, 0.02), Point<2>(2.02, -0.01)})
    {
      const double              h = 1.5 * std::abs(s[1]);
      const PrescribedMotion<2> near(*gait, {{s, -h, h},
                                             {Point<2>(s[0], 0.), 0., 0.},
                                             {Point<2>(s[0] + 1e-3, 0.), 0., 0.},
                                             {Point<2>(s[0] - 1e-3, 0.), 0., 0.}});
      const auto                here   = near.compute(time);
      const Tensor<1, 2>        along  = here.positions[2] - here.positions[3];
      const Tensor<1, 2>        across = here.positions[0] - here.positions[1];
      const Tensor<1, 2>        slope =
          (near.compute(time + 1e-5).positions[0] - near.compute(time - 1e-5).positions[0]) / 2e-5;
      angle_error =
          std::max(angle_error, std::abs(along * across) / (along.norm() * across.norm()));
      velocity_error = std::max(velocity_error, (slope - here.velocities[0]).norm());
    }
  }
  std::cout << name << ": length " << in_units(1e-6, length_error) << ", area "
            << in_units(1e-6, area_error) << ", volume everywhere " << in_units(1e-6, volume_error)
            << ", normal sections " << in_units(1e-5, angle_error) << ", velocity "
            << in_units(1e-6, velocity_error) << std::endl;
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

int main()
{
  const Entries wave = {{"Type", "travelling wave"}, {"Start-up ramp", "0.5"}};
  check_gait("eel", wave);

  // Displacement of the tail relative to the nose, against its formula
  const auto eel = make_gait(wave);
  const auto y   = [](const double s) {
    return 0.125 * L * (s + 0.03125) / 1.03125 * std::sin(2. * numbers::PI * (s - 0.8));
  };
  std::cout << "  displacement "
            << in_units(1e-5,
                        std::abs(get_position<2>(*eel, 0.8, Point<2>(L, 0.))[1] - (y(1.) - y(0.))))
            << ", at rest at t = 0 "
            << in_units(1e-12,
                        get_position<2>(*eel, 0., Point<2>(1.3, 0.1)).distance(Point<2>(1.3, 0.1)))
            << ", z unchanged ";
  const auto in_space =
      PrescribedMotion<3>(*eel, {on_outline(Point<3>(1.3, 0.1, 0.7))}).compute(0.8);
  std::cout << in_space.positions[0][2] << ' ' << in_space.velocities[0][2] << std::endl;

  const auto shifted = make_gait(
      {{"Type", "displacement"}, {"Displacement/Function", "0.1*(s + 0.2)*sin(2*pi*(s - t))"}});
  const auto moved = PrescribedMotion<2>(*shifted, {on_outline(Point<2>(1.2, 0.1))}).compute(0.1);
  std::cout << "displacement: " << moved.positions[0] << " moves with " << moved.velocities[0]
            << std::endl;

  check_gait("curvature",
             {{"Type", "curvature"}, {"Curvature/Function", "(0.5 + s)*sin(2*pi*(t - s))"}});
  const auto arc = make_gait({{"Type", "curvature"}, {"Curvature/Function", "pi/2"}});
  // Half a circle about (0, 2/pi)
  std::cout << "half a circle: the tail "
            << in_units(1e-5, get_position<2>(*arc, 0.3, Point<2>(L, 0.))
                                  .distance(Point<2>(0., 4. / numbers::PI)))
            << ", a point inside "
            << in_units(1e-5, get_position<2>(*arc, 0.3, Point<2>(L / 2., 0.1))
                                  .distance(Point<2>(2. / numbers::PI - 0.1, 2. / numbers::PI)))
            << std::endl;

  // Gaits of joints, as functions of time.
  check_gait("joints", {{"Type", "arctangent"}, {"Frequency", "1.5"}});
  check_gait("joints, started", {{"Type", "sine"}, {"Bias", "3"}, {"Start-up ramp", "0.7"}});
  check_gait("wave of curvature", {{"Type", "curvature wave"}, {"Growth", "0.5"}});
  std::ofstream table("angles.csv");
  for (unsigned int k = 0; k <= 24; ++k)
  {
    table << k / 24.;
    for (unsigned int i = 0; i < 6; ++i)
      table << "," << 20. * std::sin(2. * numbers::PI * (k % 24) / 24. - i);
    table << "\r\n";
  }
  table.close();
  const Entries control = {{"Type", "table"}, {"Table/File", "angles.csv"}};
  check_gait("table", control);
  Entries once           = control;
  once["Table/Periodic"] = "false";
  expect_sentence(
      [&] { check_table_times("Body fish", "Gait", 0, make_gait(once)->get_end(), 1.5); });

  std::cout << "none " << (make_gait({})->is_prescribed() ? "prescribes" : "does not prescribe")
            << " anything" << std::endl;
  expect_sentence([] { make_gait({{"Type", "curvature"}, {"Curvature/Function", "sqrt(-1-s)"}}); });
  expect_sentence([] {
    make_gait({{"Type", "travelling wave"}, {"Travelling wave/Frequency", "0"}});
  });
  expect_sentence([] {
    get_position<2>(*make_gait({{"Type", "arctangent"}, {"Frequency", "1, 2"}}), 1., Point<2>());
  });
  expect_sentence([] {
    get_position<2>(*make_gait({{"Type", "travelling wave"}, {"Travelling wave/Amplitude", "0.5"}}),
                    1., Point<2>());
  });
}
