// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/observe/field_observer.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    const std::string remedy_of_interval = "Give automatic or a time [s].";
  }

  void OwnInterval::add_parameter(ParameterHandler &prm)
  {
    prm.add_parameter("Interval", interval,
                      "Simulated time between two outputs of the " + fields +
                          " [s]; 0: every step; automatic: that of the fields.");
  }

  void OwnInterval::check() const
  {
    if (const auto time = read_unless_automatic(path, interval, remedy_of_interval))
      check_not_negative(path, *time, remedy_of_interval);
  }

  double OwnInterval::get(const OutputParameters &output) const
  {
    return read_unless_automatic(path, interval, remedy_of_interval)
        .value_or(output.field_interval);
  }

  template <int dim>
  void FieldObserver<dim>::start(const Observation<dim>     &observation,
                                 const ObserverContext<dim> &context)
  {
    format = context.output.format;
    if (context.is_resumed || !is_active())
      return;
    output.emplace(context.folder, format, context.communicator, series, list);
    write(observation, context);
  }

  template <int dim>
  void FieldObserver<dim>::observe_step(const Observation<dim>     &observation,
                                        const ObserverContext<dim> &context)
  {
    if (observation.is_last || is_due(observation.time, get_interval(context.output)))
      write(observation, context);
  }

  template <int dim>
  void FieldObserver<dim>::finish(const Observation<dim>     &observation,
                                  const ObserverContext<dim> &context)
  {
    write(observation, context);
  }

  template <int dim>
  void FieldObserver<dim>::exchange_state(StateArchive &archive)
  {
    if (output)
      series = output->get_series();
    archive &n_outputs &last_time &format &series;
  }

  template <int dim>
  void FieldObserver<dim>::resume(const Observation<dim>     &observation,
                                  const ObserverContext<dim> &context)
  {
    if (!is_active())
      return;
    if (format != context.output.format) // a new list begins
      series.clear();
    format = context.output.format;
    output.emplace(context.folder, format, context.communicator, series, list);
    for (const std::string &sentence : output->find_missing_files())
      context.log << "Warning: " << sentence << std::endl;
    // Their writing may have been what ended the run.
    if (is_due(observation.time, get_interval(context.output)))
      write(observation, context);
  }

  /** Whether a multiple of the interval was passed since the last, maybe additional, output. */
  template <int dim>
  bool FieldObserver<dim>::is_due(const double time, const double interval) const
  {
    const auto count = [&](const double t) { return std::floor(t / interval * (1 + 1e-9)); };
    return interval == 0 || count(time) > count(last_time);
  }

  /** The present fields, unless they were written. */
  template <int dim>
  void FieldObserver<dim>::write(const Observation<dim>     &observation,
                                 const ObserverContext<dim> &context)
  {
    if (!output || observation.time == last_time)
      return;
    write_fields(observation, context);
    last_time = observation.time;
    ++n_outputs;
  }

  template class FieldObserver<2>;
  template class FieldObserver<3>;
} // namespace caudal
