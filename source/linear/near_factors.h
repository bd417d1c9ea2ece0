// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_source_linear_near_factors_h
#define caudal_source_linear_near_factors_h

#include "window.h"

#include <caudal/linear/multifrontal.h>
#include <caudal/linear/near_system.h>

namespace caudal
{
  /** Factors of a NearSystem. Member functions are collective. */
  class NearFactors
  {
  public:
    using FieldVector = NearSystem::FieldVector;

    virtual ~NearFactors() = default;

    /** See NearSystem. */
    virtual const std::vector<int> &get_own_q() const                                          = 0;
    virtual void                    solve(dealii::Vector<double> &own_q, FieldVector &x) const = 0;

    /** Number of entries on this rank. */
    virtual double get_n_entries() const = 0;

    /** Whether this rank needed pivots from all rows. */
    virtual bool has_pivoted() const = 0;
  };

  /** Unsymmetric factors of this rank alone, with pivots from all rows where groups do not do. */
  class OwnFactors
  {
  public:
    OwnFactors();

    /** @p groups ends with the number of unknowns; see MultifrontalSolver. */
    void factorize(const std::vector<int> &groups, const MatrixParts &matrix);

    void   solve(dealii::Vector<double> &values) const;
    double get_n_entries() const;
    bool   has_pivoted() const
    {
      return pivoted;
    }

  private:
    MultifrontalSolver solver;
    bool               pivoted = false;
  };

  /** Factors of all unknowns on rank 0. */
  class CompleteFactors : public NearFactors
  {
  public:
    CompleteFactors(const NearMatrices &matrices, MPI_Comm communicator);

    const std::vector<int> &get_own_q() const override
    {
      return own_q;
    }
    void   solve(dealii::Vector<double> &own_q, FieldVector &x) const override;
    double get_n_entries() const override
    {
      return factors.get_n_entries();
    }
    bool has_pivoted() const override
    {
      return factors.has_pivoted();
    }

  private:
    std::vector<int> own_q;    // all, on rank 0
    Window           x_window; // onto all, on rank 0
    OwnFactors       factors;
  };
} // namespace caudal

#endif
