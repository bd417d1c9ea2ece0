// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_state_h
#define caudal_viscous_state_h

#include <caudal/base/time_stepping.h>
#include <caudal/fluid/fluid_state.h>
#include <caudal/solid/body_state.h>
#include <caudal/viscous/frame.h>

#include <memory>

namespace caudal
{
  /**
   * The point about which the equations of a step are linearised: all that the matrix of its linear
   * system depends on, beside the grid.
   */
  struct Linearisation
  {
    MomentumWeights weights;
    /** Velocity of the convection, through the grid [m/s]; none if it and bodies are explicit. */
    FieldVector transport;

    struct Body
    {
      /** X* [m] and U* [m/s], the extrapolated positions and velocities. */
      Vector<double> positions, velocity;
      Contraction    contraction;

      template <class Archive>
      void serialize(Archive &archive, unsigned int /*version*/)
      {
        archive &positions &velocity &contraction;
      }
    };
    /** None if the forces of the bodies are explicit. */
    std::vector<Body> bodies;
    /** End of the step. */
    Instant end;
    /** Length of the step [s], and the weight of U in its time derivative [1/s]. */
    double step = 0, rate = 0;

    /** All but the transport velocity, whose numbering is that of a grid. */
    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &weights.inertia &weights.viscosity &weights.grad_div &weights.augmentation;
      archive &bodies &end.time &end.origin &step &rate;
    }

    bool has_transport() const
    {
      return transport.size() > 0;
    }

    /** Whether the matrix about @p other is the same one: so it is if nothing moves in it. */
    bool has_same_matrix(const Linearisation &other) const
    {
      return weights == other.weights && !has_transport() && !other.has_transport();
    }
  };

  /** What the linear solver has learnt from the steps so far. */
  struct SolverMemory
  {
    /** The point of the factorisation that the next step may reuse; null if there is none. */
    std::shared_ptr<const Linearisation> linearisation;
    /** The iterations that a factorisation of the very system took. */
    unsigned int exact_iterations = 0;
    /** Steps until an old factorisation is tried again, and the last number of them. */
    unsigned int steps_until_reuse = 0, reuse_pause = 1;
  };

  /**
   * Everything that outlives a step: time level, fields, bodies, and what the solver has learnt.
   * A step makes a new state of an old one (see advance()) and leaves that as it is; equal states
   * lead to equal ones, bit by bit. The fluid's fields are numbered by the grid of the operators.
   */
  template <int dim>
  struct State
  {
    TimeStepper            time;
    FluidState<dim>        fluid;
    std::vector<BodyState> bodies;
    SolverMemory           solver;
    Frame                  frame = {};

    Instant get_instant() const
    {
      return {time.get_time(), frame.origin};
    }
  };
} // namespace caudal

#endif
