#ifndef caudal_coupling_line_weights_h
#define caudal_coupling_line_weights_h

#include <caudal/coupling/kernel.h>

#include <array>
#include <vector>

namespace caudal
{
  /**
   * The one-dimensional factors of a point's interaction with the cells around
   * it. With x the point's position in cells, phi the kernel and h the lattice
   * spacing, half a cell: for the quadratic Lagrange polynomials N_i of each cell
   *   int_cell delta_h(xi - x) N_i(xi) dxi.
   *
   * The integrals are exact to round-off, cell by cell. Then the
   * interpolated velocity is the convolution W = delta_h * u, whose divergence
   * delta_h * div u vanishes with that of u. Sums over the lattice of midpoints,
   * as in finite differences, have the kernel's discrete moment conditions too, but
   * make the volume of a bent body err twice as much.
   */
  struct LineWeights
  {
    int                                first_cell = 0;
    std::vector<std::array<double, 3>> cells;  // moments with the three polynomials
    std::vector<double>                totals; // integrals of the kernel alone

    /** @p x is the position in cells; @p kernel is null for the Dirac distribution. */
    LineWeights(double x, const DeltaKernel *kernel);
  };
} // namespace caudal

#endif
