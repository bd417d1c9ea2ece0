// SPDX-License-Identifier: LGPL-2.1-or-later
// The NearSystem of two bodies on a line of fluid nodes, as preconditioner of itself, by the
// factors of all and in parts. With R = e M, as of a gait, the parts are exact; of a frame and of
// elastic bodies they take some iterations, the more, the more motions a body has that the fluid
// has not.

#include <caudal/linear/conjugate_residuals.h>
#include <caudal/linear/near_system.h>

#include <deal.II/lac/full_matrix.h>

#include <cmath>
#include <iostream>

using namespace caudal;
using namespace dealii;

namespace
{
  constexpr unsigned int n_nodes = 12, n_bodies = 2, n_u = 2 * n_nodes + 8;
  constexpr double       s = 3;

  struct Case
  {
    unsigned int            n_q = 0, n_x = 0;
    std::vector<BodyPlaces> bodies;
    Triplets                J, E;
  };

  /** Nodes of a body lie at 1/4 and 3/4 between nodes of the fluid; q: divergences between them. */
  Case make_case(const double rate, const double stiffness, const bool has_frame)
  {
    Case               result;
    FullMatrix<double> B(n_bodies * (n_nodes / 2), n_u), G(n_bodies * n_nodes, n_u);
    result.n_q = B.m();
    result.n_x = 2 * G.m() + (has_frame ? 1 : 0);
    for (unsigned int body = 0; body < n_bodies; ++body)
    {
      BodyPlaces         places{1, {}, {}};
      const unsigned int first_u = 2 + body * (n_nodes + 2);
      for (unsigned int i = 0; i < n_nodes; ++i)
      {
        const unsigned int row = body * n_nodes + i, u = first_u + i / 2;
        G(row, u)     = i % 2 == 0 ? 0.75 : 0.25;
        G(row, u + 1) = 1 - G(row, u);
        if (i % 2 == 0)
        {
          B(row / 2, u)     = -1;
          B(row / 2, u + 1) = 1;
        }
        const int velocity = 2 * row, force = velocity + 1;
        places.velocity.push_back(velocity);
        places.force.push_back(force);
        for (unsigned int j = std::max(1u, i) - 1; j < std::min(n_nodes, i + 2); ++j)
        {
          const double mass = i == j ? 4. / 6 : 1. / 6, spring = i == j ? 2 : -1;
          const int    other = velocity + 2 * (static_cast<int>(j) - static_cast<int>(i));
          result.E.add(force, other, s * mass);
          result.E.add(velocity, other + 1, mass);
          result.E.add(velocity, other, rate * mass + stiffness * spring);
          if (has_frame)
          {
            result.E.add(velocity, result.n_x - 1, -rate * mass);
            result.E.add(result.n_x - 1, other, s * mass);
            result.E.add(result.n_x - 1, result.n_x - 1, -s * mass);
          }
        }
      }
      result.bodies.push_back(places);
    }
    // The multipliers are numbered first, then forces by their places.
    FullMatrix<double> all(result.n_q + result.n_x, n_u);
    for (unsigned int u = 0; u < n_u; ++u)
    {
      for (unsigned int q = 0; q < B.m(); ++q)
        all(q, u) = B(q, u);
      for (unsigned int f = 0; f < G.m(); ++f)
        all(result.n_q + 2 * f + 1, u) = -G(f, u);
    }
    for (unsigned int i = 0; i < all.m(); ++i)
      for (unsigned int j = 0; j <= i; ++j)
      {
        double sum = 0;
        for (unsigned int u = 0; u < n_u; ++u)
          sum += all(i, u) * all(j, u) / (2 + std::cos(u));
        if (sum != 0)
          result.J.add(i, j, sum);
      }
    return result;
  }

  class SaddlePoint
  {
  public:
    explicit SaddlePoint(const Case &problem)
        : problem(problem)
    {}

    void vmult(Vector<double> &result, const Vector<double> &source) const
    {
      const auto &[n_q, n_x, bodies, J, E] = problem;
      result                               = 0;
      for (std::size_t k = 0; k < J.values.size(); ++k)
      {
        result[J.rows[k]] -= s * J.values[k] * source[J.columns[k]];
        if (J.rows[k] != J.columns[k])
          result[J.columns[k]] -= s * J.values[k] * source[J.rows[k]];
      }
      for (std::size_t k = 0; k < E.values.size(); ++k)
        result[n_q + E.rows[k]] += E.values[k] * source[n_q + E.columns[k]];
    }

  private:
    const Case &problem;
  };

  class Preconditioner
  {
  public:
    explicit Preconditioner(const NearSystem &system)
        : system(system)
    {}

    void vmult(Vector<double> &result, const Vector<double> &source) const
    {
      result = source;
      system.solve(result);
    }

  private:
    const NearSystem &system;
  };

  void test(const std::string &name, const Case &problem)
  {
    std::cout << name << ':';
    Vector<double> rhs(problem.n_q + problem.n_x), solution(rhs.size());
    for (unsigned int i = 0; i < rhs.size(); ++i)
      rhs[i] = std::sin(1. + i * i);
    for (const unsigned int largest_complete : {1000, 0})
    {
      NearSystem system(largest_complete);
      system.factorize(problem.n_q, problem.n_x, problem.bodies, s, problem.J, problem.E);
      const IterationResult result = solve_by_conjugate_residuals(
          SaddlePoint(problem), solution, rhs, Preconditioner(system), 1e-9, 30);
      std::cout << (largest_complete > 0 ? " all factors " : ", in parts ") << result.n_iterations
                << (result.converged ? " iterations" : " iterations are not enough")
                << (system.has_pivoted() ? " (pivots of all rows)" : "");
    }
    std::cout << '\n';
  }
} // namespace

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test("a rate of 50", make_case(50, 0, false));
  test("a rate of 50 about a frame", make_case(50, 0, true));
  test("elastic", make_case(0, 200, false));
  test("elastic, held", make_case(5, 200, false));
  test("without any resistance", make_case(0, 0, false));
}
