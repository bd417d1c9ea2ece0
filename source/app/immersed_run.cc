#include <caudal/app/immersed_run.h>
#include <caudal/app/resume.h>

namespace caudal
{
  template <int dim>
  ImmersedRun<dim>::ImmersedRun(const ParameterFile &file, MPI_Comm communicator)
      : parameters(&file)
      , file(file)
      , communicator(communicator)
  {
    ParameterHandler prm;
    parameters.declare(prm);
    file.parse(prm);
    parameters.check();
    values = extract_values(prm);
    std::ostringstream out;
    prm.print_parameters(out, ParameterHandler::PRM);
    text = out.str();
  }

  template <int dim>
  void ImmersedRun<dim>::check(std::ostream &out, const bool fast) const
  {
    ImmersedSwimmer<dim>(parameters, communicator).check(out, fast);
  }

  template <int dim>
  Outcome ImmersedRun<dim>::start(const std::function<bool()> &stop_requested) const
  {
    // What can be wrong with the case is found before anything is written.
    ImmersedSwimmer<dim>     swimmer(parameters, communicator);
    std::vector<std::string> messages;
    for (const std::string &override_text : file.get_overrides())
      messages.push_back("Override: " + override_text);
    return run(swimmer, OutputFolder::Start::fresh, messages, stop_requested);
  }

  template <int dim>
  Outcome ImmersedRun<dim>::resume(const std::function<bool()> &stop_requested) const
  {
    const CheckpointFolder folder(parameters.output.folder, parameters.checkpoint.n_slots,
                                  communicator);
    const auto             checkpoint = folder.read_newest();
    RunState               state;
    unpack(checkpoint.data, state);
    std::ostringstream place;
    place << "Resumed from <" << checkpoint.path << ">, t = " << state.time << " s.";
    std::vector<std::string> messages = checkpoint.skipped;
    messages.push_back(place.str());
    for (const std::string &change : compare_parameters(state.parameters, values))
      messages.push_back("Changed: " + change);

    ImmersedSwimmer<dim> swimmer(parameters, communicator);
    folder.remove_after(state.step_number);
    swimmer.resume_from(std::move(state));
    return run(swimmer, OutputFolder::Start::resume, messages, stop_requested);
  }

  template <int dim>
  Outcome ImmersedRun<dim>::run(ImmersedSwimmer<dim> &swimmer, const OutputFolder::Start start,
                                const std::vector<std::string> &messages,
                                const std::function<bool()>    &stop_requested) const
  {
    const OutputFolder folder(parameters.output.folder, communicator, start);
    folder.write_parameters(text);
    Log log(folder.path("log.txt"), communicator, start == OutputFolder::Start::resume);
    log.print_banner();
    for (const std::string &message : messages)
      log << message << std::endl;
    swimmer.set_parameter_values(values);
    return swimmer.run(folder, log, stop_requested);
  }

  template class ImmersedRun<2>;
  template class ImmersedRun<3>;
} // namespace caudal
