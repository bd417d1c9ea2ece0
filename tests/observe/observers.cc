// SPDX-License-Identifier: LGPL-2.1-or-later
// Observers and guards of a user join those of the program by a registration; the order in which
// all are at work and what they declare; their states on the way to a checkpoint and back.

#include <caudal/observe/control_volume.h>
#include <caudal/observe/guard.h>

#include <iostream>

using namespace caudal;

namespace
{
  /** Largest speed that a run has seen. */
  template <int dim>
  class TopSpeed : public Observer<dim>
  {
  public:
    void add_parameters(ParameterHandler &prm) override
    {
      prm.enter_subsection("Top speed");
      prm.add_parameter("From", from, "Time from which on speeds count [s].");
      prm.leave_subsection();
    }
    void exchange_state(StateArchive &archive) override
    {
      archive &largest &n_steps;
    }
    double       from = 0.5, largest = 0;
    unsigned int n_steps = 0;
  };

  template <int dim>
  class FlowSpeed : public Guard<dim>
  {
  public:
    FlowSpeed()
        : Guard<dim>({"Largest speed", "Warn if the flow is faster; 0: never [m/s].", "the speed",
                      " m/s", "Slow down."},
                     3, [](const Observation<dim> &observation, const ObserverContext<dim> &) {
                       return observation.report.flow.largest_velocity;
                     })
    {}
  };

  const DimensionalRegistration<Observer, TopSpeed> top_speed("a top speed", "the largest speed");
  const DimensionalRegistration<Guard, FlowSpeed>   flow_speed("a flow speed", "too fast a flow");

  template <class Plugin>
  void print_names(const std::string &title)
  {
    std::cout << title << ":\n";
    for (const auto &[name, plugin] : PluginList<Plugin>())
      std::cout << "  " << name << '\n';
  }

  void print_error(const std::function<void()> &action)
  {
    try
    {
      action();
      std::cout << "no error\n";
    }
    catch (ExceptionBase &exception)
    {
      exception.print_info(std::cout);
    }
  }
} // namespace

int main()
{
  print_names<Observer<2>>("Observers");
  print_names<Guard<3>>("Guards");

  PluginList<Observer<2>> observers;
  ParameterHandler        prm;
  observers.add_parameters(prm);
  prm.enter_subsection("Top speed");
  prm.set("From", 0.75);
  prm.leave_subsection();
  prm.enter_subsection("Guards");
  prm.set("Largest speed", -1.);
  prm.leave_subsection();
  std::cout << "A copy for a run has the parameters: "
            << PluginList<Observer<2>>(observers).get<TopSpeed<2>>().from << '\n';
  print_error([&]() { observers.check(""); });
  prm.enter_subsection("Guards");
  prm.set("Largest speed", 0.);
  prm.leave_subsection();
  prm.enter_subsection("Fluid");
  prm.set("Control volume", "0, 0; 1, -1");
  prm.leave_subsection();
  print_error([&]() { observers.check(""); });

  TopSpeed<2> before, after;
  before.largest = 0.1 + 0.2;
  before.n_steps = 7;
  StateArchive written;
  before.exchange_state(written);
  StateArchive read(written.get_parts());
  after.exchange_state(read);
  std::cout << "Read back: " << (after.largest == before.largest) << ' ' << after.n_steps << '\n';
}
