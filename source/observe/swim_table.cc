#include <caudal/observe/swim_table.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace caudal
{
  namespace
  {
    struct Quantity
    {
      const char *name, *symbol, *unit;
      bool        is_per_span; // in two dimensions
      const char *definition;
      int         precision; // digits after the point
      bool        is_on_screen;
      double (*get)(const TailBeat &);
    };

    /** What there is with a control volume only. */
    const char *const fluid_force = "force by control volume";

    const Quantity quantities[] = {
        {"start", "start", "s", false, "the tail rises through its mean", 4, true,
         [](const TailBeat &b) { return b.start; }},
        {"period", "T", "s", false, "period, to the next rise", 4, true,
         [](const TailBeat &b) { return b.period; }},
        {"frequency", "f", "Hz", false, "frequency 1/T", 4, true,
         [](const TailBeat &b) { return b.frequency; }},
        {"amplitude", "A", "m", false, "amplitude: half of peak to trough", 4, true,
         [](const TailBeat &b) { return b.amplitude; }},
        {"speed", "U", "m/s", false, "mean forward speed of the centre of mass", 4, true,
         [](const TailBeat &b) { return b.speed; }},
        {"speed in lengths", "U/L", "1/s", false, "the same in body lengths L a second", 4, true,
         [](const TailBeat &b) { return b.lengths_per_s; }},
        {"Strouhal number", "St", "", false, "Strouhal number 2 f A / |U|", 4, true,
         [](const TailBeat &b) { return b.strouhal; }},
        {"Reynolds number", "Re", "", false, "Reynolds number |U| L / nu", 0, true,
         [](const TailBeat &b) { return b.reynolds; }},
        {"swimming number", "Sw", "", false,
         "swimming number 2 pi f A L / nu (Gazzola et al. 2014, doi:10.1038/nphys3078)", 0, false,
         [](const TailBeat &b) { return b.swimming; }},
        {"power", "P", "W", true, "mean power of the muscle", 4, true,
         [](const TailBeat &b) { return b.power; }},
        {"peak power", "Pmax", "W", true, "the muscle's largest power in a step", 4, true,
         [](const TailBeat &b) { return b.peak_power; }},
        {"energy per metre", "P/U", "J/m", true, "muscle energy per metre of way, P / |U|", 4,
         false, [](const TailBeat &b) { return b.energy_per_metre; }},
        {"cost of transport", "CoT", "J/(kg m)", false, "P / (m |U|), m the body's mass", 5, true,
         [](const TailBeat &b) { return b.cost_of_transport; }},
        {"momentum rate", "dmv/dt", "N", true,
         "mean net force forward, from the change of the body's momentum", 4, false,
         [](const TailBeat &b) { return b.momentum_rate; }},
        {"body force", "Fbody", "N", true,
         "mean forward force of muscle and springs from outside; the fluid's is dmv/dt - Fbody", 4,
         false, [](const TailBeat &b) { return b.body_force; }},
        {fluid_force, "Fvol", "N", true,
         "mean forward force of the fluid once more, by the momentum balance of Fluid/Control "
         "volume (nan once the fish has left it); dmv/dt - Fbody is to be the same",
         4, true, [](const TailBeat &b) { return b.fluid_force; }},
        {"thrust", "thrust", "N", true,
         "mean of the positive part of the fluid's forward force d(mv)/dt - Fbody of the steps, as "
         "Borazjani & Sotiropoulos 2008 (doi:10.1242/jeb.015644) do for pressure and friction",
         4, true, [](const TailBeat &b) { return b.thrust; }},
        {"drag", "drag", "N", true,
         "mean of its negative part; thrust - drag = dmv/dt - Fbody, 0 in steady free swimming", 4,
         false, [](const TailBeat &b) { return b.drag; }},
        {"Froude efficiency", "etaF", "", false, "thrust U / P", 4, false,
         [](const TailBeat &b) { return b.froude_efficiency; }},
        {"towing power", "Ptow", "W", true,
         "power to tow the straight body at U, friction of a laminar flat plate only: rho/2 S "
         "1.328 "
         "Re^(-1/2) |U|^3, S the area of both sides (Blasius 1908)",
         4, false, [](const TailBeat &b) { return b.towing_power; }},
        {"quasi-propulsive efficiency", "etaQP", "", false,
         "Ptow / P (Maertens, Triantafyllou & Yue 2015, doi:10.48550/arXiv.1409.7263); a lower "
         "bound, as Ptow leaves out form drag",
         5, false, [](const TailBeat &b) { return b.quasi_propulsive; }},
        {"muscle work", "Wmuscle", "J", true,
         "work of all muscles in the beat = dEkin + dEel + diss + feedback - external + residual",
         4, false, [](const TailBeat &b) { return b.muscle_work; }},
        {"kinetic energy", "dEkin", "J", true, "change of kinetic energy of fluid and bodies", 4,
         false, [](const TailBeat &b) { return b.kinetic_energy; }},
        {"elastic energy", "dEel", "J", true, "change of elastic energy of the bodies", 4, false,
         [](const TailBeat &b) { return b.elastic_energy; }},
        {"dissipation", "diss", "J", true, "dissipated in the fluid", 4, false,
         [](const TailBeat &b) { return b.dissipation; }},
        {"numerical dissipation", "numerical", "J", true,
         "the part of diss by stabilisations (grad-div, local projection) and the time scheme", 4,
         false, [](const TailBeat &b) { return b.numerical_dissipation; }},
        {"feedback", "feedback", "J", true, "taken up by feedback springs and dampers", 4, false,
         [](const TailBeat &b) { return b.feedback; }},
        {"external work", "external", "J", true,
         "work on the fluid through the sides of the domain and by the body force", 4, false,
         [](const TailBeat &b) { return b.external_work; }},
        {"residual", "residual", "J", true, "what is unaccounted for", 4, false,
         [](const TailBeat &b) { return b.residual; }},
        {"change", "dU", "%", false, "drift: change of U since the beat before, relative to U", 2,
         true, [](const TailBeat &b) { return 100 * b.change; }},
        {"steady", "steady", "", false, "1: this change is less than 2 %", 0, true,
         [](const TailBeat &b) { return b.is_steady ? 1. : 0.; }}};

    /** The quantities that are known for the swimmer. */
    std::vector<Quantity> get_quantities(const SwimmerConstants &swimmer, const bool is_screen)
    {
      std::vector<Quantity> known;
      for (const Quantity &quantity : quantities)
        if ((quantity.is_on_screen || !is_screen) &&
            (quantity.name != fluid_force || swimmer.has_control_volume))
          known.push_back(quantity);
      return known;
    }

    std::string get_unit(const Quantity &quantity, const SwimmerConstants &swimmer)
    {
      const std::string unit = quantity.unit;
      return quantity.is_per_span && swimmer.is_per_span ? unit + "/m" : unit;
    }

    std::string get_title(const Quantity &quantity, const SwimmerConstants &swimmer)
    {
      const std::string unit = get_unit(quantity, swimmer);
      return unit.empty() ? quantity.symbol : quantity.symbol + ("[" + unit + "]");
    }

    const int width = 14; // of a column

    void write_header(std::ostream &out, const SwimmerConstants &swimmer, const bool is_screen)
    {
      out << "# Tail beats of " << swimmer.name;
      if (swimmer.is_per_span)
        out << "; forces, energies and masses are those of one metre of span";
      out << "\n#\n";
      for (const Quantity &quantity : get_quantities(swimmer, is_screen))
        out << "# " << std::left << std::setw(width + 1) << get_title(quantity, swimmer)
            << std::right << quantity.definition << '\n';
      out << "#\n#beat";
      for (const Quantity &quantity : get_quantities(swimmer, is_screen))
        out << ' ' << std::setw(width - 1) << get_title(quantity, swimmer);
      out << '\n';
    }

    void write_row(std::ostream &out, const SwimmerConstants &swimmer, const std::size_t number,
                   const TailBeat &beat, const bool is_screen)
    {
      out << std::setw(5) << number << std::fixed;
      for (const Quantity &quantity : get_quantities(swimmer, is_screen))
        out << ' ' << std::setw(width - 1) << std::setprecision(quantity.precision)
            << quantity.get(beat);
      out << std::defaultfloat << std::setprecision(6) << '\n';
    }

    std::string quote(const std::string &text)
    {
      std::string result = "\"";
      for (const char c : text)
        result += c == '"' || c == '\\'                  ? std::string("\\") + c
                  : static_cast<unsigned char>(c) < 0x20 ? std::string(" ")
                                                         : std::string(1, c);
      return result + '"';
    }

    std::string get_number(const double value)
    {
      if (!std::isfinite(value))
        return "null";
      std::ostringstream text;
      text << std::setprecision(10) << value;
      return text.str();
    }

    void write_json_beat(std::ostream &out, const SwimmerConstants &swimmer, const TailBeat &beat)
    {
      const char *separator = "{";
      for (const Quantity &quantity : get_quantities(swimmer, false))
      {
        out << separator << quote(quantity.name) << ": "
            << (std::string(quantity.name) == "steady" ? (beat.is_steady ? "true" : "false")
                                                       : get_number(quantity.get(beat)));
        separator = ", ";
      }
      out << '}';
    }

    void write_json_constants(std::ostream &out, const SwimmerConstants &swimmer)
    {
      const std::string span  = swimmer.is_per_span ? "/m" : "";
      const auto        write = [&](const char *name, const char *symbol, const double value,
                             const std::string &unit) {
        out << "\n    " << quote(name) << ": {\"symbol\": " << quote(symbol)
            << ", \"value\": " << get_number(value) << ", \"unit\": " << quote(unit) << '}';
      };
      out << "  \"constants\": {";
      write("length", "L", swimmer.length, "m");
      out << ',';
      write("mass", "m", swimmer.mass, "kg" + span);
      out << ',';
      write("kinematic viscosity", "nu", swimmer.viscosity, "m^2/s");
      out << ',';
      write("fluid density", "rho", swimmer.fluid_density, "kg/m^3");
      out << ',';
      write("area of both sides", "S", swimmer.wetted_area, "m^2" + span);
      out << "\n  },\n";
    }
  } // namespace

  void write_screen_header(std::ostream &out, const SwimmerConstants &swimmer)
  {
    write_header(out, swimmer, true);
  }

  void write_screen_row(std::ostream &out, const SwimmerConstants &swimmer,
                        const std::size_t number, const TailBeat &beat)
  {
    write_row(out, swimmer, number, beat, true);
    out << std::flush;
  }

  void write_summary(std::ostream &out, const SwimmerConstants &swimmer, const TailBeat &mean,
                     const std::size_t n_beats, const std::size_t n_all)
  {
    out << swimmer.name << ": mean of the last " << n_beats << " of " << n_all << " tail beats, "
        << (mean.is_steady ? "which are steady" : "not steady");
    out << (swimmer.is_per_span ? "; per metre of span\n" : "\n");
    for (const Quantity &quantity : get_quantities(swimmer, false))
      if (std::string(quantity.name) != "start" && std::string(quantity.name) != "steady")
        out << "  " << std::left << std::setw(28) << quantity.name << std::right << std::setw(14)
            << std::fixed << std::setprecision(quantity.precision) << quantity.get(mean) << ' '
            << std::left << std::setw(9) << get_unit(quantity, swimmer) << std::right << '\n';
    out << std::defaultfloat << std::setprecision(6) << std::flush;
  }

  void write_swim_table(std::ostream &out, const SwimmerConstants &swimmer,
                        const std::vector<TailBeat> &beats)
  {
    write_header(out, swimmer, false);
    for (std::size_t i = 0; i < beats.size(); ++i)
      write_row(out, swimmer, i + 1, beats[i], false);
  }

  void write_swim_json(std::ostream &out, const SwimmerConstants &swimmer,
                       const std::vector<TailBeat> &beats, const std::size_t n_steady)
  {
    out << "{\n  \"body\": " << quote(swimmer.name)
        << ",\n  \"per metre of span\": " << (swimmer.is_per_span ? "true" : "false") << ",\n";
    write_json_constants(out, swimmer);
    out << "  \"quantities\": {";
    const char *separator = "\n    ";
    for (const Quantity &quantity : get_quantities(swimmer, false))
    {
      out << separator << quote(quantity.name) << ": {\"symbol\": " << quote(quantity.symbol)
          << ", \"unit\": " << quote(get_unit(quantity, swimmer))
          << ", \"definition\": " << quote(quantity.definition) << '}';
      separator = ",\n    ";
    }
    out << "\n  },\n  \"beats\": [";
    separator = "\n    ";
    for (const TailBeat &beat : beats)
    {
      out << separator;
      write_json_beat(out, swimmer, beat);
      separator = ",\n    ";
    }
    out << (beats.empty() ? "],\n" : "\n  ],\n") << "  \"steady beats\": " << n_steady
        << ",\n  \"mean of steady beats\": ";
    if (n_steady > 0)
      write_json_beat(out, swimmer, compute_mean(swimmer, {beats.end() - n_steady, beats.end()}));
    else
      out << "null";
    out << "\n}\n";
  }
} // namespace caudal
