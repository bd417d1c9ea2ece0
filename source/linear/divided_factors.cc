// SPDX-License-Identifier: LGPL-2.1-or-later
#include "divided_factors.h"

#include <caudal/base/collective.h>
#include <caudal/linear/conjugate_residuals.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

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

    /** target += factor A source, for the entries that this rank has. */
    template <typename Target, typename Source>
    void add_product(const double factor, const Triplets &A, const Source &source, Target &target)
    {
      const auto from = source.begin();
      const auto to   = target.begin();
      for (std::size_t k = 0; k < A.size(); ++k)
        to[A.rows[k]] += factor * A.values[k] * from[A.columns[k]];
    }
  } // namespace

  DividedFactors::DividedFactors(const NearMatrices &matrices, const unsigned int smallest_slice,
                                 const MPI_Comm communicator)
      : communicator(communicator)
      , division(matrices, smallest_slice, communicator)
      , dim(matrices.bodies.front().n_components)
      , s(matrices.s)
      , joint(communicator)
  {
    select_bodies(matrices);
    set_layouts(matrices.owned_x);
    divide(matrices.E);
    bound_rates();
    collect_coupling();
    const bool is_definite =
        joint.factorize(division.owned, collect_joint(matrices), division.is_force);
    AssertThrow(
        is_definite,
        ExcMessage("The matrix of the forces of the bodies is not positive definite. Choose "
                   "Solver/Method = direct."));
    factorize_rest();
  }

  void DividedFactors::select_bodies(const NearMatrices &matrices)
  {
    place.assign(matrices.owned_x.size(), -1);
    for (const unsigned int b : division.own_bodies)
    {
      bodies.push_back(matrices.bodies[b]);
      for (const int i : bodies.back().force)
      {
        place[i] = f.size();
        f.push_back(i);
      }
    }
    const auto append = [&](const int i, const bool begins) {
      if (begins)
        groups.push_back(y.size());
      place[i] = f.size() + y.size();
      y.push_back(i);
    };
    for (const BodyPlaces &body : bodies)
      for (unsigned int i = 0; i < body.velocity.size(); ++i)
        append(body.velocity[i], i % body.n_components == 0);
    for (const BodyPlaces &body : bodies)
      for (unsigned int i = 0; i < body.frame.size(); ++i)
        append(body.frame[i], i == 0);
    groups.push_back(y.size());
  }

  void DividedFactors::set_layouts(const IndexSet &owned_x)
  {
    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
    joint_layout.reinit(division.owned, communicator);
    y_layout.reinit(Utilities::MPI::create_ascending_partitioning(communicator, y.size())[rank],
                    communicator);

    std::vector<types::global_dof_index> joint_f, own_x(f.begin(), f.end());
    for (const int i : f)
      joint_f.push_back(division.place_of_x[i]);
    own_x.insert(own_x.end(), y.begin(), y.end());
    f_window = Window(division.owned, joint_f, communicator);
    x_window = Window(owned_x, own_x, communicator);
  }

  void DividedFactors::divide(const Triplets &E)
  {
    const int n_f = f.size();
    for (std::size_t k = 0; k < E.size(); ++k)
    {
      const int row = place[E.rows[k]], column = place[E.columns[k]];
      if (row < 0) // of a body of another rank
        continue;
      Assert(column >= 0 && (row >= n_f || column >= n_f), ExcNotImplemented());
      if (row < n_f)
        E_fy.add(row, column - n_f, E.values[k]);
      else if (column < n_f)
        E_yf.add(row - n_f, column, E.values[k]);
      else
        E_yy.add(row - n_f, column - n_f, E.values[k]);
    }
  }

  void DividedFactors::bound_rates()
  {
    const int      n_f = f.size();
    Vector<double> rate(n_f), mass(n_f);
    for (std::size_t k = 0; k < E_yy.size(); ++k)
      if (E_yy.rows[k] == E_yy.columns[k] && E_yy.rows[k] < n_f)
        rate[E_yy.rows[k]] += E_yy.values[k];
    for (std::size_t k = 0; k < E_yf.size(); ++k)
      if (E_yf.rows[k] == E_yf.columns[k])
        mass[E_yf.rows[k]] += E_yf.values[k];
    inverse_rate.reinit(n_f);
    for (int node = 0; node < n_f; node += dim)
    {
      double bound = s; // where nothing else resists, the inertia of the fluid does
      for (int i = node; i < node + dim; ++i)
        bound = std::max(bound, rate[i] / mass[i]);
      std::fill_n(inverse_rate.begin() + node, dim, 1 / bound);
    }
  }

  void DividedFactors::collect_coupling()
  {
    const int n_f = f.size();
    K             = E_fy;
    for (std::size_t k = 0; k < E_yy.size(); ++k)
      if (const int row = E_yy.rows[k]; row < n_f)
        K.add(row, E_yy.columns[k], -s * inverse_rate[row] * E_yy.values[k]);
  }

  Triplets DividedFactors::collect_joint(const NearMatrices &matrices) const
  {
    const int  n_q  = matrices.n_q;
    const auto find = [&](const int i) {
      return i < n_q ? division.place_of_q[i] : division.place_of_x[i - n_q];
    };
    Triplets all;
    for (std::size_t k = 0; k < matrices.J.size(); ++k)
      if (matrices.J.rows[k] >= matrices.J.columns[k])
      {
        const int row = find(matrices.J.rows[k]), column = find(matrices.J.columns[k]);
        all.add(std::max(row, column), std::min(row, column), matrices.J.values[k]);
      }
    // M/e, M being what couples the balance of a node with the forces of another.
    const int n_f = f.size();
    for (std::size_t k = 0; k < E_yf.size(); ++k)
      if (const int row = E_yf.rows[k], column = E_yf.columns[k]; row < n_f)
        all.add(division.place_of_x[f[row]], division.place_of_x[f[column]],
                E_yf.values[k] * std::sqrt(inverse_rate[row] * inverse_rate[column]));
    return all;
  }

  std::vector<double> DividedFactors::estimate_inertia() const
  {
    std::vector<double> products(bodies.size()), norms(bodies.size());
    for (int d = 0; d < dim; ++d)
    {
      Vector<double> translation(f.size()), momentum(y.size());
      for (unsigned int i = d; i < f.size(); i += dim)
        translation[i] = 1;
      add_product(1, E_yf, translation, momentum);
      momentum.grow_or_shrink(f.size());
      FieldVector joint_response(joint_layout);
      f_window.add(momentum, joint_response);
      joint.solve(joint_response);
      const Vector<double> response = f_window.read(joint_response);
      unsigned int         i        = 0;
      for (unsigned int b = 0; b < bodies.size(); ++b)
        for (const unsigned int end = i + bodies[b].force.size(); i < end; ++i)
        {
          products[b] += momentum[i] * response[i];
          norms[b] += momentum[i] * translation[i];
        }
    }
    for (unsigned int b = 0; b < bodies.size(); ++b)
      products[b] /= norms[b];
    return products;
  }

  void DividedFactors::factorize_rest()
  {
    const std::vector<double> of_bodies = estimate_inertia();
    std::vector<double>       inertia;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      inertia.resize(inertia.size() + bodies[b].force.size(), of_bodies[b]);
    const int   n_f = f.size();
    MatrixParts matrix;
    matrix.entries = E_yy;
    for (std::size_t k = 0; k < E_yy.size(); ++k)
      if (const int row = E_yy.rows[k]; row < n_f)
        matrix.entries.values[k] *= 1 - inertia[row] * inverse_rate[row];
    for (std::size_t k = 0; k < E_fy.size(); ++k)
      matrix.entries.add(E_fy.rows[k], E_fy.columns[k], inertia[E_fy.rows[k]] / s * E_fy.values[k]);
    run_on_all(communicator, [&]() {
      if (!y.empty())
        rest.factorize(groups, matrix);
    });
  }

  /** The Schur complement for y: block 0 of a vector has y, block 1 the response (q, f) to it. */
  class DividedFactors::RestComplement
  {
  public:
    explicit RestComplement(const DividedFactors &factors)
        : factors(factors)
    {}

    void vmult(BlockVector &result, const BlockVector &source) const
    {
      result = 0;
      add_product(1, factors.E_yy, source.block(0), result.block(0));
      add_product(1, factors.E_yf, factors.f_window.read(source.block(1)), result.block(0));
    }

  private:
    const DividedFactors &factors;
  };

  /** Its approximate inverse, with the exact response. */
  class DividedFactors::RestPreconditioner
  {
  public:
    explicit RestPreconditioner(const DividedFactors &factors)
        : factors(factors)
    {}

    void vmult(BlockVector &result, const BlockVector &source) const
    {
      Vector<double> values(source.block(0).begin(), source.block(0).end());
      if (values.size() > 0)
        factors.rest.solve(values);
      std::copy(values.begin(), values.end(), result.block(0).begin());
      Vector<double> forces(factors.f.size());
      add_product(1 / factors.s, factors.K, values, forces);
      result.block(1) = 0;
      factors.f_window.add(forces, result.block(1));
      factors.joint.solve(result.block(1));
    }

  private:
    const DividedFactors &factors;
  };

  void DividedFactors::solve(Vector<double> &own_q, FieldVector &x) const
  {
    const unsigned int n_f = f.size();
    BlockVector        rhs(2), correction;
    rhs.block(0).reinit(y_layout);
    rhs.block(1).reinit(joint_layout);
    rhs.collect_sizes();
    correction.reinit(rhs);

    Vector<double> own_x = x_window.read(x), forces(n_f);
    std::copy(own_x.begin() + n_f, own_x.end(), rhs.block(0).begin());
    for (unsigned int i = 0; i < n_f; ++i)
      forces[i] = own_x[i] - s * inverse_rate[i] * own_x[n_f + i];
    FieldVector q_and_f(joint_layout);
    for (unsigned int k = 0; k < own_q.size(); ++k)
      q_and_f(division.place_of_q[division.own_q[k]]) = own_q[k];
    f_window.add(forces, q_and_f);
    joint.solve(q_and_f);
    q_and_f *= -1 / s;

    add_product(-1, E_yf, f_window.read(q_and_f), rhs.block(0));
    solve_by_conjugate_residuals(RestComplement(*this), correction, rhs, RestPreconditioner(*this),
                                 inner_tolerance * rhs.l2_norm(), most_inner_iterations);
    q_and_f += correction.block(1);

    for (unsigned int k = 0; k < own_q.size(); ++k)
      own_q[k] = q_and_f(division.place_of_q[division.own_q[k]]);
    forces = f_window.read(q_and_f);
    std::copy(forces.begin(), forces.end(), own_x.begin());
    std::copy_n(correction.block(0).begin(), y.size(), own_x.begin() + n_f);
    x = 0;
    x_window.add(own_x, x);
  }
} // namespace caudal
