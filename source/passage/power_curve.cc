// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/passage/power_curve.h>

#include <algorithm>
#include <cmath>

namespace caudal::passage
{
  namespace
  {
    const Registration<PowerCurve, PowerCurve> none("none", "no power is known");

    double scale(const PowerPoint &point, const double exponent, const double speed)
    {
      return point.power * std::pow(speed / point.speed, exponent);
    }
  } // namespace

  std::function<double(double)> interpolate_power(std::vector<PowerPoint> points)
  {
    return [points = std::move(points)](const double speed) {
      const auto next =
          std::find_if(points.begin(), points.end(),
                       [speed](const PowerPoint &point) { return point.speed > speed; });
      if (next == points.begin() || next == points.end())
        return scale(next == points.end() ? points.back() : points.front(), 3., speed);
      const PowerPoint &a = *(next - 1), &b = *next;
      return scale(a, std::log(b.power / a.power) / std::log(b.speed / a.speed), speed);
    };
  }
} // namespace caudal::passage
