// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_surface_output_h
#define caudal_ideal_surface_output_h

#include <caudal/ideal/motion_sample.h>
#include <caudal/io/field_output.h>

namespace caudal::ideal
{
  /** Writes the body's surface with pressure, potential and velocity of the fluid as fields. */
  class SurfaceOutput
  {
  public:
    /**
     * @p name is that of the swim in the list of fields. Refers to shape, model and fields.
     * @p n_subdivisions of a cell, at least two, since the cells are curved.
     */
    SurfaceOutput(const SwimmingShape &shape, StrokeModel &model, FieldOutput &fields,
                  const std::string &name, unsigned int n_subdivisions);

    /** Writes the file with the number @p counter. Collective. */
    void write(const MotionSample &sample, const MotionProblem &problem, unsigned int counter);

  private:
    Vector<double> compute_potential(const MotionSample &sample, const Screw &impulse_rate,
                                     double time, double rate) const;
    Vector<double> compute_potential_rate(const MotionSample  &sample,
                                          const MotionProblem &problem) const;

    const SwimmingShape &shape;
    StrokeModel         &model;
    FieldOutput         &fields;
    const std::string    name;
    const unsigned int   n_subdivisions;
    DoFHandler<2, 3>     vectors;
  };
} // namespace caudal::ideal

#endif
