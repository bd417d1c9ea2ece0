// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_ideal_case_h
#define caudal_ideal_ideal_case_h

#include <caudal/ideal/deformation.h>
#include <caudal/ideal/ideal_parameters.h>

#include <memory>
#include <ostream>

namespace caudal
{
  /** A body at rest in an ideal fluid, with its surface and its gait. */
  class IdealCase
  {
  public:
    /** Refuses with a sentence what can't work. Refers to the parameters. */
    explicit IdealCase(const IdealParameters &parameters);

    /** Tells sizes, and what is likely to surprise. */
    void print_summary(std::ostream &out) const;

    /** Whether the fluid is solved for at some phases of one stroke only. */
    bool uses_table() const
    {
      return parameters.integration.method == "table" && gait->is_periodic();
    }

    /** Whether there are strokes: the gait has a period, and the body is not rigid. */
    bool has_strokes() const
    {
      return gait->is_periodic() && !is_rigid();
    }

    /** Whether it swims without an impulse at the start and without external forces. */
    bool is_from_rest() const
    {
      return parameters.body.is_from_rest() && !parameters.resistance.active && !is_rigid();
    }

    ideal::Torques get_torques() const;

    /** The body's mass [kg]. */
    double compute_mass() const
    {
      return compute_volume() * parameters.get_densities().body;
    }

    const IdealParameters                    &parameters;
    const ideal::Surface                      surface;
    const std::unique_ptr<StraightBody>       straight_body;
    const std::unique_ptr<Gait>               gait;
    const std::unique_ptr<ideal::Deformation> deformation;

  private:
    bool is_rigid() const
    {
      return deformation->n_modes() == 0;
    }

    double compute_volume() const; // [m^3]
    double compute_largest_bend(unsigned int n_samples) const;
  };
} // namespace caudal

#endif
