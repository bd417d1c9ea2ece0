#ifndef caudal_linear_multifrontal_solver_h
#define caudal_linear_multifrontal_solver_h

#include <caudal/linear/elimination_tree.h>

#include <deal.II/base/aligned_vector.h>

namespace caudal
{
  /**
   * Sparse direct solver of one rank for matrices with a symmetric pattern: the multifrontal
   * method (Duff & Reid 1983, doi:10.1145/356044.356047), with rows exchanged within the pivots
   * of a front only. Systems of this size are too small for MUMPS to get near the speed of its
   * BLAS: this takes 0.56 to 0.62 of its time, and half of it for a solution. A matrix that needs
   * other pivots is left to DirectSolver.
   *
   * The last unknowns may be kept out of the elimination. With i for those eliminated and k for
   * those kept, the factors then stand for
   *   S = A_kk - A_ki A_ii^-1 A_ik,
   * and a system is solved by condense(), by the caller's solution with S, and by expand().
   */
  class MultifrontalSolver
  {
  public:
    /**
     * Orders and factorises @p matrix (indices from 0). Unknowns are ordered in groups with
     * consecutive indices, such as the components of a velocity: @p group_begins has their first
     * unknowns, and behind them the number of all unknowns. The last @p n_kept unknowns, which are
     * whole groups, are not eliminated. Returns whether there are sound pivots; if not, there are
     * no factors.
     */
    bool factorize(const std::vector<int> &group_begins, const MatrixParts &matrix,
                   unsigned int n_kept = 0);

    /** Gives back the memory. */
    void clear();

    /** S, row by row. */
    const std::vector<double> &get_schur_complement() const
    {
      return schur_complement;
    }

    /**
     * Replaces the kept part of @p vector by b_k - A_ki A_ii^-1 b_i, the other one by what
     * expand() needs.
     */
    void condense(std::vector<double> &vector);

    /** Replaces @p vector of condense(), which got the kept part of the solution, by all of it. */
    void expand(std::vector<double> &vector);

    /** Entries of the factors. */
    double get_factor_entries() const
    {
      return factors.size();
    }
    /** Operations for the factors. */
    double get_factor_operations() const;

  private:
    EliminationTree tree;
    unsigned int    n_eliminated = 0;

    /** D A D has entries up to about one. */
    std::vector<double> scales;

    /** Begins of the fronts' factors and row exchanges. */
    std::vector<std::size_t>      factor_begins, exchange_begins;
    dealii::AlignedVector<double> factors;
    std::vector<int>              exchanges;
    std::vector<double>           schur_complement;

    /** Work space: what fronts leave for their parents, and where that of each begins. */
    dealii::AlignedVector<double> updates;
    std::vector<std::size_t>      update_begins;

    void compute_scales(const MatrixParts &matrix, unsigned int n);
    void lay_out_factors();
    void lay_out_updates();
    bool eliminate(const MatrixParts &matrix);
  };
} // namespace caudal

#endif
