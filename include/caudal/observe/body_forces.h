// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_body_forces_h
#define caudal_observe_body_forces_h

#include <caudal/observe/backward_difference.h>
#include <caudal/observe/observer.h>

namespace caudal
{
  /**
   * Columns with the force of the surrounding fluid on the bodies, by two accounts that should
   * agree with each other and with ControlVolume (per metre of span in 2D):
   * - body force: d/dt int_B rho u - int_B f, f the force density on the fluid;
   * - feedback force: the same with the feedback forces alone; for bodies that
   *   are held and neither swim nor have another density than the fluid.
   * The inertia of the fluid in the place of the bodies B is part of both.
   */
  template <int dim>
  class BodyForces : public Observer<dim>
  {
  public:
    BodyForces()
        : Observer<dim>(20)
    {}

    void start(const Observation<dim> &, const ObserverContext<dim> &) override;
    void observe_step(const Observation<dim> &, const ObserverContext<dim> &) override;
    void set_body_columns(const Observation<dim> &, unsigned int body, Statistics &) const override;
    void exchange_state(StateArchive &archive) override;

    /** int_B f of a body [N/m], the resultant of all its forces on the fluid, in the last step. */
    const Tensor<1, dim> &get_resultant(const unsigned int body) const
    {
      return resultants[body];
    }

  private:
    std::vector<BackwardDifference<dim>> momenta;
    std::vector<Tensor<1, dim>>          resultants;
  };
} // namespace caudal

#endif
