// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_flow_evaluation_h
#define caudal_observe_flow_evaluation_h

#include <caudal/observe/observation.h>

namespace caudal
{
  /** The flow at a point. */
  template <int dim>
  struct FlowValue
  {
    Tensor<1, dim> velocity;     // [m/s]
    Tensor<2, dim> gradient;     // du_i/dx_j [1/s]
    double         pressure = 0; // [Pa]
  };

  /** Evaluates the flow at points of this rank's cells. */
  template <int dim>
  class FlowEvaluation
  {
  public:
    FlowEvaluation(const FluidSpace<dim> &space, const FluidState<dim> &fluid);
    ~FlowEvaluation();

    /** At @p unit_points of a locally owned @p cell. */
    std::vector<FlowValue<dim>>
    evaluate(const typename Triangulation<dim>::active_cell_iterator &cell,
             const std::vector<Point<dim>>                           &unit_points);

  private:
    class Velocity;

    const FluidSpace<dim>    &space;
    const FluidState<dim>    &fluid;
    std::unique_ptr<Velocity> velocity;
  };

  /**
   * The flow at points of the grid's frame, wherever they are: those beyond a side of the domain
   * get what is nearest to them on that side. Throws if it is not finite somewhere. Collective; all
   * ranks have the same @p points and get the same values.
   */
  template <int dim>
  std::vector<FlowValue<dim>> evaluate_flow(const Observation<dim>        &observation,
                                            const std::vector<Point<dim>> &points);
} // namespace caudal

#endif
