#ifndef caudal_base_plugin_h
#define caudal_base_plugin_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/parameter_handler.h>

#include <cctype>
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
   * its parameters, which it declares in a subsection named after it.
   */
  class Plugin
  {
  public:
    virtual ~Plugin() = default;

    /** Declares its parameters in its own subsection, which @p prm is in. */
    virtual void add_parameters(ParameterHandler & /*prm*/) {}

    /** Throws a sentence about the first bad value; @p path is the path of its subsection. */
    virtual void check(const std::string & /*path*/) const {}
  };

  /**
   * All members of the family @p Base, by name. Members register themselves as the program or a
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

    static const std::map<std::string, Member> &get_members()
    {
      return members();
    }

    template <class Derived>
    static void add(const std::string &name, const std::string &documentation)
    {
      const bool is_new =
          members()
              .insert({name,
                       {documentation, []() { return std::make_unique<Derived>(); },
                        [](const Base &other) {
                          return std::make_unique<Derived>(static_cast<const Derived &>(other));
                        }}})
              .second;
      AssertThrow(is_new, ExcMessage("Two plug-ins of the same kind are called <" + name +
                                     ">. Give yours another name."));
    }

  private:
    static std::map<std::string, Member> &members()
    {
      static std::map<std::string, Member> map;
      return map;
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
    /** @p documentation begins the entry's description; those of the members follow. */
    Choice(std::string entry, std::string default_name, std::string documentation)
        : entry(std::move(entry))
        , name(std::move(default_name))
        , documentation(std::move(documentation))
    {
      for (const auto &[member_name, member] : Registry<Base>::get_members())
        members[member_name] = member.create();
    }

    /** Declares the entry and the subsections in the section that @p prm is in. */
    void add_parameters(ParameterHandler &prm)
    {
      std::string names, text = documentation;
      for (const auto &[member_name, member] : Registry<Base>::get_members())
      {
        names += (names.empty() ? "" : "|") + member_name;
        text += (names == member_name ? " '" : "; '") + member_name + "': " + member.documentation;
      }
      prm.add_parameter(entry, name, text + ".", Patterns::Selection(names));
      for (const auto &[member_name, member] : members)
      {
        prm.enter_subsection(get_section(member_name));
        member->add_parameters(prm);
        prm.leave_subsection();
      }
    }

    /** Checks the parameters of the chosen member; @p path is that of the section around it. */
    void check(const std::string &path) const
    {
      get().check(path + "/" + get_section(name));
    }

    const std::string &get_name() const
    {
      return name;
    }

    /** The chosen member with its parameters. */
    const Base &get() const
    {
      const auto member = members.find(name);
      AssertThrow(member != members.end(),
                  ExcMessage(entry + ": there is nothing called <" + name + ">."));
      return *member->second;
    }

    /** A copy of the chosen member, to be used in a run. */
    std::unique_ptr<Base> create() const
    {
      return Registry<Base>::get_members().at(name).copy(get());
    }

    /** The subsections of the members that are not chosen: what is set there has no effect. */
    std::vector<std::string> get_idle_sections() const
    {
      std::vector<std::string> sections;
      for (const auto &member : members)
        if (member.first != name)
          sections.push_back(get_section(member.first));
      return sections;
    }

  private:
    const std::string                            entry;
    std::string                                  name;
    const std::string                            documentation;
    std::map<std::string, std::unique_ptr<Base>> members;

    static std::string get_section(std::string member_name)
    {
      member_name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(member_name[0])));
      return member_name;
    }
  };
} // namespace caudal

#endif
