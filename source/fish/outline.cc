// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/grid/grid_tools.h>

#include <caudal/fish/graded_grid.h>
#include <caudal/fish/outline.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  Point<2> Outline::point(const double s, const double eta) const
  {
    const double slope = camber_slope(s);
    const double h     = half_thickness(s) / std::sqrt(1. + slope * slope);
    return Point<2>(s - eta * h * slope, camber(s) + eta * h);
  }

  void check_first_region(const std::string &path, const double nose_end,
                          const std::vector<double> &region_boundaries)
  {
    require(region_boundaries.empty() || region_boundaries.front() > nose_end, path,
            "Region boundaries",
            "the first one lies within the round nose of the grid, which ends at " +
                std::to_string(nose_end) + ". Give a larger fraction.");
  }

  namespace
  {
    /**
     * The C-shaped grid round an outline's nose: the outermost layers of cells wrap round the
     * front of a core of cells. The core's front edge lies at the station @p core, and the
     * diagonals from its two corners meet the outline, under 45 degrees, at the station
     * @p shoulder. So no cell has two edges on the smooth outline, hence none a corner near 180
     * degrees.
     *
     * A layer takes a fifth of the body's thickness on each side. The cap in front of the core is
     * made as thick as the layers beside it.
     */
    struct Nose
    {
      Nose(const Outline &outline, const unsigned int n_across)
          : n_layers(std::max(1u, n_across / 5))
          , n_core(n_across - 2 * n_layers)
      {
        AssertThrow(n_across >= 4, ExcMessage("A round nose needs four cells across."));
        const double eta = static_cast<double>(n_core) / n_across;
        core = find_zero([&](const double s) { return s - (1. - eta) * outline.half_thickness(s); },
                         1e-12, 0.5);
        const double corner = eta * outline.half_thickness(core);
        shoulder            = find_zero(
            [&](const double s) { return (outline.half_thickness(s) - corner) - (core - s); }, 0.,
            core);
      }

      const unsigned int n_layers, n_core;
      double             core, shoulder;
    };

    /** The grid of a SlenderShape as lists of vertices (unit length) and cells. */
    class OutlineGrid
    {
    public:
      OutlineGrid(const Outline &outline, const GridDivisions &divisions)
          : outline(outline)
          , region_boundaries(divisions.region_boundaries)
          , n_along(divisions.elements[0])
          , n_across(divisions.elements[1])
          , nose(outline, n_across)
      {
        add_strip();
        add_cap();
      }

      std::vector<Point<2>>    vertices;
      std::vector<CellData<2>> cells;

    private:
      // Grid lines across the body are straight in the core. In the layers they
      // lean forward, from 45 degrees at the nose to nothing ten noses further, at
      // the end of the first region at the latest.
      void add_strip()
      {
        const std::vector<double> stations = compute_columns(nose.core, region_boundaries, n_along);
        const double              fade_end =
            std::min(10. * nose.core, region_boundaries.empty() ? 1. : region_boundaries.front());
        const double core_eta = static_cast<double>(nose.n_core) / n_across;

        for (const double s : stations)
        {
          const double lean =
              (nose.core - nose.shoulder) * std::max(0., (fade_end - s) / (fade_end - nose.core));
          for (unsigned int j = 0; j <= n_across; ++j)
          {
            const int    outward = 2 * static_cast<int>(j) - static_cast<int>(n_across);
            const int    layer   = (std::abs(outward) - static_cast<int>(nose.n_core)) / 2;
            const double side    = outward < 0 ? -1. : 1.;
            if (layer <= 0)
              vertices.push_back(outline.point(s, static_cast<double>(outward) / n_across));
            else
              vertices.push_back(interpolate(outline.point(s, side * core_eta),
                                             outline.point(s - lean, side),
                                             static_cast<double>(layer) / nose.n_layers));
          }
        }

        for (unsigned int i = 0; i < n_along; ++i)
          for (unsigned int j = 0; j < n_across; ++j)
          {
            const unsigned int corner = i * (n_across + 1) + j;
            add_cell({corner, corner + n_across + 1, corner + 1, corner + n_across + 2},
                     get_region(0.5 * (stations[i] + stations[i + 1]), region_boundaries));
          }
      }

      // The cap lies between the core's front edge (k = 0) and the outline
      // (k = n_layers). Its first and last line are the strip's first column.
      void add_cap()
      {
        const unsigned int n_layers = nose.n_layers, n_core = nose.n_core;
        const unsigned int first_new = vertices.size();

        for (unsigned int k = 1; k <= n_layers; ++k)
          for (unsigned int j = 1; j < n_core; ++j)
          {
            // u^2 instead of u spaces the points evenly on a parabolic nose.
            const double u = -1. + 2. * j / n_core;
            vertices.push_back(interpolate(vertices[n_layers + j],
                                           outline.point(nose.shoulder * u * u, u < 0. ? -1. : 1.),
                                           static_cast<double>(k) / n_layers));
          }

        const auto vertex = [&](const unsigned int k, const unsigned int j) {
          if (k == 0)
            return n_layers + j;
          if (j == 0)
            return n_layers - k;
          if (j == n_core)
            return n_across - n_layers + k;
          return first_new + (k - 1) * (n_core - 1) + (j - 1);
        };
        for (unsigned int k = 0; k < n_layers; ++k)
          for (unsigned int j = 0; j < n_core; ++j)
            add_cell({vertex(k + 1, j), vertex(k, j), vertex(k + 1, j + 1), vertex(k, j + 1)}, 0);
      }

      void add_cell(const std::vector<unsigned int> &corners, const types::material_id region)
      {
        cells.emplace_back();
        std::copy(corners.begin(), corners.end(), cells.back().vertices.begin());
        cells.back().material_id = region;
      }

      const Outline             &outline;
      const std::vector<double> &region_boundaries;
      const unsigned int         n_along, n_across;
      const Nose                 nose;
    };
  } // namespace

  template <int dim>
  void SlenderShape<dim>::check_divisions(const ShapeLengths &, const GridDivisions &divisions,
                                          const std::string &path) const
  {
    if (divisions.is_automatic())
      return;
    require(divisions.elements[1] >= 4, path, "Elements",
            "there are " + std::to_string(divisions.elements[1]) +
                " elements across the body. Give at least four: they wrap round the nose.");
    check_first_region(path, Nose(*make_outline(), divisions.elements[1]).core,
                       divisions.region_boundaries);
  }

  template <int dim>
  void SlenderShape<dim>::make_grid(const ShapeLengths &lengths, const GridDivisions &divisions,
                                    const std::string &path, Triangulation<dim> &tria) const
  {
    if constexpr (dim == 2)
    {
      const auto outline = make_outline();
      if (divisions.is_automatic())
        make_graded_grid(*outline, divisions.spacing / lengths.length, divisions.region_boundaries,
                         path, tria);
      else
      {
        OutlineGrid grid(*outline, divisions);
        GridTools::consistently_order_cells(grid.cells);
        tria.create_triangulation(grid.vertices, grid.cells, SubCellData());
      }
      GridTools::scale(lengths.length, tria);
    }
  }

  template class SlenderShape<2>;
  template class SlenderShape<3>;
} // namespace caudal
