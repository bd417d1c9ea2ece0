// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_surface_quadrature_h
#define caudal_ideal_surface_quadrature_h

#include <caudal/ideal/surface.h>

#include <deal.II/base/quadrature.h>

#include <array>
#include <map>
#include <vector>

/**
 * Marks functions whose loops gain by vectors of four numbers: they are compiled for processors
 * with and without them, and chosen when the program starts. The results are the same, as no
 * operations are fused.
 */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__linux__)
#define CAUDAL_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define CAUDAL_WIDE_VECTORS
#endif

namespace caudal::ideal
{
  /** One value for each node of a cell. */
  template <class T>
  using CellArray = std::array<T, Surface::n_nodes_per_cell>;

  /** The values at the nodes of a cell, of those at all @p nodes of a surface. */
  template <class Values>
  CellArray<typename Values::value_type>
  extract_cell(const Values &values, const std::vector<types::global_dof_index> &nodes)
  {
    CellArray<typename Values::value_type> result;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      result[k] = values[nodes[k]];
    return result;
  }

  /** Shape functions and weights at the points of a quadrature rule on the unit square. */
  class ReferenceRule
  {
  public:
    ReferenceRule(const Quadrature<2> &quadrature, const FiniteElement<2, 3> &fe);

    /** The largest number of points. */
    static constexpr unsigned int n_most_points = 280;

    /** A number at each point; at the points of smaller rules, the first ones count. */
    using Numbers = std::array<double, n_most_points>;

    /** A vector at each point, one coordinate after the other. */
    using Vectors = std::array<Numbers, 3>;

    /** The shape functions N_k, and their derivatives along both reference coordinates. */
    enum Function
    {
      value,
      x_derivative,
      y_derivative
    };

    unsigned int size() const
    {
      return weights.size();
    }

    const std::vector<double> &get_weights() const
    {
      return weights;
    }

    /** N_k at the point @p q. */
    double get_value(const unsigned int k, const unsigned int q) const
    {
      return by_point[value][q][k];
    }

    /** At all points sum_k f_k nodal[k]: a field, or a derivative of it. */
    void interpolate(Function f, const CellArray<double> &nodal, double *at_points) const;

    template <class Vector>
    void interpolate(Function f, const CellArray<Vector> &nodal, Vectors &at_points) const
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        CellArray<double> coordinate;
        for (unsigned int k = 0; k < nodal.size(); ++k)
          coordinate[k] = nodal[k][d];
        interpolate(f, coordinate, at_points[d].data());
      }
    }

    /** The transposed: adds sum_q f_k(q) at_points[q] to each nodal[k], point by point. */
    void add_sums(Function f, const Numbers &at_points, CellArray<double> &nodal) const;

  private:
    const std::vector<double> weights;

    // Of each function; loops run along what comes last: the points, the nodes.
    std::array<std::vector<double>, 3>            by_node;
    std::array<std::vector<CellArray<double>>, 3> by_point;
  };

  /** A quadrature rule on a cell in space. */
  class PlacedRule
  {
  public:
    PlacedRule(const ReferenceRule &reference, const CellArray<Point<3>> &nodes);

    const ReferenceRule &get_reference() const
    {
      return *reference;
    }

    unsigned int size() const
    {
      return reference->size();
    }

    /** The coordinate @p d of the points y [m]. */
    const double *get_points(const unsigned int d) const
    {
      return data.data() + d * size();
    }

    /** The coordinate @p d of N = n dS times the weight at the points [m^2]. */
    const double *get_areas(const unsigned int d) const
    {
      return data.data() + (3 + d) * size();
    }

    Point<3> get_point(const unsigned int q) const
    {
      return Point<3>(get_points(0)[q], get_points(1)[q], get_points(2)[q]);
    }

    Tensor<1, 3> get_area(const unsigned int q) const
    {
      return Point<3>(get_areas(0)[q], get_areas(1)[q], get_areas(2)[q]);
    }

    /** u.N at the points. */
    ReferenceRule::Numbers compute_fluxes(const ReferenceRule::Vectors &u) const;

  private:
    const ReferenceRule *reference;
    std::vector<double>  data;
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
