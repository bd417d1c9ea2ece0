// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef CAUDAL_ITERATIVE_SOLVER

#include "window.h"

#include <caudal/linear/near_system.h>
#include <caudal/linear/ownership.h>
#include <caudal/linear/schur_complement.h>

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <Epetra_MultiVector.h>
#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <numeric>
#include <optional>

using namespace dealii;

namespace caudal
{
  namespace
  {
    using FieldVector = SchurComplement::FieldVector;
    using Matrix      = TrilinosWrappers::SparseMatrix;

    /**
     * Where S is singular for constant multipliers, this part of its diagonal is added: far below
     * its smallest other eigenvalue, far above round-off.
     */
    constexpr double regularisation = 1e-6;

    /** All ranks' entries in the rows that this rank owns, its rows being consecutive ones. */
    Triplets send_to_owners(const Triplets &entries, const IndexSet &owned_rows,
                            const MPI_Comm communicator)
    {
      const Ownership           ownership(owned_rows.n_elements(), communicator);
      std::vector<unsigned int> owners;
      for (const int row : entries.rows)
        owners.push_back(ownership.find_rank(row));
      return exchange(entries, owners, communicator);
    }

    /** Adds up entries of one place in the order in which they stand. */
    void set_row(const types::global_dof_index row, std::vector<std::size_t>::iterator begin,
                 const std::vector<std::size_t>::iterator end, const Triplets &entries,
                 const double weight, Matrix &matrix)
    {
      std::stable_sort(begin, end, [&](const std::size_t a, const std::size_t b) {
        return entries.columns[a] < entries.columns[b];
      });
      std::vector<types::global_dof_index> columns;
      std::vector<double>                  values;
      for (; begin != end; ++begin)
      {
        const types::global_dof_index column = entries.columns[*begin];
        if (columns.empty() || columns.back() != column)
        {
          columns.push_back(column);
          values.push_back(0);
        }
        values.back() += weight * entries.values[*begin];
      }
      matrix.set(row, columns.size(), columns.data(), values.data(), false);
    }

    /** The sum of all ranks' entries; its rows times @p weights, if there are. Collective. */
    Matrix assemble(const Triplets &triplets, const IndexSet &owned_rows,
                    const IndexSet &owned_columns, const MPI_Comm communicator,
                    const TrilinosWrappers::MPI::Vector *weights = nullptr)
    {
      const Triplets            entries = send_to_owners(triplets, owned_rows, communicator);
      const unsigned int        n_rows  = owned_rows.n_elements();
      std::vector<unsigned int> lengths(n_rows), local_rows;
      for (const int row : entries.rows)
        ++lengths[local_rows.emplace_back(owned_rows.index_within_set(row))];
      std::vector<std::size_t> ends(n_rows), order(entries.size());
      std::partial_sum(lengths.begin(), lengths.end(), ends.begin());
      std::vector<std::size_t> next(n_rows);
      for (unsigned int row = 0; row < n_rows; ++row)
        next[row] = ends[row] - lengths[row];
      for (std::size_t k = 0; k < entries.size(); ++k)
        order[next[local_rows[k]]++] = k;

      Matrix matrix(owned_rows, owned_columns, communicator, lengths);
      for (unsigned int i = 0; i < n_rows; ++i)
        if (const auto row = owned_rows.nth_index_in_set(i); lengths[i] > 0)
          set_row(row, order.begin() + (ends[i] - lengths[i]), order.begin() + ends[i], entries,
                  weights ? (*weights)(row) : 1, matrix);
      matrix.compress(VectorOperation::insert);
      return matrix;
    }

    Triplets transpose(Triplets triplets)
    {
      std::swap(triplets.rows, triplets.columns);
      return triplets;
    }

    /**
     * result = A source or A^T source. deal.II's own product is a template of its library, whose
     * name clang spells otherwise than gcc, which has built the library.
     */
    void multiply(const Matrix &A, const bool transposed, FieldVector &result,
                  const FieldVector &source)
    {
      const Epetra_CrsMatrix &matrix = A.trilinos_matrix();
      // Epetra's views of constant data do not exist.
      const Epetra_Map   &range = matrix.RangeMap(), &domain = matrix.DomainMap();
      const Epetra_Vector from(View, transposed ? range : domain,
                               const_cast<double *>(source.begin()));
      Epetra_Vector       to(View, transposed ? domain : range, result.begin());
      const int           error = matrix.Multiply(transposed, from, to);
      AssertThrow(error == 0, ExcTrilinosError(error));
    }

    /**
     * Calls operation(column, value) for the entries of a row that this rank owns. deal.II's
     * iterators copy the row into arrays as long as the matrix has columns.
     */
    template <typename Operation>
    void for_each_entry_of_row(const Matrix &matrix, const types::global_dof_index row,
                               const Operation &operation)
    {
      const Epetra_CrsMatrix &entries = matrix.trilinos_matrix();
      int                     n = 0, *columns = nullptr;
      double                 *values = nullptr;
      const int               error =
          entries.ExtractMyRowView(entries.LRID(static_cast<int>(row)), n, values, columns);
      AssertThrow(error == 0, ExcTrilinosError(error));
      const int *global_columns = entries.ColMap().MyGlobalElements();
      for (int k = 0; k < n; ++k)
        operation(static_cast<types::global_dof_index>(global_columns[columns[k]]), values[k]);
    }

    /** Calls operation(row, column, value) for this rank's entries. */
    template <typename Operation>
    void for_each_entry(const Matrix &matrix, const Operation &operation)
    {
      for (const auto row : matrix.locally_owned_range_indices())
        for_each_entry_of_row(matrix, row,
                              [&](const types::global_dof_index column, const double value) {
                                operation(row, column, value);
                              });
    }
  } // namespace

  struct SchurComplement::Implementation
  {
    explicit Implementation(const MPI_Comm communicator)
        : communicator(communicator)
        , near(communicator)
    {}

    void     set_divergence(const FieldVector &u, const Triplets &entries);
    void     set_up_cycle();
    void     find_enclosed(const Matrix &G_transposed);
    Triplets collect_near(const Matrix &H) const;
    void     factorize(const Triplets &G, const Triplets &E, const std::vector<BodyPlaces> &bodies);
    void     add_near(FieldVector &q, FieldVector &x, const FieldVector &r_q,
                      const FieldVector &r_x) const;

    const MPI_Comm communicator;

    IndexSet                 owned_u, owned_q, owned_x;
    FieldVector              with_velocities; // zeros
    std::vector<FieldVector> smooth;
    std::optional<Matrix>    B, B_transposed;
    bool                     is_singular = false; // for constant multipliers

    double                            s = 1;
    TrilinosWrappers::MPI::Vector     inverse_diagonal; // of D
    Matrix                            S, C_transposed;
    TrilinosWrappers::PreconditionAMG cycle;

    // The multipliers that are factorised, and where they are: of all ranks, on all of them.
    std::vector<types::global_dof_index> enclosed;
    std::vector<double>                  positions;
    NearSystem                           near;
    Window                               q_window; // onto those that it has on this rank
    bool                                 is_coupled = false;
    Triplets                             G, E; // of the last call of couple()
  };

  void SchurComplement::Implementation::set_divergence(const FieldVector &u,
                                                       const Triplets    &entries)
  {
    with_velocities.reinit(u);
    owned_u = u.locally_owned_elements();
    owned_q = smooth.front().locally_owned_elements();
    B.emplace(assemble(entries, owned_q, owned_u, communicator));
    B_transposed.emplace(assemble(transpose(entries), owned_u, owned_q, communicator));

    FieldVector gradient(owned_u, communicator);
    multiply(*B_transposed, false, gradient, smooth.front());
    is_singular = gradient.linfty_norm() < 1e-10 * B->linfty_norm() * smooth.front().linfty_norm();
  }

  void SchurComplement::Implementation::set_up_cycle()
  {
    const Epetra_CrsMatrix &matrix = S.trilinos_matrix();
    Epetra_MultiVector      null_space(matrix.DomainMap(), smooth.size());
    for (unsigned int k = 0; k < smooth.size(); ++k)
      std::copy_n(smooth[k].begin(), null_space.MyLength(), null_space[k]);
    Teuchos::ParameterList parameters;
    parameters.set("prec type", "MGV");
    parameters.set("max levels", 10);
    parameters.set("PDE equations", null_space.NumVectors());
    parameters.set("aggregation: type", "Uncoupled");
    parameters.set("aggregation: threshold", 0.);
    // Estimates of the largest eigenvalue start from random numbers; the sum of a row's absolute
    // values, which does not, is 2.4 times as large in 2D and about three times in 3D.
    parameters.set("eigen-analysis: type", "Anorm");
    parameters.set("aggregation: damping factor", 3.);
    parameters.set("smoother: type", "Gauss-Seidel");
    parameters.set("smoother: sweeps", 2);
    parameters.set("smoother: Gauss-Seidel efficient symmetric", true);
    parameters.set("smoother: pre or post", "both");
    parameters.set("coarse: type", "Amesos-KLU");
    parameters.set("coarse: max size", 500);
    parameters.set("ML output", 0);
    parameters.set("null space: type", "pre-computed");
    parameters.set("null space: dimension", null_space.NumVectors());
    parameters.set("null space: vectors", null_space.Values());
    cycle.initialize(matrix, parameters);
  }

  void SchurComplement::Implementation::find_enclosed(const Matrix &G_transposed)
  {
    FieldVector touched(with_velocities);
    for (const auto i : owned_u)
      touched(i) = G_transposed.row_length(i) > 0 ? 1 : 0;
    touched.update_ghost_values();
    std::vector<types::global_dof_index> own;
    for (const auto row : owned_q)
    {
      bool all_touched = B->row_length(row) > 0;
      for_each_entry_of_row(*B, row, [&](const types::global_dof_index column, double) {
        all_touched &= touched(column) != 0;
      });
      if (all_touched)
        own.push_back(row);
    }
    const unsigned int  n_per_cell = smooth.size(), dim = smooth.size() - 1;
    std::vector<double> own_positions; // which the first function of a cell has
    for (const auto q : own)
      for (unsigned int d = 0; d < dim; ++d)
        own_positions.push_back(
            smooth[d + 1].local_element(owned_q.index_within_set(q) / n_per_cell * n_per_cell));
    const auto join = [&](const auto &part, auto &all) {
      all.clear();
      for (const auto &others : Utilities::MPI::all_gather(communicator, part))
        all.insert(all.end(), others.begin(), others.end());
    };
    join(own, enclosed);
    join(own_positions, positions);
  }

  Triplets SchurComplement::Implementation::collect_near(const Matrix &H) const
  {
    const int  begin = enclosed.size(); // of x
    const auto find  = [&](const types::global_dof_index q) -> int {
      const auto place = std::lower_bound(enclosed.begin(), enclosed.end(), q);
      return place == enclosed.end() || *place != q ? -1 : place - enclosed.begin();
    };
    Triplets own;
    for (const auto q : enclosed)
      if (owned_q.is_element(q))
      {
        const int row = find(q);
        for_each_entry_of_row(S, q, [&](const types::global_dof_index q2, const double value) {
          if (const int column = find(q2); column >= 0 && column <= row)
            own.add(row, column, value);
        });
      }
    for_each_entry(C_transposed,
                   [&](const types::global_dof_index q, const int x, const double value) {
                     if (const int place = find(q); place >= 0)
                       own.add(begin + x, place, -value);
                   });
    for_each_entry(H, [&](const int row, const int column, const double value) {
      own.add(begin + row, begin + column, value);
    });
    return own;
  }

  void SchurComplement::Implementation::factorize(const Triplets &G, const Triplets &E,
                                                  const std::vector<BodyPlaces> &bodies)
  {
    const Matrix scaled_G_transposed = // D^-1 G^T
        assemble(transpose(G), owned_u, owned_x, communicator, &inverse_diagonal);
    Matrix H;
    B->mmult(C_transposed, scaled_G_transposed);
    assemble(G, owned_x, owned_u, communicator).mmult(H, scaled_G_transposed);
    find_enclosed(scaled_G_transposed);
    near.factorize({static_cast<unsigned int>(enclosed.size()), owned_x, positions, bodies, s,
                    collect_near(H), E});
    std::vector<types::global_dof_index> own_q;
    for (const int k : near.get_own_q())
      own_q.push_back(enclosed[k]);
    q_window = Window(owned_q, own_q, communicator);
  }

  void SchurComplement::Implementation::add_near(FieldVector &q, FieldVector &x,
                                                 const FieldVector &r_q,
                                                 const FieldVector &r_x) const
  {
    Vector<double> own_q = q_window.read(r_q);
    x.copy_locally_owned_data_from(r_x);
    near.solve(own_q, x);
    q_window.add(own_q, q);
  }

  SchurComplement::SchurComplement(const MPI_Comm communicator)
      : implementation(std::make_unique<Implementation>(communicator))
  {}

  SchurComplement::~SchurComplement() = default;

  bool SchurComplement::is_available()
  {
    return true;
  }

  void SchurComplement::reinit(const FieldVector &u, std::vector<FieldVector> smooth,
                               const Triplets &B)
  {
    implementation->smooth = std::move(smooth);
    implementation->set_divergence(u, B);
  }

  void SchurComplement::set_diagonal(const FieldVector &D, const double s)
  {
    Implementation               &own = *implementation;
    TrilinosWrappers::MPI::Vector inverse(own.owned_u, own.communicator);
    for (const auto i : own.owned_u)
      inverse(i) = 1 / D(i);
    inverse.compress(VectorOperation::insert);

    own.cycle.clear(); // it refers to the matrix of before
    own.s = s;
    own.B->mmult(own.S, *own.B_transposed, inverse);
    if (own.is_singular)
      for (const auto i : own.owned_q)
        own.S.set(i, i, (1 + regularisation) * own.S.diag_element(i));
    own.S.compress(VectorOperation::insert);
    own.set_up_cycle();
    own.inverse_diagonal = inverse;
    own.is_coupled       = false;
  }

  void SchurComplement::couple(Triplets G, Triplets E, const IndexSet &owned_x,
                               const std::vector<BodyPlaces> &bodies)
  {
    Implementation &own = *implementation;
    if (Utilities::MPI::min(static_cast<int>(own.is_coupled && G == own.G && E == own.E),
                            own.communicator) == 1)
      return;
    own.is_coupled = false; // should it fail
    own.owned_x    = owned_x;
    if (owned_x.size() > 0)
      own.factorize(G, E, bodies);
    own.G          = std::move(G);
    own.E          = std::move(E);
    own.is_coupled = true;
  }

  void SchurComplement::solve(FieldVector &q, FieldVector &x, const FieldVector &r_q,
                              const FieldVector &r_x) const
  {
    const Implementation &own = *implementation;
    own.cycle.vmult(q, r_q);
    q *= -1 / own.s;
    if (own.owned_x.size() == 0)
      return;
    FieldVector rest_q(r_q), rest_x(r_x);
    multiply(own.S, false, rest_q, q);
    rest_q.sadd(own.s, 1, r_q);
    multiply(own.C_transposed, true, rest_x, q);
    rest_x.sadd(-own.s, 1, r_x);
    own.add_near(q, x, rest_q, rest_x);
  }

  bool SchurComplement::is_singular() const
  {
    return implementation->is_singular;
  }

  double SchurComplement::get_factor_entries() const
  {
    return implementation->near.get_factor_entries();
  }

  bool SchurComplement::has_pivoted() const
  {
    return implementation->near.has_pivoted();
  }
} // namespace caudal

#endif
