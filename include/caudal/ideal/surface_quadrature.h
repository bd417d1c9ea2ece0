// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_surface_quadrature_h
#define caudal_ideal_surface_quadrature_h

#include <caudal/ideal/surface.h>

#include <deal.II/base/quadrature.h>

#include <array>
#include <map>
#include <vector>

namespace caudal::ideal
{
  /** One value for each node of a cell. */
  template <class T>
  using CellArray = std::array<T, Surface::n_nodes_per_cell>;

  /** Shape functions and weights at the points of a quadrature rule on the unit square. */
  struct ReferenceRule
  {
    ReferenceRule(const Quadrature<2> &quadrature, const FiniteElement<2, 3> &fe);

    unsigned int size() const
    {
      return weights.size();
    }

    std::vector<double>                  weights;
    std::vector<CellArray<double>>       values;    ///< by point
    std::vector<CellArray<Tensor<1, 2>>> gradients; ///< by point
  };

  /** A quadrature rule on a cell in space. */
  struct PlacedRule
  {
    PlacedRule(const ReferenceRule &reference, const CellArray<Point<3>> &nodes);

    /** The tangents dy/dxi along both reference coordinates at the point @p q [m]. */
    std::array<Tensor<1, 3>, 2> compute_tangents(const CellArray<Point<3>> &nodes,
                                                 unsigned int               q) const;

    const ReferenceRule      *reference;
    std::vector<Point<3>>     points; ///< y [m]
    std::vector<Tensor<1, 3>> areas;  ///< N = n dS times the weight [m^2]
  };

  /** One of the equal parts of the unit square, 2^levels[d] in the direction d. */
  struct CellPart
  {
    std::array<unsigned int, 2> levels = {{0, 0}}, indices = {{0, 0}};

    /** One of the halves in a direction. */
    CellPart get_half(unsigned int direction, unsigned int half) const;

    bool operator<(const CellPart &other) const
    {
      return std::tie(levels, indices) < std::tie(other.levels, other.indices);
    }
  };

  /** The rules that integrate kernels over a cell, whatever the distance of the point x. */
  class ReferenceRules
  {
  public:
    explicit ReferenceRules(const FiniteElement<2, 3> &fe);

    /** Gauss's rules, with more and more points, are the kinds from 0 on. */
    static constexpr unsigned int n_gauss = 4;

    /**
     * The kind for kernels that are singular at a node of the cell: triangles with a corner
     * there, in coordinates that cancel the singularity (M. G. Duffy, SIAM J. Numer. Anal. 19,
     * 1982, doi:10.1137/0719090).
     */
    static constexpr unsigned int get_singular_kind(const unsigned int node)
    {
      return n_gauss + node;
    }

    /** The kind whose points are corners, middles of the edges and centre (number 4). */
    static constexpr unsigned int outline = n_gauss + Surface::n_nodes_per_cell;

    /** The rule of this kind on a part of the cell. */
    const ReferenceRule &get(unsigned int kind, const CellPart &part);

  private:
    const FiniteElement<2, 3>                                 &fe;
    std::vector<Quadrature<2>>                                 on_square; // by kind
    std::map<std::pair<unsigned int, CellPart>, ReferenceRule> rules;
  };
} // namespace caudal::ideal

#endif
