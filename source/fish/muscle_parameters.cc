#include <caudal/fish/body_function.h>
#include <caudal/fish/force_table.h>
#include <caudal/fish/muscle.h>

namespace caudal
{
  namespace
  {
    /** "path/entry: the value is 3. " */
    std::string bad(const std::string &path, const std::string &entry, const double value)
    {
      return path + "/" + entry + ": the value is " + Patterns::Tools::to_string(value) + ". ";
    }
  } // namespace

  void BangBangParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Bang-bang");
    prm.add_parameter("Maximum force density", maximum_force_density,
                      "Force per reference volume where the force distribution is 1 [N/m^3].");
    prm.add_parameter("Switching position", switching_position,
                      "Lateral distance of the monitored point from its reference place at which "
                      "the force that drove it there reverses [m].");
    prm.add_parameter("Switching duration", switching_duration,
                      "Time [s] that the force takes to reverse, along a cosine; to be short "
                      "against half a beat. 0 reverses at once.");
    prm.add_parameter("Initial direction", initial_direction,
                      "Direction of the first force: 1 towards +y, -1 towards -y.");
    prm.leave_subsection();
  }

  void BangBangParameters::check(const std::string &path) const
  {
    const std::string section = path + "/Bang-bang";
    AssertThrow(maximum_force_density >= 0.,
                ExcMessage(bad(section, "Maximum force density", maximum_force_density) +
                           "Give a density that is not negative [N/m^3]; the initial direction "
                           "sets the sign."));
    AssertThrow(switching_position > 0.,
                ExcMessage(bad(section, "Switching position", switching_position) +
                           "Give a positive distance [m]."));
    AssertThrow(switching_duration >= 0.,
                ExcMessage(bad(section, "Switching duration", switching_duration) +
                           "Give a duration that is not negative [s]."));
    AssertThrow(initial_direction == 1 || initial_direction == -1,
                ExcMessage(bad(section, "Initial direction", initial_direction) + "Give 1 or -1."));
  }

  void TravellingWaveParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Travelling wave");
    prm.add_parameter("Maximum active stress", maximum_active_stress,
                      "Second Piola-Kirchhoff stress along the body at the reference half "
                      "thickness, where the envelope is 1 [Pa].");
    prm.add_parameter("Envelope", envelope,
                      "Amplitude of the wave [-], a function of the arc length s over the body "
                      "length (0 nose, 1 tail) and the time t [s].");
    prm.add_parameter("Wave number", wave_number, "Waves on the body; they run to the tail [-].");
    prm.add_parameter("Frequency", frequency, "Tail-beat frequency [Hz].");
    prm.add_parameter("Phase", phase, "Phase of the wave at the nose at t = 0 [rad].");
    prm.add_parameter("Reference half thickness", reference_half_thickness,
                      "Distance from the midline, over the body length, at which the stress has "
                      "its full value; it is linear across the body [-].");
    prm.leave_subsection();
  }

  void TravellingWaveParameters::check(const std::string &path) const
  {
    const std::string section = path + "/Travelling wave";
    AssertThrow(frequency > 0., ExcMessage(bad(section, "Frequency", frequency) +
                                           "Give a positive frequency [Hz]."));
    AssertThrow(reference_half_thickness > 0.,
                ExcMessage(bad(section, "Reference half thickness", reference_half_thickness) +
                           "Give a positive share of the body length."));
    const BodyFunction function(section + "/Envelope", "s,t", envelope);
    for (const double s : {0., 0.25, 0.5, 0.75, 1.})
      function.value(s, 0.);
  }

  void FibreParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Fibres");
    prm.add_parameter(
        "Tension", tension,
        "Active stress T along the fibres, of the second Piola-Kirchhoff tensor [Pa]: "
        "a function of the place x, y (and z) in the body's own frame [m] and of the "
        "time t [s].");
    prm.add_parameter("Direction", direction,
                      "Direction of the fibres in the reference configuration, of any length: "
                      "functions of x, y (and z) and t, one for each dimension, separated by ';'; "
                      "'-y; x' is circumferential.");
    prm.leave_subsection();
  }

  void TableParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Table");
    prm.add_parameter("File", file,
                      "Text file of times [s] and force densities [N/m^3], a row per instant; "
                      "several columns if a first row <time, s1, s2, ...> gives their arc "
                      "lengths over the body length.");
    prm.add_parameter("Periodic", periodic,
                      "Whether the table repeats; its last row must then equal its first.");
    prm.leave_subsection();
  }

  void TableParameters::check(const std::string &path) const
  {
    AssertThrow(!file.empty(),
                ExcMessage(path + "/Table/File: there is no file name. Give the table's."));
    ForceTable(file, periodic);
  }

  void MuscleParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Muscle");
    prm.add_parameter("Type", type,
                      "'bang-bang' is a lateral force that reverses when the tail has reached a "
                      "position; 'travelling wave' an active stress; 'fibres' one along given "
                      "lines; 'table' a lateral force from a file; 'none' is passive.",
                      Patterns::Selection(get_muscle_names()));
    prm.add_parameter("Regions", regions,
                      "Regions of the body in which the muscle acts, separated by commas; empty "
                      "is the whole body.");
    prm.add_parameter("Monitored point", monitored_point,
                      "Arc length over body length of the point on the midline whose lateral "
                      "motion the muscle watches (0 nose, 1 tail).");
    prm.add_parameter("Start-up ramp", ramp.duration,
                      "Time [s] in which the activation grows from zero, as (1 - cos)/2.");
    prm.add_parameter("Force distribution", force_distribution,
                      "Share of the force density [-] of the bang-bang muscle and the table: a "
                      "function of the arc length s and the lateral distance y from the "
                      "midline, both over the body length.");
    bang_bang.add_parameters(prm);
    travelling_wave.add_parameters(prm);
    fibres.add_parameters(prm);
    table.add_parameters(prm);
    prm.leave_subsection();
  }

  void MuscleParameters::check(const std::string &path) const
  {
    const std::string section = path + "/Muscle";
    AssertThrow(monitored_point >= 0. && monitored_point <= 1.,
                ExcMessage(bad(section, "Monitored point", monitored_point) +
                           "Give an arc length between 0 (nose) and 1 (tail)."));
    AssertThrow(ramp.duration >= 0., ExcMessage(bad(section, "Start-up ramp", ramp.duration) +
                                                "Give a duration that is not negative [s]."));
    const BodyFunction distribution(section + "/Force distribution", "s,y", force_distribution);
    for (const double s : {0., 0.25, 0.5, 0.75, 1.})
      distribution.value(s, 0.);

    if (type == "bang-bang")
      bang_bang.check(section);
    else if (type == "travelling wave")
      travelling_wave.check(section);
    else if (type == "table")
      table.check(section);
  }
} // namespace caudal
