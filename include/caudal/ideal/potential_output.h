#ifndef caudal_ideal_potential_output_h
#define caudal_ideal_potential_output_h

#include <caudal/ideal/motion_sample.h>
#include <caudal/ideal/potential_parameters.h>
#include <caudal/io/output_folder.h>
#include <caudal/io/statistics.h>

#include <memory>

namespace caudal
{
  /** What a swim's output has come to. */
  struct OutputCounters
  {
    unsigned int n_rows      = 0; // due, if not written
    unsigned int n_fields    = 0;
    double       next_fields = 0.; // [s]

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &n_rows &n_fields &next_fields;
    }
  };

  /**
   * Writes what happens in the swim at one frequency: a row of statistics.txt for each time,
   * and the surface with pressure, potential and velocity of the fluid as fields.
   */
  class PotentialOutput
  {
  public:
    /**
     * @p suffix distinguishes the files of several frequencies ("_0.64Hz"). Goes on from the
     * @p counters and keeps the rows of an earlier run up to @p kept_time [s]. Collective.
     */
    PotentialOutput(const PotentialParameters &parameters, ideal::SwimmingShape &shape,
                    ideal::StrokeModel &model, const OutputFolder &folder, FieldOutput &fields,
                    const std::string &suffix, OutputCounters &counters, double kept_time,
                    MPI_Comm communicator);

    /**
     * A row, and fields if they are due. @p distance is that of the centre of mass from its
     * start [m]. Collective.
     */
    void write(const ideal::MotionSample &sample, const ideal::MotionProblem &problem,
               double distance);

    /**
     * Removes what a run that is resumed wrote of a swim after @p time [s]: fields from the list
     * and, if it is to begin anew (negative), its table. Collective.
     */
    static void remove_after(double time, const OutputFolder &folder, FieldOutput &fields,
                             const std::string &suffix, MPI_Comm communicator);

  private:
    void write_row(const ideal::MotionSample &sample, double rate, double distance);
    void write_fields(const ideal::MotionSample &sample, const ideal::MotionProblem &problem);

    const PotentialParameters &parameters;
    ideal::SwimmingShape      &shape;
    ideal::StrokeModel        &model;
    const std::string          name; // of the body in the list of fields
    const MPI_Comm             communicator;
    Statistics                 statistics;
    FieldOutput               &fields;
    OutputCounters            &counters;
    DoFHandler<2, 3>           place_handler;
  };
} // namespace caudal

#endif
