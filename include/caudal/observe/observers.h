// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_observers_h
#define caudal_observe_observers_h

#include <caudal/observe/observer.h>

#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <optional>

namespace caudal
{
  /** All observers of a run, and the table statistics.txt that they fill. */
  template <int dim>
  class Observers
  {
  public:
    Observers() = default;

    /** Observers with the same parameters, for another run. */
    Observers(const Observers &other)
        : observers(other.observers)
    {}

    void add_parameters(ParameterHandler &prm)
    {
      observers.add_parameters(prm);
    }
    void check() const
    {
      observers.check("");
    }

    /** Throws a sentence if the case can't be observed as the parameters ask for. Collective. */
    void check_case(const Observation<dim> &start) const;

    /**
     * Opens the files, before the first step or, in a resumed run, before the state of the
     * observers is read back. Collective, as all that follows.
     */
    void start(const Observation<dim> &observation, const OutputFolder &folder, Log &log,
               const OutputParameters &output, bool is_resumed);

    /**
     * After the state of the observers was read: brings tables and lists to the time of the
     * checkpoint, and writes what had failed to be written then.
     */
    void resume(const Observation<dim> &observation);

    void observe_step(const Observation<dim> &observation);
    void observe_new_grid(const Observation<dim> &observation);

    /** At the end of the run, even if it failed or was stopped. */
    void finish(const Observation<dim> &observation);

    /** In the end, what the user should know before believing the results. */
    void print_warnings() const;

    /** The observer of the class @p Derived. */
    template <class Derived>
    const Derived &get() const
    {
      return observers.template get<Derived>();
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      std::map<std::string, std::vector<std::string>> states;
      for (const auto &[name, observer] : observers)
      {
        StateArchive state;
        observer->exchange_state(state);
        states[name] = state.get_parts();
      }
      archive &states;
      // An observer that the checkpoint does not know begins with the resumed run.
      for (const auto &[name, observer] : observers)
        if (Archive::is_loading::value && states.count(name) > 0)
        {
          StateArchive state(states[name]);
          observer->exchange_state(state);
        }
    }

  private:
    PluginList<Observer<dim>>           observers;
    std::optional<ObserverContext<dim>> context;
    std::optional<Statistics>           statistics;

    bool is_due(const Observation<dim> &observation) const; // a row
    void write_row(const Observation<dim> &observation);
  };
} // namespace caudal

#endif
