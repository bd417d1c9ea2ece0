// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/app/model_run.h>
#include <caudal/app/resume.h>
#include <caudal/base/archive.h>
#include <caudal/ideal/ideal_swimmer.h>
#include <caudal/viscous/immersed_swimmer.h>

namespace caudal
{
  template <class Swimmer>
  ModelRun<Swimmer>::ModelRun(const ParameterFile &file, MPI_Comm communicator)
      : parameters(&file)
      , file(file)
      , communicator(communicator)
  {
    ParameterHandler prm;
    parameters.declare(prm);
    figures.add_parameters(prm);
    file.parse(prm);
    parameters.check();
    figures.check();
    remarks = file.get_remarks(prm);
    values  = extract_values(prm);
    std::ostringstream out;
    prm.print_parameters(out, ParameterHandler::PRM);
    text = out.str();
  }

  template <class Swimmer>
  void ModelRun<Swimmer>::check(std::ostream &out, const bool fast) const
  {
    for (const std::string &remark : remarks)
      out << remark << '\n';
    Swimmer swimmer(parameters, communicator);
    swimmer.start();
    swimmer.check(out, fast);
  }

  template <class Swimmer>
  Outcome ModelRun<Swimmer>::start(const std::function<bool()> &stop_requested) const
  {
    // What can be wrong with the case is found before anything is written.
    Swimmer swimmer(parameters, communicator);
    swimmer.start();
    std::vector<std::string> messages = remarks;
    for (const std::string &override_text : file.get_overrides())
      messages.push_back("Override: " + override_text);
    return run(swimmer, OutputFolder::Start::fresh, messages, stop_requested);
  }

  template <class Swimmer>
  Outcome ModelRun<Swimmer>::resume(const std::function<bool()> &stop_requested) const
  {
    const CheckpointFolder folder(parameters.output.folder, parameters.checkpoint.n_slots,
                                  communicator);
    const auto             slot = folder.read_newest();
    Checkpoint             checkpoint;
    unpack(slot.data, checkpoint);
    std::ostringstream place;
    place << "Resumed from <" << slot.path << ">, t = " << checkpoint.time << " s.";
    std::vector<std::string> messages = slot.skipped;
    messages.push_back(place.str());
    for (const std::string &change :
         compare_parameters(checkpoint.parameters, values, Parameters::fixed_entries))
      messages.push_back("Changed: " + change);

    Swimmer swimmer(parameters, communicator);
    folder.remove_after(checkpoint.step_number);
    swimmer.resume_from(std::move(checkpoint));
    return run(swimmer, OutputFolder::Start::resume, messages, stop_requested);
  }

  template <class Swimmer>
  Outcome ModelRun<Swimmer>::run(Swimmer &swimmer, const OutputFolder::Start start,
                                 const std::vector<std::string> &messages,
                                 const std::function<bool()>    &stop_requested) const
  {
    const OutputFolder folder(parameters.output.folder, communicator, start);
    folder.write_parameters(text);
    Log log(folder.path("log.txt"), communicator, start == OutputFolder::Start::resume);
    if (figures.are_printed())
      log.keep_from_terminal(figures.with_warnings);
    log.print_banner();
    for (const std::string &message : messages)
      log << message << std::endl;
    swimmer.set_parameter_values(values);
    const Outcome outcome = swimmer.run(folder, log, stop_requested);
    if (outcome == Outcome::finished)
      print_figures(figures, parameters.output.folder, communicator);
    return outcome;
  }

  template class ModelRun<ImmersedSwimmer<2>>;
  template class ModelRun<ImmersedSwimmer<3>>;
  template class ModelRun<IdealSwimmer>;
} // namespace caudal
