// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cholmod_context.h"

#include <caudal/linear/cholesky.h>

#include <algorithm>

using namespace dealii;

namespace caudal
{
  struct Cholesky::Implementation
  {
    mutable Cholmod cholmod{CHOLMOD_METIS};
    Cholmod::Factor factor{nullptr, Cholmod::Free{nullptr}};
  };

  Cholesky::Cholesky()
      : implementation(std::make_unique<Implementation>())
  {}

  Cholesky::~Cholesky() = default;

  bool Cholesky::factorize(const unsigned int n, const Triplets &entries)
  {
    Cholmod &cholmod = implementation->cholmod;
    implementation->factor.reset();
    cholmod_triplet *lower = cholmod_allocate_triplet(n, n, entries.values.size(),
                                                      /*lower triangle=*/-1, CHOLMOD_REAL, cholmod);
    cholmod.check(lower != nullptr);
    for (std::size_t k = 0; k < entries.values.size(); ++k)
      if (entries.rows[k] >= entries.columns[k])
      {
        static_cast<int *>(lower->i)[lower->nnz]      = entries.rows[k];
        static_cast<int *>(lower->j)[lower->nnz]      = entries.columns[k];
        static_cast<double *>(lower->x)[lower->nnz++] = entries.values[k];
      }
    cholmod_sparse *sum = cholmod_triplet_to_sparse(lower, lower->nnz, cholmod);
    cholmod_free_triplet(&lower, cholmod);
    const auto matrix = cholmod.own(sum);
    auto       factor = cholmod.own(cholmod_analyze(matrix.get(), cholmod));
    cholmod_factorize(matrix.get(), factor.get(), cholmod);
    if (cholmod.data.status == CHOLMOD_NOT_POSDEF)
      return false;
    cholmod.check(true);
    implementation->factor = std::move(factor);
    return true;
  }

  void Cholesky::solve(Vector<double> &values) const
  {
    Cholmod      &cholmod = implementation->cholmod;
    cholmod_dense rhs{};
    rhs.nrow = rhs.nzmax = rhs.d = values.size();
    rhs.ncol                     = 1;
    rhs.x                        = values.begin();
    rhs.xtype                    = CHOLMOD_REAL;
    rhs.dtype                    = CHOLMOD_DOUBLE;
    const auto solution =
        cholmod.own(cholmod_solve(CHOLMOD_A, implementation->factor.get(), &rhs, cholmod));
    std::copy_n(static_cast<const double *>(solution->x), values.size(), values.begin());
  }

  double Cholesky::get_n_entries() const
  {
    return implementation->factor ? implementation->factor->xsize : 0.;
  }
} // namespace caudal
