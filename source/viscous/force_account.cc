#include <caudal/viscous/force_account.h>

#include <limits>

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

    template <int dim>
    void set_vector(Statistics &statistics, const std::string &name, const std::string &cause,
                    const Tensor<1, dim> &force)
    {
      for (unsigned int d = 0; d < dim; ++d)
        statistics.set(name + " " + "xyz"[d] + " " + cause, get_extensive_unit<dim>("N"), force[d]);
    }
  } // namespace

  template <int dim>
  ForceAccount<dim>::ForceAccount(const Observation<dim> &observation)
      : body_momenta(observation.bodies.size())
      , resultants(observation.bodies.size())
      , body_forces(observation.bodies.size())
      , feedback_forces(observation.bodies.size())
  {
    const auto &corners = observation.space.get_parameters().control_volume;
    if (!corners.empty())
      control_volume.emplace(BoundingBox<dim>({corners[0], corners[1]}));
  }

  template <int dim>
  void ForceAccount<dim>::update(const Observation<dim> &observation)
  {
    const double density = observation.space.get_parameters().density;
    for (unsigned int b = 0; b < observation.bodies.size(); ++b)
    {
      const auto &[body, state, report] = observation.bodies[b];
      const SolidBody<dim> &solid       = body.get_solid();
      const auto           &size        = solid.get_nodal_volumes();
      body_momenta[b].add(observation.time, density * sum_over_nodes(solid, state.velocity, &size));
      const Tensor<1, dim> change = body_momenta[b].get_derivative();
      resultants[b]               = sum_over_nodes(solid, state.force_density, &size);
      body_forces[b]              = change - resultants[b];
      feedback_forces[b] =
          change - sum_over_nodes(solid, body.compute_force(LoadAccount::feedback,
                                                            body.get_motion(state, observation.time,
                                                                            observation.step)));
    }
    if (control_volume)
      control_volume->update(observation);
  }

  template <int dim>
  void ForceAccount<dim>::adapt(const Observation<dim> &observation)
  {
    if (control_volume)
      control_volume->adapt(observation);
  }

  template <int dim>
  Tensor<1, dim> ForceAccount<dim>::get_control_volume_impulse() const
  {
    Tensor<1, dim> unknown;
    unknown[0] = std::numeric_limits<double>::quiet_NaN();
    return control_volume ? control_volume->get_impulse() : unknown;
  }

  template <int dim>
  void ForceAccount<dim>::set_body_statistics(const Observation<dim> &observation,
                                              const unsigned int b, Statistics &statistics) const
  {
    const Body<dim> &body = observation.bodies[b].body;
    set_vector(statistics, body.get_name() + ": force", "of the fluid", body_forces[b]);
    if (is_merely_held(body))
      set_vector(statistics, body.get_name() + ": force", "by feedback", feedback_forces[b]);
  }

  template <int dim>
  void ForceAccount<dim>::set_control_volume_statistics(Statistics &statistics) const
  {
    if (control_volume)
      set_vector(statistics, "force", "by control volume", control_volume->get_force());
  }

  template class ForceAccount<2>;
  template class ForceAccount<3>;
} // namespace caudal
