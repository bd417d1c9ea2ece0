// Gaits: the midline keeps its length and a symmetric body its area, cross
// sections stay normal, velocities are time derivatives, a known displacement
// and an arc of a circle come out; bad input.

#include <caudal/fish/gait.h>

#include <cmath>
#include <iostream>

using namespace caudal;

const double L = 2.;

std::string ok(const double error, const double tolerance)
{
  return error < tolerance ? "ok" : "bad (" + std::to_string(error) + ")";
}

// Half the thickness of a NACA0012 outline of length L
double half_thickness(const double x)
{
  const double s = x / L;
  return 0.6 * L * (0.2969 * std::sqrt(s) - s * (0.126 + s * (0.3516 - s * (0.2843 - s * 0.1036))));
}

void check_gait(const std::string &name, const GaitParameters &parameters)
{
  const auto gait = create_gait<2>(parameters, L);
  const auto at   = [&](const double time, const Point<2> &s) {
    gait->set_time(time);
    return gait->position(s);
  };
  const unsigned int n            = 3000;
  double             length_error = 0., area_error = 0., velocity_error = 0., angle_error = 0.;
  for (const double time : {0.05, 0.3, 0.61, 0.97})
  {
    gait->set_time(time);
    double length = 0., area = 0., reference = 0.;
    for (unsigned int i = 0; i < n; ++i)
    {
      const double left = i * L / n, right = (i + 1) * L / n;
      length += gait->position(Point<2>(right, 0.)).distance(gait->position(Point<2>(left, 0.)));

      // Shoelace formula for the quadrilateral between two cross sections
      const Point<2> corners[] = {
          Point<2>(left, -half_thickness(left)), Point<2>(right, -half_thickness(right)),
          Point<2>(right, half_thickness(right)), Point<2>(left, half_thickness(left))};
      for (unsigned int c = 0; c < 4; ++c)
      {
        const Point<2> s = corners[c], t = corners[(c + 1) % 4];
        const Point<2> X = gait->position(s), Y = gait->position(t);
        reference += 0.5 * (s[0] * t[1] - s[1] * t[0]);
        area += 0.5 * (X[0] * Y[1] - X[1] * Y[0]);
      }
    }
    length_error = std::max(length_error, std::abs(length / L - 1.));
    area_error   = std::max(area_error, std::abs(area / reference - 1.));

    // The last two points lie beyond the ends of the midline.
    for (const Point<2> s : {Point<2>(0.3, 0.05), Point<2>(1.1, -0.07), Point<2>(1.99, 0.01),
                             Point<2>(-0.01, 0.02), Point<2>(2.02, -0.01)})
    {
      gait->set_time(time);
      const Tensor<1, 2> V = gait->velocity(s);
      const Tensor<1, 2> along =
          gait->position(Point<2>(s[0] + 1e-3, 0.)) - gait->position(Point<2>(s[0] - 1e-3, 0.));
      const Tensor<1, 2> across = gait->position(s) - gait->position(Point<2>(s[0], 0.));
      const Tensor<1, 2> slope  = (at(time + 1e-5, s) - at(time - 1e-5, s)) / 2e-5;
      angle_error =
          std::max(angle_error, std::abs(along * across) / (along.norm() * across.norm()));
      velocity_error = std::max(velocity_error, (slope - V).norm());
    }
  }
  std::cout << name << ": length " << ok(length_error, 1e-5) << ", area " << ok(area_error, 1e-5)
            << ", normal sections " << ok(angle_error, 1e-4) << ", velocity "
            << ok(velocity_error, 1e-6) << std::endl;
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
  GaitParameters wave;
  wave.type          = "travelling wave";
  wave.ramp.duration = 0.5;
  check_gait("eel", wave);

  // Displacement of the tail relative to the nose, against its formula
  const auto eel = create_gait<2>(wave, L);
  eel->set_time(0.8);
  const auto y = [](const double s) {
    return 0.125 * L * (s + 0.03125) / 1.03125 * std::sin(2. * numbers::PI * (s - 0.8));
  };
  std::cout << "  displacement "
            << ok(std::abs(eel->position(Point<2>(L, 0.))[1] - (y(1.) - y(0.))), 1e-5)
            << ", at rest at t = 0 ";
  eel->set_time(0.);
  std::cout << ok(eel->position(Point<2>(1.3, 0.1)).distance(Point<2>(1.3, 0.1)), 1e-12)
            << ", z unchanged ";
  const auto eel_3d = create_gait<3>(wave, L);
  eel_3d->set_time(0.8);
  std::cout << eel_3d->position(Point<3>(1.3, 0.1, 0.7))[2] << ' '
            << eel_3d->velocity(Point<3>(1.3, 0.1, 0.7))[2] << std::endl;

  GaitParameters curvature;
  curvature.type      = "curvature";
  curvature.curvature = "(0.5 + s)*sin(2*pi*(t - s))";
  check_gait("curvature", curvature);

  curvature.curvature = "pi/2";
  const auto arc      = create_gait<2>(curvature, L);
  arc->set_time(0.3);
  // Half a circle about (0, 2/pi)
  std::cout << "half a circle: the tail "
            << ok(arc->position(Point<2>(L, 0.)).distance(Point<2>(0., 4. / numbers::PI)), 1e-5)
            << ", a point inside "
            << ok(arc->position(Point<2>(L / 2., 0.1))
                      .distance(Point<2>(2. / numbers::PI - 0.1, 2. / numbers::PI)),
                  1e-5)
            << std::endl;

  std::cout << "none is " << (create_gait<2>(GaitParameters(), L) ? "a gait" : "null") << std::endl;
  curvature.curvature = "sqrt(-1-s)";
  expect_sentence([&] { curvature.check("Body eel"); });
  wave.frequency = 0.;
  expect_sentence([&] { wave.check("Body eel"); });
  wave.amplitude = 0.5;
  expect_sentence([&] { create_gait<2>(wave, L)->set_time(1.); });
}
