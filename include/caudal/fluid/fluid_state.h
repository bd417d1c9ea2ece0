// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_fluid_state_h
#define caudal_fluid_fluid_state_h

#include <caudal/fluid/fluid_space.h>

#include <deal.II/numerics/data_postprocessor.h>

namespace caudal
{
  /** The fluid's fields, all with up-to-date ghost values. */
  template <int dim>
  struct FluidState
  {
    /** At t^n and t^{n-1} [m/s]. */
    FieldVector velocity, old_velocity;
    /** At the last step [Pa]. */
    FieldVector pressure;

    /** Zero fields on the present grid. */
    void reinit(const FluidSpace<dim> &space);
    void update_ghost_values() const;
  };

  /** The nodal interpolant of the initial velocity of the .prm. */
  template <int dim>
  void set_initial_velocity(const FluidSpace<dim> &space, FluidState<dim> &state);

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
  };

  template <int dim>
  FlowSummary<dim> summarise_flow(const FluidSpace<dim> &space, const FieldVector &velocity);

  /**
   * What the local projection stabilisation of the convection dissipates,
   * int tau |k(u.grad u)|^2 [W, per metre of span in 2D: W/m]; @p rate [1/s] is the
   * weight of the present velocity in the time derivative, by which tau is limited, see
   * CellMatrices::get_convection_matrix().
   */
  template <int dim>
  double compute_stabilisation_dissipation(const FluidSpace<dim> &space,
                                           const FieldVector &velocity, double rate);

  /** Velocity [m/s] and pressure [Pa] at a point. */
  template <int dim>
  struct ProbeValues
  {
    Tensor<1, dim> velocity;
    double         pressure = 0;
  };

  /**
   * Velocity and pressure at @p point; the pressure, which jumps from cell to cell,
   * is the mean of those of all cells that meet there. Collective.
   */
  template <int dim>
  ProbeValues<dim> evaluate_at(const FluidSpace<dim> &space, const FluidState<dim> &state,
                               const Point<dim> &point);

  /** Largest h |vorticity| of each active cell of this rank, h the cell's edge [m/s]. */
  template <int dim>
  Vector<float> compute_vorticity_indicator(const FluidSpace<dim> &space,
                                            const FieldVector     &velocity);

  /** The vorticity for DataOut: a scalar in 2D, a vector in 3D [1/s]. */
  template <int dim>
  class VorticityPostprocessor : public DataPostprocessor<dim>
  {
  public:
    void evaluate_vector_field(const DataPostprocessorInputs::Vector<dim> &input,
                               std::vector<Vector<double>> &quantities) const override;
    std::vector<std::string> get_names() const override;
    std::vector<DataComponentInterpretation::DataComponentInterpretation>
                get_data_component_interpretation() const override;
    UpdateFlags get_needed_update_flags() const override;
  };
} // namespace caudal

#endif
