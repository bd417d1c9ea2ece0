// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_coupling_line_weights_h
#define caudal_coupling_line_weights_h

#include <caudal/coupling/kernel.h>

#include <array>
#include <vector>

namespace caudal
{
  /**
   * The one-dimensional factors of a point's interaction with the cells around
   * it. With x the point's position in cells, delta_h the kernel, whose lattice
   * spacing h is half a cell, and N_i the quadratic Lagrange polynomials of each
   * cell:
   *   int_cell delta_h(xi - x) N_i(xi) dxi.
   */
  struct LineWeights
  {
    int                                first_cell = 0;
    std::vector<std::array<double, 3>> cells;

    /** The integral of the kernel alone over a cell, since the N_i add up to one. */
    double get_total(const unsigned int cell) const
    {
      return cells[cell][0] + cells[cell][1] + cells[cell][2];
    }
  };

  /**
   * The weights by numerical integration between the knots of the kernel and the
   * sides of cells, exact to round-off. Then the interpolated velocity is the
   * convolution W = delta_h * u, whose divergence delta_h * div u vanishes with
   * that of u, if all components share the kernel. Sums over the lattice of midpoints, as in finite
   * differences, have the kernel's discrete moment conditions too, but make the volume of a bent
   * body err twice as much.
   */
  LineWeights integrate_line_weights(double x, const DeltaKernel &kernel);

  /**
   * The line weights of a kernel at the price of a polynomial. Where a point lies in its cell
   * decides on the weights, and within each quarter of the cell they are analytic: they are
   * interpolated there in Chebyshev's points of the first kind, by the barycentric formula (Berrut
   * & Trefethen 2004, doi:10.1137/S0036144502417715).
   */
  class LineTable
  {
  public:
    explicit LineTable(const DeltaKernel &kernel);

    /** The weights for the position @p x in cells. */
    LineWeights evaluate(double x) const;

  private:
    static constexpr unsigned int n_quarters = 4, n_nodes = 32;

    std::array<double, n_nodes> nodes, node_weights; // in a quarter, from 0 to 1
    /** At the nodes of each quarter of the cell 0; empty for a kernel of radius 0. */
    std::array<std::vector<LineWeights>, n_quarters> values;
  };
} // namespace caudal

#endif
