// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/swim_table.h>

#include <caudal/base/json.h>

#include <iomanip>

namespace caudal
{
  namespace
  {
    using Quantity = TailBeatQuantity;

    /** The quantities that are known for the swimmer. */
    std::vector<Quantity> get_quantities(const SwimmerConstants &swimmer, const SwimTable table)
    {
      std::vector<Quantity> known;
      for (const Quantity &quantity : get_tail_beat_quantities())
        if ((quantity.is_on_screen || table == SwimTable::file) &&
            (quantity.value != &TailBeat::fluid_force || swimmer.has_control_volume))
          known.push_back(quantity);
      return known;
    }

    std::string get_unit(const Quantity &quantity, const SwimmerConstants &swimmer)
    {
      return quantity.unit + (quantity.is_per_span && swimmer.is_per_span ? "/m" : "");
    }

    std::string get_title(const Quantity &quantity, const SwimmerConstants &swimmer)
    {
      const std::string unit = get_unit(quantity, swimmer);
      return unit.empty() ? quantity.symbol : quantity.symbol + "[" + unit + "]";
    }

    const int width = 14; // of a column

    Json describe_beat(const SwimmerConstants &swimmer, const TailBeat &beat)
    {
      Json json = Json::object();
      for (const Quantity &quantity : get_quantities(swimmer, SwimTable::file))
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

    Json describe_quantities(const SwimmerConstants &swimmer)
    {
      Json json = Json::object();
      for (const Quantity &quantity : get_quantities(swimmer, SwimTable::file))
        json.add(quantity.name, Json::object()
                                    .add("symbol", quantity.symbol)
                                    .add("unit", get_unit(quantity, swimmer))
                                    .add("definition", quantity.definition));
      return json;
    }
  } // namespace

  void write_header(std::ostream &out, const SwimmerConstants &swimmer, const SwimTable table)
  {
    out << "# Tail beats of " << swimmer.name;
    if (swimmer.is_per_span)
      out << "; forces, energies and masses are those of one metre of span";
    out << "\n#\n";
    for (const Quantity &quantity : get_quantities(swimmer, table))
      out << "# " << std::left << std::setw(width + 1) << get_title(quantity, swimmer) << std::right
          << quantity.definition << '\n';
    out << "#\n#beat";
    for (const Quantity &quantity : get_quantities(swimmer, table))
      out << ' ' << std::setw(width - 1) << get_title(quantity, swimmer);
    out << '\n';
  }

  void write_row(std::ostream &out, const SwimmerConstants &swimmer, const std::size_t number,
                 const TailBeat &beat, const SwimTable table)
  {
    out << std::setw(5) << number << std::fixed;
    for (const Quantity &quantity : get_quantities(swimmer, table))
      out << ' ' << std::setw(width - 1) << std::setprecision(quantity.precision)
          << beat.*quantity.value;
    out << std::defaultfloat << std::setprecision(6) << '\n';
  }

  void write_summary(std::ostream &out, const SwimmerConstants &swimmer, const TailBeat &mean,
                     const std::size_t n_beats, const std::size_t n_all)
  {
    out << swimmer.name << ": mean of the last " << n_beats << " of " << n_all << " tail beats, "
        << (mean.steady > 0 ? "which are steady" : "not steady");
    out << (swimmer.is_per_span ? "; per metre of span\n" : "\n");
    for (const Quantity &quantity : get_quantities(swimmer, SwimTable::file))
      if (quantity.value != &TailBeat::start && quantity.value != &TailBeat::steady)
        out << "  " << std::left << std::setw(28) << quantity.name << std::right << std::setw(14)
            << std::fixed << std::setprecision(quantity.precision) << mean.*quantity.value << ' '
            << std::left << std::setw(9) << get_unit(quantity, swimmer) << std::right << '\n';
    out << std::defaultfloat << std::setprecision(6) << std::flush;
  }

  void write_swim_json(std::ostream &out, const SwimmerConstants &swimmer,
                       const std::vector<TailBeat> &beats, const std::size_t n_steady)
  {
    Json list = Json::array();
    for (const TailBeat &beat : beats)
      list.append(describe_beat(swimmer, beat));
    const std::vector<TailBeat> steady(beats.end() - n_steady, beats.end());
    Json::object()
        .add("body", swimmer.name)
        .add("per metre of span", swimmer.is_per_span)
        .add("constants", describe_constants(swimmer))
        .add("quantities", describe_quantities(swimmer))
        .add("beats", list)
        .add("steady beats", n_steady)
        .add("mean of steady beats",
             steady.empty() ? Json() : describe_beat(swimmer, compute_mean(swimmer, steady)))
        .write(out);
    out << '\n';
  }
} // namespace caudal
