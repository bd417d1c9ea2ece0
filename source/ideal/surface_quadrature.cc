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
      , values(size())
      , gradients(size())
  {
    for (unsigned int q = 0; q < size(); ++q)
      for (unsigned int k = 0; k < Surface::n_nodes_per_cell; ++k)
      {
        values[q][k]    = fe.shape_value(k, quadrature.point(q));
        gradients[q][k] = fe.shape_grad(k, quadrature.point(q));
      }
  }

  PlacedRule::PlacedRule(const ReferenceRule &rule, const CellArray<Point<3>> &nodes)
      : reference(&rule)
      , points(rule.size())
      , areas(rule.size())
  {
    for (unsigned int q = 0; q < rule.size(); ++q)
    {
      for (unsigned int k = 0; k < nodes.size(); ++k)
        points[q] += rule.values[q][k] * Tensor<1, 3>(nodes[k]);
      const auto [along_x, along_y] = compute_tangents(nodes, q);
      areas[q]                      = rule.weights[q] * cross_product_3d(along_x, along_y);
    }
  }

  std::array<Tensor<1, 3>, 2> PlacedRule::compute_tangents(const CellArray<Point<3>> &nodes,
                                                           const unsigned int         q) const
  {
    std::array<Tensor<1, 3>, 2> tangents;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      for (unsigned int d = 0; d < 2; ++d)
        tangents[d] += reference->gradients[q][k][d] * Tensor<1, 3>(nodes[k]);
    return tangents;
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
