// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_plugin_h
#define caudal_base_plugin_h

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace caudal
{
  using namespace dealii;

  /**
   * What can be chosen by its name in the parameter file: a material, a muscle, a kernel. It owns
   * its parameters, which it declares in a subsection named after it. A run works with copies.
   */
  class Plugin
  {
  public:
    virtual ~Plugin() = default;

    /** Declares its parameters in its own subsection, which @p prm is in. */
    virtual void add_parameters(ParameterHandler & /*prm*/) {}

    /** Throws a sentence about the first bad value; @p path is that of its subsection. */
    virtual void check(const std::string & /*path*/) const {}
  };

  /** The subsection with the parameters of a plug-in: `Bang-bang` for `bang-bang`. */
  std::string get_plugin_section(const std::string &name);

  /**
   * Declares the parameters of @p plugin in the subsection @p section of the one that @p prm is
   * in. A plug-in without parameters gets no subsection.
   */
  void declare_plugin(ParameterHandler &prm, const std::string &section, Plugin &plugin);

  /**
   * Loads shared libraries, whose plug-ins register themselves: @p files are separated by commas.
   * To be called before parameters are declared. Throws a sentence if a library can't be loaded
   * or if two plug-ins have the same name.
   */
  void load_libraries(const std::string &files);

  /** Declares the entry with the files that load_libraries() takes. */
  void declare_libraries(ParameterHandler &prm);

  /** Notes two plug-ins with the same name; an exception can't leave an initialisation. */
  void report_second_plugin(const std::string &name);

  /**
   * All members of the family @p Base, by name. Members register themselves when the program or a
   * user's library is loaded, so that a new one is known without a change elsewhere.
   */
  template <class Base>
  class Registry
  {
  public:
    struct Member
    {
      std::string                                        documentation;
      std::function<std::unique_ptr<Base>()>             create;
      std::function<std::unique_ptr<Base>(const Base &)> copy;
    };

    /** In alphabetical order, as the parameters are declared, whoever registers first. */
    static const std::map<std::string, Member> &get_members()
    {
      return members().by_name;
    }

    /** @p documentation is a part of a sentence, without a full stop. */
    template <class Derived>
    static void add(const std::string &name, const std::string &documentation)
    {
      const Member member{documentation, [] { return std::make_unique<Derived>(); },
                          [](const Base &other) {
                            return std::make_unique<Derived>(dynamic_cast<const Derived &>(other));
                          }};
      if (!members().by_name.emplace(name, member).second)
        report_second_plugin(name);
    }

    /** The names, separated by @p separator ('|' for Patterns::Selection). */
    static std::string get_names(const std::string &separator)
    {
      std::string names;
      for (const auto &member : members().by_name)
        names += (names.empty() ? "" : separator) + member.first;
      return names;
    }

  private:
    /** A type of its own, so that gcc and clang give the one object the same name. */
    struct Members
    {
      std::map<std::string, Member> by_name;
    };

    static Members &members()
    {
      static Members instance;
      return instance;
    }
  };

  /** Registers @p Derived as a member of the family @p Base: an object at namespace scope. */
  template <class Base, class Derived>
  struct Registration
  {
    Registration(const std::string &name, const std::string &documentation)
    {
      Registry<Base>::template add<Derived>(name, documentation);
    }
  };

  /** Registers a template on the space dimension for two and for three dimensions. */
  template <template <int> class Base, template <int> class Derived>
  struct DimensionalRegistration
  {
    DimensionalRegistration(const std::string &name, const std::string &documentation)
    {
      Registry<Base<2>>::template add<Derived<2>>(name, documentation);
      Registry<Base<3>>::template add<Derived<3>>(name, documentation);
    }
  };

  /**
   * An entry of the parameter file that chooses one member of the family @p Base. Each member has
   * a subsection for its own parameters beside the entry, named after it: `Bang-bang` for the
   * muscle `bang-bang`.
   */
  template <class Base>
  class Choice
  {
  public:
    /**
     * @p documentation begins the entry's description; those of the members follow. @p prefix
     * precedes the members' names in those of their subsections, where one section holds several
     * choices: with `left `, `Left inflow`.
     */
    Choice(std::string entry, std::string default_name, std::string documentation,
           std::string prefix = "")
        : entry(std::move(entry))
        , name(std::move(default_name))
        , documentation(std::move(documentation))
        , prefix(std::move(prefix))
    {
      for (const auto &[member_name, member] : Registry<Base>::get_members())
        members[member_name] = member.create();
    }

    /** The parameter handler keeps references to the parameters: a choice stays where it is. */
    Choice(const Choice &)            = delete;
    Choice &operator=(const Choice &) = delete;

    /** Declares the entry and the subsections in the section that @p prm is in. */
    void add_parameters(ParameterHandler &prm)
    {
      std::string text = documentation;
      for (const auto &[member_name, member] : Registry<Base>::get_members())
        text += (text == documentation ? " '" : "; '") + member_name + "': " + member.documentation;
      prm.add_parameter(entry, name, text + ".",
                        Patterns::Selection(Registry<Base>::get_names("|")));
      for (const auto &[member_name, member] : members)
        declare_plugin(prm, get_section(member_name), *member);
    }

    /** Checks the parameters of the chosen member; @p path is that of the section around it. */
    void check(const std::string &path) const
    {
      get().check(get_path(path));
    }

    /** The path of the chosen member's section; @p path is that of the section around it. */
    std::string get_path(const std::string &path) const
    {
      return path + "/" + get_section(name);
    }

    const std::string &get_name() const
    {
      return name;
    }

    /** Chooses another member, as the entry does. */
    void set_name(const std::string &new_name)
    {
      name = new_name;
    }

    /** The chosen member with its parameters. */
    const Base &get() const
    {
      const auto member = members.find(name);
      AssertThrow(member != members.end(),
                  ExcMessage(entry + ": there is nothing called <" + name +
                             ">. The known ones are: " + Registry<Base>::get_names(", ") + "."));
      return *member->second;
    }

    /** A copy of the chosen member, to be used in a run. */
    std::unique_ptr<Base> create() const
    {
      return Registry<Base>::get_members().at(name).copy(get());
    }

  private:
    const std::string                            entry;
    std::string                                  name;
    const std::string                            documentation, prefix;
    std::map<std::string, std::unique_ptr<Base>> members;

    std::string get_section(const std::string &member_name) const
    {
      return get_plugin_section(prefix + member_name);
    }
  };
} // namespace caudal

#endif
