#ifndef caudal_viscous_state_h
#define caudal_viscous_state_h

#include <caudal/base/time_stepping.h>
#include <caudal/fluid/fluid_state.h>
#include <caudal/solid/body_state.h>

#include <memory>

namespace caudal
{
  /**
   * The point about which the equations of a step are linearised: everything that the matrix of
   * its linear system depends on, beside the grid.
   */
  struct Linearisation
  {
    MomentumWeights weights;
    /** Velocity of the convection [m/s]; no unknowns: convection is explicit. */
    FieldVector transport;

    struct Body
    {
      /** X* [m] and U* [m/s], the extrapolated positions and velocities. */
      Vector<double> positions, velocity;
      Contraction    contraction;
    };
    /** None: the forces of the bodies are explicit. */
    std::vector<Body> bodies;
    /** Time at the end of the step and its length [s]; weight of U in its time derivative [1/s]. */
    double time = 0, step = 0, rate = 0;

    bool has_transport() const
    {
      return transport.size() > 0;
    }

    /** Archives everything but the transport velocity, whose numbering is that of a grid. */
    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/);
  };

  /** What the solver has learnt from the steps so far. */
  struct SolverMemory
  {
    /** That of the factorisation in use; null if the next step makes a new one. */
    std::shared_ptr<const Linearisation> linearisation;
    /** Iterations with a factorisation of the very system. */
    unsigned int exact_iterations = 0;
    /** Factorisations until an old one is tried again, and how many it was to wait last. */
    unsigned int steps_until_reuse = 0, reuse_pause = 1;
  };

  /** Everything that outlives a step. The fluid's fields belong to the grid of the operators. */
  struct State
  {};
} // namespace caudal

#endif
