// SPDX-License-Identifier: LGPL-2.1-or-later
// Conjugate residuals: three eigenvalues take three iterations, each with one application of the
// preconditioner; too few are reported; a right hand side of zeros takes none; the limit of a
// singular operator is not taken for a solution.

#include <caudal/linear/conjugate_residuals.h>

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/vector.h>

#include <cmath>
#include <iostream>

using namespace caudal;
using namespace dealii;

namespace
{
  struct CountingPreconditioner
  {
    mutable unsigned int n_applications = 0;

    void vmult(Vector<double> &result, const Vector<double> &source) const
    {
      ++n_applications;
      result = source;
    }
  };

  void solve(const std::string &name, const Vector<double> &eigenvalues, const Vector<double> &b,
             const unsigned int n_most)
  {
    DiagonalMatrix<Vector<double>> A(eigenvalues);
    CountingPreconditioner         preconditioner;
    Vector<double>                 x(b.size()), image(b.size());
    x = 7; // of no effect
    const IterationResult result =
        solve_by_conjugate_residuals(A, x, b, preconditioner, 1e-10, n_most);
    A.vmult(image, x);
    image -= b;
    std::cout << name << ": " << (result.converged ? "converged" : "not converged") << " after "
              << result.n_iterations << " iterations, preconditioner applied "
              << preconditioner.n_applications << " times, residual as reported "
              << (std::abs(image.l2_norm() - result.residual) < 1e-9) << '\n';
  }
} // namespace

int main()
{
  Vector<double> eigenvalues(6), b(6), zero(6);
  for (unsigned int i = 0; i < 6; ++i)
  {
    eigenvalues[i] = i % 3 == 1 ? -2. : 1. + i % 3; // 1, -2, 3: indefinite
    b[i]           = 1 + i;
  }
  solve("three eigenvalues", eigenvalues, b, 10);
  solve("too few iterations", eigenvalues, b, 2);
  solve("nothing to do", eigenvalues, zero, 10);
  eigenvalues[0] = 0;
  solve("singular", eigenvalues, b, 10);
}
