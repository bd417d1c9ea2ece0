#ifndef caudal_viscous_guards_h
#define caudal_viscous_guards_h

#include <caudal/viscous/run_output.h>

#include <map>

namespace caudal
{
  /**
   * Warns when a run leaves the limits within which its results can be
   * believed. Each kind of warning is written once for each body, with what it
   * may come from, and counted for the end of the run.
   */
  template <int dim>
  class Guards
  {
  public:
    explicit Guards(const GuardParameters &parameters);

    /** After each step. */
    void check(const Observation<dim> &observation, const EnergyLedger &ledger,
               const EnergyLedger &start, Log &log);

    /** How many steps were outside of which limit. */
    void print_summary(Log &log) const;

  private:
    struct Limit
    {
      const char *entry; // in section Guards
      std::string what;
      const char *unit;
      const char *hint;
    };

    const GuardParameters              &parameters;
    unsigned int                        n_steps = 0; // checked so far
    std::map<std::string, unsigned int> counts;      // steps, by what was measured

    /** A start at once is damped by the time scheme, and there is little other energy yet. */
    static constexpr unsigned int n_starting_steps = 10;

    void   check_body(const Observation<dim> &observation, const BodyObservation<dim> &body,
                      Log &log);
    void   warn(const Limit &limit, double value, double allowed, double time, Log &log);
    double compute_tether_displacement(const Observation<dim>     &observation,
                                       const BodyObservation<dim> &body) const;
  };
} // namespace caudal

#endif
