#ifndef caudal_linear_direct_solver_h
#define caudal_linear_direct_solver_h

#include <caudal/linear/matrix_parts.h>

#include <memory>
#include <vector>

namespace caudal
{
  /**
   * Sparse direct solver of one rank for matrices that need their pivots exchanged: a thin layer
   * over MUMPS (Amestoy et al. 2001, doi:10.1137/S0895479899358194) that takes the matrix as
   * triplets, so that a matrix composed of several operators never has to be put together.
   */
  class DirectSolver
  {
  public:
    DirectSolver();
    ~DirectSolver();

    /**
     * Orders and factorises the matrix that is the sum of all @p entries (indices from 0).
     * Unknowns are ordered in groups with consecutive indices, such as the components of a
     * velocity: that is cheaper than one by one. @p group_begins: their first unknowns, and
     * behind them the number of all unknowns.
     * Throws if the matrix is singular or memory runs out.
     */
    void factorize(const std::vector<int> &group_begins, const Triplets &entries);

    /** Replaces @p vector by the solution. */
    void solve(std::vector<double> &vector);

    /** Entries of the factors. */
    double get_factor_entries() const;
    /** Operations for the factors. */
    double get_factor_operations() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> mumps;
  };
} // namespace caudal

#endif
