// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/solid/bending.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    constexpr unsigned int n_sections = 40;

    /** The force that the gait's constraint exerts on each node, in the domain's directions. */
    template <int dim>
    Vector<double> compute_constraint_force(const Body<dim> &body, const BodyState &state,
                                            const double time, const double step)
    {
      const BodyMotion motion = body.get_motion(state, time, step);
      ForcesByAccount  forces;
      for (const LoadAccount account :
           {LoadAccount::elastic, LoadAccount::feedback, LoadAccount::gravity})
        forces[account] = body.compute_force(account, motion);
      Vector<double> acceleration(state.velocity);
      acceleration -= state.old_velocity;
      if (step > 0.)
        acceleration /= step;
      return body.compute_gait_force(state.force_density, forces, acceleration);
    }

    /** A node in the frame of the gait: its section, place and the force on it. */
    template <int dim>
    struct LoadedNode
    {
      double         s;
      Tensor<1, dim> place, force;
    };

    template <int dim>
    std::vector<LoadedNode<dim>>
    bring_to_gait(const SolidBody<dim> &solid, const RigidMotion<dim> &fit,
                  const Vector<double> &positions, const Vector<double> &forces)
    {
      const Tensor<2, dim>         back = transpose(fit.rotation);
      std::vector<LoadedNode<dim>> nodes;
      for (const auto &node : solid.get_nodes())
        nodes.push_back({solid.get_reference_point(node[0])[0],
                         back * (get_value(positions, node) - fit.center) + fit.reference_center,
                         back * Tensor<1, dim>(get_value(forces, node))});
      return nodes;
    }

    /** The torque on the nodes behind the section at @p s about the spine there. */
    template <int dim>
    double compute_torque(const std::vector<LoadedNode<dim>> &nodes, const double s,
                          const Point<2> &spine)
    {
      double torque = 0;
      for (const auto &[section, place, force] : nodes)
        if (section > s)
          torque += (place[0] - spine[0]) * force[1] - (place[1] - spine[1]) * force[0];
      return torque;
    }
  } // namespace

  template <int dim>
  Bending compute_bending(const Body<dim> &body, const BodyState &state, const double time,
                          const double step)
  {
    Bending               result;
    const SolidBody<dim> &solid = body.get_solid();
    const auto           &nodes = solid.get_nodes();
    const auto            shape = body.get_prescribed_motion().compute(time).positions;
    const auto            fit   = lay_over(solid, shape, state.positions);
    for (unsigned int n = 0; n < nodes.size(); ++n)
      result.distance +=
          (fit.apply(shape[n]) - get_value(state.positions, nodes[n])).norm_square() / nodes.size();
    result.distance = std::sqrt(result.distance) / body.get_length();
    if (body.get_gait().shifts_sections())
      return result;

    const double        length = body.get_gait().get_length();
    std::vector<double> sections; // the ends of equal pieces, and their middles
    for (unsigned int i = 0; i <= 2 * n_sections; ++i)
      sections.push_back(length * i / (2 * n_sections));
    const auto spine  = compute_gait_points(body.get_gait(), sections, time);
    const auto loaded = bring_to_gait(solid, fit, state.positions,
                                      compute_constraint_force(body, state, time, step));
    const auto torque = [&](const unsigned int i) {
      return compute_torque(loaded, sections[i], spine[i].place);
    };
    for (unsigned int i = 0; i < n_sections; ++i)
      result.power +=
          torque(2 * i + 1) * (spine[2 * i + 2].turning_rate - spine[2 * i].turning_rate);
    for (unsigned int k = 1; k < 10; ++k)
      result.torques.push_back(torque(2 * n_sections / 10 * k));
    return result;
  }

  template Bending compute_bending(const Body<2> &, const BodyState &, double, double);
  template Bending compute_bending(const Body<3> &, const BodyState &, double, double);
} // namespace caudal
