// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_face_flow_h
#define caudal_fluid_face_flow_h

#include <caudal/fluid/fluid_state.h>

#include <deal.II/fe/fe_values.h>

namespace caudal
{
  /** The flow on one side of a face, in its quadrature points. */
  template <int dim>
  struct FaceFlow
  {
    std::vector<Tensor<1, dim>> velocity;
    std::vector<Tensor<2, dim>> gradient;
    std::vector<double>         pressure;

    void evaluate(const FEValuesBase<dim> &velocities, const FEValuesBase<dim> &pressures,
                  const FluidState<dim> &state)
    {
      const FEValuesExtractors::Vector components(0);
      velocity.resize(velocities.n_quadrature_points);
      gradient.resize(velocity.size());
      pressure.resize(velocity.size());
      velocities[components].get_function_values(state.velocity, velocity);
      velocities[components].get_function_gradients(state.velocity, gradient);
      pressures.get_function_values(state.pressure, pressure);
    }
  };
} // namespace caudal

#endif
