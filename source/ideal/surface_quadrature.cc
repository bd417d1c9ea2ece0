// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/ideal/surface_quadrature.h>

#include <deal.II/base/quadrature_lib.h>

namespace caudal::ideal
{
  namespace
  {
    // Points in each direction.
    const unsigned int n_gauss_points[ReferenceRules::n_gauss] = {3, 4, 5, 6};
    const unsigned int n_radial                                = 5;
    const unsigned int n_angular                               = 14;

    /** The rule of the unit square on a part of it. */
    Quadrature<2> restrict_to_part(const Quadrature<2> &on_square, const CellPart &part)
    {
      std::vector<Point<2>> points  = on_square.get_points();
      std::vector<double>   weights = on_square.get_weights();
      for (unsigned int d = 0; d < 2; ++d)
      {
        const double size = 1. / (1u << part.levels[d]);
        for (unsigned int q = 0; q < points.size(); ++q)
        {
          points[q][d] = size * (points[q][d] + part.indices[d]);
          weights[q] *= size;
        }
      }
      return Quadrature<2>(points, weights);
    }
  } // namespace

  ReferenceRule::ReferenceRule(const Quadrature<2> &quadrature, const FiniteElement<2, 3> &fe)
      : weights(quadrature.get_weights())
  {
    AssertIndexRange(size(), n_most_points + 1);
    for (unsigned int f = 0; f < 3; ++f)
    {
      by_node[f].resize(Surface::n_nodes_per_cell * size());
      by_point[f].resize(size());
    }
    for (unsigned int q = 0; q < size(); ++q)
      for (unsigned int k = 0; k < Surface::n_nodes_per_cell; ++k)
      {
        const Tensor<1, 2> gradient  = fe.shape_grad(k, quadrature.point(q));
        by_point[value][q][k]        = fe.shape_value(k, quadrature.point(q));
        by_point[x_derivative][q][k] = gradient[0];
        by_point[y_derivative][q][k] = gradient[1];
        for (unsigned int f = 0; f < 3; ++f)
          by_node[f][k * size() + q] = by_point[f][q][k];
      }
  }

  CAUDAL_WIDE_VECTORS
  void ReferenceRule::interpolate(const Function f, const CellArray<double> &nodal,
                                  double *const at_points) const
  {
    const std::size_t   n         = size();
    const double *const functions = by_node[f].data();
#pragma omp simd
    for (std::size_t q = 0; q < n; ++q)
    {
      double sum = 0.;
#pragma GCC unroll 9
      for (std::size_t k = 0; k < Surface::n_nodes_per_cell; ++k)
        sum += functions[k * n + q] * nodal[k];
      at_points[q] = sum;
    }
  }

  CAUDAL_WIDE_VECTORS
  void ReferenceRule::add_sums(const Function f, const Numbers &at_points,
                               CellArray<double> &nodal) const
  {
    CellArray<double> sums = nodal;
    for (unsigned int q = 0; q < size(); ++q)
    {
      const CellArray<double> &functions = by_point[f][q];
#pragma GCC unroll 9
      for (unsigned int k = 0; k < Surface::n_nodes_per_cell; ++k)
        sums[k] += functions[k] * at_points[q];
    }
    nodal = sums;
  }

  PlacedRule::PlacedRule(const ReferenceRule &rule, const CellArray<Point<3>> &nodes)
      : reference(&rule)
      , data(6 * rule.size())
  {
    const unsigned int     n = size();
    ReferenceRule::Vectors points, along_x, along_y;
    rule.interpolate(ReferenceRule::value, nodes, points);
    rule.interpolate(ReferenceRule::x_derivative, nodes, along_x);
    rule.interpolate(ReferenceRule::y_derivative, nodes, along_y);
    for (unsigned int d = 0; d < 3; ++d)
    {
      const unsigned int e = (d + 1) % 3, f = (d + 2) % 3;
      double *const y = data.data() + d * n, *const N = data.data() + (3 + d) * n;
#pragma omp simd
      for (unsigned int q = 0; q < n; ++q)
      {
        y[q] = points[d][q];
        N[q] =
            rule.get_weights()[q] * (along_x[e][q] * along_y[f][q] - along_x[f][q] * along_y[e][q]);
      }
    }
  }

  ReferenceRule::Numbers PlacedRule::compute_fluxes(const ReferenceRule::Vectors &u) const
  {
    ReferenceRule::Numbers fluxes;
    for (unsigned int q = 0; q < size(); ++q)
      fluxes[q] = u[0][q] * get_areas(0)[q] + u[1][q] * get_areas(1)[q] + u[2][q] * get_areas(2)[q];
    return fluxes;
  }

  CellPart CellPart::get_half(const unsigned int direction, const unsigned int half) const
  {
    CellPart part = *this;
    ++part.levels[direction];
    part.indices[direction] = 2 * indices[direction] + half;
    return part;
  }

  ReferenceRules::ReferenceRules(const FiniteElement<2, 3> &fe)
      : fe(fe)
  {
    for (const unsigned int n : n_gauss_points)
      on_square.emplace_back(QGauss<2>(n));
    const QDuffy on_triangle{QGauss<1>(n_radial), QGauss<1>(n_angular)};
    for (const Point<2> &node : fe.get_unit_support_points())
      on_square.emplace_back(QSplit<2>(on_triangle, node));
    on_square.emplace_back(QIterated<2>(QTrapezoid<1>(), 2));
  }

  const ReferenceRule &ReferenceRules::get(const unsigned int kind, const CellPart &part)
  {
    const auto known = rules.find({kind, part});
    if (known != rules.end())
      return known->second;
    return rules.insert({{kind, part}, ReferenceRule(restrict_to_part(on_square[kind], part), fe)})
        .first->second;
  }
} // namespace caudal::ideal
