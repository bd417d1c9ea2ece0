// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_linear_schur_complement_h
#define caudal_linear_schur_complement_h

#include <caudal/linear/near_system.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <memory>
#include <vector>

namespace caudal
{
  /**
   * An approximate solution of the saddle-point system with a diagonal matrix D in its corner,
   *   D u + B^T q - G^T x = 0,   s B u = r_q,   E x - s G u = r_x,
   * for the many multipliers q and the few unknowns x; without u it is
   *   -s S q + s C^T x = r_q,   s C q + (E - s H) x = r_x,
   *   S = B D^-1 B^T,  C = G D^-1 B^T,  H = G D^-1 G^T.
   * One cycle of algebraic multigrid (Trilinos' ML; Vanek, Mandel & Brezina 1996,
   * doi:10.1007/BF02238511) on S solves for all q; then the NearSystem for the correction
   * of all x together with those q all of whose u have entries in G: those are what the cycle alone
   * can't see, since D is not what resists u there.
   *
   * Its factors and cycles are a function of the matrices, bit by bit. Member functions are
   * collective.
   */
  class SchurComplement
  {
  public:
    using FieldVector = dealii::LinearAlgebra::distributed::Vector<double>;

    explicit SchurComplement(MPI_Comm communicator);
    ~SchurComplement();

    /** Whether there is one: not without Trilinos' Epetra and ML. */
    static bool is_available();

    /**
     * Sets B. @p u has the layout of these vectors, with ghost entries for the columns of the rows
     * of B that this rank owns. @p smooth: multipliers that S hardly sees, as many as a cell has
     * unknowns, the first one constant; the coarser levels of the multigrid have them all. The
     * unknowns of a cell stand together and on one rank; the others but the first are coordinates,
     * whose mean a cell's first unknown has. @p B: the rows that this rank owns.
     */
    void reinit(const FieldVector &u, std::vector<FieldVector> smooth, const Triplets &B);

    /** Sets D and s, after which couple() is due. */
    void set_diagonal(const FieldVector &D, double s);

    /**
     * Sets G, the sum of all ranks' entries, and E, which all ranks have. @p owned_x: which of x,
     * numbered as the rows of G and E, this rank owns; @p bodies says which are whose. Where both
     * are those of the last call, as for bodies at rest, the factors are kept.
     */
    void couple(Triplets G, Triplets E, const dealii::IndexSet &owned_x,
                const std::vector<BodyPlaces> &bodies);

    /** An approximate solution; @p x and @p r_x may be empty. */
    void solve(FieldVector &q, FieldVector &x, const FieldVector &r_q,
               const FieldVector &r_x) const;

    /** Whether constant q are in the null space of B^T. */
    bool is_singular() const;

    /** Number of entries of the factors. */
    double get_factor_entries() const;

    /** Whether the last factorisation needed pivots from all rows, which is slow: see NearSystem.
     */
    bool has_pivoted() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace caudal

#endif
