// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/graded_grid.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  namespace
  {
    /**
     * The grid of make_graded_grid() as lists of vertices and cells. It consists of columns of
     * cells between stations, and of a cap on the round nose: the outermost cells go round the
     * front of a core, whose front edge lies at the first station.
     */
    class GradedGrid
    {
    public:
      GradedGrid(const Outline &outline, const double size,
                 const std::vector<double> &region_boundaries, const std::string &path)
          : outline(outline)
          , size(size)
          , region_boundaries(region_boundaries)
      {
        choose_nose();
        check_first_region(path, front, region_boundaries);
        add_stations();
        for (unsigned int i = 0; i + 1 < rows.size(); ++i)
          add_column(i);
        if (has_cap)
          add_cap();
      }

      std::vector<Point<2>>    vertices;
      std::vector<CellData<2>> cells;

    private:
      using Row = std::vector<unsigned int>; // vertices, from the right side to the left

      const Outline             &outline;
      const double               size;
      const std::vector<double> &region_boundaries;

      bool                has_cap;
      double              front;    // the first station
      double              shoulder; // where the diagonals from the core's corners meet the outline
      std::vector<Row>    rows;
      std::vector<double> stations;

      double get_thickness(const double s) const
      {
        return 2. * outline.half_thickness(s);
      }

      /**
       * A layer round the nose is as thick in front of the core as beside it, and the core at
       * least half as wide as the layer. A nose that is too small for this has no cap: it is cut
       * off where it is 0.4 elements thick, if it is so thick, or before.
       */
      void choose_nose()
      {
        front = std::min(
            size, find_zero([&](const double s) { return outline.half_thickness(s) - 1.25 * s; },
                            1e-9, 1.));
        has_cap  = front > 0.5 * size;
        shoulder = front;
        if (!has_cap)
        {
          const double cut = std::min(0.4 * size, 0.5 * get_thickness(front));
          front            = shoulder =
              find_zero([&](const double s) { return get_thickness(s) - cut; }, 0., front);
        }
        else
        {
          const double corner = outline.half_thickness(front) - front;
          shoulder            = find_zero(
              [&](const double s) { return outline.half_thickness(s) - corner - (front - s); }, 0.,
              front);
        }
      }

      /** The number of elements across that suits a thickness: an odd one. */
      unsigned int count_across(const double thickness) const
      {
        if (thickness < 1.76 * size)
          return 1;
        return std::max(3, 2 * static_cast<int>(thickness / (2. * size)) + 1);
      }

      /** The next number of elements across: it changes by two, and not back at once. */
      unsigned int get_next_count(const unsigned int n, const double thickness) const
      {
        if (count_across(thickness) > n)
          return n + 2;
        return count_across(1.1 * thickness) < n ? n - 2 : n;
      }

      void add_stations()
      {
        const unsigned int n_columns =
            std::max<long>(region_boundaries.size() + 1, std::lround((1. - front) / size));
        stations = compute_columns(front, region_boundaries, n_columns);
        const double fade_end =
            std::min(10. * front, region_boundaries.empty() ? 1. : region_boundaries.front());
        // The first row: the core of a nose has elements like the rest.
        const double core_width = get_thickness(front) - 2. * front;
        unsigned int n          = has_cap ? 3 + 2 * static_cast<int>(core_width / (2. * size)) : 1;
        for (const double s : stations)
        {
          const double thickness = get_thickness(s);
          double       layer     = front;
          if (s != front)
          {
            n     = get_next_count(n, thickness);
            layer = std::min(std::clamp(thickness / n, 0.64 * size, size), 0.4 * thickness);
          }
          // The outermost cells lean forward at the nose.
          const double lean =
              (front - shoulder) * std::max(0., (fade_end - s) / (fade_end - front));
          add_row(s, lean, n, 1. - 2. * layer / thickness);
        }
      }

      /** A row of @p n elements across, all but the outermost within @p core of the thickness. */
      void add_row(const double s, const double lean, const unsigned int n, const double core)
      {
        rows.emplace_back();
        for (unsigned int k = 0; k <= n; ++k)
        {
          rows.back().push_back(vertices.size());
          if (k == 0 || k == n)
            vertices.push_back(outline.point(s - lean, k == 0 ? -1. : 1.));
          else
            vertices.push_back(outline.point(s, core * (2. * (k - 1.) / (n - 2.) - 1.)));
        }
      }

      /** The column of cells between the stations i and i + 1. */
      void add_column(const unsigned int i)
      {
        const Row         &left = rows[i], &right = rows[i + 1];
        const unsigned int region =
            get_region(0.5 * (stations[i] + stations[i + 1]), region_boundaries);
        const Row         &fewer = left.size() < right.size() ? left : right;
        const Row         &more  = left.size() < right.size() ? right : left;
        const unsigned int shift = more.size() - fewer.size(), middle = fewer.size() / 2 - 1;
        for (unsigned int k = 0; k + 1 < fewer.size(); ++k)
          if (shift > 0 && k == middle)
            add_transition({fewer[k], fewer[k + 1]},
                           {more[k], more[k + 1], more[k + 2], more[k + 3]}, region);
          else
          {
            const unsigned int other = k + (k > middle ? shift : 0);
            add_cell({fewer[k], more[other], fewer[k + 1], more[other + 1]}, region);
          }
      }

      /** Four cells between an edge on one side and three on the other. */
      void add_transition(const Row &one, const Row &three, const unsigned int region)
      {
        Row inner(2);
        for (unsigned int i = 0; i < 2; ++i)
        {
          inner[i] = vertices.size();
          vertices.push_back(
              interpolate(interpolate(vertices[one[0]], vertices[one[1]], i == 0 ? 0.3 : 0.7),
                          vertices[three[1 + i]], 0.5));
        }
        add_cell({one[0], inner[0], one[1], inner[1]}, region);
        add_cell({one[0], three[0], inner[0], three[1]}, region);
        add_cell({inner[0], three[1], inner[1], three[2]}, region);
        add_cell({inner[1], three[2], one[1], three[3]}, region);
      }

      /** The cells between the front edge of the core and the nose. */
      void add_cap()
      {
        const Row         &row    = rows.front();
        const unsigned int n_core = row.size() - 3, n_front = std::max(3u, n_core);
        Row                nose(1, row.front());
        for (unsigned int j = 1; j < n_front; ++j)
        {
          nose.push_back(vertices.size());
          // u^2 instead of u spaces the points evenly on a parabolic nose.
          const double u = -1. + 2. * j / n_front;
          vertices.push_back(outline.point(shoulder * u * u, u < 0. ? -1. : 1.));
        }
        nose.push_back(row.back());
        if (n_core == 1)
          add_transition({row[1], row[2]}, {nose[0], nose[1], nose[2], nose[3]}, 0);
        else
          for (unsigned int j = 0; j < n_core; ++j)
            add_cell({row[1 + j], nose[j], row[2 + j], nose[j + 1]}, 0);
      }

      /** Adds a cell with its corners as in the unit cell, or mirrored. */
      void add_cell(Row corners, const unsigned int region)
      {
        const Tensor<1, 2> a = vertices[corners[3]] - vertices[corners[0]],
                           b = vertices[corners[2]] - vertices[corners[1]];
        if (a[0] * b[1] - a[1] * b[0] < 0.)
          std::swap(corners[1], corners[2]);
        cells.emplace_back();
        std::copy(corners.begin(), corners.end(), cells.back().vertices.begin());
        cells.back().material_id = region;
      }
    };

    /** The area inside the outline, from a polygon of many points, dense at the nose. */
    double compute_area(const Outline &outline)
    {
      const unsigned int    n = 2000;
      std::vector<Point<2>> right, left;
      for (unsigned int i = 0; i <= n; ++i)
      {
        const double u = static_cast<double>(i) / n;
        right.push_back(outline.point(u * u, -1.));
        left.push_back(outline.point(u * u, 1.));
      }
      double area = 0.;
      for (unsigned int i = 0; i < n; ++i)
      {
        const Tensor<1, 2> a = left[i + 1] - right[i], b = left[i] - right[i + 1];
        area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
      }
      return std::abs(area);
    }
  } // namespace

  void make_graded_grid(const Outline &outline, const double size,
                        const std::vector<double> &region_boundaries, const std::string &path,
                        Triangulation<2> &tria)
  {
    GradedGrid grid(outline, size, region_boundaries, path);
    // A nose that ends in an edge keeps the body's length.
    double front = 1.;
    for (const Point<2> &vertex : grid.vertices)
      front = std::min(front, vertex[0]);
    for (Point<2> &vertex : grid.vertices)
      if (vertex[0] < front + 1e-10)
        vertex[0] = 0.;
    GridTools::consistently_order_cells(grid.cells);
    tria.create_triangulation(grid.vertices, grid.cells, SubCellData());
    const double factor = compute_area(outline) / GridTools::volume(tria);
    GridTools::transform([&](const Point<2> &p) { return Point<2>(p[0], factor * p[1]); }, tria);
  }
} // namespace caudal
