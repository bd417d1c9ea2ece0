// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_fluid_state_h
#define caudal_fluid_fluid_state_h

#include <caudal/fluid/fluid_space.h>

namespace caudal
{
  /** The fluid's fields, all with up-to-date ghost values. */
  template <int dim>
  struct FluidState
  {
    /** At t^n, t^{n-1} and t^{n-2} [m/s]. */
    FieldVector velocity, old_velocity, older_velocity;
    /** At the last step [Pa]. */
    FieldVector pressure;

    /** Zero fields on the present grid. */
    void reinit(const FluidSpace<dim> &space);
    void update_ghost_values() const;

    std::vector<FieldVector *> get_velocities()
    {
      return {&velocity, &old_velocity, &older_velocity};
    }
    std::vector<const FieldVector *> get_velocities() const
    {
      return {&velocity, &old_velocity, &older_velocity};
    }
  };

  /** Integral quantities of a velocity field (per metre of span in 2D). */
  template <int dim>
  struct FlowSummary
  {
    /** rho/2 int |u|^2 [J/m] */
    double kinetic_energy = 0;
    /** mu int |grad u|^2 and the part of the grad-div term [W/m] */
    double viscous_dissipation = 0, grad_div_dissipation = 0;
    /** largest nodal |u| [m/s] */
    double largest_velocity = 0;
    /** largest |u|/h in a cell, h the spacing of its velocity nodes [1/s] */
    double largest_rate = 0;
    /** (int (div u)^2)^(1/2) */
    double divergence_norm = 0;
    /** rho int u [kg m/s per m] */
    Tensor<1, dim> momentum;

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &kinetic_energy &viscous_dissipation &grad_div_dissipation &largest_velocity
          &largest_rate &divergence_norm &momentum;
    }
  };

  /** @p grid_velocity [m/s] counts in FlowSummary::largest_rate, u - w being in place of u. */
  template <int dim>
  FlowSummary<dim> summarise_flow(const FluidSpace<dim> &space, const FieldVector &velocity,
                                  const Tensor<1, dim> &grid_velocity = {});

  /** FlowSummary::kinetic_energy alone, which costs less. */
  template <int dim>
  double compute_kinetic_energy(const FluidSpace<dim> &space, const FieldVector &velocity);

  /**
   * What the local projection stabilisation of the convection dissipates,
   * int tau |k(u.grad u)|^2 [W, per metre of span in 2D: W/m]; @p rate [1/s] is the
   * weight of the present velocity in the time derivative, by which tau is limited, see
   * CellMatrices::get_convection_matrix(). In a grid with @p grid_velocity w the first u is u - w.
   */
  template <int dim>
  double compute_stabilisation_dissipation(const FluidSpace<dim> &space,
                                           const FieldVector &velocity, double rate,
                                           const Tensor<1, dim> &grid_velocity = {});
} // namespace caudal

#endif
