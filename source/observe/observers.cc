// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/observers.h>

#include <caudal/base/collective.h>

#include <filesystem>

namespace caudal
{
  template <int dim>
  void Observers<dim>::check_case(const Observation<dim> &start) const
  {
    for (const auto &[name, observer] : observers)
      observer->check_case(start);
  }

  template <int dim>
  void Observers<dim>::start(const Observation<dim> &observation, const OutputFolder &folder,
                             Log &log, const OutputParameters &output, const bool is_resumed)
  {
    const MPI_Comm communicator = observation.space.get_communicator();
    context.emplace(ObserverContext<dim>{communicator, folder, log, output, observers, is_resumed});
    // Rank 0 alone writes to the tables; if it can't, all ranks must know.
    run_on_all(communicator, [&]() {
      const bool is_root = Utilities::MPI::this_mpi_process(communicator) == 0;
      statistics.emplace(is_root ? folder.add_table("statistics.txt") : "",
                         is_resumed ? observation.time : -1);
      if (!statistics->get_damaged_file().empty())
        folder.add(std::filesystem::path(statistics->get_damaged_file()).filename());
    });
    for (const std::string &damage : statistics->get_damages())
      log << "Warning: " << damage << std::endl;
    for (const auto &[name, observer] : observers)
      observer->start(observation, *context);
  }

  template <int dim>
  void Observers<dim>::resume(const Observation<dim> &observation)
  {
    for (const auto &[name, observer] : observers)
      observer->resume(observation, *context);
    const bool is_missing = !statistics->has_row_at(observation.time);
    if (observation.step_number > 0 && is_due(observation) &&
        Utilities::MPI::broadcast(context->communicator, is_missing))
      write_row(observation);
  }

  template <int dim>
  void Observers<dim>::observe_step(const Observation<dim> &observation)
  {
    // One that can't write must not keep the others from what they add up.
    std::string error;
    for (const auto &entry : observers)
    {
      Observer<dim>    &observer = *entry.second;
      const std::string failure =
          catch_error([&]() { observer.observe_step(observation, *context); });
      error = error.empty() ? failure : error;
    }
    AssertThrow(error.empty(), ExcMessage(error));
    if (is_due(observation))
      write_row(observation);
  }

  template <int dim>
  bool Observers<dim>::is_due(const Observation<dim> &observation) const
  {
    return observation.step_number % context->output.statistics_interval == 0 ||
           observation.is_last;
  }

  template <int dim>
  void Observers<dim>::observe_new_grid(const Observation<dim> &observation)
  {
    for (const auto &[name, observer] : observers)
      observer->observe_new_grid(observation, *context);
  }

  template <int dim>
  void Observers<dim>::finish(const Observation<dim> &observation)
  {
    for (const auto &[name, observer] : observers)
      observer->finish(observation, *context);
  }

  template <int dim>
  void Observers<dim>::print_warnings() const
  {
    for (const auto &[name, observer] : observers)
      observer->print_warnings(context->log);
  }

  /** The columns of the step, those of each body, and those of the whole. */
  template <int dim>
  void Observers<dim>::write_row(const Observation<dim> &observation)
  {
    const StepReport<dim> &report = observation.report;
    statistics->set("time", "s", observation.time);
    statistics->set("time step", "s", observation.step);
    statistics->set("iterations", "", report.iterations);
    statistics->set("cells", "", observation.space.get_triangulation().n_global_active_cells());
    statistics->set("CFL", "", report.indicators.convective_cfl);
    statistics->set("body CFL", "", report.indicators.body_cfl);
    statistics->set("max velocity", "m/s", report.flow.largest_velocity);
    statistics->set("divergence", "m/s", report.flow.divergence_norm);
    for (unsigned int body = 0; body < observation.bodies.size(); ++body)
      for (const auto &[name, observer] : observers)
        observer->set_body_columns(observation, body, *statistics);
    for (const auto &[name, observer] : observers)
      observer->set_columns(observation, *statistics);
    run_on_all(context->communicator, [&]() {
      const bool has_earlier = !statistics->get_earlier_file().empty();
      statistics->write_row();
      const std::filesystem::path earlier = statistics->get_earlier_file();
      if (has_earlier || earlier.empty())
        return;
      context->folder.add_table(earlier.filename());
      context->log
          << "The columns of the table changed: rows from here on stand in statistics.txt, "
          << "those before in " << earlier.filename().string() << "." << std::endl;
    });
  }

  template class Observers<2>;
  template class Observers<3>;
} // namespace caudal
