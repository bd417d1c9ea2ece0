// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_stroke_model_h
#define caudal_ideal_stroke_model_h

#include <caudal/ideal/swimming_shape.h>

#include <memory>

namespace caudal::ideal
{
  /**
   * Torques of the modes together with external forces on them [N m], by Lagrange's equations:
   * Q_i = d/dt (dT/dc_i') - dT/dc_i. @p state_rate: StrokeModel::compute_state_rate().
   */
  std::vector<double> compute_torques(const StrokeState &state, const StrokeState &state_rate,
                                      const Drive &drive);

  /** How the body and the fluid around it respond to the gait, at any instant. */
  class StrokeModel
  {
  public:
    virtual ~StrokeModel() = default;

    virtual MotionCoefficients compute_motion(double argument) = 0;
    virtual StrokeState        compute_state(double argument)  = 0;

    /** The derivative of the state by the argument, but for those of the coordinates. */
    virtual StrokeState compute_state_rate(double argument) = 0;

    /** The potentials of Potentials::values at the surface's nodes. */
    virtual FullMatrix<double> compute_potentials(double argument) = 0;

    /** Torques of the modes [N m] for the states at the argument, by the function above. */
    std::vector<double> compute_torques(double argument, const Drive &drive);
  };

  /**
   * The model that solves for the fluid around a new surface at each instant. Rates are
   * differences over twice the @p increment of the argument.
   */
  std::unique_ptr<StrokeModel> create_brute_force(SwimmingShape &shape, double increment);

  /**
   * The states of one stroke of a periodic gait at equidistant phases, with trigonometric
   * interpolation between them: for smooth functions its error falls faster than any power of the
   * number of phases. It does not depend on the frequency. If the second half of the stroke
   * mirrors the first one, only that is computed.
   */
  class PhaseTable : public StrokeModel
  {
  public:
    /**
     * The phases are shared among the ranks of @p communicator (that of @p shape should be
     * MPI_COMM_SELF). Collective.
     */
    PhaseTable(SwimmingShape &shape, unsigned int n_phases, MPI_Comm communicator);

    MotionCoefficients compute_motion(double psi) override;
    StrokeState        compute_state(double psi) override;
    StrokeState        compute_state_rate(double psi) override;
    FullMatrix<double> compute_potentials(double psi) override;

    /** The number of phases that were computed: all, or half of them. */
    unsigned int get_n_computed() const
    {
      return is_mirrored ? n_phases / 2 : n_phases;
    }

  private:
    std::vector<double> compute_weights(double psi, bool of_derivative) const;

    /** The sum of the states of all phases times the @p weights. */
    StrokeState interpolate(const std::vector<double> &weights) const;

    const Gait                 &gait;
    const unsigned int          n_phases;
    const bool                  is_mirrored;
    std::vector<StrokeSolution> solutions; // by phase
  };
} // namespace caudal::ideal

#endif
