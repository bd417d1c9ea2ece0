// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_linear_distributed_cholesky_h
#define caudal_linear_distributed_cholesky_h

#include <caudal/linear/cholesky.h>
#include <caudal/linear/ownership.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <vector>

namespace caudal
{
  /**
   * Sparse Cholesky factors of a symmetric positive definite matrix on all ranks, by substructuring
   * (Przemieniecki 1963, doi:10.2514/3.1728). Each rank eliminates those of its unknowns that don't
   * meet any of other ranks but unknowns k of an interface. For these is left the sum
   *   S = A_kk - sum_r A_kr A_rr^-1 A_rk
   * of the ranks' parts, sparse where interfaces don't meet, which rank 0 factorises. A rank's part
   * falls out of its own factors: where its interface stands last, with a diagonal T >= A_kk in its
   * corner, the corner L_kk of L has  L_kk L_kk^T = T - A_kr A_rr^-1 A_rk.
   *
   * The factors are a function of layout and matrix, bit by bit. Member functions are collective.
   */
  class DistributedCholesky
  {
  public:
    using FieldVector = dealii::LinearAlgebra::distributed::Vector<double>;

    explicit DistributedCholesky(MPI_Comm communicator);

    /**
     * Factorises the sum of all ranks' @p entries, of which those on and below the diagonal are
     * taken. Each rank owns the unknowns that it does of vectors of the layout @p owned, which
     * should be close to each other. Of two unknowns of different ranks that an entry couples, S
     * takes the one that @p reaches_far. Returns whether the matrix is positive definite; if not,
     * there are no factors.
     */
    bool factorize(const dealii::IndexSet &owned, const Triplets &entries,
                   const std::vector<bool> &reaches_far);

    /** Replaces @p values, which have the layout of factorize(), by the solution. */
    void solve(FieldVector &values) const;

    /** Number of entries of this rank's factors. */
    double get_n_own_entries() const
    {
      return (interior.empty() ? 0 : interior_factor.get_n_entries()) +
             (n_interface == 0 ? 0 : interface_factor.get_n_entries());
    }

  private:
    /** Entries between unknowns of S, by their places there, and those of a rank's interior. */
    struct Parts
    {
      Triplets inside, between;
    };

    void             find_interface(const Triplets &lower, const std::vector<bool> &reaches_far);
    Parts            divide(const Triplets &lower) const;
    void             number_unknowns(Triplets &inside);
    bool             factorize_interior(Triplets &inside, Triplets &between);
    dealii::IndexSet get_own_interface() const;
    void             solve_interface(dealii::Vector<double> &own, FieldVector &values) const;

    const MPI_Comm     communicator;
    const unsigned int rank;

    Ownership        ownership; // of the unknowns
    std::vector<int> place;     // of all unknowns in S
    unsigned int     n_interface = 0;
    std::vector<int> interior, owned_interface; // unknowns of this rank
    std::vector<int> met_interface;             // places in S of what the interior meets
    FieldVector      with_interface; // zeros: rank 0's, what others need as ghost entries

    Cholesky                         interior_factor, interface_factor;
    dealii::LAPACKFullMatrix<double> corner; // L_kk
  };
} // namespace caudal

#endif
