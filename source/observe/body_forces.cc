// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/body_forces.h>

#include <boost/serialization/vector.hpp>

namespace caudal
{
  namespace
  {
    /** The sum of a vector's entries over the nodes, weighted. */
    template <int dim>
    Tensor<1, dim> sum_over_nodes(const SolidBody<dim> &solid, const Vector<double> &vector,
                                  const Vector<double> *weights = nullptr)
    {
      Tensor<1, dim> sum;
      for (const auto &node : solid.get_nodes())
        for (unsigned int d = 0; d < dim; ++d)
          sum[d] += vector[node[d]] * (weights != nullptr ? (*weights)[node[d]] : 1.);
      return sum;
    }

    /** Whether feedback forces are all that can have a resultant on the body. */
    template <int dim>
    bool is_merely_held(const Body<dim> &body)
    {
      const SolidBody<dim> &solid = body.get_solid();
      return !body.swims() && solid.get_excess_density() == 0 &&
             solid.get_parameters().traction.empty() &&
             (solid.get_feedback_stiffness().linfty_norm() > 0 ||
              solid.get_feedback_damping().linfty_norm() > 0);
    }

    const DimensionalRegistration<Observer, BodyForces>
        registration("body forces", "the force of the fluid on each body");
  } // namespace

  template <int dim>
  void BodyForces<dim>::start(const Observation<dim> &observation, const ObserverContext<dim> &)
  {
    momenta.resize(observation.bodies.size());
    resultants.resize(observation.bodies.size());
  }

  template <int dim>
  void BodyForces<dim>::observe_step(const Observation<dim> &observation,
                                     const ObserverContext<dim> &)
  {
    const double density = observation.space.get_parameters().density;
    for (unsigned int b = 0; b < observation.bodies.size(); ++b)
    {
      const SolidBody<dim> &solid = observation.bodies[b].body.get_solid();
      const BodyState      &state = observation.bodies[b].state;
      const Vector<double> &size  = solid.get_nodal_volumes();
      momenta[b].add(observation.time, density * sum_over_nodes(solid, state.velocity, &size));
      resultants[b] = sum_over_nodes(solid, state.force_density, &size);
    }
  }

  template <int dim>
  void BodyForces<dim>::set_body_columns(const Observation<dim> &observation, const unsigned int b,
                                         Statistics &statistics) const
  {
    const auto &[body, state, report] = observation.bodies[b];
    const Tensor<1, dim> change       = momenta[b].get_derivative();
    const auto           set          = [&, &name = body.get_name()](const std::string    &cause,
                                                  const Tensor<1, dim> &force) {
      for (unsigned int d = 0; d < dim; ++d)
        statistics.set(name + ": force " + "xyz"[d] + cause, get_extensive_unit<dim>("N"),
                                          change[d] - force[d]);
    };
    set(" of the fluid", resultants[b]);
    if (is_merely_held(body))
      set(" by feedback", sum_over_nodes(body.get_solid(),
                                         body.compute_force(LoadAccount::feedback,
                                                            body.get_motion(state, observation.time,
                                                                            observation.step))));
  }

  template <int dim>
  void BodyForces<dim>::exchange_state(StateArchive &archive)
  {
    archive &momenta;
  }

  template class BodyForces<2>;
  template class BodyForces<3>;
} // namespace caudal
