// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/number_table.h>
#include <caudal/fish/outline.h>
#include <caudal/fish/spline.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  namespace
  {
    /** A side of an outline: y over (x)^(1/2), in which a round nose is smooth. */
    Spline make_side(const std::vector<Point<2>> &points)
    {
      std::vector<double> u, y;
      for (const Point<2> &point : points)
        if (u.empty() || std::sqrt(point[0]) > u.back())
        {
          u.push_back(std::sqrt(point[0]));
          y.push_back(point[1]);
        }
      return Spline(u, y, Spline::Kind::limited);
    }

    /** The outline through two rows of points from the nose (0, 0) to x = 1. */
    class PointsOutline : public Outline
    {
    public:
      PointsOutline(const std::vector<Point<2>> &left, const std::vector<Point<2>> &right)
          : left(make_side(left))
          , right(make_side(right))
      {}

      /** Half the distance of the two sides. */
      double compute_half_distance(const double s) const
      {
        const double u = std::sqrt(s);
        return 0.5 * (left.evaluate(u).first - right.evaluate(u).first);
      }

      // Measured along y, as the slope of the camber line is given as zero.
      double half_thickness(const double s) const override
      {
        const double half = compute_half_distance(s);
        return s < 0.5 ? half : std::max(half, least_half_thickness);
      }

      double camber(const double s) const override
      {
        const double u = std::sqrt(s);
        return 0.5 * (left.evaluate(u).first + right.evaluate(u).first);
      }

    private:
      // A tail that ends in a point could not be divided into quadrilaterals.
      static constexpr double least_half_thickness = 1e-3;

      const Spline left, right;
    };

    /** A plane body whose outline goes through given points. */
    template <int dim>
    class PointsShape : public SlenderShape<dim>
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Table", table,
                          "Points `x, y` of the outline, separated by ';', one after the other "
                          "round the body, in any unit: it is scaled to `Length`. The nose is the "
                          "point with the smallest x, and each line across the body meets the "
                          "outline twice. A tail thinner than 0.2 % of the length is made blunt.",
                          Patterns::Anything());
        prm.add_parameter("File", file,
                          "A text file with these points, instead of them; a row of names may come "
                          "first.",
                          Patterns::FileName(Patterns::FileName::input));
      }

      void check(const std::string &path) const override
      {
        const auto outline = read(path);
        const bool is_file = !file.empty();
        for (unsigned int k = 1; k < n_checks; ++k)
          require(outline->compute_half_distance(1. * k / n_checks) > 0., path,
                  is_file ? "File" : "Table",
                  "the body has no thickness at " + std::to_string(100 * k / n_checks) +
                      " % of its length. Give points whose two sides do not meet there.");
      }

    private:
      static constexpr unsigned int n_checks = 100;

      std::string table, file;

      std::unique_ptr<Outline> make_outline() const override
      {
        return read("Shape/Points");
      }

      std::unique_ptr<PointsOutline> read(const std::string &path) const
      {
        require(file.empty() != table.empty(), path, "Table",
                "give the points either here or in " + path + "/File.");
        const std::string entry = path + (file.empty() ? "/Table" : "/File");
        const NumberTable rows =
            file.empty() ? parse_number_table(entry, table, 2) : read_number_table(entry, file, 2);
        std::vector<Point<2>> points;
        for (const auto &row : rows.rows)
          points.emplace_back(row.values[0], row.values[1]);
        if (points.size() > 1 && points.front() == points.back())
          points.pop_back();
        AssertThrow(points.size() >= 6,
                    ExcMessage(entry + ": there are " + std::to_string(points.size()) +
                               " different points. Give at least six."));
        const auto precedes = [](const Point<2> &a, const Point<2> &b) { return a[0] < b[0]; };
        std::rotate(points.begin(), std::min_element(points.begin(), points.end(), precedes),
                    points.end());
        const Point<2>    nose   = points.front();
        const auto        tail   = std::max_element(points.begin(), points.end(), precedes);
        const double      length = (*tail)[0] - nose[0];
        const std::size_t n_tail = tail - points.begin();
        for (Point<2> &point : points)
          point = Point<2>((point - nose) / length);

        std::vector<Point<2>> one(points.begin(), points.begin() + n_tail + 1), other;
        other.push_back(points.front());
        other.insert(other.end(), points.rbegin(), points.rend() - n_tail);
        for (auto *side : {&one, &other})
          for (std::size_t i = 1; i < side->size(); ++i)
            AssertThrow((*side)[i][0] >= (*side)[i - 1][0],
                        ExcMessage(entry + ": behind " + std::to_string(100 * (*side)[i - 1][0]) +
                                   " % of the length the outline goes back towards the nose, so "
                                   "that a line across the body meets it more than twice. Sort "
                                   "the points round the body, or give a mesh (Type = file)."));
        const auto mean = [](const std::vector<Point<2>> &side) {
          double sum = 0.;
          for (const Point<2> &point : side)
            sum += point[1] / side.size();
          return sum;
        };
        if (mean(one) < mean(other))
          std::swap(one, other);
        return std::make_unique<PointsOutline>(one, other);
      }
    };

    const DimensionalRegistration<Shape, PointsShape>
        registration("points", "an outline through given points (2D)");
  } // namespace
} // namespace caudal
