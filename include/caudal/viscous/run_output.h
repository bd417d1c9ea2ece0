#ifndef caudal_viscous_run_output_h
#define caudal_viscous_run_output_h

#include <caudal/io/log.h>
#include <caudal/io/output_folder.h>
#include <caudal/io/statistics.h>
#include <caudal/observe/swim_report.h>
#include <caudal/viscous/force_account.h>
#include <caudal/viscous/parameters.h>

#include <optional>

namespace caudal
{
  /** Until when a resumed run keeps what was written before [s]. */
  struct KeptResults
  {
    double until  = -1;
    double fields = -1;
  };

  /** Writes what a run finds: fields, statistics.txt and the tables of tail beats. */
  template <int dim>
  class RunOutput
  {
  public:
    RunOutput(const RunParameters<dim> &parameters, const Observation<dim> &observation,
              const OutputFolder &folder, Log &log, const std::optional<KeptResults> &kept = {});

    /** After each step: updates ledger and reports, writes a row and fields if they are due. */
    void report_step(const Observation<dim> &observation);

    /** After each change of the grid between two steps. */
    void report_new_grid(const Observation<dim> &observation);

    /** The state as fields, whether they are due or not; not twice at the same time. */
    void write_fields(const Observation<dim> &observation);

    void finish();

    const EnergyLedger &get_ledger() const
    {
      return ledger;
    }
    const EnergyLedger &get_initial_ledger() const
    {
      return initial_ledger;
    }
    double get_last_field_time() const
    {
      return last_field_time;
    }

    /** What later reports depend on. */
    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &ledger &initial_ledger &body_impulses        &forces;
      archive &last_dissipation &last_numerical_dissipation &last_external_power;
      archive &n_field_outputs                              &last_field_time;
      for (const auto &report : swim_reports)
        if (report)
        {
          archive &*report;
          if (Archive::is_loading::value)
            report->resume();
        }
    }

    /** Of the last tail beat of the first body that has made one [s]; 0 if there is none. */
    double get_last_beat_period() const;

  private:
    const RunParameters<dim>                &parameters;
    Log                                     &log;
    Statistics                               statistics;
    FieldOutput                              field_output;
    std::vector<std::unique_ptr<SwimReport>> swim_reports;
    std::vector<Tensor<1, dim>>              initial_centers;
    ForceAccount<dim>                        forces;
    EnergyLedger                             ledger, initial_ledger;
    std::vector<double>                      body_impulses;                  // forward [N s/m]
    double                                   last_dissipation           = 0; // [W/m]
    double                                   last_numerical_dissipation = 0; // [W/m]
    double                                   last_external_power        = 0; // [W/m]
    unsigned int                             n_field_outputs            = 0;
    double                                   last_field_time            = -1;

    SwimmerConstants get_constants(const Body<dim> &body) const;
    void             update_ledger(const Observation<dim> &observation);
    void             update_forces(const Observation<dim> &observation);
    bool             fields_are_due(double time) const;
    void             report_swimming(const Observation<dim> &observation);
    void             write_statistics(const Observation<dim> &observation);
    void             set_probe_statistics(const Observation<dim> &observation);
    void             set_body_statistics(const Observation<dim> &observation, unsigned int body);
    void             write_fluid(const Observation<dim> &observation);
    void write_body(const Observation<dim> &observation, const BodyObservation<dim> &observed);
  };
} // namespace caudal

#endif
