// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef CAUDAL_ITERATIVE_SOLVER

#include <caudal/linear/schur_complement.h>

#include <deal.II/base/exceptions.h>

using namespace dealii;

// What stands for SchurComplement where deal.II has no Trilinos with Epetra and ML.

namespace caudal
{
  struct SchurComplement::Implementation
  {};

  SchurComplement::SchurComplement(MPI_Comm) {}

  SchurComplement::~SchurComplement() = default;

  bool SchurComplement::is_available()
  {
    return false;
  }

  void SchurComplement::reinit(const FieldVector &, std::vector<FieldVector>, const Triplets &)
  {
    AssertThrow(false, ExcMessage("Solver/Method: this program was built without Trilinos' Epetra "
                                  "and ML, which <iterative> needs. Choose direct or automatic."));
  }

  void SchurComplement::set_diagonal(const FieldVector &, double)
  {
    Assert(false, ExcInternalError());
  }

  void SchurComplement::couple(Triplets, Triplets, const IndexSet &,
                               const std::vector<BodyPlaces> &)
  {
    Assert(false, ExcInternalError());
  }

  void SchurComplement::solve(FieldVector &, FieldVector &, const FieldVector &,
                              const FieldVector &) const
  {
    Assert(false, ExcInternalError());
  }

  bool SchurComplement::is_singular() const
  {
    return false;
  }

  double SchurComplement::get_factor_entries() const
  {
    return 0;
  }

  bool SchurComplement::has_pivoted() const
  {
    return false;
  }
} // namespace caudal

#endif
