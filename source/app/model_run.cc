// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/app/model_run.h>
#include <caudal/base/collective.h>
#include <caudal/ideal/ideal_swimmer.h>
#include <caudal/passage/fish_passage.h>
#include <caudal/solid/elastic_body.h>
#include <caudal/viscous/immersed_swimmer.h>

#include <regex>

namespace caudal
{
  namespace
  {
    std::string get_value(const ParameterValues &values, const std::string &path)
    {
      const auto found = values.find(path);
      return found == values.end() ? "not there" : "<" + found->second + ">";
    }

    /**
     * What has changed since the parameters @p before: "Time/End time: 5 before, now 7". Throws
     * if one of them can't change in the middle of a run: @p fixed is a regular expression for
     * these entries.
     */
    std::vector<std::string> compare_parameters(const ParameterValues &before,
                                                const ParameterValues &now,
                                                const std::string     &fixed)
    {
      const std::regex fixed_entries(fixed);
      ParameterValues  all = now;
      all.insert(before.begin(), before.end());
      all.erase("Output/Folder"); // it may have been moved

      std::vector<std::string> changes;
      std::string              refused;
      for (const auto &entry : all)
      {
        const std::string &path      = entry.first;
        const std::string  old_value = get_value(before, path), new_value = get_value(now, path);
        if (old_value == new_value)
          continue;
        const bool is_of_file =
            path.size() > contents_ending.size() &&
            path.substr(path.size() - contents_ending.size()) == contents_ending;
        changes.push_back(path + ": " + old_value + " before, now " + new_value);
        if (is_of_file || std::regex_match(path, fixed_entries))
          refused += "\n  " + changes.back();
      }
      AssertThrow(
          refused.empty(),
          ExcMessage("A run can't be resumed with another grid, other bodies, other gaits, another "
                     "scheme or other input files. Leave these as they were, or start a new run:" +
                     refused));
      return changes;
    }
  } // namespace

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
    const OutputFolder folder(parameters.output.folder, communicator, OutputFolder::Start::fresh,
                              parameters.output.get_existing_results());
    return run(swimmer, folder, false, messages, stop_requested);
  }

  template <class Swimmer>
  bool ModelRun<Swimmer>::can_be_resumed() const
  {
    const std::string &folder = parameters.output.folder;
    return OutputFolder::find_progress(folder) != OutputFolder::Progress::none &&
           has_checkpoints(folder);
  }

  template <class Swimmer>
  Outcome ModelRun<Swimmer>::resume(const std::function<bool()> &stop_requested) const
  {
    const OutputFolder folder(parameters.output.folder, communicator, OutputFolder::Start::resume);
    const std::string &results = parameters.output.folder;
    const auto         slot    = read_newest_checkpoint(results, communicator);
    typename Swimmer::Checkpoint checkpoint;
    run_on_all(communicator, [&]() { read(slot, checkpoint); });
    std::ostringstream place;
    place << "Resumed from <" << slot.path << ">, t = " << checkpoint.time << " s.";
    std::vector<std::string> messages = slot.skipped;
    for (const std::string &damage : slot.damages)
      messages.push_back("Warning: " + damage);
    messages.push_back(place.str());
    for (const std::string &change :
         compare_parameters(checkpoint.parameters, values, Parameters::fixed_entries))
      messages.push_back("Changed: " + change);

    Swimmer swimmer(parameters, communicator);
    remove_checkpoints_after(results, checkpoint.step_number, communicator);
    swimmer.resume_from(std::move(checkpoint));
    return run(swimmer, folder, true, messages, stop_requested);
  }

  template <class Swimmer>
  Outcome ModelRun<Swimmer>::run(Swimmer &swimmer, const OutputFolder &folder,
                                 const bool is_resumed, const std::vector<std::string> &messages,
                                 const std::function<bool()> &stop_requested) const
  {
    folder.write_parameters(text);
    Log log(folder.add("log.txt"), communicator, is_resumed);
    if (figures.are_printed())
      log.keep_from_terminal(figures.with_warnings);
    log.print_banner();
    if (!folder.get_kept_results().empty())
      log << parameters.output.folder << " -> " << folder.get_kept_results()
          << " (results of an earlier run)" << std::endl;
    for (const std::string &message : messages)
      log << message << std::endl;
    swimmer.set_parameter_values(values);
    const Outcome outcome =
        folder.record([&]() { return swimmer.run(folder, log, stop_requested); });
    if (outcome == Outcome::finished)
      print_figures(figures, parameters.output.folder, communicator);
    return outcome;
  }

  template class ModelRun<ImmersedSwimmer<2>>;
  template class ModelRun<ImmersedSwimmer<3>>;
  template class ModelRun<IdealSwimmer>;

  // Without resume().
#define INSTANTIATE(Model)                                                                         \
  template ModelRun<Model>::ModelRun(const ParameterFile &, MPI_Comm);                             \
  template void    ModelRun<Model>::check(std::ostream &, bool) const;                             \
  template Outcome ModelRun<Model>::start(const std::function<bool()> &) const;
  INSTANTIATE(ElasticBody<2>)
  INSTANTIATE(ElasticBody<3>)
  INSTANTIATE(FishPassage)
#undef INSTANTIATE
} // namespace caudal
