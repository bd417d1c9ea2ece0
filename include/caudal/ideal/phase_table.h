// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_phase_table_h
#define caudal_ideal_phase_table_h

#include <caudal/ideal/stroke_model.h>

namespace caudal::ideal
{
  /**
   * The states of one stroke of a periodic gait at equidistant phases, with trigonometric
   * interpolation between them. It does not depend on the frequency. If the second half of
   * the stroke mirrors the first one, only that is computed.
   */
  class PhaseTable : public StrokeModel
  {
  public:
    /**
     * The phases are shared among the ranks of @p communicator (that of @p shape should be
     * MPI_COMM_SELF). Collective.
     */
    PhaseTable(SwimmingShape &shape, unsigned int n_phases, MPI_Comm communicator);

    MotionCoefficients  compute_motion(double psi) override;
    StrokeState         compute_state(double psi) override;
    std::vector<double> compute_torques(double psi, const Drive &drive) override;
    Tensor<1, 3>        compute_centre_rate(double psi) override;
    FullMatrix<double>  compute_potentials(double psi) override;

    /** The number of phases that were computed: all, or half of them. */
    unsigned int get_n_computed() const
    {
      return is_mirrored ? n_phases / 2 : n_phases;
    }

  private:
    void        add_second_half(const Surface &surface);
    StrokeState make_state(const std::vector<double> &row) const;

    const Gait                      &gait;
    const unsigned int               n_modes, n_drives, n_phases;
    const bool                       is_mirrored;
    std::vector<std::vector<double>> states;     // numbers by phase
    std::vector<std::vector<double>> potentials; // by phase, then node and motion
  };
} // namespace caudal::ideal

#endif
