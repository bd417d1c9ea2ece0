#ifndef caudal_potential_surface_quadrature_h
#define caudal_potential_surface_quadrature_h

#include <caudal/potential/surface.h>

#include <deal.II/base/quadrature.h>

#include <array>
#include <memory>
#include <vector>

namespace caudal::potential
{
  /** Shape functions and weights at the points of a quadrature rule on the unit square. */
  struct ReferenceRule
  {
    ReferenceRule(const Quadrature<2> &quadrature, const FiniteElement<2, 3> &fe);

    unsigned int        n_points;
    std::vector<double> weights;
    std::vector<double> values;        ///< by point, then shape function
    std::vector<double> x_derivatives; ///< along the first reference coordinate
    std::vector<double> y_derivatives; ///< along the second one
  };

  /** The rules that integrate kernels over a cell, whatever the distance of the point x. */
  class ReferenceRules
  {
  public:
    explicit ReferenceRules(const FiniteElement<2, 3> &fe);

    /** Gauss's rule on the whole cell, for points far from it and for smooth functions. */
    const ReferenceRule &get_regular() const
    {
      return *regular;
    }

    /**
     * For kernels that are singular at the node with this number: triangles with
     * a corner there, in coordinates that cancel the singularity (M. G. Duffy, SIAM
     * J. Numer. Anal. 19, 1982, doi:10.1137/0719090).
     */
    const ReferenceRule &get_singular(const unsigned int node) const
    {
      return *singular[node];
    }

    /** Gauss's rule on the square (i, j) of the 4^level equal parts of the cell. */
    const ReferenceRule &get_part(unsigned int level, unsigned int i, unsigned int j);

    /** The index of such a part among those of all levels. */
    static unsigned int get_index(const unsigned int level, const unsigned int i,
                                  const unsigned int j)
    {
      return ((1u << (2 * level)) - 1) / 3 + (j << level) + i;
    }

    static constexpr unsigned int finest_level = 6;

  private:
    const FiniteElement<2, 3>                  &fe;
    std::unique_ptr<ReferenceRule>              regular;
    std::vector<std::unique_ptr<ReferenceRule>> singular;
    std::vector<std::unique_ptr<ReferenceRule>> parts;
  };

  /** A rule on a cell in space: points and elements of area N = n dS times the weight. */
  struct CellRule
  {
    /** @p positions are those of the cell's nodes. */
    CellRule(const ReferenceRule &reference, const std::vector<Point<3>> &positions);

    /** The points' mean and the distance of the farthest of them from it, enlarged. */
    void compute_ball();

    const ReferenceRule               *reference;
    std::array<std::vector<double>, 3> points; ///< [m]
    std::array<std::vector<double>, 3> areas;  ///< [m^2]
    Point<3>                           centre;
    double                             radius = 0.;
  };
} // namespace caudal::potential

#endif
