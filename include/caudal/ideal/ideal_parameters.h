// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_ideal_parameters_h
#define caudal_ideal_ideal_parameters_h

#include <caudal/base/parameter_file.h>
#include <caudal/fish/gait.h>
#include <caudal/ideal/kirchhoff.h>
#include <caudal/ideal/resistance.h>
#include <caudal/ideal/surface.h>
#include <caudal/io/checkpoints.h>
#include <caudal/io/field_output.h>
#include <caudal/mesh/shape.h>

namespace caudal
{
  using namespace dealii;

  /** Section `Time` of a run of the potential model: when there is output. */
  struct OutputSchedule
  {
    double end_time   = 20.;
    double step       = 0.01;
    double first_step = 0.001;
    double first_part = 1.;

    void add_parameters(ParameterHandler &prm);
    void check() const;

    /** All times of output [s], from 0 to the end. */
    std::vector<double> get_times() const;
  };

  /** Section `Body <name>`: the swimmer at rest and how it moves. */
  struct IdealBodyParameters
  {
    ShapeParameters<3>  shape{"stations", 0.1};
    GaitParameters      gait{"arctangent"};
    double              density         = 0.; // 0: that of the fluid
    std::vector<double> linear_impulse  = {0., 0., 0.};
    std::vector<double> angular_impulse = {0., 0., 0.};

    void add_parameters(ParameterHandler &prm);
    void check(const std::string &path) const;
    bool is_from_rest() const;

    /** (Lambda, Pi) at the start. */
    ideal::Screw get_impulse() const;
  };

  /** Section `Integration`. */
  struct IntegrationParameters
  {
    std::string  method    = "table";
    unsigned int n_phases  = 32;
    double       tolerance = 1e-9;
    bool         torques   = true;

    void add_parameters(ParameterHandler &prm);
    void check() const;
  };

  /** All parameters of a run of the swimmer in an ideal fluid. */
  struct IdealParameters
  {
    /**
     * What body and motion are, and columns of the tables depend on: entries that can't change
     * in the middle of a run, as a regular expression.
     */
    static constexpr const char *fixed_entries =
        "Model|Bodies|Body .*|Surface/.*|Fluid/Density|Integration/Torques|"
        "Resistance/Active|Output/Format";

    std::string                 model = "potential";
    std::string                 body_name;
    double                      fluid_density = 1000.;
    OutputSchedule              time;
    ideal::SurfaceParameters    surface;
    IdealBodyParameters         body;
    IntegrationParameters       integration;
    ideal::ResistanceParameters resistance;
    OutputParameters            output;
    CheckpointParameters        checkpoint;

    /** The body is the one that @p file names; without a file it is called `<name>`. */
    explicit IdealParameters(const ParameterFile *file);

    /** Entries that had other names in earlier versions. */
    static std::vector<RenamedEntry> get_renamed_entries();

    void declare(ParameterHandler &prm);
    void check() const;

    ideal::Densities get_densities() const;

    std::string get_body_path() const
    {
      return "Body " + body_name;
    }
  };
} // namespace caudal

#endif
