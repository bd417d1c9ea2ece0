// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/observe/guard.h>

#include <boost/serialization/map.hpp>

namespace caudal
{
  template <int dim>
  void Guard<dim>::check(const std::string &path) const
  {
    check_not_negative(path + "/" + words.entry, limit, "Give a positive limit, or 0 for none.");
  }

  namespace
  {
    /**
     * Warns when a run leaves the limits of the guards. Each kind of warning is written once for
     * each body, with what it may come from, and counted for the end of the run.
     */
    template <int dim>
    class Guards : public Observer<dim>
    {
    public:
      Guards()
          : Observer<dim>(110)
      {}

      void add_parameters(ParameterHandler &prm) override
      {
        prm.enter_subsection("Guards");
        guards.add_parameters(prm);
        prm.leave_subsection();
      }

      void check(const std::string & /*path*/) const override
      {
        guards.check("Guards");
      }

      void observe_step(const Observation<dim>     &observation,
                        const ObserverContext<dim> &context) override
      {
        for (const auto &body : observation.bodies)
          for (const auto &[name, guard] : guards)
            if (const auto *measure = std::get_if<BodyMeasure>(&guard->measure))
              compare(*guard, (*measure)(observation, body), " of body " + body.body.get_name(),
                      observation.time, context.log);
        for (const auto &[name, guard] : guards)
          if (const auto *measure = std::get_if<Measure>(&guard->measure))
            compare(*guard, (*measure)(observation, context), "", observation.time, context.log);
      }

      void print_warnings(Log &log) const override
      {
        for (const auto &[what, count] : counts)
          log << "Warnings: " << what << " was outside of its limit in " << count
              << (count == 1 ? " step." : " steps.") << std::endl;
      }

      void exchange_state(StateArchive &archive) override
      {
        archive &counts;
      }

    private:
      using BodyMeasure = typename Guard<dim>::BodyMeasure;
      using Measure     = typename Guard<dim>::Measure;

      PluginList<Guard<dim>>              guards;
      std::map<std::string, unsigned int> counts; // steps, by what was measured

      void compare(const Guard<dim> &guard, const double value, const std::string &owner,
                   const double time, Log &log)
      {
        const auto       &words = guard.words;
        const std::string what  = words.quantity + owner;
        if (guard.is_violated(value) && ++counts[what] == 1)
          log << "Warning: at t = " << time << " s " << what << " is " << value << words.unit
              << " (Guards/" << words.entry << " = " << guard.get_limit() << "). " << words.hint
              << std::endl;
      }
    };

    const DimensionalRegistration<Observer, Guards> registration("guards", "limits of trust");
  } // namespace

  template class Guard<2>;
  template class Guard<3>;
} // namespace caudal
