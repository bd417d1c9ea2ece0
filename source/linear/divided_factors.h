// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_source_linear_divided_factors_h
#define caudal_source_linear_divided_factors_h

#include "near_division.h"
#include "near_factors.h"

#include <caudal/linear/distributed_cholesky.h>

#include <deal.II/lac/la_parallel_block_vector.h>

namespace caudal
{
  /** The factors of J on all ranks, and of y on the rank that has the body: see NearSystem. */
  class DividedFactors : public NearFactors
  {
  public:
    DividedFactors(const NearMatrices &matrices, unsigned int smallest_slice,
                   MPI_Comm communicator);

    const std::vector<int> &get_own_q() const override
    {
      return division.own_q;
    }
    void   solve(dealii::Vector<double> &own_q, FieldVector &x) const override;
    double get_n_entries() const override
    {
      return joint.get_n_own_entries() + rest.get_n_entries();
    }
    bool has_pivoted() const override
    {
      return rest.has_pivoted();
    }

  private:
    using BlockVector = dealii::LinearAlgebra::distributed::BlockVector<double>;
    class RestComplement;
    class RestPreconditioner;

    void                select_bodies(const NearMatrices &matrices);
    void                set_layouts(const dealii::IndexSet &owned_x);
    void                divide(const Triplets &E);
    void                bound_rates();
    void                collect_coupling();
    Triplets            collect_joint(const NearMatrices &matrices) const;
    std::vector<double> estimate_inertia() const;
    void                factorize_rest();

    const MPI_Comm     communicator;
    const NearDivision division;
    const int          dim;
    const double       s;

    // Of the bodies of this rank.
    std::vector<BodyPlaces> bodies;
    std::vector<int>        f, y;   // which x: f body by body; U in the order of f, then frames
    std::vector<int>        place;  // of x among f and, behind them, y
    std::vector<int>        groups; // first y of those that are eliminated together, and n_y
    Triplets                E_fy, E_yf, E_yy, K;
    dealii::Vector<double>  inverse_rate; // 1/e for each f

    FieldVector joint_layout, y_layout; // zeros; the joint unknowns are q and f
    Window      f_window;               // onto f among the joint unknowns
    Window      x_window;               // onto f and, behind them, y among x

    DistributedCholesky joint; // of J
    OwnFactors          rest;  // of y
  };
} // namespace caudal

#endif
