// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/app/case_name.h>
#include <caudal/io/output_folder.h>

#include <deal.II/base/exceptions.h>

#include <filesystem>
#include <set>

namespace caudal
{
  namespace
  {
    namespace fs = std::filesystem;

    bool is_file(const fs::path &path)
    {
      std::error_code ignored;
      return fs::is_regular_file(path, ignored);
    }

    /** The files in prm/, there and in its folders, that are called like @p file; sorted. */
    std::set<std::string> find_cases(const fs::path &file)
    {
      std::set<std::string> cases;
      std::error_code       error;
      for (fs::recursive_directory_iterator entry("prm", error), end; !error && entry != end;
           entry.increment(error))
        if (entry->path().extension() == ".prm" && entry->path().stem() == file.stem())
          cases.insert(entry->path().string());
      return cases;
    }

    /** The parameter file that may be meant; empty if there is none. */
    std::string find_meant(const std::string &file)
    {
      if (is_file(file + ".prm"))
        return file + ".prm";
      const std::set<std::string> cases = find_cases(file);
      return cases.empty() ? "" : *cases.begin();
    }
  } // namespace

  void check_case_name(const std::string &file)
  {
    std::error_code ignored;
    const bool      is_run = fs::is_directory(file, ignored) &&
                        OutputFolder::find_progress(file) != OutputFolder::Progress::none;
    AssertThrow(!is_run, dealii::ExcMessage("<" + file +
                                            "> is no .prm file but a folder of results. To go on "
                                            "with its run give --resume " +
                                            file + "."));
    const std::string meant = fs::exists(file, ignored) ? "" : find_meant(file);
    AssertThrow(meant.empty(),
                dealii::ExcMessage("<" + file + "> is no .prm file. Did you mean " + meant + "?"));
  }
} // namespace caudal
