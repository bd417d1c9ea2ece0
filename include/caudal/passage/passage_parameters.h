// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_passage_passage_parameters_h
#define caudal_passage_passage_parameters_h

#include <caudal/base/parameter_file.h>
#include <caudal/io/field_output.h>
#include <caudal/passage/batch.h>
#include <caudal/passage/design.h>
#include <caudal/passage/endurance_law.h>
#include <caudal/passage/population.h>
#include <caudal/passage/power_curve.h>
#include <caudal/passage/strategy.h>
#include <caudal/passage/turbine.h>
#include <caudal/passage/water_source.h>

namespace caudal
{
  /** Section `Passage`: the way. */
  struct WayParameters
  {
    Choice<passage::WaterSource> source{"Type", "channel", "Where velocities and depths are from"};
    double                       velocity_factor = 1.;
    std::string                  drops_text, rests_text;
    double                       rest_spacing = 0.; // [m]; 0: none

    void add_parameters(ParameterHandler &prm);
    void check() const;

    /** The way at each discharge, with drops and rests, as the fish meets it. */
    std::vector<passage::Waterway> make_waterways() const;

    /** Adds drops, rests and the velocity factor to what the source gives. */
    passage::Waterway complete(const passage::Waterway &water) const;
  };

  /** All parameters of a run of the model `passage`. */
  struct PassageParameters
  {
    std::string                   model = "passage";
    passage::Population           population;
    Choice<passage::EnduranceLaw> law{"Law", "Katopodis-Gervais", "How long which speed is held"};
    WayParameters                 way;
    Choice<passage::Strategy>     strategy{"Type", "best speed", "Which speeds the fish choose"};
    Choice<passage::PowerCurve>   power{"Type", "none", "The power at a speed"};
    passage::DesignParameters     design;
    passage::BatchParameters      batch;
    passage::TurbineParameters    turbine;
    OutputParameters              output;

    /** Which sections there are does not depend on the file. */
    explicit PassageParameters(const ParameterFile * /*file*/) {}

    /** There were none in earlier versions. */
    static std::vector<RenamedEntry> get_renamed_entries()
    {
      return {};
    }

    void declare(ParameterHandler &prm);
    void check() const;

    passage::Question get_question() const
    {
      return {law.get(), strategy.get(), population};
    }
  };
} // namespace caudal

#endif
