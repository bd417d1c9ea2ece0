// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/swim_report.h>

#include <caudal/io/safe_file.h>
#include <caudal/observe/swim_table.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace caudal
{
  SwimReport::SwimReport(const SwimmerConstants &swimmer, std::ostream &log,
                         const std::string &file)
      : swimmer(swimmer)
      , log(log)
      , file(file)
      , detector(swimmer.minimum_amplitude * swimmer.length)
  {}

  void SwimReport::add(const SwimSample &sample)
  {
    samples.push_back(sample);
    const auto cycle = detector.add(sample.time, sample.tail_position);
    if (!cycle)
      return;

    beats.push_back(
        compute_beat(swimmer, samples, *cycle, beats.empty() ? 0. : beats.back().speed));
    if (beats.size() == 1)
      write_header(log, swimmer, SwimTable::screen);
    write_row(log, swimmer, beats.size(), beats.back(), SwimTable::screen);
    log << std::flush;
    write_files();

    const auto still_needed = std::find_if(
        samples.begin(), samples.end(), [&](const SwimSample &s) { return s.time > cycle->end; });
    samples.erase(samples.begin(), still_needed - 1);
  }

  std::size_t SwimReport::count_steady_beats() const
  {
    return std::find_if(beats.rbegin(), beats.rend(),
                        [](const TailBeat &beat) { return beat.steady == 0; }) -
           beats.rbegin();
  }

  void SwimReport::finish()
  {
    if (beats.empty())
    {
      log << swimmer.name << ": no whole tail beat." << std::endl;
      return;
    }
    const std::size_t n = std::max<std::size_t>(count_steady_beats(), 1);
    write_summary(log, swimmer, compute_mean(swimmer, {beats.end() - n, beats.end()}), n,
                  beats.size());
  }

  void SwimReport::resume() const
  {
    if (!beats.empty() || file.empty())
    {
      write_files();
      return;
    }
    std::filesystem::remove(file);
    std::filesystem::remove(get_json_file());
  }

  std::string SwimReport::get_json_file() const
  {
    return file.substr(0, file.rfind('.')) + ".json";
  }

  void SwimReport::write_files() const
  {
    if (file.empty())
      return;
    std::ostringstream table, json;
    write_header(table, swimmer, SwimTable::file);
    for (std::size_t i = 0; i < beats.size(); ++i)
      write_row(table, swimmer, i + 1, beats[i], SwimTable::file);
    replace_file(file, table.str());
    write_swim_json(json, swimmer, beats, count_steady_beats());
    replace_file(get_json_file(), json.str());
  }
} // namespace caudal
