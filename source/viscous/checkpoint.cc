// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/archive.h>
#include <caudal/fluid/snapshot_index.h>
#include <caudal/viscous/checkpoint.h>

#include <boost/serialization/utility.hpp>

namespace caudal
{
  namespace
  {
    // The parts of a checkpoint, as messages call them.
    const std::string time_part = "time or step", frame_part = "the grid's place",
                      bodies_part = "the bodies", solver_part = "what the solver has learnt";

    /** The bodies' states, and their initial positions, by which they are recognised. */
    using ArchivedBodies = std::vector<std::pair<BodyState, Vector<double>>>;

    /** The solver's memory, but for the transport velocity of its linearisation. */
    struct ArchivedSolver
    {
      bool          has_linearisation = false, has_transport = false;
      Linearisation linearisation;
      SolverMemory  memory;

      template <class Archive>
      void serialize(Archive &archive, unsigned int /*version*/)
      {
        archive &has_linearisation &has_transport &linearisation &memory.exact_iterations;
        archive &memory.steps_until_reuse &memory.reuse_pause;
      }
    };
  } // namespace

  void read(const CheckpointSlot &slot, Checkpoint &checkpoint)
  {
    unpack(slot.data, checkpoint);
    for (const std::string &bytes : slot.parts)
    {
      FluidSnapshot part;
      unpack(bytes, part);
      const auto append = [](const auto &more, auto &all) {
        all.insert(all.end(), more.begin(), more.end());
      };
      append(part.cells, checkpoint.fluid.cells);
      append(part.values, checkpoint.fluid.values);
    }
  }

  template <int dim>
  Checkpoint take_checkpoint(const Operators<dim> &operators, const State<dim> &state)
  {
    Checkpoint checkpoint;
    checkpoint.step_number = state.time.get_step_number();
    checkpoint.time        = state.time.get_time();

    ArchivedBodies bodies;
    for (unsigned int b = 0; b < state.bodies.size(); ++b)
      bodies.emplace_back(state.bodies[b],
                          operators.bodies[b]->get_solid().get_initial_positions());
    ArchivedSolver                   solver;
    std::vector<const FieldVector *> velocities = state.fluid.get_velocities();
    solver.memory                               = state.solver;
    if (const Linearisation *point = state.solver.linearisation.get())
    {
      solver.has_linearisation = true;
      solver.has_transport     = point->has_transport();
      solver.linearisation     = *point;
      if (solver.has_transport)
        velocities.push_back(&point->transport);
    }
    checkpoint.parts = {{time_part, pack(state.time)},
                        {frame_part, pack(state.frame)},
                        {bodies_part, pack(bodies)},
                        {solver_part, pack(solver)}};
    checkpoint.fluid = take_snapshot(operators.space, velocities, state.fluid.pressure);
    return checkpoint;
  }

  template <int dim>
  State<dim> restore(const Checkpoint &checkpoint, Operators<dim> &operators)
  {
    State<dim>     state{TimeStepper(operators.parameters.time), {}, {}, {}};
    ArchivedBodies bodies;
    ArchivedSolver solver;
    unpack(checkpoint.parts.at(time_part), state.time);
    unpack(checkpoint.parts.at(frame_part), state.frame);
    unpack(checkpoint.parts.at(bodies_part), bodies);
    unpack(checkpoint.parts.at(solver_part), solver);
    state.time.resume();
    for (unsigned int b = 0; b < operators.bodies.size(); ++b)
    {
      operators.bodies[b]->check_state(bodies[b].first, bodies[b].second);
      state.bodies.push_back(bodies[b].first);
    }
    state.solver = solver.memory;

    const SnapshotIndex<dim> fluid(checkpoint.fluid, operators.communicator);
    restore_grid(fluid, operators.parameters.domain, operators.triangulation);
    operators.reinit();
    const auto                 point      = std::make_shared<Linearisation>(solver.linearisation);
    std::vector<FieldVector *> velocities = state.fluid.get_velocities();
    if (solver.has_transport)
      velocities.push_back(&point->transport);
    restore_fields(fluid.extract(operators.triangulation), operators.space, velocities,
                   state.fluid.pressure);
    if (solver.has_linearisation)
      state.solver.linearisation = point;
    return state;
  }

  template Checkpoint take_checkpoint(const Operators<2> &, const State<2> &);
  template Checkpoint take_checkpoint(const Operators<3> &, const State<3> &);
  template State<2>   restore(const Checkpoint &, Operators<2> &);
  template State<3>   restore(const Checkpoint &, Operators<3> &);
} // namespace caudal
