// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/cubed_ball.h>
#include <caudal/fish/elliptic_body.h>
#include <caudal/fish/graded_grid.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  EllipticBody::EllipticBody(const double length)
      : length(length)
  {}

  double EllipticBody::get_end_factor(const double s, const double length)
  {
    return 2. * std::sqrt(std::max(0., s * (length - s))) / length;
  }

  Point<3> EllipticBody::place(const Point<3> &reference) const
  {
    const double s      = 0.5 * length * (1. + reference[0]);
    const auto [ga, gb] = get_scales(s);
    return Point<3>(s, ga * reference[1], gb * reference[2]);
  }

  double EllipticBody::half_width(const double s) const
  {
    return get_scales(s).first * get_end_factor(s, length);
  }

  std::vector<BodySlice> EllipticBody::compute_slices() const
  {
    const QIterated<1>     quadrature(QGauss<1>(3), 56);
    std::vector<BodySlice> slices;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      BodySlice slice;
      slice.s             = length * quadrature.point(q)[0];
      const auto [ga, gb] = get_scales(slice.s);
      const double a      = ga * get_end_factor(slice.s, length);
      const double b      = gb * get_end_factor(slice.s, length);
      const double volume = numbers::PI * a * b * length * quadrature.weight(q);
      slice.moments[0][0] = volume;
      slice.moments[1][1] = volume * a * a / 4.;
      slice.moments[2][2] = volume * b * b / 4.;
      slices.push_back(slice);
    }
    return slices;
  }

  template <int dim>
  void EllipticShape<dim>::check_divisions(const ShapeLengths &, const GridDivisions &divisions,
                                           const std::string &path) const
  {
    for (unsigned int d = 1; d < divisions.elements.size(); ++d)
      require(divisions.elements[d] >= 3, path, "Elements",
              "there are " + std::to_string(divisions.elements[d]) +
                  " elements across the body. Give at least three: a core and a layer round it.");
  }

  namespace
  {
    /**
     * Length, and half-axes of the section [m], where the point @p x of the ball's axis is placed.
     */
    template <int dim>
    Tensor<1, dim> get_section(const StraightBody &body, const double x)
    {
      Tensor<1, dim> section;
      section[0] = body.get_length();
      for (unsigned int d = 1; d < dim; ++d)
      {
        Point<3> reference(x, 0., 0.);
        reference[d] = std::sqrt(1. - x * x);
        section[d]   = body.place(reference)[d];
      }
      return section;
    }

    /** Length, largest width and, in 3D, largest height. */
    template <int dim>
    Tensor<1, dim> get_sides(const StraightBody &body)
    {
      Tensor<1, dim> sides;
      sides[0]             = body.get_length();
      const unsigned int n = 100;
      for (unsigned int i = 1; i < n; ++i)
      {
        const Tensor<1, dim> section = get_section<dim>(body, 2. * i / n - 1.);
        for (unsigned int d = 1; d < dim; ++d)
          sides[d] = std::max(sides[d], 2. * section[d]);
      }
      return sides;
    }

    /**
     * The outline of the half-widths of a body, as a fraction of its length. Its round tail is cut
     * off where it is @p cut thick, so that a column of elements ends in an edge, and the rest
     * stretched to the whole length.
     */
    class EllipticOutline : public Outline
    {
    public:
      EllipticOutline(const StraightBody &body, const double cut)
          : body(body)
          , end(find_zero(
                [&](const double s) {
                  return 2. * body.half_width(s * body.get_length()) / body.get_length() - cut;
                },
                0.5, 1.))
      {}

      double half_thickness(const double s) const override
      {
        return body.half_width(s * end * body.get_length()) / body.get_length();
      }

    private:
      const StraightBody &body;
      const double        end; // of the outline on the body
    };

    /**
     * The graded grid of a plane body of which the tail, and not the middle, is one element
     * across; false if it is not so, which leaves @p tria empty.
     */
    bool make_slender_grid(const StraightBody &body, const GridDivisions &divisions,
                           const std::string &path, Triangulation<2> &tria)
    {
      const double length = body.get_length(), size = divisions.spacing / length;
      const double tail = body.half_width((1. - size) * length);
      if (size > 0.1 || body.half_width(0.5 * length) < divisions.spacing ||
          2. * tail > 1.7 * divisions.spacing)
        return false;
      const double cut = std::min(0.4 * size, tail / length);
      make_graded_grid(EllipticOutline(body, cut), size, divisions.region_boundaries, path, tria);
      GridTools::scale(length, tria);
      return true;
    }

    /** From where on @p body is not wider than @p width [m], or its end. */
    double find_tail(const StraightBody &body, const double width)
    {
      const unsigned int n = 400;
      unsigned int       i = n;
      while (i > 0 && 2. * body.half_width(body.get_length() * (i - 1) / n) <= width)
        --i;
      return body.get_length() * i / n;
    }

    /** The elements of the ball that becomes the body. */
    template <int dim>
    CubedBallDivisions divide_ball(const StraightBody &body, const GridDivisions &divisions)
    {
      CubedBallDivisions result;
      result.core = divisions.get_elements(get_sides<dim>(body));
      for (unsigned int d = 1; d < dim; ++d)
        result.core[d] = std::max(3u, result.core[d]);
      const unsigned int least = *std::min_element(result.core.begin() + 1, result.core.end());
      result.n_layers          = std::max(1u, least / 5);
      if (dim == 3 && divisions.is_automatic() && result.core[0] > 6 && result.core[1] == least)
      {
        // A thin tail has as many elements across as suit it, and so has the core.
        const double       length   = body.get_length();
        const unsigned int n_across = divisions.count_elements(
            2. * body.half_width(std::max(0.5 * length, length - divisions.spacing)));
        const double tail   = length - find_tail(body, (n_across + 0.9) * divisions.spacing);
        const int    n_tail = static_cast<int>(result.core[0] * tail / length - 0.5);
        if (n_across + 2 <= least && n_tail > 0)
        {
          result.n_tail   = std::min<unsigned int>(n_tail, result.core[0] - 5);
          result.n_layers = (least - n_across) / 2;
          result.core[1]  = n_across + 2 * result.n_layers;
          result.core[0] -= result.n_tail + 2;
        }
      }
      for (unsigned int d = 1; d < dim; ++d)
        result.core[d] -= 2 * result.n_layers;
      return result;
    }

    /** The volume of the body, int pi a b ds [m^3]; in 2D the area of its outline, int 2 a ds. */
    template <int dim>
    double compute_volume(const StraightBody &body)
    {
      // Gauss points over the angle from nose to tail, where the round ends are smooth.
      const QIterated<1> quadrature(QGauss<1>(4), 50);
      double             volume = 0.;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const double angle = numbers::PI * quadrature.point(q)[0];
        const auto   sides = get_section<dim>(body, -std::cos(angle));
        double       area  = dim == 2 ? 2. : numbers::PI;
        for (unsigned int d = 1; d < dim; ++d)
          area *= sides[d];
        volume += area * 0.5 * sides[0] * std::sin(angle) * numbers::PI * quadrature.weight(q);
      }
      return volume;
    }

    /**
     * Gives a grid the nose at 0, the length and the volume of the body. Inscribed in it, it has
     * less volume, and with an odd number of elements across it ends in edges or faces instead of
     * points, which make it shorter. A plane grid is stretched evenly; in space, where the faces
     * take more off, the middle stays where it is, and what is at the share t of the length from
     * an end moves to it by (1 - 2 t)^2 of what is missing there.
     */
    template <int dim>
    void fit_to_body(Triangulation<dim> &tria, const StraightBody &body)
    {
      const BoundingBox<dim> box    = GridTools::compute_bounding_box(tria);
      const double           length = body.get_length(), front = box.lower_bound(0),
                   back = length - box.upper_bound(0), side = box.side_length(0);
      GridTools::transform(
          [&](const Point<dim> &p) {
            Point<dim>   result = p;
            const double t = (p[0] - front) / side, middle = 1. - 2. * t;
            if (dim == 2)
              result[0] = t * length;
            else
              result[0] += middle * middle * (t < 0.5 ? -front : back);
            return result;
          },
          tria);
      const double widen =
          std::pow(compute_volume<dim>(body) / GridTools::volume(tria), 1. / (dim - 1.));
      GridTools::transform(
          [&](const Point<dim> &p) {
            Point<dim> result(widen * p);
            result[0] = p[0];
            return result;
          },
          tria);
    }
  } // namespace

  template <int dim>
  void EllipticShape<dim>::make_grid(const ShapeLengths &lengths, const GridDivisions &divisions,
                                     const std::string &path, Triangulation<dim> &tria) const
  {
    const auto body = this->make_straight_body(lengths);
    if constexpr (dim == 2)
      if (divisions.is_automatic() && make_slender_grid(*body, divisions, path, tria))
        return;
    make_cubed_ball(tria, divide_ball<dim>(*body, divisions));
    GridTools::transform(
        [&body](const Point<dim> &reference) {
          Point<3> point;
          for (unsigned int d = 0; d < dim; ++d)
            point[d] = reference[d];
          point = body->place(point);
          Point<dim> result;
          for (unsigned int d = 0; d < dim; ++d)
            result[d] = point[d];
          return result;
        },
        tria);
    fit_to_body(tria, *body);
    assign_regions(tria, divisions.region_boundaries);
  }

  template class EllipticShape<2>;
  template class EllipticShape<3>;
} // namespace caudal
