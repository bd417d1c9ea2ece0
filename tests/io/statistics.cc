// SPDX-License-Identifier: LGPL-2.1-or-later
// The table of statistics: headers, rows, what is refused, and a resumed run.

#include <caudal/io/progress.h>
#include <caudal/io/statistics.h>

#include <cmath>
#include <fstream>
#include <iostream>

using namespace caudal;

namespace
{
  const std::string file = "statistics.txt";

  void print_file()
  {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
      std::cout << line << '\n';
  }

  template <typename Action>
  void expect_refusal(const Action &action)
  {
    try
    {
      action();
      std::cout << "not refused\n";
    }
    catch (dealii::ExceptionBase &exception)
    {
      exception.print_info(std::cout);
    }
  }

  void write_row(Statistics &statistics, const double time)
  {
    statistics.set("time", "s", time);
    statistics.set("fish: area change", "", 1e-3 * time);
    statistics.set("fish: u of point 1", "m/s", -1 - 1. / 3. * time);
    statistics.write_row();
  }
} // namespace

int main()
{
  {
    Statistics statistics(file);
    for (const double time : {0., 0.1, 0.2, 0.3})
      write_row(statistics, time);

    std::cout << "A missing column:\n";
    expect_refusal([&]() {
      statistics.set("time", "s", 0.4);
      statistics.write_row();
    });
    std::cout << "A column that the first row hasn't got:\n";
    expect_refusal([&]() { statistics.set("kinetic energy", "J/m", 1.); });
    std::cout << "A column twice:\n";
    expect_refusal([&]() { statistics.set("time", "s", 0.5); });
    std::cout << "Not a number:\n";
    expect_refusal([&]() { statistics.set("fish: area change", "", std::nan("")); });
  }
  std::cout << "The file:\n";
  print_file();
  {
    Statistics statistics(file, 0.1);
    write_row(statistics, 0.15);
    expect_refusal([&]() { statistics.set("new", "m", 0.); });
  }
  std::cout << "Resumed at 0.1 s:\n";
  print_file();

  std::cout << "Other ranks write nothing:\n";
  Statistics silent("");
  write_row(silent, 0.);

  std::cout << "Durations: " << format_duration(0.4) << ' ' << format_duration(125) << ' '
            << format_duration(3600 + 62) << '\n';
}
