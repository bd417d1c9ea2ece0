// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_tail_beats_h
#define caudal_observe_tail_beats_h

#include <caudal/observe/observer.h>
#include <caudal/observe/swim_report.h>

#include <optional>

namespace caudal
{
  /** A SwimReport for each body that swims: in swim.txt or, with several bodies, swim_<body>.txt.
   */
  template <int dim>
  class TailBeats : public Observer<dim>
  {
  public:
    TailBeats()
        : Observer<dim>(90)
    {}

    void start(const Observation<dim> &, const ObserverContext<dim> &) override;
    void observe_step(const Observation<dim> &, const ObserverContext<dim> &) override;
    void finish(const Observation<dim> &, const ObserverContext<dim> &) override;
    void exchange_state(StateArchive &archive) override;
    void resume(const Observation<dim> &, const ObserverContext<dim> &) override;

    /** Period of the last beat of the first body that has made one [s]; 0 if there is none. */
    double get_last_period() const;

  private:
    std::vector<std::optional<SwimReport>> reports;       // none for bodies that do not swim
    std::vector<double>                    body_impulses; // forward, since the start [N s/m]

    SwimSample take_sample(const Observation<dim> &observation, const ObserverContext<dim> &context,
                           unsigned int body) const;
  };
} // namespace caudal

#endif
