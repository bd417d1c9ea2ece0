// SPDX-License-Identifier: LGPL-2.1-or-later
#include "near_factors.h"

#include <caudal/base/collective.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <numeric>

using namespace dealii;

namespace caudal
{
  OwnFactors::OwnFactors()
      : solver(MPI_COMM_SELF)
  {}

  void OwnFactors::factorize(const std::vector<int> &groups, const MatrixParts &matrix)
  {
    pivoted = !solver.factorize(groups, matrix);
    if (pivoted)
      solver.factorize_with_pivoting(groups.back(), matrix);
  }

  void OwnFactors::solve(Vector<double> &values) const
  {
    LinearAlgebra::distributed::BlockVector<double> vector(1);
    vector.block(0).reinit(values.size());
    vector.collect_sizes();
    std::copy(values.begin(), values.end(), vector.block(0).begin());
    solver.solve(vector);
    std::copy(vector.block(0).begin(), vector.block(0).end(), values.begin());
  }

  double OwnFactors::get_n_entries() const
  {
    return solver.get_factor_entries();
  }

  namespace
  {
    MatrixParts collect_all(const Triplets &J, const NearMatrices &matrices)
    {
      MatrixParts all;
      for (std::size_t k = 0; k < J.size(); ++k)
        if (const int row = J.rows[k], column = J.columns[k]; row >= column)
        {
          all.entries.add(row, column, -matrices.s * J.values[k]);
          if (row != column)
            all.entries.add(column, row, -matrices.s * J.values[k]);
        }
      const int   n_q = matrices.n_q;
      const auto &E   = matrices.E;
      for (std::size_t k = 0; k < E.size(); ++k)
        all.entries.add(n_q + E.rows[k], n_q + E.columns[k], E.values[k]);
      return all;
    }

    /** Force and velocity of a node together offer pivots in the mass. */
    std::vector<int> group(const NearMatrices &matrices)
    {
      std::vector<bool> begins(matrices.owned_x.size(), true);
      for (const BodyPlaces &body : matrices.bodies)
        for (unsigned int i = 0; i < body.force.size(); ++i)
        {
          begins[body.force[i]]    = false;
          begins[body.velocity[i]] = i % body.n_components == 0;
        }
      const unsigned int n = matrices.n_q + matrices.owned_x.size();
      std::vector<int>   groups;
      for (unsigned int i = 0; i < n; ++i)
        if (i < matrices.n_q || begins[i - matrices.n_q])
          groups.push_back(i);
      groups.push_back(n);
      return groups;
    }
  } // namespace

  CompleteFactors::CompleteFactors(const NearMatrices &matrices, const MPI_Comm communicator)
  {
    std::vector<types::global_dof_index> own_x;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
    {
      own_q.resize(matrices.n_q);
      std::iota(own_q.begin(), own_q.end(), 0);
      own_x.resize(matrices.owned_x.size());
      std::iota(own_x.begin(), own_x.end(), 0);
    }
    x_window         = Window(matrices.owned_x, own_x, communicator);
    const Triplets J = gather_on_root(matrices.J, communicator);
    run_on_root(communicator,
                [&]() { factors.factorize(group(matrices), collect_all(J, matrices)); });
  }

  void CompleteFactors::solve(Vector<double> &q, FieldVector &x) const
  {
    Vector<double> own_x = x_window.read(x);
    if (own_x.size() > 0) // on rank 0
    {
      Vector<double> all(q.size() + own_x.size());
      std::copy(q.begin(), q.end(), all.begin());
      std::copy(own_x.begin(), own_x.end(), all.begin() + q.size());
      factors.solve(all);
      std::copy_n(all.begin(), q.size(), q.begin());
      std::copy_n(all.begin() + q.size(), own_x.size(), own_x.begin());
    }
    x = 0;
    x_window.add(own_x, x);
  }
} // namespace caudal
