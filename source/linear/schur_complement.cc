// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef CAUDAL_ITERATIVE_SOLVER

#include <caudal/base/collective.h>
#include <caudal/linear/near_system.h>
#include <caudal/linear/schur_complement.h>

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <Epetra_MultiVector.h>
#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

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

    struct Entry
    {
      int    row, column;
      double value;

      template <class Archive>
      void serialize(Archive &archive, unsigned int /*version*/)
      {
        archive &row &column &value;
      }
    };

    /** All ranks' entries in the rows that this rank owns, its rows being consecutive ones. */
    std::vector<Entry> send_to_owners(std::vector<Entry> own, const IndexSet &owned_rows,
                                      const MPI_Comm communicator)
    {
      if (Utilities::MPI::n_mpi_processes(communicator) == 1)
        return own;
      std::vector<unsigned int> ends = // of the ranks' rows
          Utilities::MPI::all_gather(communicator,
                                     static_cast<unsigned int>(owned_rows.n_elements()));
      std::partial_sum(ends.begin(), ends.end(), ends.begin());
      std::map<unsigned int, std::vector<Entry>> parts;
      for (const Entry &entry : own)
        parts[std::upper_bound(ends.begin(), ends.end(), static_cast<unsigned int>(entry.row)) -
              ends.begin()]
            .push_back(entry);
      std::vector<Entry> received;
      for (const auto &part : Utilities::MPI::some_to_some(communicator, parts))
        received.insert(received.end(), part.second.begin(), part.second.end());
      return received;
    }

    /** The sum of all ranks' entries, or its transpose. Collective. */
    Matrix assemble(const Triplets &triplets, const bool transpose, const IndexSet &owned_rows,
                    const IndexSet &owned_columns, const MPI_Comm communicator)
    {
      std::vector<Entry> entries;
      entries.reserve(triplets.values.size());
      for (std::size_t k = 0; k < triplets.values.size(); ++k)
      {
        const int row = triplets.rows[k], column = triplets.columns[k];
        entries.push_back({transpose ? column : row, transpose ? row : column, triplets.values[k]});
      }
      entries = send_to_owners(std::move(entries), owned_rows, communicator);
      std::stable_sort(entries.begin(), entries.end(), [](const Entry &a, const Entry &b) {
        return std::tie(a.row, a.column) < std::tie(b.row, b.column);
      });

      std::vector<unsigned int> lengths(owned_rows.n_elements());
      for (const Entry &entry : entries)
        ++lengths[owned_rows.index_within_set(entry.row)];
      Matrix                               matrix(owned_rows, owned_columns, communicator, lengths);
      std::vector<types::global_dof_index> columns;
      std::vector<double>                  values;
      for (std::size_t k = 0; k < entries.size(); ++k)
      {
        const Entry &entry = entries[k];
        if (!columns.empty() && columns.back() == static_cast<unsigned int>(entry.column))
          values.back() += entry.value;
        else
        {
          columns.push_back(entry.column);
          values.push_back(entry.value);
        }
        if (k + 1 == entries.size() || entries[k + 1].row != entry.row)
        {
          matrix.set(entry.row, columns.size(), columns.data(), values.data(), false);
          columns.clear();
          values.clear();
        }
      }
      matrix.compress(VectorOperation::insert);
      return matrix;
    }

    /**
     * result = A source. deal.II's own product is a template of its library, whose name clang
     * spells otherwise than gcc, which has built the library.
     */
    void multiply(const Matrix &A, FieldVector &result, const FieldVector &source)
    {
      const Epetra_CrsMatrix &matrix = A.trilinos_matrix();
      // Epetra's views of constant data do not exist.
      const Epetra_Vector from(View, matrix.DomainMap(), const_cast<double *>(source.begin()));
      Epetra_Vector       to(View, matrix.RangeMap(), result.begin());
      const int           error = matrix.Multiply(false, from, to);
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

    /** All ranks' entries on the root. Collective. */
    Triplets gather(const Triplets &own, const MPI_Comm communicator)
    {
      Triplets   all;
      const auto append = [&](const auto &parts, auto &whole) {
        for (const auto &part : parts)
          whole.insert(whole.end(), part.begin(), part.end());
      };
      append(Utilities::MPI::gather(communicator, own.rows), all.rows);
      append(Utilities::MPI::gather(communicator, own.columns), all.columns);
      append(Utilities::MPI::gather(communicator, own.values), all.values);
      return all;
    }
  } // namespace

  struct SchurComplement::Implementation
  {
    explicit Implementation(const MPI_Comm communicator)
        : communicator(communicator)
        , is_root(Utilities::MPI::this_mpi_process(communicator) == 0)
    {}

    void     set_divergence(const FieldVector &u, const Triplets &entries);
    void     set_up_cycle();
    void     find_enclosed(const Matrix &G_transposed);
    Triplets collect_near(const Matrix &H) const;
    void     add_near(FieldVector &q, FieldVector &x, const FieldVector &r_q,
                      const FieldVector &r_x) const;

    const MPI_Comm communicator;
    const bool     is_root;

    IndexSet                 owned_u, owned_q, owned_x;
    FieldVector              with_velocities; // zeros
    std::vector<FieldVector> smooth;
    std::optional<Matrix>    B, B_transposed;
    bool                     is_singular = false; // for constant multipliers

    double                            s = 1;
    TrilinosWrappers::MPI::Vector     inverse_diagonal; // of D
    Matrix                            S, C;
    TrilinosWrappers::PreconditionAMG cycle;

    // The multipliers that are factorised, of all ranks, on all of them; the root has their values
    // as ghost entries.
    std::vector<types::global_dof_index> enclosed;
    FieldVector                          with_enclosed;
    NearSystem                           near; // of the root
    bool                                 is_coupled = false;
    Triplets                             G, E; // of the last call of couple()
  };

  void SchurComplement::Implementation::set_divergence(const FieldVector &u,
                                                       const Triplets    &entries)
  {
    with_velocities.reinit(u);
    owned_u = u.locally_owned_elements();
    owned_q = smooth.front().locally_owned_elements();
    B.emplace(assemble(entries, false, owned_q, owned_u, communicator));
    B_transposed.emplace(assemble(entries, true, owned_u, owned_q, communicator));

    FieldVector gradient(owned_u, communicator);
    multiply(*B_transposed, gradient, smooth.front());
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
    enclosed.clear();
    for (const auto &part : Utilities::MPI::all_gather(communicator, own))
      enclosed.insert(enclosed.end(), part.begin(), part.end());
    IndexSet ghosts(owned_q.size());
    if (is_root)
      ghosts.add_indices(enclosed.begin(), enclosed.end());
    with_enclosed.reinit(owned_q, ghosts, communicator);
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
    Triplets all = gather(own, communicator);
    for_each_entry(C, [&](const int x, const types::global_dof_index q, const double value) {
      if (const int place = find(q); place >= 0)
        all.add(begin + x, place, -value);
    });
    for_each_entry(H, [&](const int row, const int column, const double value) {
      all.add(begin + row, begin + column, value);
    });
    return all;
  }

  void SchurComplement::Implementation::add_near(FieldVector &q, FieldVector &x,
                                                 const FieldVector &r_q,
                                                 const FieldVector &r_x) const
  {
    FieldVector at_enclosed(with_enclosed);
    at_enclosed.copy_locally_owned_data_from(r_q);
    at_enclosed.update_ghost_values();
    Vector<double> near_part;
    if (is_root)
    {
      near_part.reinit(enclosed.size() + r_x.size());
      for (unsigned int k = 0; k < enclosed.size(); ++k)
        near_part[k] = at_enclosed(enclosed[k]);
      std::copy(r_x.begin(), r_x.end(), near_part.begin() + enclosed.size());
      near.solve(near_part);
    }
    at_enclosed = 0;
    at_enclosed.zero_out_ghost_values();
    if (is_root)
    {
      const unsigned int n_enclosed = enclosed.size();
      for (unsigned int k = 0; k < n_enclosed; ++k)
        at_enclosed(enclosed[k]) = near_part[k];
      std::copy_n(near_part.begin() + n_enclosed, x.size(), x.begin());
    }
    at_enclosed.compress(VectorOperation::add);
    for (unsigned int i = 0; i < q.locally_owned_size(); ++i)
      q.local_element(i) += at_enclosed.local_element(i);
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

  void SchurComplement::couple(Triplets G, Triplets E, const unsigned int n_x,
                               const std::vector<BodyPlaces> &bodies)
  {
    Implementation &own = *implementation;
    if (Utilities::MPI::min(static_cast<int>(own.is_coupled && G == own.G && E == own.E),
                            own.communicator) == 1)
      return;
    own.is_coupled = false; // should it fail
    own.owned_x    = IndexSet(n_x);
    if (own.is_root)
      own.owned_x.add_range(0, n_x);
    if (n_x > 0)
    {
      const Matrix G_matrix     = assemble(G, false, own.owned_x, own.owned_u, own.communicator);
      const Matrix G_transposed = assemble(G, true, own.owned_u, own.owned_x, own.communicator);
      Matrix       H;
      G_matrix.mmult(own.C, *own.B_transposed, own.inverse_diagonal);
      G_matrix.mmult(H, G_transposed, own.inverse_diagonal);
      own.find_enclosed(G_transposed);
      Triplets J = own.collect_near(H);
      run_on_root(own.communicator, [&]() {
        own.near.factorize(own.enclosed.size(), n_x, bodies, own.s, std::move(J), E);
      });
    }
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
    multiply(own.S, rest_q, q);
    rest_q.sadd(own.s, 1, r_q);
    multiply(own.C, rest_x, q);
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
