// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/declared_parameters.h>
#include <caudal/base/plugin.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <dlfcn.h>
#include <filesystem>

namespace caudal
{
  namespace
  {
    /** The name of the last plug-in that was registered under the name of another one. */
    std::string &second_plugin()
    {
      static std::string name;
      return name;
    }
  } // namespace

  std::string get_plugin_section(const std::string &name)
  {
    std::string section = name;
    section[0]          = static_cast<char>(std::toupper(static_cast<unsigned char>(section[0])));
    // deal.II's parameter handler, which writes all entries as JSON, takes it for a separator.
    section.erase(std::remove(section.begin(), section.end(), '.'), section.end());
    return section;
  }

  void declare_plugin(ParameterHandler &prm, const std::string &section, Plugin &plugin)
  {
    ParameterHandler trial;
    plugin.add_parameters(trial);
    if (extract_values(trial).empty())
      return;
    prm.enter_subsection(section);
    plugin.add_parameters(prm);
    prm.leave_subsection();
  }

  void report_second_plugin(const std::string &name)
  {
    second_plugin() = name;
  }

  void declare_libraries(ParameterHandler &prm)
  {
    prm.declare_entry("Libraries", "", Patterns::Anything(),
                      "Shared libraries with plug-ins of your own, separated by commas; see "
                      "examples/own_material.");
  }

  void load_libraries(const std::string &files)
  {
    for (const std::string &file : Utilities::split_string_list(files))
    {
      AssertThrow(std::filesystem::is_regular_file(file),
                  ExcMessage("Libraries: there is no file <" + file +
                             ">. Give the shared library's name with its folder."));
      // It is never closed: what it has registered is used until the end.
      const bool is_loaded =
          dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL) != nullptr;
      AssertThrow(is_loaded,
                  ExcMessage("Libraries: <" + file + "> can't be loaded (" +
                             std::string(dlerror()) +
                             "). Build it as a shared library against this version of Caudal."));
    }
    AssertThrow(second_plugin().empty(),
                ExcMessage("Libraries: two plug-ins of the same kind are called <" +
                           second_plugin() + ">. Give yours another name."));
  }
} // namespace caudal
