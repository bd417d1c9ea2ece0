// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/observers.h>

#include <caudal/base/collective.h>

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
      statistics.emplace(is_root ? folder.path("statistics.txt") : "",
                         is_resumed ? observation.time : -1);
    });
    for (const auto &[name, observer] : observers)
      observer->start(observation, *context);
  }

  template <int dim>
  void Observers<dim>::observe_step(const Observation<dim> &observation)
  {
    for (const auto &[name, observer] : observers)
      observer->observe_step(observation, *context);
    if (observation.step_number % context->output.statistics_interval == 0 || observation.is_last)
      write_row(observation);
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
    run_on_all(context->communicator, [&]() { statistics->write_row(); });
  }

  template class Observers<2>;
  template class Observers<3>;
} // namespace caudal
