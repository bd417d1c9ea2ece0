// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/linear/conjugate_residuals.h>
#include <caudal/linear/near_system.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/block_vector.h>

#include <algorithm>

using namespace dealii;

namespace caudal
{
  namespace
  {
    /**
     * Conjugate residuals for y end at this part of the residual: one does where the elements of
     * the bodies are as large as the cells of the fluid; where they are smaller, soft motions that
     * the fluid can't follow take more.
     */
    constexpr double       inner_tolerance       = 0.3;
    constexpr unsigned int most_inner_iterations = 8;

    /** target[begin + i] += factor sum_j A_ij source[source_begin + j] */
    void add_product(const double factor, const Triplets &A, const Vector<double> &source,
                     const unsigned int source_begin, Vector<double> &target,
                     const unsigned int begin)
    {
      for (std::size_t k = 0; k < A.values.size(); ++k)
        target[begin + A.rows[k]] += factor * A.values[k] * source[source_begin + A.columns[k]];
    }
  } // namespace

  NearSystem::NearSystem(const unsigned int largest_complete)
      : largest_complete(largest_complete)
      , rest(MPI_COMM_SELF)
  {}

  void NearSystem::factorize(const unsigned int new_n_q, const unsigned int n_x,
                             const std::vector<BodyPlaces> &bodies, const double new_s, Triplets J,
                             const Triplets &E)
  {
    s           = new_s;
    n_q         = new_n_q;
    is_complete = n_q + n_x <= largest_complete;
    if (is_complete)
    {
      factorize_completely(n_x, bodies, J, E);
      return;
    }
    divide(bodies, n_x, E);
    bound_rates(bodies);
    collect_coupling();
    for (std::size_t k = 0; k < J.values.size(); ++k)
      for (int *index : {&J.rows[k], &J.columns[k]})
        if (*index >= static_cast<int>(n_q))
          *index = n_q + place[*index - n_q];
    // M/e, M being what couples the balance of a node with the forces of another.
    for (std::size_t k = 0; k < E_yf.values.size(); ++k)
      if (E_yf.rows[k] < static_cast<int>(n_f))
        J.add(n_q + E_yf.rows[k], n_q + E_yf.columns[k],
              E_yf.values[k] *
                  std::sqrt(inverse_rate[E_yf.rows[k]] * inverse_rate[E_yf.columns[k]]));
    AssertThrow(
        forces.factorize(n_q + n_f, J),
        ExcMessage("The matrix of the forces of the bodies is not positive definite. Choose "
                   "Solver/Method = direct."));
    factorize_rest(bodies);
  }

  void NearSystem::factorize_by_groups(const std::vector<int> &groups, const MatrixParts &matrix)
  {
    pivoted = !rest.factorize(groups, matrix);
    if (pivoted)
      rest.factorize_with_pivoting(groups.back(), matrix);
  }

  void NearSystem::factorize_completely(const unsigned int             n_x,
                                        const std::vector<BodyPlaces> &bodies, const Triplets &J,
                                        const Triplets &E)
  {
    MatrixParts matrix;
    for (std::size_t k = 0; k < J.values.size(); ++k)
      if (const int row = J.rows[k], column = J.columns[k]; row >= column)
      {
        matrix.entries.add(row, column, -s * J.values[k]);
        if (row != column)
          matrix.entries.add(column, row, -s * J.values[k]);
      }
    for (std::size_t k = 0; k < E.values.size(); ++k)
      matrix.entries.add(n_q + E.rows[k], n_q + E.columns[k], E.values[k]);
    // Force and velocity of a node together offer pivots in the mass.
    std::vector<bool> begins(n_x, true);
    for (const BodyPlaces &body : bodies)
      for (unsigned int i = 0; i < body.force.size(); ++i)
      {
        begins[body.force[i]]    = false;
        begins[body.velocity[i]] = i % body.n_components == 0;
      }
    std::vector<int> groups;
    for (unsigned int i = 0; i < n_q + n_x; ++i)
      if (i < n_q || begins[i - n_q])
        groups.push_back(i);
    groups.push_back(n_q + n_x);
    factorize_by_groups(groups, matrix);
  }

  void NearSystem::divide(const std::vector<BodyPlaces> &bodies, const unsigned int n_x,
                          const Triplets &E)
  {
    place.assign(n_x, -1);
    rest_groups.clear();
    n_f = 0;
    for (const BodyPlaces &body : bodies)
      for (const int f : body.force)
        place[f] = n_f++;
    n_y = 0;
    for (const BodyPlaces &body : bodies)
      for (const int velocity : body.velocity)
      {
        if (n_y % body.n_components == 0)
          rest_groups.push_back(n_y);
        place[velocity] = n_f + n_y++;
      }
    for (unsigned int x = 0; x < n_x; ++x)
      if (place[x] < 0)
      {
        if (x == 0 || place[x - 1] + 1 != static_cast<int>(n_f + n_y))
          rest_groups.push_back(n_y);
        place[x] = n_f + n_y++;
      }
    rest_groups.push_back(n_y);

    E_fy = E_yf = E_yy = Triplets();
    const int begin    = n_f;
    for (std::size_t k = 0; k < E.values.size(); ++k)
    {
      const int  row = place[E.rows[k]], column = place[E.columns[k]];
      const bool is_force_row = row < begin, is_force_column = column < begin;
      Assert(!is_force_row || !is_force_column, ExcNotImplemented());
      if (is_force_row)
        E_fy.add(row, column - begin, E.values[k]);
      else if (is_force_column)
        E_yf.add(row - begin, column, E.values[k]);
      else
        E_yy.add(row - begin, column - begin, E.values[k]);
    }
  }

  void NearSystem::bound_rates(const std::vector<BodyPlaces> &bodies)
  {
    Vector<double> rate(n_f), mass(n_f);
    for (std::size_t k = 0; k < E_yy.values.size(); ++k)
      if (E_yy.rows[k] == E_yy.columns[k] && E_yy.rows[k] < static_cast<int>(n_f))
        rate[E_yy.rows[k]] += E_yy.values[k];
    for (std::size_t k = 0; k < E_yf.values.size(); ++k)
      if (E_yf.rows[k] == E_yf.columns[k])
        mass[E_yf.rows[k]] += E_yf.values[k];
    inverse_rate.clear();
    for (const BodyPlaces &body : bodies)
      for (const std::size_t end = inverse_rate.size() + body.force.size();
           inverse_rate.size() < end;)
      {
        double bound = s; // where nothing else resists, the inertia of the fluid does
        for (unsigned int i = inverse_rate.size(), d = 0; d < body.n_components; ++d, ++i)
          bound = std::max(bound, rate[i] / mass[i]);
        inverse_rate.insert(inverse_rate.end(), body.n_components, 1 / bound);
      }
  }

  void NearSystem::collect_coupling()
  {
    K = E_fy;
    for (std::size_t k = 0; k < E_yy.values.size(); ++k)
      if (const int row = E_yy.rows[k]; row < static_cast<int>(n_f))
        K.add(row, E_yy.columns[k], -s * inverse_rate[row] * E_yy.values[k]);
  }

  std::vector<double> NearSystem::estimate_inertia(const std::vector<BodyPlaces> &bodies) const
  {
    const unsigned int  dim = bodies.empty() ? 0 : bodies.front().n_components;
    std::vector<double> products(bodies.size()), norms(bodies.size());
    for (unsigned int d = 0; d < dim; ++d)
    {
      Vector<double> translation(n_f), momentum(n_y), response(n_q + n_f);
      for (unsigned int i = d; i < n_f; i += dim)
        translation[i] = 1;
      add_product(1, E_yf, translation, 0, momentum, 0);
      std::copy_n(momentum.begin(), n_f, response.begin() + n_q);
      forces.solve(response);
      unsigned int i = 0;
      for (unsigned int b = 0; b < bodies.size(); ++b)
        for (const unsigned int end = i + bodies[b].force.size(); i < end; ++i)
        {
          products[b] += momentum[i] * response[n_q + i];
          norms[b] += momentum[i] * translation[i];
        }
    }
    for (unsigned int b = 0; b < bodies.size(); ++b)
      products[b] /= norms[b];
    return products;
  }

  void NearSystem::factorize_rest(const std::vector<BodyPlaces> &bodies)
  {
    const std::vector<double> of_bodies = estimate_inertia(bodies);
    std::vector<double>       inertia;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      inertia.resize(inertia.size() + bodies[b].force.size(), of_bodies[b]);
    MatrixParts matrix;
    matrix.entries = E_yy;
    for (std::size_t k = 0; k < E_yy.values.size(); ++k)
      if (const int row = E_yy.rows[k]; row < static_cast<int>(n_f))
        matrix.entries.values[k] *= 1 - inertia[row] * inverse_rate[row];
    for (std::size_t k = 0; k < E_fy.values.size(); ++k)
      matrix.entries.add(E_fy.rows[k], E_fy.columns[k], inertia[E_fy.rows[k]] / s * E_fy.values[k]);
    factorize_by_groups(rest_groups, matrix);
  }

  /** The Schur complement for y: block 0 of a vector has y, block 1 the response (q, f) to it. */
  class NearSystem::RestComplement
  {
  public:
    explicit RestComplement(const NearSystem &system)
        : system(system)
    {}

    void vmult(BlockVector<double> &result, const BlockVector<double> &source) const
    {
      result = 0;
      add_product(1, system.E_yy, source.block(0), 0, result.block(0), 0);
      add_product(1, system.E_yf, source.block(1), system.n_q, result.block(0), 0);
    }

  private:
    const NearSystem &system;
  };

  /** Its approximate inverse, with the exact response. */
  class NearSystem::RestPreconditioner
  {
  public:
    explicit RestPreconditioner(const NearSystem &system)
        : system(system)
    {}

    void vmult(BlockVector<double> &result, const BlockVector<double> &source) const
    {
      result.block(0) = source.block(0);
      system.solve_rest(result.block(0));
      result.block(1) = 0;
      add_product(1 / system.s, system.K, result.block(0), 0, result.block(1), system.n_q);
      system.forces.solve(result.block(1));
    }

  private:
    const NearSystem &system;
  };

  void NearSystem::solve_rest(Vector<double> &values) const
  {
    LinearAlgebra::distributed::BlockVector<double> vector(1);
    vector.block(0).reinit(values.size());
    vector.collect_sizes();
    std::copy(values.begin(), values.end(), vector.block(0).begin());
    rest.solve(vector);
    std::copy(vector.block(0).begin(), vector.block(0).end(), values.begin());
  }

  void NearSystem::solve(Vector<double> &values) const
  {
    if (is_complete)
    {
      solve_rest(values);
      return;
    }
    const auto is_force = [&](const unsigned int x) { return place[x] < static_cast<int>(n_f); };
    BlockVector<double> rhs, correction;
    rhs.reinit(std::vector<types::global_dof_index>{n_y, n_q + n_f});
    correction.reinit(rhs);

    Vector<double> q_and_f(n_q + n_f);
    std::copy_n(values.begin(), n_q, q_and_f.begin());
    for (unsigned int x = 0; x < place.size(); ++x)
      (is_force(x) ? q_and_f[n_q + place[x]] : rhs.block(0)[place[x] - n_f]) = values[n_q + x];
    for (unsigned int i = 0; i < n_f; ++i)
      q_and_f[n_q + i] -= s * inverse_rate[i] * rhs.block(0)[i];
    forces.solve(q_and_f);
    q_and_f *= -1 / s;

    add_product(-1, E_yf, q_and_f, n_q, rhs.block(0), 0);
    solve_by_conjugate_residuals(RestComplement(*this), correction, rhs, RestPreconditioner(*this),
                                 inner_tolerance * rhs.l2_norm(), most_inner_iterations);
    q_and_f += correction.block(1);

    std::copy_n(q_and_f.begin(), n_q, values.begin());
    for (unsigned int x = 0; x < place.size(); ++x)
      values[n_q + x] = is_force(x) ? q_and_f[n_q + place[x]] : correction.block(0)[place[x] - n_f];
  }

  double NearSystem::get_factor_entries() const
  {
    return (is_complete ? 0 : forces.get_n_entries()) + rest.get_factor_entries();
  }
} // namespace caudal
