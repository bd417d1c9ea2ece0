// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_control_volume_h
#define caudal_observe_control_volume_h

#include <caudal/observe/backward_difference.h>
#include <caudal/observe/observer.h>

#include <deal.II/base/bounding_box.h>

namespace caudal
{
  /**
   * Columns with the force of the surrounding fluid on the bodies B in a control volume V, by the
   * momentum balance of the flow (per metre of span in 2D),
   *   F = Phi - dP/dt [N/m],  P = int_V rho u - int_B rho u [N s/m],
   * Phi the other forces on the fluid in V with the momentum that flows in (MomentumBalance), and
   * (with gravity, without the buoyancy -rho g V) its impulse since the first step,
   *   I = int Phi dt - (P - P_0) + J [N s/m],
   * by the trapezoidal rule, as BDF2's sum over the steps asks for: so the mean force over a time
   * needs no derivative.
   *
   * J is the momentum in V that changes of the grid have brought, by interpolation and projection
   * between two steps. No force has, so that it is left out of the impulse and, by shifting the
   * earlier samples of P, of the force, which otherwise has a spike J/dt.
   */
  template <int dim>
  class ControlVolume : public Observer<dim>
  {
  public:
    ControlVolume()
        : Observer<dim>(50)
    {}

    void add_parameters(ParameterHandler &prm) override;
    void check(const std::string &path) const override;
    void check_case(const Observation<dim> &start) const override;
    void observe_step(const Observation<dim> &, const ObserverContext<dim> &) override;
    void observe_new_grid(const Observation<dim> &, const ObserverContext<dim> &) override;
    void set_columns(const Observation<dim> &, Statistics &) const override;
    void exchange_state(StateArchive &archive) override;

    /** Whether the parameters give a volume. */
    bool is_active() const
    {
      return !corners.empty();
    }

    /**
     * Impulse since the first step [N s/m]; its first component is NaN without a volume and from
     * the step on in which a body reached out of V.
     */
    Tensor<1, dim> get_impulse() const;

  private:
    std::vector<Point<dim>> corners;      // lower and upper; V are the coarse cells with centre
                                          // between them
    BackwardDifference<dim> momentum;     // P
    Tensor<1, dim>          other_forces; // Phi
    Tensor<1, dim>          force, impulse;

    BoundingBox<dim> get_box() const
    {
      return BoundingBox<dim>({corners[0], corners[1]});
    }
    bool has_all_bodies(const Observation<dim> &observation) const;
  };
} // namespace caudal

#endif
