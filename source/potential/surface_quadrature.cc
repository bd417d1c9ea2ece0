#include <caudal/potential/surface_quadrature.h>

#include <deal.II/base/quadrature_lib.h>

namespace caudal::potential
{
  namespace
  {
    const unsigned int n_regular = 3; // points in each direction
    const unsigned int n_part    = 4;
    const unsigned int n_radial  = 5;
    const unsigned int n_angular = 14;

    /**
     * Rule on the triangle (apex, a, b), p = apex + u ((a - apex) + v (b - a)) with the
     * Jacobian u |(a - apex) x (b - a)|, which vanishes like the distance from the apex.
     */
    void add_triangle(const Point<2> &apex, const Point<2> &a, const Point<2> &b,
                      std::vector<Point<2>> &points, std::vector<double> &weights)
    {
      const Tensor<1, 2> to_a = a - apex, along = b - a;
      const double       twice_area = std::abs(to_a[0] * along[1] - to_a[1] * along[0]);
      if (twice_area < 1e-12)
        return; // the apex stands on this edge
      const QGauss<1> radial(n_radial), angular(n_angular);
      for (unsigned int i = 0; i < n_radial; ++i)
        for (unsigned int j = 0; j < n_angular; ++j)
        {
          const double u = radial.point(i)[0], v = angular.point(j)[0];
          points.push_back(apex + u * (to_a + v * along));
          weights.push_back(twice_area * u * radial.weight(i) * angular.weight(j));
        }
    }

    /** Four triangles between a node and the edges; those of no area are left out. */
    Quadrature<2> make_singular_quadrature(const Point<2> &node)
    {
      const Point<2> corners[] = {Point<2>(0, 0), Point<2>(1, 0), Point<2>(1, 1), Point<2>(0, 1),
                                  Point<2>(0, 0)};
      std::vector<Point<2>> points;
      std::vector<double>   weights;
      for (unsigned int i = 0; i < 4; ++i)
        add_triangle(node, corners[i], corners[i + 1], points, weights);
      return Quadrature<2>(points, weights);
    }
  } // namespace

  ReferenceRule::ReferenceRule(const Quadrature<2> &quadrature, const FiniteElement<2, 3> &fe)
      : n_points(quadrature.size())
      , weights(quadrature.get_weights())
  {
    for (const Point<2> &point : quadrature.get_points())
      for (unsigned int k = 0; k < fe.n_dofs_per_cell(); ++k)
      {
        const Tensor<1, 2> gradient = fe.shape_grad(k, point);
        values.push_back(fe.shape_value(k, point));
        x_derivatives.push_back(gradient[0]);
        y_derivatives.push_back(gradient[1]);
      }
  }

  ReferenceRules::ReferenceRules(const FiniteElement<2, 3> &fe)
      : fe(fe)
      , regular(std::make_unique<ReferenceRule>(QGauss<2>(n_regular), fe))
      , parts(get_index(finest_level + 1, 0, 0))
  {
    for (const Point<2> &node : fe.get_unit_support_points())
      singular.push_back(std::make_unique<ReferenceRule>(make_singular_quadrature(node), fe));
  }

  const ReferenceRule &ReferenceRules::get_part(const unsigned int level, const unsigned int i,
                                                const unsigned int j)
  {
    auto &part = parts[get_index(level, i, j)];
    if (!part)
    {
      const QGauss<2>       gauss(n_part);
      const double          size = 1. / (1u << level);
      std::vector<Point<2>> points;
      std::vector<double>   weights;
      for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        points.push_back(size * (gauss.point(q) + Point<2>(i, j)));
        weights.push_back(size * size * gauss.weight(q));
      }
      part = std::make_unique<ReferenceRule>(Quadrature<2>(points, weights), fe);
    }
    return *part;
  }

  CellRule::CellRule(const ReferenceRule &reference, const std::vector<Point<3>> &positions)
      : reference(&reference)
  {
    for (unsigned int d = 0; d < 3; ++d)
    {
      points[d].resize(reference.n_points);
      areas[d].resize(reference.n_points);
    }
    const unsigned int n = positions.size();
    for (unsigned int q = 0; q < reference.n_points; ++q)
    {
      Tensor<1, 3> X, X_x, X_y;
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int d = 0; d < 3; ++d)
        {
          X[d] += reference.values[q * n + k] * positions[k][d];
          X_x[d] += reference.x_derivatives[q * n + k] * positions[k][d];
          X_y[d] += reference.y_derivatives[q * n + k] * positions[k][d];
        }
      const Tensor<1, 3> N = reference.weights[q] * cross_product_3d(X_x, X_y);
      for (unsigned int d = 0; d < 3; ++d)
      {
        points[d][q] = X[d];
        areas[d][q]  = N[d];
      }
    }
  }

  void CellRule::compute_ball()
  {
    // Gauss's points stay off the corners by a tenth of the size.
    const double       enlarged = 1.2;
    const unsigned int n        = reference->n_points;
    for (unsigned int q = 0; q < n; ++q)
      for (unsigned int d = 0; d < 3; ++d)
        centre[d] += points[d][q] / n;
    for (unsigned int q = 0; q < n; ++q)
      radius = std::max(
          radius, enlarged * centre.distance(Point<3>(points[0][q], points[1][q], points[2][q])));
  }
} // namespace caudal::potential
