#ifndef caudal_ideal_surface_quadrature_h
#define caudal_ideal_surface_quadrature_h

#include <caudal/ideal/surface.h>

#include <deal.II/base/quadrature.h>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace caudal::ideal
{
  /** Shape functions and weights at the points of a quadrature rule on the unit square. */
  struct ReferenceRule
  {
    ReferenceRule(const Quadrature<2> &quadrature, const FiniteElement<2, 3> &fe);

    /** Doubles from one point's shape functions to the next one's; the last are zeros. */
    static constexpr unsigned int stride = 12;

    unsigned int        n_points;
    std::vector<double> weights;
    std::vector<double> values;        ///< by point, then shape function
    std::vector<double> x_derivatives; ///< along the first reference coordinate
    std::vector<double> y_derivatives; ///< along the second one

    /** The same three, one after the other, by shape function, then point. */
    std::array<std::vector<double>, 3> by_function;
  };

  /** One of the equal parts of the unit square, 2^levels[d] in the direction d. */
  struct CellPart
  {
    std::array<unsigned int, 2> levels = {{0, 0}}, indices = {{0, 0}};

    /** One of the halves in a direction. */
    CellPart get_half(const unsigned int direction, const unsigned int half) const
    {
      CellPart part = *this;
      ++part.levels[direction];
      part.indices[direction] = 2 * indices[direction] + half;
      return part;
    }

    /** A number of its own for each part with levels below 16. */
    std::uint64_t get_key() const
    {
      return ((std::uint64_t(levels[0]) << 4 | levels[1]) << 16 | indices[0]) << 16 | indices[1];
    }
  };

  /** The rules that integrate kernels over a cell, whatever the distance of the point x. */
  class ReferenceRules
  {
  public:
    explicit ReferenceRules(const FiniteElement<2, 3> &fe);

    /**
     * For kernels that are singular at the node with this number: triangles with
     * a corner there, in coordinates that cancel the singularity (M. G. Duffy, SIAM
     * J. Numer. Anal. 19, 1982, doi:10.1137/0719090).
     */
    const ReferenceRule &get_singular(const unsigned int node) const
    {
      return singular[node];
    }

    /** Gauss's rules with more and more points. */
    static constexpr unsigned int n_gauss_rules = 4;

    /** One of them on a part of the cell. */
    const ReferenceRule &get_gauss(unsigned int rule, const CellPart &part);

    /** Corners, middles of the edges and centre (number 4) of a part. */
    const ReferenceRule &get_outline(const CellPart &part);

  private:
    using Rules = std::unordered_map<std::uint64_t, ReferenceRule>; // by CellPart::get_key()

    const ReferenceRule &get_rule(Rules &rules, const CellPart &part,
                                  const Quadrature<2> &quadrature);

    const FiniteElement<2, 3>                     &fe;
    const std::array<Quadrature<2>, n_gauss_rules> gauss_on_square;
    const Quadrature<2>                            outline_of_square;
    std::vector<ReferenceRule>                     singular; // by node
    std::array<Rules, n_gauss_rules>               gauss;
    Rules                                          outlines;
  };

  /** A rule on a cell in space: points and elements of area N = n dS times the weight. */
  class CellRule
  {
  public:
    static constexpr unsigned int n_most_points = 288;

    CellRule() = default;

    /** @p positions are those of the cell's nodes. */
    CellRule(const ReferenceRule &reference, const std::vector<Point<3>> &positions)
    {
      place(reference, positions);
    }

    void place(const ReferenceRule &reference, const std::vector<Point<3>> &positions);

    const ReferenceRule &get_reference() const
    {
      return *reference;
    }

    /** The coordinate @p d of all points [m]. */
    const double *get_points(const unsigned int d) const
    {
      return data.data() + d * reference->n_points;
    }

    /** The component @p d of N of all points [m^2]. */
    const double *get_areas(const unsigned int d) const
    {
      return data.data() + (3 + d) * reference->n_points;
    }

    Point<3> get_point(const unsigned int q) const
    {
      return Point<3>(get_points(0)[q], get_points(1)[q], get_points(2)[q]);
    }

    Tensor<1, 3> get_area(const unsigned int q) const
    {
      return Point<3>(get_areas(0)[q], get_areas(1)[q], get_areas(2)[q]);
    }

  private:
    const ReferenceRule *reference = nullptr;
    std::vector<double>  data;
  };
} // namespace caudal::ideal

#endif
