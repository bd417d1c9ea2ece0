// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_plugin_list_h
#define caudal_base_plugin_list_h

#include <caudal/base/plugin.h>

#include <algorithm>

namespace caudal
{
  /** The place of plug-ins that do not ask for another one: behind all others. */
  constexpr unsigned int last_place = 1000;

  /**
   * One of each member of the family @p Base: of plug-ins that are all at work in a run, such as
   * guards. They stand in the order of their `place`, those of the same place by name.
   */
  template <class Base>
  class PluginList
  {
  public:
    PluginList()
    {
      for (const auto &[name, member] : Registry<Base>::get_members())
        plugins.emplace_back(name, member.create());
      std::stable_sort(plugins.begin(), plugins.end(), [](const auto &a, const auto &b) {
        return a.second->place < b.second->place;
      });
    }

    /** Copies the plug-ins, to be used in a run. */
    PluginList(const PluginList &other)
    {
      for (const auto &[name, plugin] : other.plugins)
        plugins.emplace_back(name, Registry<Base>::get_members().at(name).copy(*plugin));
    }

    /** Lets each plug-in declare its parameters in the section that @p prm is in. */
    void add_parameters(ParameterHandler &prm)
    {
      for (const auto &named : plugins)
        named.second->add_parameters(prm);
    }

    /** Lets each plug-in check its parameters; @p path is that of the section. */
    void check(const std::string &path) const
    {
      for (const auto &named : plugins)
        named.second->check(path);
    }

    /** The plug-in of the class @p Derived. */
    template <class Derived>
    const Derived &get() const
    {
      for (const auto &named : plugins)
        if (const auto *derived = dynamic_cast<const Derived *>(named.second.get()))
          return *derived;
      Assert(false, ExcMessage("There is no such plug-in."));
      throw ExcInternalError();
    }

    /** Pairs of a name and a plug-in. */
    auto begin() const
    {
      return plugins.begin();
    }
    auto end() const
    {
      return plugins.end();
    }

  private:
    std::vector<std::pair<std::string, std::unique_ptr<Base>>> plugins;
  };
} // namespace caudal

#endif
