// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/swim_report.h>

#include <caudal/base/json.h>
#include <caudal/base/safe_file.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <sstream>

namespace caudal
{
  namespace
  {
    const int width = 14; // of a column

    /** The quantities that are known for the swimmer: all, or those for which there is room. */
    std::vector<TailBeatQuantity> get_quantities(const SwimmerConstants &swimmer,
                                                 const bool              on_screen)
    {
      std::vector<TailBeatQuantity> known;
      for (TailBeatQuantity quantity : get_tail_beat_quantities())
        if ((quantity.is_on_screen || !on_screen) &&
            (quantity.value != &TailBeat::fluid_force || swimmer.has_control_volume))
        {
          if (quantity.is_per_span && swimmer.is_per_span)
            quantity.unit += "/m";
          known.push_back(quantity);
        }
      return known;
    }

    std::string get_title(const TailBeatQuantity &quantity)
    {
      return quantity.symbol + (quantity.unit.empty() ? "" : "[" + quantity.unit + "]");
    }

    /**
     * A value with the quantity's digits after the point, and with more where these are fewer than
     * four of its own: powers of a small fish are some mW.
     */
    std::string print_value(const TailBeatQuantity &quantity, const double value)
    {
      const bool   is_number = std::isfinite(value) && value != 0;
      const double order     = is_number ? std::floor(std::log10(std::abs(value))) : 0;
      const bool   is_plain =
          !is_number || quantity.value == &TailBeat::steady || order >= 3 - quantity.precision;
      std::ostringstream text;
      if (is_plain)
        text << std::fixed << std::setprecision(quantity.precision) << value + 0.; // no -0
      else if (order >= -4)
        text << std::fixed << std::setprecision(3 - static_cast<int>(order)) << value;
      else
        text << std::scientific << std::setprecision(3) << value;
      return text.str();
    }

    Json describe_beat(const std::vector<TailBeatQuantity> &quantities, const TailBeat &beat)
    {
      Json json = Json::object();
      for (const TailBeatQuantity &quantity : quantities)
        json.add(quantity.name, quantity.value == &TailBeat::steady ? Json(beat.steady > 0)
                                                                    : beat.*quantity.value);
      return json;
    }

    Json describe_constants(const SwimmerConstants &swimmer)
    {
      const std::string span = swimmer.is_per_span ? "/m" : "";
      Json              json = Json::object();
      const auto        add  = [&](const char *name, const char *symbol, const double value,
                           const std::string &unit) {
        json.add(name, Json::object().add("symbol", symbol).add("value", value).add("unit", unit));
      };
      add("length", "L", swimmer.length, "m");
      add("mass", "m", swimmer.mass, "kg" + span);
      add("kinematic viscosity", "nu", swimmer.viscosity, "m^2/s");
      add("fluid density", "rho", swimmer.fluid_density, "kg/m^3");
      add("area of both sides", "S", swimmer.wetted_area, "m^2" + span);
      return json;
    }
  } // namespace

  SwimReport::SwimReport(const SwimmerConstants &swimmer, std::ostream &log,
                         const std::string &file)
      : swimmer(swimmer)
      , log(log)
      , file(file)
      , in_file(get_quantities(swimmer, /*on_screen=*/false))
      , on_screen(get_quantities(swimmer, /*on_screen=*/true))
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
      write_header(log, on_screen);
    write_row(log, on_screen, beats.size() - 1);
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
    const std::size_t n    = std::max<std::size_t>(count_steady_beats(), 1);
    const TailBeat    mean = compute_mean(swimmer, {beats.end() - n, beats.end()});
    log << swimmer.name << ": mean of the last " << n << " of " << beats.size() << " tail beats, "
        << (mean.steady > 0 ? "which are steady" : "not steady")
        << (swimmer.is_per_span ? "; per metre of span\n" : "\n");
    for (const TailBeatQuantity &quantity : in_file)
      if (quantity.value != &TailBeat::start && quantity.value != &TailBeat::steady)
        log << "  " << std::left << std::setw(28) << quantity.name << std::right << std::setw(14)
            << print_value(quantity, mean.*quantity.value) << ' ' << std::left << std::setw(9)
            << quantity.unit << std::right << '\n';
    log << std::flush;
  }

  void SwimReport::resume() const
  {
    if (!beats.empty() || file.empty())
    {
      write_files();
      return;
    }
    for (const std::string ending : {".txt", ".json", ".csv"})
      std::filesystem::remove(get_file(ending));
  }

  std::string SwimReport::get_file(const std::string &ending) const
  {
    return file.substr(0, file.rfind('.')) + ending;
  }

  void SwimReport::write_files() const
  {
    if (file.empty())
      return;
    std::ostringstream table, json, csv;
    write_header(table, in_file);
    for (std::size_t beat = 0; beat < beats.size(); ++beat)
      write_row(table, in_file, beat);
    replace_file(file, table.str());
    write_json(json);
    replace_file(get_file(".json"), json.str());
    write_csv(csv);
    replace_file(get_file(".csv"), csv.str());
  }

  /** What stands in front of the rows: the definitions of the columns and their titles. */
  void SwimReport::write_header(std::ostream &out, const Quantities &quantities) const
  {
    out << "# Tail beats of " << swimmer.name;
    if (swimmer.is_per_span)
      out << "; forces, energies and masses are those of one metre of span";
    out << "\n#\n";
    for (const TailBeatQuantity &quantity : quantities)
      out << "# " << std::left << std::setw(width + 1) << get_title(quantity) << std::right
          << quantity.definition << '\n';
    out << "#\n#beat";
    for (const TailBeatQuantity &quantity : quantities)
      out << ' ' << std::setw(width - 1) << get_title(quantity);
    out << '\n';
  }

  void SwimReport::write_row(std::ostream &out, const Quantities &quantities,
                             const std::size_t beat) const
  {
    out << std::setw(5) << beat + 1;
    for (const TailBeatQuantity &quantity : quantities)
      out << ' ' << std::setw(width - 1) << print_value(quantity, beats[beat].*quantity.value);
    out << '\n';
  }

  /** A row for each beat, after one of names and units; blank where there is no number. */
  void SwimReport::write_csv(std::ostream &out) const
  {
    out << "beat";
    for (const TailBeatQuantity &quantity : in_file)
      out << ',' << quantity.name << (quantity.unit.empty() ? "" : " [" + quantity.unit + "]");
    out << std::setprecision(10);
    for (std::size_t beat = 0; beat < beats.size(); ++beat)
    {
      out << '\n' << beat + 1;
      for (const TailBeatQuantity &quantity : in_file)
      {
        out << ',';
        if (std::isfinite(beats[beat].*quantity.value))
          out << beats[beat].*quantity.value;
      }
    }
    out << '\n';
  }

  /**
   * The constants, for each quantity its symbol, unit and definition, the beats, and the mean of
   * the last ones, which are steady (null if there are none). What is not finite, such as a
   * Strouhal number without speed, is null.
   */
  void SwimReport::write_json(std::ostream &out) const
  {
    Json quantities = Json::object(), list = Json::array();
    for (const TailBeatQuantity &quantity : in_file)
      quantities.add(quantity.name, Json::object()
                                        .add("symbol", quantity.symbol)
                                        .add("unit", quantity.unit)
                                        .add("definition", quantity.definition));
    for (const TailBeat &beat : beats)
      list.append(describe_beat(in_file, beat));
    const std::vector<TailBeat> steady(beats.end() - count_steady_beats(), beats.end());
    Json::object()
        .add("body", swimmer.name)
        .add("per metre of span", swimmer.is_per_span)
        .add("constants", describe_constants(swimmer))
        .add("quantities", quantities)
        .add("beats", list)
        .add("steady beats", steady.size())
        .add("mean of steady beats",
             steady.empty() ? Json() : describe_beat(in_file, compute_mean(swimmer, steady)))
        .write(out);
    out << '\n';
  }
} // namespace caudal
