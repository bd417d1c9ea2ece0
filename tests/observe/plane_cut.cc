// SPDX-License-Identifier: LGPL-2.1-or-later
// Cuts through a unit square and a unit cube: their number of pieces, and their size, whole and as
// the sum over the parts of the box, among which a plane on sides of parts is counted once.

#include <caudal/observe/plane_cut.h>

#include <iomanip>
#include <iostream>

using namespace caudal;

namespace
{
  double get_size(const PlanePiece<2> &line)
  {
    return line[0].distance(line[1]);
  }

  /** The two triangles of a quadrilateral, the corners 0, 1, 3 and 0, 3, 2. */
  double get_size(const PlanePiece<3> &piece)
  {
    return 0.5 * cross_product_3d(piece[1] - piece[0], piece[3] - piece[0]).norm() +
           0.5 * cross_product_3d(piece[3] - piece[0], piece[2] - piece[0]).norm();
  }

  template <int dim>
  void print(const std::string &what, const Point<dim> &point, const Tensor<1, dim> &normal)
  {
    const Plane<dim> plane{point, normal / normal.norm()};
    std::cout << dim << "D, " << what << ":";
    for (const int n : {1, 2, 3})
    {
      Tensor<1, dim> size;
      for (unsigned int d = 0; d < dim; ++d)
        size[d] = 1. / n;
      double   sum      = 0;
      unsigned n_pieces = 0;
      for (int k = 0; k < std::pow(n, dim); ++k)
      {
        const Point<3> lower(k % n * size[0], k / n % n * size[0], k / n / n * size[0]);
        Point<dim>     corner;
        for (unsigned int d = 0; d < dim; ++d)
          corner[d] = lower[d];
        for (const auto &piece : cut_box(plane, corner, size))
        {
          sum += get_size(piece);
          ++n_pieces;
        }
      }
      std::cout << "  " << n_pieces << " of size " << sum;
    }
    std::cout << '\n';
  }
} // namespace

int main()
{
  std::cout << std::fixed << std::setprecision(6);
  print<2>("x = 0.4", {0.4, 0}, Tensor<1, 2>({1, 0}));
  print<2>("x = 0.5", {0.5, 0}, Tensor<1, 2>({-2, 0}));
  print<2>("diagonal", {0, 0}, Tensor<1, 2>({1, -1}));
  print<2>("x + 2 y = 1", {1, 0}, Tensor<1, 2>({1, 2}));
  print<2>("off", {1.1, 0}, Tensor<1, 2>({1, 0}));
  print<3>("z = 0.4", {0, 0, 0.4}, Tensor<1, 3>({0, 0, 1}));
  print<3>("z = 0.5", {0, 0, 0.5}, Tensor<1, 3>({0, 0, -1}));
  print<3>("y = 1", {0, 1, 0}, Tensor<1, 3>({0, 1, 0}));
  print<3>("x = y", {0, 0, 0}, Tensor<1, 3>({1, -1, 0}));
  print<3>("x + y + z = 1", {1, 0, 0}, Tensor<1, 3>({1, 1, 1}));
  print<3>("x + y + z = 1.5", {0.5, 0.5, 0.5}, Tensor<1, 3>({1, 1, 1}));
  print<3>("x + 2 y + 3 z = 2", {2, 0, 0}, Tensor<1, 3>({1, 2, 3}));
  print<3>("at a corner", {0, 0, 0}, Tensor<1, 3>({1, 1, 1}));
}
