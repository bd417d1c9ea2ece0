// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_field_observer_h
#define caudal_observe_field_observer_h

#include <caudal/observe/observer.h>

#include <optional>

namespace caudal
{
  /** The entry Interval of fields that are written at times of their own, or with the others. */
  class OwnInterval
  {
  public:
    /** @p path is that of the entry; @p fields, in the plural, are what it is for. */
    OwnInterval(const std::string &path, const std::string &fields)
        : path(path)
        , fields(fields)
    {}

    void add_parameter(ParameterHandler &prm);

    /** Throws if the entry is neither automatic nor a time. */
    void check() const;

    /** Simulated time between two outputs [s]; 0: every step. */
    double get(const OutputParameters &output) const;

  private:
    const std::string path, fields;
    std::string       interval = "automatic";
  };

  /**
   * An observer that writes fields at an interval, and at the end of the run, as files that a list
   * of its own holds together. What derives from it says how often, and writes what it has.
   */
  template <int dim>
  class FieldObserver : public Observer<dim>
  {
  public:
    /** @p list is the name of its list without the ending. */
    FieldObserver(const unsigned int place, const std::string &list)
        : Observer<dim>(place)
        , list(list)
    {}

    void start(const Observation<dim> &, const ObserverContext<dim> &) override;
    void observe_step(const Observation<dim> &, const ObserverContext<dim> &) override;
    void finish(const Observation<dim> &, const ObserverContext<dim> &) override;
    void exchange_state(StateArchive &) override;
    void resume(const Observation<dim> &, const ObserverContext<dim> &) override;

  protected:
    /** Whether the parameters ask for the fields. */
    virtual bool is_active() const = 0;

    /** Simulated time between two outputs [s]; 0: every step. */
    virtual double get_interval(const OutputParameters &output) const = 0;

    /** Writes all its fields by add(). Collective. */
    virtual void write_fields(const Observation<dim> &, const ObserverContext<dim> &) = 0;

    /** Writes the present field @p name, see FieldOutput::write(). Collective. */
    template <int patch_dim>
    void add(DataOutInterface<patch_dim, dim> &data_out, const std::string &name,
             const Observation<dim> &observation, const MPI_Comm field_communicator)
    {
      output->write(data_out, name, observation.time, n_outputs, field_communicator);
    }

  private:
    const std::string          list;
    std::optional<FieldOutput> output;
    FieldOutput::Series        series; // of the checkpoint
    std::string                format;
    unsigned int               n_outputs = 0;
    double                     last_time = -1; // [s]

    bool is_due(double time, double interval) const;
    void write(const Observation<dim> &, const ObserverContext<dim> &);
  };
} // namespace caudal

#endif
