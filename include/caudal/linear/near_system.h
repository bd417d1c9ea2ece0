// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_linear_near_system_h
#define caudal_linear_near_system_h

#include <caudal/linear/cholesky.h>
#include <caudal/linear/multifrontal.h>

#include <deal.II/lac/vector.h>

#include <vector>

namespace caudal
{
  /** Places of a body's force densities and velocities, node by node, among its unknowns. */
  struct BodyPlaces
  {
    unsigned int     n_components;
    std::vector<int> force, velocity;
  };

  /**
   * A solution, approximate where it is large, of the saddle-point system of few multipliers q, the
   * force densities f of bodies and what bodies have besides, y: velocities U and those of frames,
   *   s (-S q + C^T f)       = r_q,
   *   s (C q - H f) + E_fy y = r_f,  where  E_fU = s M,
   *   M f + E_Uy y           = r_U,  where  E_UU = R,
   *   E_gy y                 = r_g   for what is neither force nor velocity.
   * It is symmetric up to scaling, and no unsymmetric factors of all are needed: with a bound e of
   * R/M, s/e times the third line is taken from the second, which leaves
   *   J = [S, -C^T; -C, H + M/e],  K = E_fy - s/e E_Uy,
   * J on (q, f) by Cholesky; where R = e M, as with a gait, K has nothing in the columns of U. Then
   * y has the Schur complement E_yy + E_yf T K/s, T = (J^-1)_ff. A few conjugate residuals solve
   * it, preconditioned with T ~ t M^-1, t the mean of T over translations. The bound e may differ
   * by node.
   */
  class NearSystem
  {
  public:
    /** Systems of up to @p largest_complete unknowns are solved exactly, by factors of all. */
    explicit NearSystem(unsigned int largest_complete = 4000);

    /**
     * Sets the matrices. @p J: S and -C, whose rows are those of f, behind the @p n_q of q,
     * numbered by @p bodies; H, too; on and below the diagonal. @p E: the rows and columns of x,
     * @p n_x of f and y together.
     */
    void factorize(unsigned int n_q, unsigned int n_x, const std::vector<BodyPlaces> &bodies,
                   double s, Triplets J, const Triplets &E);

    /** Replaces (r_q, r_x) by an approximate solution (q, x). */
    void solve(dealii::Vector<double> &values) const;

    /** Number of entries of the factors. */
    double get_factor_entries() const;

    /** Whether the last factorisation, of y or of all, needed pivots from all rows, which is slow.
     */
    bool has_pivoted() const
    {
      return pivoted;
    }

  private:
    class RestComplement;
    class RestPreconditioner;

    /** Makes the factors of y, or of all; @p groups ends with the number of unknowns. */
    void factorize_by_groups(const std::vector<int> &groups, const MatrixParts &matrix);
    void factorize_completely(unsigned int n_x, const std::vector<BodyPlaces> &bodies,
                              const Triplets &J, const Triplets &E);
    void divide(const std::vector<BodyPlaces> &bodies, unsigned int n_x, const Triplets &E);
    void bound_rates(const std::vector<BodyPlaces> &bodies);
    void collect_coupling();
    void factorize_rest(const std::vector<BodyPlaces> &bodies);

    /** For each body t with T ~ t M^-1. */
    std::vector<double> estimate_inertia(const std::vector<BodyPlaces> &bodies) const;

    /** Solves by the factors of y, or of all. */
    void solve_rest(dealii::Vector<double> &values) const;

    const unsigned int largest_complete;
    bool               is_complete = false;
    bool               pivoted     = false;
    double             s           = 1;
    unsigned int       n_q = 0, n_f = 0, n_y = 0;

    std::vector<int>    place; // of x among f and, behind them, y: U in the order of f, then others
    std::vector<int>    rest_groups; // first y of those that are eliminated together, and n_y
    Triplets            E_fy, E_yf, E_yy, K;
    std::vector<double> inverse_rate; // 1/e for each f

    Cholesky                   forces; // of J
    mutable MultifrontalSolver rest;   // of y, or of all
  };
} // namespace caudal

#endif
