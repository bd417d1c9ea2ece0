#ifndef caudal_viscous_force_account_h
#define caudal_viscous_force_account_h

#include <caudal/io/statistics.h>
#include <caudal/viscous/control_volume_force.h>

#include <boost/serialization/vector.hpp>

#include <optional>

namespace caudal
{
  /**
   * The force of the surrounding fluid on the bodies, by up to three accounts
   * that should agree (per metre of span in 2D):
   * - body force: d/dt int_B rho u - int_B f, f the force density on the fluid;
   * - feedback force: the same with the feedback forces alone; for bodies that
   *   are held and neither swim nor have another density than the fluid;
   * - control volume: the momentum balance of the flow round all bodies (ControlVolumeForce).
   * The inertia of the fluid in the place of the bodies B is part of all of them.
   */
  template <int dim>
  class ForceAccount
  {
  public:
    explicit ForceAccount(const Observation<dim> &observation);

    /** After each step. */
    void update(const Observation<dim> &observation);

    /** After each change of the grid between two steps. */
    void adapt(const Observation<dim> &observation);

    /** int_B f of a body [N/m], the resultant of all its forces on the fluid. */
    const Tensor<1, dim> &get_resultant(const unsigned int body) const
    {
      return resultants[body];
    }

    /** The impulse by the control volume since the start [N s/m]; NaN if it is not known. */
    Tensor<1, dim> get_control_volume_impulse() const;

    /** Whether what the control volume tells is the force on the bodies; true without one. */
    bool is_control_volume_valid() const
    {
      return !control_volume || control_volume->is_valid();
    }

    void set_body_statistics(const Observation<dim> &observation, unsigned int body,
                             Statistics &statistics) const;
    void set_control_volume_statistics(Statistics &statistics) const;

    /** What later forces depend on. */
    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &body_momenta;
      if (control_volume)
        archive &*control_volume;
    }

  private:
    std::optional<ControlVolumeForce<dim>> control_volume;
    std::vector<BackwardDifference<dim>>   body_momenta;
    std::vector<Tensor<1, dim>>            resultants, body_forces, feedback_forces;
  };
} // namespace caudal

#endif
