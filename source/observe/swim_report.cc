#include <caudal/observe/swim_report.h>
#include <caudal/observe/swim_table.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

using namespace dealii;

namespace caudal
{
  TailCycleDetector::TailCycleDetector(const double smallest_amplitude)
      : smallest_swing(2 * smallest_amplitude)
  {}

  std::optional<TailCycle> TailCycleDetector::add(const double time, const double position)
  {
    times.push_back(time);
    positions.push_back(position);
    const std::size_t i         = positions.size() - 1;
    const double      threshold = std::max(smallest_swing, 0.2 * swing);

    if (direction == 0)
    {
      if (position > positions[extreme])
        extreme = i;
      if (position < positions[opposite])
        opposite = i;
      if (positions[extreme] - positions[opposite] > threshold)
      {
        direction = extreme > opposite ? 1 : -1;
        if (direction < 0)
          std::swap(extreme, opposite);
      }
    }
    else if (direction * (position - positions[extreme]) > 0)
      extreme = i;
    else if (direction * (positions[extreme] - position) > threshold)
    {
      if (direction > 0)
        return accept_peak();
      accept_trough();
    }
    return {};
  }

  std::optional<TailCycle> TailCycleDetector::accept_peak()
  {
    // Only a rise that starts from an accepted trough gives a crossing: the
    // position at rest is none.
    std::optional<TailCycle> cycle;
    if (swing > 0)
    {
      const double crossing = get_up_crossing();
      if (start >= 0)
        cycle = TailCycle{start, crossing, amplitude};
      start = crossing;
    }
    swing     = positions[extreme] - *std::min_element(positions.begin(), positions.end());
    opposite  = extreme;
    extreme   = positions.size() - 1;
    direction = -1;
    return cycle;
  }

  void TailCycleDetector::accept_trough()
  {
    swing     = positions[opposite] - positions[extreme];
    amplitude = swing / 2;
    times.erase(times.begin(), times.begin() + extreme);
    positions.erase(positions.begin(), positions.begin() + extreme);
    extreme   = positions.size() - 1;
    opposite  = 0;
    direction = 1;
  }

  double TailCycleDetector::get_up_crossing() const
  {
    const double mean = (positions.front() + positions[extreme]) / 2;
    std::size_t  i    = extreme;
    while (positions[i - 1] >= mean)
      --i;
    const double weight = (mean - positions[i - 1]) / (positions[i] - positions[i - 1]);
    return times[i - 1] + weight * (times[i] - times[i - 1]);
  }

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
      write_screen_header(log, swimmer);
    write_screen_row(log, swimmer, beats.size(), beats.back());
    write_files();

    const auto still_needed = std::find_if(
        samples.begin(), samples.end(), [&](const SwimSample &s) { return s.time > cycle->end; });
    samples.erase(samples.begin(), still_needed - 1);
  }

  std::size_t SwimReport::count_steady_beats() const
  {
    return std::find_if(beats.rbegin(), beats.rend(),
                        [](const TailBeat &beat) { return !beat.is_steady; }) -
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
    std::ofstream out(file);
    write_swim_table(out, swimmer, beats);
    AssertThrow(out.flush(), ExcMessage("The table of tail beats <" + file +
                                        "> can't be written. Is the disk full?"));
    std::ofstream json(get_json_file());
    write_swim_json(json, swimmer, beats, count_steady_beats());
    AssertThrow(json.flush(), ExcMessage("The table of tail beats <" + get_json_file() +
                                         "> can't be written. Is the disk full?"));
  }
} // namespace caudal
