// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/collective.h>
#include <caudal/base/safe_file.h>
#include <caudal/io/figures.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/utilities.h>

#include <boost/algorithm/string.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

using namespace dealii;

namespace caudal
{
  namespace
  {
    const std::string entry = "Output/Figures/Print";

    /** The columns of a file by their names, without the rows before the start. */
    struct Table
    {
      std::string                                file;
      std::map<std::string, std::vector<double>> columns;
      std::vector<double>                        times; // [s]; none in a summary
    };

    using Values = std::vector<double>;

    double get_smallest(const Values &values)
    {
      return *std::min_element(values.begin(), values.end());
    }

    double get_largest(const Values &values)
    {
      return *std::max_element(values.begin(), values.end());
    }

    /** The frequency of upward passages through the middle of the range; 0: fewer than two. */
    double compute_frequency(const Values &times, const Values &values)
    {
      const double level = 0.5 * (get_smallest(values) + get_largest(values));
      Values       passages;
      for (std::size_t i = 1; i < std::min(times.size(), values.size()); ++i)
        if (values[i - 1] < level && values[i] >= level)
          passages.push_back(times[i - 1] + (level - values[i - 1]) / (values[i] - values[i - 1]) *
                                                (times[i] - times[i - 1]));
      return passages.size() < 2 ? 0.
                                 : (passages.size() - 1) / (passages.back() - passages.front());
    }

    /** What makes one number of many. */
    using Statistic = double (*)(const Values &times, const Values &values);

    const std::map<std::string, Statistic> statistics = {
        {"first", [](const Values &, const Values &v) { return v.front(); }},
        {"last", [](const Values &, const Values &v) { return v.back(); }},
        {"smallest", [](const Values &, const Values &v) { return get_smallest(v); }},
        {"largest", [](const Values &, const Values &v) { return get_largest(v); }},
        {"mean",
         [](const Values &, const Values &v) {
           return std::accumulate(v.begin(), v.end(), 0.) / v.size();
         }},
        {"amplitude",
         [](const Values &, const Values &v) { return 0.5 * (get_largest(v) - get_smallest(v)); }},
        {"frequency", compute_frequency}};

    std::string strip_unit(const std::string &header)
    {
      return Utilities::trim(header.substr(0, header.rfind(" [")));
    }

    /** The numbers of a row of summary.csv; not a number where the cell is blank, or a text. */
    Values read_cells(const std::string &line)
    {
      std::vector<std::string> cells;
      boost::split(cells, line, boost::is_any_of(","));
      Values row;
      for (const std::string &cell : cells)
      {
        double value;
        row.push_back(std::istringstream(cell) >> value ? value
                                                        : std::numeric_limits<double>::quiet_NaN());
      }
      return row;
    }

    /** The table in statistics*.txt, "# n: name [unit]" and rows, or in summary.csv. */
    Table read_table(const std::filesystem::path &path, const double start)
    {
      Table                    table{path.filename().string(), {}, {}};
      const bool               is_summary = path.extension() == ".csv";
      std::vector<std::string> names;
      std::istringstream       file(read_whole_file(path));
      for (std::string line; std::getline(file, line);)
        if (line.rfind("# ", 0) == 0)
          names.push_back(strip_unit(line.substr(line.find(": ") + 2)));
        else if (is_summary && names.empty())
          for (const std::string &header : Utilities::split_string_list(line))
            names.push_back(strip_unit(header));
        else
        {
          std::istringstream numbers(line);
          const Values       row =
              is_summary ? read_cells(line) : Values{std::istream_iterator<double>(numbers), {}};
          if (row.size() != names.size() ||
              (!is_summary && row[0] < start - 1e-9 * std::abs(start)))
            continue;
          for (std::size_t k = 0; k < names.size(); ++k)
            table.columns[names[k]].push_back(row[k]);
          if (!is_summary)
            table.times.push_back(row[0]);
        }
      return table;
    }

    /** The names in brackets. */
    std::vector<std::string> find_columns(const std::string &text)
    {
      std::set<std::string> names;
      for (auto open = text.find('['); open != std::string::npos; open = text.find('[', open + 1))
      {
        const auto close = text.find(']', open);
        AssertThrow(close != std::string::npos,
                    ExcMessage(entry + ": in <" + text + "> a bracket is not closed."));
        names.insert(text.substr(open + 1, close - open - 1));
      }
      return {names.begin(), names.end()};
    }

    /** An expression of x, y, z and t. */
    std::unique_ptr<FunctionParser<3>> parse(const std::string &expression)
    {
      auto function = std::make_unique<FunctionParser<3>>(1);
      try
      {
        function->initialize("x,y,z,t", expression, {{"pi", numbers::PI}}, true);
        function->value(Point<3>());
      }
      catch (const std::exception &)
      {
        AssertThrow(false,
                    ExcMessage(entry + ": <" + expression +
                               "> is no valid expression. Columns stand in brackets, within one of "
                               "the functions first, last, smallest, largest, mean, amplitude and "
                               "frequency; x, y, z stand for them in this message."));
      }
      return function;
    }

    /** The expression of up to three columns, in each row that has values of all of them. */
    Values evaluate_rows(std::string expression, const Table &table)
    {
      const auto names = find_columns(expression);
      AssertThrow(!names.empty() && names.size() <= 3,
                  ExcMessage(entry + ": in <" + expression + "> there are " +
                             std::to_string(names.size()) +
                             " columns in brackets. Give one to three within a function."));
      for (std::size_t k = 0; k < names.size(); ++k)
        for (std::size_t at; (at = expression.find("[" + names[k] + "]")) != std::string::npos;)
          expression.replace(at, names[k].size() + 2, 1, "xyz"[k]);
      const auto function = parse(expression);
      Values     values;
      for (std::size_t i = 0; i < table.columns.at(names[0]).size(); ++i)
      {
        Point<3> row;
        for (std::size_t k = 0; k < names.size(); ++k)
          row[k] = table.columns.at(names[k])[i];
        function->set_time(table.times.empty() ? 0. : table.times[i]);
        if (std::isfinite(row.norm()))
          values.push_back(function->value(row));
      }
      AssertThrow(!values.empty(), ExcMessage(entry + ": <" + table.file +
                                              "> has no row. Check Output/Figures/From time."));
      return values;
    }

    /** The position behind the parenthesis that closes the one at @p open. */
    std::size_t find_end(const std::string &text, const std::size_t open)
    {
      int depth = 0;
      for (std::size_t i = open; i < text.size(); ++i)
        if ((depth += (text[i] == '(') - (text[i] == ')')) == 0)
          return i + 1;
      AssertThrow(false, ExcMessage(entry + ": in <" + text + "> a parenthesis is not closed."));
      return text.size();
    }

    /** The value of an expression in which functions make numbers of columns. */
    double evaluate(const std::string &expression, const Table &table)
    {
      const auto check = [&](const double value) {
        AssertThrow(std::isfinite(value), ExcMessage(entry + ": <" + expression +
                                                     "> is not a finite number. Columns and "
                                                     "t stand within a function."));
        return value;
      };
      std::string text = expression;
      for (const auto &[name, statistic] : statistics)
        for (std::size_t at; (at = text.find(name + "(")) != std::string::npos;)
        {
          const std::size_t  open = at + name.size(), end = find_end(text, open);
          const Values       values = evaluate_rows(text.substr(open, end - open), table);
          std::ostringstream number;
          number << std::setprecision(17) << '(' << check(statistic(table.times, values)) << ')';
          text.replace(at, end - at, number.str());
        }
      const double none     = std::numeric_limits<double>::quiet_NaN();
      const auto   function = parse(text);
      function->set_time(none);
      return check(function->value(Point<3>(none, none, none)));
    }

    std::vector<Table> read_tables(const std::string &folder, const double start)
    {
      std::set<std::filesystem::path> paths;
      for (const auto &file : std::filesystem::directory_iterator(folder))
        if (const std::string name = file.path().filename().string();
            (name.rfind("statistics", 0) == 0 && file.path().extension() == ".txt") ||
            name == "summary.csv")
          paths.insert(file.path());
      std::vector<Table> tables;
      for (const auto &path : paths)
        tables.push_back(read_table(path, start));
      return tables;
    }

    /** A line for each table that has the columns. */
    void print_figure(const std::string &expression, const unsigned int n_decimals,
                      const std::vector<Table> &tables)
    {
      std::vector<const Table *> suitable;
      const auto                 names = find_columns(expression);
      for (const Table &table : tables)
        if (std::all_of(names.begin(), names.end(),
                        [&](const auto &name) { return table.columns.count(name) > 0; }))
          suitable.push_back(&table);
      AssertThrow(
          !suitable.empty(),
          ExcMessage(
              entry + ": no table of the run has the columns of <" + expression +
              ">. The first lines of statistics.txt name its columns; caudal --resume prints "
              "figures of a run that has ended, too."));
      for (const Table *table : suitable)
      {
        const double value   = evaluate(expression, *table);
        const bool   is_zero = std::abs(value) < 0.5 * std::pow(0.1, n_decimals);
        std::cout << (suitable.size() > 1 ? table->file + ": " : "") << expression << " = "
                  << std::fixed << std::setprecision(n_decimals) << (is_zero ? 0. : value)
                  << std::defaultfloat << std::endl;
      }
    }
  } // namespace

  void FigureParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.enter_subsection("Figures");
    prm.add_parameter(
        "Print", print,
        "What a run prints in the end: expressions of the columns of statistics.txt (of "
        "summary.csv, too, in an ideal fluid), separated by ';'. [name] is a column, without its "
        "unit, t the time; first(), last(), smallest(), largest(), mean(), amplitude() (half of "
        "the range) and frequency() (of upward passages through the middle of the range) make a "
        "number of a column or of an expression of up to three, row by row. Example: "
        "1e3*last([fish: x of point 1]). If there are any, the terminal shows nothing else, no "
        "times, versions, machine: what is needed to compare a run with an earlier one.",
        Patterns::Anything());
    prm.add_parameter("Warnings", with_warnings, "Whether the terminal shows warnings, too.");
    prm.add_parameter("From time", start, "Rows before this time don't count [s].");
    prm.add_parameter("Decimals", n_decimals, "Digits after the point [1].",
                      Patterns::Integer(0, 15));
    prm.leave_subsection();
    prm.leave_subsection();
  }

  void FigureParameters::check() const
  {
    AssertThrow(std::isfinite(start), ExcMessage("Output/Figures/From time: the value is " +
                                                 std::to_string(start) + ". Give a time [s]."));
    for (const std::string &expression : Utilities::split_string_list(print, ';'))
      AssertThrow(!find_columns(expression).empty(),
                  ExcMessage(entry + ": <" + expression +
                             "> names no column. Give at least one, in brackets."));
  }

  bool FigureParameters::are_printed() const
  {
    return !print.empty();
  }

  void print_figures(const FigureParameters &parameters, const std::string &folder,
                     const MPI_Comm communicator)
  {
    if (!parameters.are_printed())
      return;
    run_on_root(communicator, [&]() {
      const std::vector<Table> tables = read_tables(folder, parameters.start);
      for (const std::string &expression : Utilities::split_string_list(parameters.print, ';'))
        print_figure(expression, parameters.n_decimals, tables);
    });
  }
} // namespace caudal
