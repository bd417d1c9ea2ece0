#ifndef caudal_base_direct_solver_h
#define caudal_base_direct_solver_h

#include <caudal/base/types.h>

#include <memory>
#include <vector>

namespace caudal
{
  /**
   * Sparse direct solver of one rank: a thin layer over MUMPS (Amestoy et al.
   * 2001, doi:10.1137/S0895479899358194) that takes the matrix as triplets, so
   * that a matrix composed of several operators never has to be put together.
   *
   * The last unknowns may be kept out of the elimination. With i for those eliminated and k for
   * those kept, the factors then stand for
   *   S = A_kk - A_ki A_ii^-1 A_ik,
   * and a system is solved by condense(), by the caller's solution with S, and by expand().
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
     * behind them the number of all unknowns. The last @p n_kept unknowns, which are whole
     * groups, are not eliminated; at least one has to be.
     * Throws if the matrix is singular or memory runs out.
     */
    void factorize(const std::vector<int> &group_begins, const Triplets &entries,
                   unsigned int n_kept = 0);

    /** S, row by row. */
    const std::vector<double> &get_schur_complement() const;

    /** Replaces the kept part of @p vector by b_k - A_ki A_ii^-1 b_i. */
    void condense(std::vector<double> &vector);

    /** Replaces @p vector, which has the kept part of the solution, by all; after condense(). */
    void expand(std::vector<double> &vector);

    /** Pivots that were too small where the order had them, and came later. */
    unsigned int get_n_delayed_pivots() const;

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
