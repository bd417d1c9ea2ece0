// SPDX-License-Identifier: LGPL-2.1-or-later
// Values that the user gives: range checks, expressions, and JSON files.

#include <caudal/base/checks.h>
#include <caudal/base/collective.h>
#include <caudal/base/expression.h>
#include <caudal/base/json.h>

#include <iostream>
#include <limits>

using namespace caudal;

namespace
{
  void try_to(const std::function<void()> &action)
  {
    const std::string error = catch_error(action);
    std::cout << (error.empty() ? "accepted" : error) << '\n';
  }

  void test_checks()
  {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double value : {-0.1, 0., 1e-9, infinity})
    {
      try_to([&] { check_finite("Any", value); });
      try_to([&] { check_positive("Fluid/Density", value); });
      try_to([&] { check_not_negative("Body/Density", value); });
      try_to([&] { check_between("Share", value, 0, 1, "Give a share from 0 to 1."); });
    }
  }

  void test_expressions()
  {
    Expression<2> velocity("Fluid/Velocity", "2*x + t; sqrt(y)", 2);
    velocity.set_time(3);
    const Expression<2> copy(velocity);
    Vector<double>      values(2);
    copy.vector_value(Point<2>(1, 4), values);
    std::cout << values[0] << ' ' << values[1] << ' ' << velocity.value(Point<2>(1, 4), 1) << '\n';
    try_to([&] { velocity.value(Point<2>(1, -4), 0); });
    try_to([&] { velocity.value(Point<2>(1, -4), 1); });
    try_to([&] { velocity.vector_value(Point<2>(1, -4), values); });
    try_to([] { Expression<2>("Fluid/Velocity", "x", 2); });
    try_to([] { Expression<3>("Fluid/Level", "x + w", 1); });

    const Expression<2> envelope("Envelope", "s,t", "1/s + cos(pi*t)");
    std::cout << envelope.value({0.5, 1.}) << '\n';
    try_to([&] { envelope.value({0., 1.}); });
    try_to([] { Expression<2>("Envelope", "s,t", "x"); });
  }

  void test_json()
  {
    Json constants = Json::object();
    constants.add("length", Json::object().add("value", 0.1).add("unit", "m"));
    Json beats = Json::array();
    beats.append(Json::object().add("n", 1).add("speed", 1. / 3.).add("steady", true));
    beats.append(Json::object().add("n", 2).add("speed", std::numeric_limits<double>::quiet_NaN()));
    Json::object()
        .add("body", "a \"fish\"\n\\")
        .add("constants", constants)
        .add("beats", beats)
        .add("none", Json::array())
        .add("mean", Json())
        .write(std::cout);
    std::cout << '\n';
  }
} // namespace

int main()
{
  test_checks();
  test_expressions();
  test_json();
}
