// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_linear_near_system_h
#define caudal_linear_near_system_h

#include <caudal/linear/triplets.h>

#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/vector.h>

#include <memory>
#include <vector>

namespace caudal
{
  /**
   * Places of a body's force densities and velocities, node by node, and of the velocities of its
   * frame among the unknowns of all bodies; and where its nodes are.
   */
  struct BodyPlaces
  {
    unsigned int        n_components;
    std::vector<int>    force, velocity, frame;
    std::vector<double> positions; // node by node
  };

  /** The matrices of a NearSystem, whose equations see there. */
  struct NearMatrices
  {
    unsigned int     n_q = 0;
    dealii::IndexSet owned_x{}; // of vectors of x: f and y together

    /** Points near which the q are, as many coordinates each as a body has components. */
    std::vector<double>     positions{};
    std::vector<BodyPlaces> bodies{};

    double s = 1;
    /**
     * The entries on and below the diagonal of [S, -C^T; -C, H], first those of q, then those of x,
     * of which only forces have some; their sum over all ranks.
     */
    Triplets J{};
    /** The rows and columns of x; all ranks have all. */
    Triplets E{};
  };

  class NearFactors;

  /**
   * A solution, approximate where it is large, of the saddle-point system of few multipliers q, the
   * force densities f of bodies and what bodies have besides, y: velocities U and those of frames,
   *   s (-S q + C^T f)       = r_q,
   *   s (C q - H f) + E_fy y = r_f,  where  E_fU = s M,
   *   M f + E_Uy y           = r_U,  where  E_UU = R,
   *   E_gy y                 = r_g   for frames.
   * It is symmetric up to scaling, and no unsymmetric factors of all are needed: with a bound e of
   * R/M, s/e times the third line is taken from the second, which leaves
   *   J = [S, -C^T; -C, H + M/e],  K = E_fy - s/e E_Uy,
   * J on (q, f) by Cholesky; where R = e M, as with a gait, K has nothing in the columns of U. Then
   * y has the Schur complement E_yy + E_yf T K/s, T = (J^-1)_ff. A few conjugate residuals solve
   * it, preconditioned with T ~ t M^-1, t the mean of T over translations. The bound e may differ
   * by node.
   *
   * All ranks share J in slices; what else a body has is with one of them, see NearDivision.
   * Member functions are collective.
   */
  class NearSystem
  {
  public:
    using FieldVector = dealii::LinearAlgebra::distributed::Vector<double>;

    /**
     * Systems of up to @p largest_complete unknowns are solved exactly, by factors of all on rank
     * 0. A rank's slice of J has at least @p smallest_slice unknowns.
     */
    explicit NearSystem(MPI_Comm communicator, unsigned int largest_complete = 4000,
                        unsigned int smallest_slice = 1500);
    ~NearSystem();

    /** Makes the factors. */
    void factorize(const NearMatrices &matrices);

    /** The q whose values this rank gives and takes. */
    const std::vector<int> &get_own_q() const;

    /**
     * Replaces (r_q, r_x) by an approximate solution (q, x): @p own_q in the order of get_own_q(),
     * @p x in the layout of factorize().
     */
    void solve(dealii::Vector<double> &own_q, FieldVector &x) const;

    /** Number of entries of the factors, over all ranks. */
    double get_factor_entries() const
    {
      return n_entries;
    }

    /** Whether the last factorisation, of y or of all, needed pivots from all rows, which is slow.
     */
    bool has_pivoted() const
    {
      return pivoted;
    }

  private:
    const MPI_Comm     communicator;
    const unsigned int largest_complete, smallest_slice;

    std::unique_ptr<NearFactors> factors;
    double                       n_entries = 0;
    bool                         pivoted   = false;
  };
} // namespace caudal

#endif
