// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_parameter_file_h
#define caudal_base_parameter_file_h

#include <caudal/base/declared_parameters.h>

#include <set>
#include <string>
#include <vector>

namespace caudal
{
  using namespace dealii;

  /** An entry or a section that had another name in an earlier version. */
  struct RenamedEntry
  {
    /** Path of the entry; a `*` stands for any part of a name, as in `Body *` with what follows. */
    std::string old_path;
    /** In the same order, each `*` stands for what it stood for in the old path. */
    std::string new_path;
    /** If given, only this value is meant, and has another name, too. */
    std::string old_value = "", new_value = "";
  };

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
     * Takes what was set by a former name as if it had been set by the present one; of the names
     * that fit, the first counts. Throws if a file sets both.
     */
    void rename(const std::vector<RenamedEntry> &renamed_entries);

    /** Sentences about the former names that rename() has found, with their places. */
    const std::vector<std::string> &get_hints() const
    {
      return hints;
    }

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

    /**
     * Sentences about the entries that have been set for plug-ins which @p prm, after parse(), does
     * not choose, to other than their default values. It is right if a file sets them together with
     * its choice, and one that includes it chooses something else.
     */
    std::vector<std::string> find_idle_entries(const ParameterHandler &prm) const;

    /** The hints of rename() and the warnings of find_idle_entries(), a line of the log each. */
    std::vector<std::string> get_remarks(const ParameterHandler &prm) const;

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
      bool        is_override = false;
      /** Whether entries of this section were renamed, which itself may exist no more. */
      bool is_former = false;
    };

    void read(const std::string &file, const std::string &included_from, Sections sections,
              std::set<std::string> &open_files);
    void read_override(const std::string &text);

    static std::string get_path(const Assignment &assignment);

    void rename(Assignment &assignment, const RenamedEntry &renamed,
                const std::vector<Assignment> &original);
    /** Whether the file of the assignment sets the entry @p path to @p value. */
    bool is_set_beside(const Assignment &assignment, const std::string &path,
                       const std::string &value) const;
    /** Gives the value to @p prm; returns what is wrong, or nothing. */
    std::string find_problem(const Assignment &assignment, const DeclaredSection &declared,
                             ParameterHandler &prm) const;

    std::vector<std::string> overrides;
    std::vector<Assignment>  assignments;
    std::vector<std::string> hints;
  };
} // namespace caudal

#endif
