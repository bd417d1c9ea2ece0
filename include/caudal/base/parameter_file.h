#ifndef caudal_base_parameter_file_h
#define caudal_base_parameter_file_h

#include <deal.II/base/parameter_handler.h>

#include <set>
#include <string>
#include <vector>

namespace caudal
{
  using namespace dealii;

  /**
   * A parameter file (.prm) with everything that it includes, and the
   * overrides of the command line, read once and kept as a list of assignments
   * together with the place where each was made.
   *
   * The syntax is that of ParameterHandler: "subsection Name", "end",
   * "set Entry = value", "include other.prm" (relative to the folder of the
   * including file), "#" starts a comment and a backslash at the end of a line
   * continues it on the next. The last value wins; overrides of the form
   * "Section/Subsection/Entry=value" come after all files.
   *
   * Contrary to ParameterHandler::parse_input(), what is wrong is reported with
   * the line of the file in which it stands, through any depth of includes,
   * and together with what would have been right.
   */
  class ParameterFile
  {
  public:
    /** Reads @p file; a file that cannot be read or understood throws. */
    explicit ParameterFile(const std::string &file, const std::vector<std::string> &overrides = {});

    /**
     * The last value given to an entry ("Section/Subsection/Entry"), or
     * @p default_value: without declarations, for the entries that decide
     * which sections are declared.
     */
    std::string get(const std::string &path, const std::string &default_value) const;

    /**
     * Gives all values to the declared parameters. Throws one exception that
     * lists every unknown section or entry, every value that does not match
     * its pattern and every required entry that was not given.
     */
    void parse(ParameterHandler &prm) const;

    /** The overrides, as they were given. */
    const std::vector<std::string> &get_overrides() const
    {
      return overrides;
    }

  private:
    /** The names of the sections around an entry, the outermost first. */
    using Sections = std::vector<std::string>;

    /** An entry that is set, or a section that is opened (then entry is empty). */
    struct Assignment
    {
      Sections    sections;
      std::string entry;
      std::string value;
      std::string origin; // "fish.prm:12" or the override
    };

    void read(const std::string &file, const std::string &included_from, Sections sections,
              std::set<std::string> &open_files);
    void read_override(const std::string &text);

    std::vector<std::string> overrides;
    std::vector<Assignment>  assignments;
  };
} // namespace caudal

#endif
