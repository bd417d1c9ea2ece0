// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_coupled_equations_h
#define caudal_viscous_coupled_equations_h

#include <caudal/coupling/interaction_operator.h>
#include <caudal/fluid/momentum_operator.h>
#include <caudal/linear/near_system.h>

#include <deal.II/lac/vector.h>

namespace caudal
{
  /** Places of a field of a body among its unknowns: @p n_components of each @p stride. */
  struct Places
  {
    int          begin;
    unsigned int size, n_components, stride;

    int operator[](const unsigned int i) const
    {
      return begin + i / n_components * stride + i % n_components;
    }
  };

  /**
   * The part of a body in a step's linear system: the equations
   *   scale (M_s dU - G du) = scale r_U,
   *   R dU + M_s dPhi - eta M_s Z dq = r_Phi,  scale Z^T M_s (dU - Z dq) = scale r_q
   * for the corrections of its velocity, its force density and, with a gait, of the velocity q of
   * its floating frame (Z: rigid-body velocities; R = -db/dU: stiffness times step, damping, excess
   * inertia). Unknowns are numbered node by node, velocity before force density, those of the frame
   * last. r_Phi stands in the rows of dU and r_U in those of dPhi: then only dPhi shares rows and
   * columns with the fluid, and the factors of the matrix are smaller by up to a fifth.
   */
  template <int dim>
  struct BodyEquations
  {
    BodyEquations(const InteractionOperator<dim> &interaction, const Vector<double> &positions,
                  const unsigned int n_frame)
        : interaction(interaction)
        , positions(positions)
        , velocity{0, static_cast<unsigned int>(positions.size()), dim, 2 * dim}
        , force_density{dim, velocity.size, dim, 2 * dim}
        , frame{2 * static_cast<int>(velocity.size), n_frame, 1, 1}
    {}

    /** G */
    const InteractionOperator<dim> &interaction;
    /** Of the nodes, to tell what is near what. */
    const Vector<double> &positions;
    /** Places of the unknowns, and of the equations of balance, kinematics and frame. */
    Places velocity, force_density, frame;
    /** The matrix of the equations, without G. */
    Triplets matrix{};

    unsigned int n_unknowns() const
    {
      return 2 * velocity.size + frame.size;
    }
  };

  /** One value for each unknown of a body, or for each of its equations. */
  struct BodyUnknowns
  {
    Vector<double> velocity, force_density, frame_velocity;
  };

  /** One value for each unknown of a step, or for each of its equations. */
  struct CoupledUnknowns
  {
    FieldVector               velocity, pressure;
    std::vector<BodyUnknowns> bodies;
  };

  /**
   * The linear system of a step: momentum, continuity and all bodies at once,
   *   A du + B^T dq - sum_b G_b^T dPhi_b = r_u,   B du = r_p,   dq = -dp,
   *   and the BodyEquations.
   * The continuity equation is scaled as those of the bodies, by rho/dt, which makes all residuals
   * comparable to forces.
   */
  template <int dim>
  class CoupledEquations
  {
  public:
    CoupledEquations(const FluidSpace<dim> &space, const MomentumOperator<dim> &momentum,
                     const std::vector<BodyEquations<dim>> &bodies, const MomentumWeights &weights);

    /** The blocks velocity, pressure and, if there are bodies, their unknowns; scaled. */
    BlockFieldVector make_right_hand_side(const CoupledUnknowns &residual) const;

    /** The correction that a solution of the system stands for. */
    CoupledUnknowns extract_correction(const BlockFieldVector &solution) const;

    void vmult(BlockFieldVector &result, const BlockFieldVector &source) const;

    /** This rank's part of the matrix of velocities and bodies, without the pressure. */
    MatrixParts collect_matrix() const;

    /**
     * First unknowns of the groups that are eliminated together, and the number of all unknowns:
     * velocities of a node of the fluid, velocities or force densities of a node of a body.
     * At one node of a body in @p most_per_anchor at least, both are eliminated together.
     */
    std::vector<int> get_group_begins(unsigned int most_per_anchor) const;

    /** This rank's entries of all G, scale left out: their rows are those of dPhi's columns. */
    Triplets collect_interactions() const;

    /** The matrices of all bodies; numbered, as the rows of collect_interactions(), from 0. */
    Triplets collect_body_matrix() const;

    /** Places of all bodies' unknowns, and where their nodes are. */
    std::vector<BodyPlaces> get_body_places() const;

    /** Those of the bodies' unknowns that this rank has in vectors: about as many on each. */
    const IndexSet &get_owned_body_unknowns() const
    {
      return owned_body_unknowns;
    }

    /** forces += factor sum_b G_b^T dPhi_b, from the block of the @p bodies. Collective. */
    void add_forces(const FieldVector &bodies, double factor, FieldVector &forces) const;

  private:
    const MPI_Comm                         communicator;
    const unsigned int                     n_velocities;
    const MomentumOperator<dim>           &momentum;
    const std::vector<BodyEquations<dim>> &bodies;
    const double                           scale;
    std::vector<unsigned int>              begins; // of the bodies' unknowns, and their number
    IndexSet                               owned_body_unknowns;

    /** As add_forces(), from the bodies' unknowns that all ranks have. */
    void spread(const Vector<double> &values, double factor, FieldVector &forces) const;
  };
} // namespace caudal

#endif
