#ifndef caudal_app_potential_output_h
#define caudal_app_potential_output_h

#include <caudal/app/potential_parameters.h>
#include <caudal/io/output_folder.h>
#include <caudal/io/statistics.h>
#include <caudal/potential/motion_sample.h>

#include <memory>

namespace caudal
{
  /**
   * Writes what happens in the swim at one frequency: a row of statistics.txt for each time,
   * and the surface with pressure, potential and velocity of the fluid as fields.
   */
  class PotentialOutput
  {
  public:
    /** @p suffix distinguishes the files of several frequencies ("_0.64Hz"). Collective. */
    PotentialOutput(const PotentialParameters &parameters, potential::SwimmingShape &shape,
                    potential::StrokeModel &model, const OutputFolder &folder, FieldOutput &fields,
                    const std::string &suffix, MPI_Comm communicator);

    /** A row, and fields if they are due. @p rate is that of the gait [rad/s]. Collective. */
    void write(const potential::MotionSample &sample, double rate);

  private:
    void write_row(const potential::MotionSample &sample, double rate);
    void write_fields(const potential::MotionSample &sample, double rate);

    const PotentialParameters &parameters;
    potential::SwimmingShape  &shape;
    potential::StrokeModel    &model;
    const std::string          name; // of the body in the list of fields
    const MPI_Comm             communicator;
    Statistics                 statistics;
    FieldOutput               &fields;
    DoFHandler<2, 3>           place_handler;
    Tensor<1, 3>               first_centre;
    unsigned int               n_rows = 0, n_fields = 0;
    double                     next_fields = 0.; // [s]
  };
} // namespace caudal

#endif
