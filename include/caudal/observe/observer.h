// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_observer_h
#define caudal_observe_observer_h

#include <caudal/base/plugin_list.h>
#include <caudal/io/field_output.h>
#include <caudal/io/log.h>
#include <caudal/io/output_folder.h>
#include <caudal/io/statistics.h>
#include <caudal/mesh/cell_lattice.h>
#include <caudal/observe/observation.h>
#include <caudal/observe/state_archive.h>

namespace caudal
{
  template <int dim>
  class Observer;

  /** What an observer has beside the observation: where results go, and the other observers. */
  template <int dim>
  struct ObserverContext
  {
    const MPI_Comm                   communicator;
    const OutputFolder              &folder;
    Log                             &log;
    const OutputParameters          &output;
    const PluginList<Observer<dim>> &others;
    /** Whether the run goes on from a checkpoint, in the folder of the run that wrote it. */
    bool is_resumed;
  };

  /**
   * An observer of a run: it tells what it finds in columns of statistics.txt, in the log or in
   * files of its own, and never writes into the model. All observers that are registered are at
   * work in the order of their places, which is also that of their columns; one that uses another
   * observer stands behind it. Those of the program have the places
   *   10 motion, 20 body forces, 30 deformation, 40 swimming, 50 control volume, 60 energies,
   *   70 probes, 80 error norms, 90 tail beats, 100 fields, 102 surfaces, 104 slices, 110 guards;
   * one that does not ask for a place comes last.
   *
   * Parameters are declared from the top level of the file, in a section of its own. All functions
   * are called on all ranks.
   */
  template <int dim>
  class Observer : public Plugin
  {
  public:
    explicit Observer(const unsigned int place = last_place)
        : place(place)
    {}

    const unsigned int place;

    /**
     * Throws a sentence if the case can't be observed as the parameters ask for: at the start, and
     * when it is resumed, since other observations may be asked for then.
     */
    virtual void check_case(const Observation<dim> & /*start*/) const {}

    /** Before the first step of a run, or of its part since it was resumed. */
    virtual void start(const Observation<dim> &, const ObserverContext<dim> &) {}

    /** After each step. */
    virtual void observe_step(const Observation<dim> &, const ObserverContext<dim> &) {}

    /** After each change of the grid between two steps. */
    virtual void observe_new_grid(const Observation<dim> &, const ObserverContext<dim> &) {}

    /** Sets the columns that it has for the body with the number @p body. */
    virtual void set_body_columns(const Observation<dim> &, unsigned int /*body*/,
                                  Statistics &) const
    {}

    /** Sets the columns that it has for the whole of fluid and bodies. */
    virtual void set_columns(const Observation<dim> &, Statistics &) const {}

    /** At the end of the run, even if it failed or was stopped. */
    virtual void finish(const Observation<dim> &, const ObserverContext<dim> &) {}

    /** In the end, what the user should know before believing the results. */
    virtual void print_warnings(Log &) const {}

    /** Writes or reads what later observations depend on. */
    virtual void exchange_state(StateArchive &) {}

    /**
     * After start() and the reading of the state: brings its files to what they were at the time
     * of the checkpoint.
     */
    virtual void resume(const Observation<dim> &, const ObserverContext<dim> &) {}
  };
} // namespace caudal

#endif
