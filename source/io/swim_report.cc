#include <caudal/io/swim_report.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>

using namespace dealii;

namespace caudal
{
  namespace
  {
    const double steady_change = 0.02;

    struct Column
    {
      const char *title;
      const char *definition;
      int         precision;
      double (*get)(const TailBeat &);
    };

    const Column columns[] = {
        {"start[s]", "the tail rises through its mean", 4,
         [](const TailBeat &b) { return b.start; }},
        {"T[s]", "period, to the next rise", 4, [](const TailBeat &b) { return b.period; }},
        {"f[Hz]", "frequency 1/T", 4, [](const TailBeat &b) { return b.frequency; }},
        {"A[m]", "amplitude: half of peak to trough", 4,
         [](const TailBeat &b) { return b.amplitude; }},
        {"U[m/s]", "mean forward speed of the centre of mass", 4,
         [](const TailBeat &b) { return b.speed; }},
        {"U[L/s]", "the same in body lengths L", 4,
         [](const TailBeat &b) { return b.lengths_per_s; }},
        {"St", "Strouhal number 2 f A / |U|", 4, [](const TailBeat &b) { return b.strouhal; }},
        {"Re", "Reynolds number |U| L / nu", 0, [](const TailBeat &b) { return b.reynolds; }},
        {"Sw", "swimming number 2 pi f A L / nu", 0, [](const TailBeat &b) { return b.swimming; }},
        {"P[W/m]", "mean power of the muscle", 4, [](const TailBeat &b) { return b.power; }},
        {"P/U[J/m/m]", "energy per metre of way", 4,
         [](const TailBeat &b) { return b.energy_per_metre; }},
        {"CoT[J/kg/m]", "cost of transport P / (m |U|), m the body's mass", 5,
         [](const TailBeat &b) { return b.cost_of_transport; }},
        {"dU[%]", "change of U since the beat before, relative to U", 2,
         [](const TailBeat &b) { return 100 * b.change; }},
        {"steady", "1: this change is less than 2 %", 0,
         [](const TailBeat &b) { return b.is_steady ? 1. : 0.; }}};

    void write_header(std::ostream &out, const std::string &body)
    {
      out << "# Tail beats of " << body << "\n#\n";
      for (const Column &column : columns)
        out << "# " << std::left << std::setw(12) << column.title << std::right << column.definition
            << '\n';
      out << "#\n#beat";
      for (const Column &column : columns)
        out << std::setw(12) << column.title;
      out << '\n';
    }

    void write_row(std::ostream &out, const std::size_t number, const TailBeat &beat)
    {
      out << std::setw(5) << number << std::fixed;
      for (const Column &column : columns)
        out << std::setw(12) << std::setprecision(column.precision) << column.get(beat);
      out << std::defaultfloat << std::setprecision(6) << std::endl;
    }
  } // namespace

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

  TailBeat compute_beat(const SwimmerConstants &swimmer, const std::vector<SwimSample> &samples,
                        const TailCycle &cycle, const double previous_speed)
  {
    Assert(!samples.empty() && samples.front().time <= cycle.start &&
               cycle.end <= samples.back().time,
           ExcInternalError());
    const auto interpolate = [&](const double time, double SwimSample::*value) {
      const auto after =
          std::upper_bound(samples.begin() + 1, samples.end() - 1, time,
                           [](const double t, const SwimSample &s) { return t < s.time; });
      const auto   before = after - 1;
      const double weight = (time - before->time) / (after->time - before->time);
      return (1 - weight) * (*before).*value + weight * (*after).*value;
    };
    const auto get_rate = [&](double SwimSample::*value) {
      return (interpolate(cycle.end, value) - interpolate(cycle.start, value)) /
             (cycle.end - cycle.start);
    };

    TailBeat beat;
    beat.start             = cycle.start;
    beat.period            = cycle.end - cycle.start;
    beat.frequency         = 1 / beat.period;
    beat.amplitude         = cycle.amplitude;
    beat.speed             = get_rate(&SwimSample::forward_position);
    const double magnitude = std::abs(beat.speed);
    beat.lengths_per_s     = beat.speed / swimmer.length;
    beat.strouhal          = 2 * beat.frequency * beat.amplitude / magnitude;
    beat.reynolds          = magnitude * swimmer.length / swimmer.viscosity;
    beat.swimming = 2 * M_PI * beat.frequency * beat.amplitude * swimmer.length / swimmer.viscosity;
    beat.power    = get_rate(&SwimSample::muscle_work);
    beat.energy_per_metre  = beat.power / magnitude;
    beat.cost_of_transport = beat.energy_per_metre / swimmer.mass;
    beat.change            = (beat.speed - previous_speed) / magnitude;
    beat.is_steady         = std::abs(beat.change) < steady_change;
    return beat;
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
      write_header(log, swimmer.name);
    write_row(log, beats.size(), beats.back());
    write_file();

    const auto still_needed = std::find_if(
        samples.begin(), samples.end(), [&](const SwimSample &s) { return s.time > cycle->end; });
    samples.erase(samples.begin(), still_needed - 1);
  }

  void SwimReport::finish()
  {
    const auto first = std::find_if(beats.rbegin(), beats.rend(), [](const TailBeat &beat) {
                         return !beat.is_steady;
                       }).base();
    const auto n     = beats.end() - first;
    if (n == 0)
    {
      log << swimmer.name << ": " << beats.size()
          << " tail beats, the speed is not steady at the end." << std::endl;
      return;
    }
    TailBeat mean;
    for (auto beat = first; beat != beats.end(); ++beat)
    {
      mean.period += beat->period / n;
      mean.amplitude += beat->amplitude / n;
      mean.speed += beat->speed / n;
      mean.power += beat->power / n;
    }
    log << swimmer.name << ": steady over the last " << n << " of " << beats.size()
        << " tail beats: U = " << mean.speed << " m/s = " << mean.speed / swimmer.length
        << " L/s, T = " << mean.period << " s, A = " << mean.amplitude << " m, P = " << mean.power
        << " W/m." << std::endl;
  }

  void SwimReport::resume() const
  {
    if (beats.empty() && !file.empty())
      std::filesystem::remove(file);
    else
      write_file();
  }

  void SwimReport::write_file() const
  {
    if (file.empty())
      return;
    std::ofstream out(file);
    write_header(out, swimmer.name);
    for (std::size_t i = 0; i < beats.size(); ++i)
      write_row(out, i + 1, beats[i]);
    out.close();
    AssertThrow(out, ExcMessage("The table of tail beats <" + file +
                                "> can't be written. Is the disk full?"));
  }
} // namespace caudal
