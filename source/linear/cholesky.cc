// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cholmod_context.h"

#include <caudal/linear/cholesky.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

using namespace dealii;

namespace caudal
{
  struct Cholesky::Implementation
  {
    mutable Cholmod cholmod{CHOLMOD_METIS};
    Cholmod::Factor factor{nullptr, Cholmod::Free{nullptr}};

    Cholmod::Matrix assemble(unsigned int n, const Triplets &entries);
    Cholmod::Factor analyze(cholmod_sparse *matrix, const Triplets &entries, unsigned int n_last);
    void            solve(int system, Vector<double> &values) const;

    /** The unknowns in the order of their elimination. */
    const int *get_order() const
    {
      return static_cast<const int *>(factor->Perm);
    }
  };

  /** The lower triangle of the first @p n rows and columns. */
  Cholmod::Matrix Cholesky::Implementation::assemble(const unsigned int n, const Triplets &entries)
  {
    cholmod_triplet *lower = cholmod_allocate_triplet(n, n, entries.values.size(),
                                                      /*lower triangle=*/-1, CHOLMOD_REAL, cholmod);
    cholmod.check(lower != nullptr);
    for (std::size_t k = 0; k < entries.values.size(); ++k)
      if (entries.rows[k] >= entries.columns[k] && entries.rows[k] < static_cast<int>(n))
      {
        static_cast<int *>(lower->i)[lower->nnz]      = entries.rows[k];
        static_cast<int *>(lower->j)[lower->nnz]      = entries.columns[k];
        static_cast<double *>(lower->x)[lower->nnz++] = entries.values[k];
      }
    cholmod_sparse *sum = cholmod_triplet_to_sparse(lower, lower->nnz, cholmod);
    cholmod_free_triplet(&lower, cholmod);
    return cholmod.own(sum);
  }

  Cholmod::Factor Cholesky::Implementation::analyze(cholmod_sparse *matrix, const Triplets &entries,
                                                    const unsigned int n_last)
  {
    const unsigned int n = matrix->nrow;
    if (n_last == 0)
      return cholmod.own(cholmod_analyze(matrix, cholmod));
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    if (n_last < n)
    {
      const auto first   = assemble(n - n_last, entries);
      const auto factors = cholmod.own(cholmod_analyze(first.get(), cholmod));
      std::copy_n(static_cast<const int *>(factors->Perm), n - n_last, order.begin());
    }
    const int ordering     = std::exchange(cholmod.data.method[0].ordering, CHOLMOD_GIVEN);
    const int postordering = std::exchange(cholmod.data.postorder, 0); // it would move the last
    cholmod_factor *factor = cholmod_analyze_p(matrix, order.data(), nullptr, 0, cholmod);
    cholmod.data.method[0].ordering = ordering;
    cholmod.data.postorder          = postordering;
    return cholmod.own(factor);
  }

  void Cholesky::Implementation::solve(const int system, Vector<double> &values) const
  {
    cholmod_dense rhs{};
    rhs.nrow = rhs.nzmax = rhs.d = values.size();
    rhs.ncol                     = 1;
    rhs.x                        = values.begin();
    rhs.xtype                    = CHOLMOD_REAL;
    rhs.dtype                    = CHOLMOD_DOUBLE;
    const auto solution          = cholmod.own(cholmod_solve(system, factor.get(), &rhs, cholmod));
    std::copy_n(static_cast<const double *>(solution->x), values.size(), values.begin());
  }

  Cholesky::Cholesky()
      : implementation(std::make_unique<Implementation>())
  {}

  Cholesky::~Cholesky() = default;

  bool Cholesky::factorize(const unsigned int n, const Triplets &entries, const unsigned int n_last)
  {
    Implementation &own     = *implementation;
    Cholmod        &cholmod = own.cholmod;
    own.factor.reset();
    const auto matrix = own.assemble(n, entries);
    auto       factor = own.analyze(matrix.get(), entries, n_last);
    cholmod_factorize(matrix.get(), factor.get(), cholmod);
    if (cholmod.data.status == CHOLMOD_NOT_POSDEF)
      return false;
    cholmod.check(true);
    own.factor = std::move(factor);
    return true;
  }

  void Cholesky::solve(Vector<double> &values) const
  {
    implementation->solve(CHOLMOD_A, values);
  }

  void Cholesky::solve_lower(Vector<double> &values) const
  {
    Vector<double> ordered(values.size());
    for (unsigned int k = 0; k < values.size(); ++k)
      ordered[k] = values[implementation->get_order()[k]];
    implementation->solve(CHOLMOD_L, ordered);
    values.swap(ordered);
  }

  void Cholesky::solve_upper(Vector<double> &values) const
  {
    Vector<double> ordered(values);
    implementation->solve(CHOLMOD_Lt, ordered);
    for (unsigned int k = 0; k < values.size(); ++k)
      values[implementation->get_order()[k]] = ordered[k];
  }

  LAPACKFullMatrix<double> Cholesky::extract_last(const unsigned int n) const
  {
    const cholmod_factor &factor = *implementation->factor;
    Assert(factor.is_super, ExcInternalError());
    const int *first_column = static_cast<const int *>(factor.super);
    const int *first_row    = static_cast<const int *>(factor.pi);
    const int *first_value  = static_cast<const int *>(factor.px);
    const int *rows         = static_cast<const int *>(factor.s);
    const auto values       = static_cast<const double *>(factor.x);

    const int                begin = static_cast<int>(factor.n) - static_cast<int>(n);
    LAPACKFullMatrix<double> last(n);
    for (std::size_t k = 0; k < factor.nsuper; ++k)
    {
      const int n_rows = first_row[k + 1] - first_row[k];
      for (int column = std::max(first_column[k], begin); column < first_column[k + 1]; ++column)
        for (int i = column - first_column[k]; i < n_rows; ++i)
          last(rows[first_row[k] + i] - begin, column - begin) =
              values[first_value[k] + (column - first_column[k]) * n_rows + i];
    }
    last.set_property(LAPACKSupport::lower_triangular);
    return last;
  }

  double Cholesky::get_n_entries() const
  {
    return implementation->factor ? implementation->factor->xsize : 0.;
  }
} // namespace caudal
