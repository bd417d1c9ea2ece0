#ifndef caudal_base_factory_h
#define caudal_base_factory_h

#include <deal.II/base/exceptions.h>

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace caudal
{
  /**
   * A table of named creators of objects derived from @p Base: the way in
   * which a kernel, a stress, a muscle is chosen by its name in the .prm.
   */
  template <class Base, class... Args>
  class Factory
  {
  public:
    using Creator = std::function<std::unique_ptr<Base>(Args...)>;

    /** @p what names the kind of thing in the error message ("kernel"). */
    explicit Factory(std::string what, std::map<std::string, Creator> creators)
        : what(std::move(what))
        , creators(std::move(creators))
    {}

    /** The known names, separated by @p separator ('|' for Patterns::Selection). */
    std::string get_names(const std::string &separator = "|") const
    {
      std::string names;
      for (const auto &entry : creators)
        names += (names.empty() ? "" : separator) + entry.first;
      return names;
    }

    /** A new object of that name. */
    std::unique_ptr<Base> create(const std::string &name, Args... args) const
    {
      const auto entry = creators.find(name);
      AssertThrow(entry != creators.end(),
                  dealii::ExcMessage("There is no " + what + " called <" + name +
                                     ">. The known ones are: " + get_names(", ") + "."));
      return entry->second(std::forward<Args>(args)...);
    }

  private:
    const std::string                    what;
    const std::map<std::string, Creator> creators;
  };
} // namespace caudal

#endif
