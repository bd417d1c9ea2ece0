#include <caudal/base/archive.h>
#include <caudal/base/collective.h>
#include <caudal/base/compatibility.h>
#include <caudal/viscous/checkpoints.h>

namespace caudal
{
  namespace
  {
    /** The bodies' states as one object to serialise. */
    template <int dim>
    struct Bodies
    {
      const std::vector<std::unique_ptr<SwimmingBody<dim>>> &bodies;

      template <class Archive>
      void serialize(Archive &archive, unsigned int /*version*/)
      {
        for (const auto &body : bodies)
          archive &*body;
      }
    };
  } // namespace

  template <int dim>
  Checkpoints<dim>::Checkpoints(const RunParameters<dim>                  &parameters,
                                parallel::distributed::Triangulation<dim> &triangulation,
                                FluidSpace<dim> &space, GridAdaptation<dim> &adaptation,
                                const ImmersedSystem<dim> &system)
      : parameters(parameters)
      , triangulation(triangulation)
      , space(space)
      , adaptation(adaptation)
      , system(system)
      , communicator(compatibility::get_communicator(triangulation))
      , writer(parameters.checkpoint, communicator)
  {}

  template <int dim>
  void Checkpoints<dim>::start(const OutputFolder &output_folder, const ParameterValues &new_values,
                               TimeStepper &new_stepper, RunOutput<dim> &new_output)
  {
    writer.start(output_folder.path());
    values  = new_values;
    stepper = &new_stepper;
    output  = &new_output;
  }

  template <int dim>
  bool Checkpoints<dim>::is_due() const
  {
    return writer.is_due(stepper->get_step_number());
  }

  template <int dim>
  RunState Checkpoints<dim>::take_state() const
  {
    RunState state;
    state.step_number     = stepper->get_step_number();
    state.time            = stepper->get_time();
    state.last_field_time = output->get_last_field_time();
    state.parameters      = values;
    state.fluid           = take_snapshot(space, system.fluid);
    state.stepper         = pack(*stepper);
    state.bodies          = pack(Bodies<dim>{system.bodies});
    state.output          = pack(*output);
    return state;
  }

  template <int dim>
  void Checkpoints<dim>::write(const bool goes_on)
  {
    if (writer.has_written(stepper->get_step_number()))
      return;
    TimerOutput::Scope timer_section(system.timer, "checkpoint");
    RunState           state = take_state();
    std::string        bytes = pack(state);
    writer.write(bytes, state.step_number, state.time);
    if (!goes_on)
      return;
    broadcast_text(bytes, communicator);
    unpack(bytes, state);
    restore(state);
  }

  template <int dim>
  void Checkpoints<dim>::restore(const RunState &state)
  {
    restore_grid(state.fluid, parameters.domain, triangulation);
    space.reinit();
    space.set_boundary_values(state.time);
    restore_fields(state.fluid, space, system.fluid);
    adaptation.set_up_operators();
    system.coupled_system.forget_history();

    Bodies<dim> bodies{system.bodies};
    unpack(state.bodies, bodies);
    unpack(state.stepper, *stepper);
    stepper->resume();
    // Rank 0 writes tables anew.
    run_on_all(communicator, [&]() { unpack(state.output, *output); });
  }

  template class Checkpoints<2>;
  template class Checkpoints<3>;
} // namespace caudal
