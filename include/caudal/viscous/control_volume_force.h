#ifndef caudal_viscous_control_volume_force_h
#define caudal_viscous_control_volume_force_h

#include <caudal/observe/backward_difference.h>
#include <caudal/observe/observation.h>

#include <deal.II/base/bounding_box.h>

#include <cmath>

namespace caudal
{
  /**
   * The force of the surrounding fluid on the bodies B in a control volume V, by the momentum
   * balance of the flow (per metre of span in 2D),
   *   F = Phi - dP/dt [N/m],  P = int_V rho u - int_B rho u [N s/m],
   * Phi the other forces on the fluid in V with the momentum that flows in (MomentumBalance), and
   * its impulse since the first step,
   *   I = int Phi dt - (P - P_0) + J [N s/m],
   * by the trapezoidal rule, as BDF2's sum over the steps asks for: so the mean force over a time
   * needs no derivative.
   *
   * J is the momentum in V that changes of the grid have brought, by interpolation and projection
   * between two steps. No force has, so that it is left out of the impulse and, by shifting the
   * earlier samples of P, of the force, which otherwise has a spike J/dt.
   */
  template <int dim>
  class ControlVolumeForce
  {
  public:
    /** V are the coarse cells with their centre in @p box. */
    explicit ControlVolumeForce(const BoundingBox<dim> &box);

    /** Whether all bodies, with the kernel's support, are in V. */
    bool has_all_bodies(const Observation<dim> &observation) const;

    /** After each step. */
    void update(const Observation<dim> &observation);

    /** After each change of the grid between two steps. */
    void adapt(const Observation<dim> &observation);

    const Tensor<1, dim> &get_force() const
    {
      return force;
    }

    /** Since the first step; NaN from the step on in which a body reached out of V. */
    const Tensor<1, dim> &get_impulse() const
    {
      return impulse;
    }

    /** Whether all bodies were in V in all steps. */
    bool is_valid() const
    {
      return !std::isnan(impulse[0]);
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &momentum &other_forces &impulse;
    }

  private:
    BoundingBox<dim>        box;
    BackwardDifference<dim> momentum;     // P
    Tensor<1, dim>          other_forces; // Phi
    Tensor<1, dim>          force, impulse;

    Tensor<1, dim> compute_body_momentum(const Observation<dim> &observation) const;
  };
} // namespace caudal

#endif
