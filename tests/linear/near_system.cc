// SPDX-License-Identifier: LGPL-2.1-or-later
// The NearSystem of two bodies on a line of fluid nodes, as preconditioner of itself, by the
// factors of all and in parts. With R = e M, as of a gait, the parts are exact; of frames and of
// elastic bodies they take some iterations, the more, the more motions a body has that the fluid
// has not. On two ranks, which have a body each, and on three, whose slices cut bodies, the same.

#include <caudal/linear/conjugate_residuals.h>
#include <caudal/linear/near_system.h>

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/full_matrix.h>

#include <cmath>
#include <iostream>
#include <tuple>
#include <utility>

using namespace caudal;
using namespace dealii;

namespace
{
  constexpr unsigned int n_nodes = 12, n_bodies = 2, n_u = 2 * n_nodes + 8;
  constexpr double       s = 3;

  using FieldVector = NearSystem::FieldVector;

  /** Nodes of a body lie at 1/4 and 3/4 between nodes of the fluid; q: divergences between them. */
  NearMatrices make_case(const double rate, const double stiffness, const bool has_frames)
  {
    NearMatrices       result;
    FullMatrix<double> B(n_bodies * (n_nodes / 2), n_u), G(n_bodies * n_nodes, n_u);
    result.n_q = B.m();
    result.s   = s;
    for (unsigned int q = 0; q < result.n_q; ++q)
      result.positions.push_back(q / (n_nodes / 2) * (n_nodes + 2.) + q % (n_nodes / 2) * 2);
    const int first_frame = 2 * G.m(), n_x = first_frame + (has_frames ? n_bodies : 0);
    result.owned_x = Utilities::create_evenly_distributed_partitioning(
        Utilities::MPI::this_mpi_process(MPI_COMM_WORLD),
        Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD), n_x);
    for (unsigned int body = 0; body < n_bodies; ++body)
    {
      BodyPlaces         places{1, {}, {}, {}, {}};
      const int          frame   = first_frame + body;
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
        places.positions.push_back(body * (n_nodes + 2.) + i);
        for (unsigned int j = std::max(1u, i) - 1; j < std::min(n_nodes, i + 2); ++j)
        {
          const double mass = i == j ? 4. / 6 : 1. / 6, spring = i == j ? 2 : -1;
          const int    other = velocity + 2 * (static_cast<int>(j) - static_cast<int>(i));
          result.E.add(force, other, s * mass);
          result.E.add(velocity, other + 1, mass);
          result.E.add(velocity, other, rate * mass + stiffness * spring);
          if (has_frames)
          {
            result.E.add(velocity, frame, -rate * mass);
            result.E.add(frame, other, s * mass);
            result.E.add(frame, frame, -s * mass);
          }
        }
      }
      if (has_frames)
        places.frame.push_back(frame);
      result.bodies.push_back(places);
    }
    // The multipliers are numbered first, then forces by their places.
    FullMatrix<double> all(result.n_q + n_x, n_u);
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

  /** A part of the entries for each rank, without regard to what they are. */
  NearMatrices distribute(NearMatrices matrices)
  {
    const Triplets all = std::exchange(matrices.J, {});
    for (std::size_t k = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD); k < all.size();
         k += Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD))
      matrices.J.add(all.rows[k], all.columns[k], all.values[k]);
    return matrices;
  }

  /** All entries, on all ranks. */
  Vector<double> collect(const FieldVector &source)
  {
    Vector<double> values(source.size());
    for (const auto i : source.locally_owned_elements())
      values[i] = source(i);
    Utilities::MPI::sum(values, MPI_COMM_WORLD, values);
    return values;
  }

  /** The equations; J has all entries. */
  class SaddlePoint
  {
  public:
    explicit SaddlePoint(const NearMatrices &problem)
        : problem(problem)
    {}

    void vmult(FieldVector &result, const FieldVector &source) const
    {
      const auto &[J, E]        = std::tie(problem.J, problem.E);
      const unsigned int   n_q  = problem.n_q;
      const Vector<double> from = collect(source);
      Vector<double>       to(from.size());
      for (std::size_t k = 0; k < J.size(); ++k)
      {
        to[J.rows[k]] -= s * J.values[k] * from[J.columns[k]];
        if (J.rows[k] != J.columns[k])
          to[J.columns[k]] -= s * J.values[k] * from[J.rows[k]];
      }
      for (std::size_t k = 0; k < E.size(); ++k)
        to[n_q + E.rows[k]] += E.values[k] * from[n_q + E.columns[k]];
      for (const auto i : result.locally_owned_elements())
        result(i) = to[i];
    }

  private:
    const NearMatrices &problem;
  };

  class Preconditioner
  {
  public:
    Preconditioner(const NearMatrices &problem, const NearSystem &system)
        : problem(problem)
        , system(system)
    {}

    void vmult(FieldVector &result, const FieldVector &source) const
    {
      const Vector<double>    values = collect(source);
      const std::vector<int> &own_q  = system.get_own_q();
      Vector<double>          q(own_q.size()), all(values.size());
      for (unsigned int k = 0; k < own_q.size(); ++k)
        q[k] = values[own_q[k]];
      FieldVector x(problem.owned_x, MPI_COMM_WORLD);
      for (const auto i : problem.owned_x)
        x(i) = values[problem.n_q + i];
      system.solve(q, x);
      for (unsigned int k = 0; k < own_q.size(); ++k)
        all[own_q[k]] = q[k];
      for (const auto i : problem.owned_x)
        all[problem.n_q + i] = x(i);
      Utilities::MPI::sum(all, MPI_COMM_WORLD, all);
      for (const auto i : result.locally_owned_elements())
        result(i) = all[i];
    }

  private:
    const NearMatrices &problem;
    const NearSystem   &system;
  };

  void test(const std::string &name, const NearMatrices &problem)
  {
    ConditionalOStream out(std::cout, Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0);
    out << name << ':';
    const unsigned int n = problem.n_q + problem.owned_x.size();
    FieldVector        rhs(Utilities::create_evenly_distributed_partitioning(
                               Utilities::MPI::this_mpi_process(MPI_COMM_WORLD),
                               Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD), n),
                           MPI_COMM_WORLD),
        solution(rhs);
    for (const auto i : rhs.locally_owned_elements())
      rhs(i) = std::sin(1. + i * i);
    for (const unsigned int largest_complete : {1000, 0})
    {
      NearSystem system(MPI_COMM_WORLD, largest_complete, /*smallest_slice=*/10);
      system.factorize(distribute(problem));
      const IterationResult result = solve_by_conjugate_residuals(
          SaddlePoint(problem), solution, rhs, Preconditioner(problem, system), 1e-9, 30);
      out << (largest_complete > 0 ? " all factors " : ", in parts ") << result.n_iterations
          << (result.converged ? " iterations" : " iterations are not enough")
          << (system.has_pivoted() ? " (pivots of all rows)" : "");
    }
    out << '\n';
  }
} // namespace

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test("a rate of 50", make_case(50, 0, false));
  test("a rate of 50 about frames", make_case(50, 0, true));
  test("elastic", make_case(0, 200, false));
  test("elastic, held", make_case(5, 200, false));
  test("without any resistance", make_case(0, 0, false));
}
