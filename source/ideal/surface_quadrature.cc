#include <caudal/ideal/surface_quadrature.h>

#include <deal.II/base/quadrature_lib.h>

namespace caudal::ideal
{
  namespace
  {
    // Points in each direction.
    const unsigned int n_gauss[ReferenceRules::n_gauss_rules] = {3, 4, 5, 6};
    const unsigned int n_radial                               = 5;
    const unsigned int n_angular                              = 14;

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
      , values(n_points * stride, 0.)
      , x_derivatives(n_points * stride, 0.)
      , y_derivatives(n_points * stride, 0.)
  {
    for (unsigned int q = 0; q < n_points; ++q)
      for (unsigned int k = 0; k < fe.n_dofs_per_cell(); ++k)
      {
        const Tensor<1, 2> gradient   = fe.shape_grad(k, quadrature.point(q));
        values[q * stride + k]        = fe.shape_value(k, quadrature.point(q));
        x_derivatives[q * stride + k] = gradient[0];
        y_derivatives[q * stride + k] = gradient[1];
      }
    const std::vector<double> *const by_point[] = {&values, &x_derivatives, &y_derivatives};
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int k = 0; k < fe.n_dofs_per_cell(); ++k)
        for (unsigned int q = 0; q < n_points; ++q)
          by_function[i].push_back((*by_point[i])[q * stride + k]);
  }

  ReferenceRules::ReferenceRules(const FiniteElement<2, 3> &fe)
      : fe(fe)
      , gauss_on_square{{QGauss<2>(n_gauss[0]), QGauss<2>(n_gauss[1]), QGauss<2>(n_gauss[2]),
                         QGauss<2>(n_gauss[3])}}
      , outline_of_square(QIterated<2>(QTrapezoid<1>(), 2))
  {
    for (const Point<2> &node : fe.get_unit_support_points())
      singular.emplace_back(make_singular_quadrature(node), fe);
  }

  const ReferenceRule &ReferenceRules::get_rule(Rules &rules, const CellPart &part,
                                                const Quadrature<2> &quadrature)
  {
    const auto known = rules.find(part.get_key());
    if (known != rules.end())
      return known->second;
    std::vector<Point<2>> points;
    std::vector<double>   weights;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      points.push_back(quadrature.point(q));
      weights.push_back(quadrature.weight(q));
      for (unsigned int d = 0; d < 2; ++d)
      {
        const double size = 1. / (1u << part.levels[d]);
        points.back()[d]  = size * (points.back()[d] + part.indices[d]);
        weights.back() *= size;
      }
    }
    return rules.emplace(part.get_key(), ReferenceRule(Quadrature<2>(points, weights), fe))
        .first->second;
  }

  const ReferenceRule &ReferenceRules::get_gauss(const unsigned int rule, const CellPart &part)
  {
    return get_rule(gauss[rule], part, gauss_on_square[rule]);
  }

  const ReferenceRule &ReferenceRules::get_outline(const CellPart &part)
  {
    return get_rule(outlines, part, outline_of_square);
  }
} // namespace caudal::ideal
