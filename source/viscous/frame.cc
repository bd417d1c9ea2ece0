// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/expression.h>
#include <caudal/viscous/operators.h>
#include <caudal/viscous/state.h>

#include <algorithm>

namespace caudal
{
  namespace
  {
    template <int dim>
    DomainVector extend(const Tensor<1, dim> &vector)
    {
      DomainVector result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = vector[d];
      return result;
    }

    /** The integral of the prescribed velocity over a step, by Simpson's rule. */
    template <int dim>
    DomainVector integrate_velocity(const std::string &text, const double time, const double dt)
    {
      Expression<dim> velocity("Domain/Frame velocity", text, dim);
      const auto      evaluate = [&](const double t) {
        velocity.set_time(t);
        DomainVector result;
        for (unsigned int d = 0; d < dim; ++d)
          result[d] = velocity.value(Point<dim>(), d);
        return result;
      };
      return dt / 6. * (evaluate(time) + 4. * evaluate(time + 0.5 * dt) + evaluate(time + dt));
    }

    /** See move_frame(). */
    template <int dim>
    DomainVector follow(const Body<dim> &body, const BodyState &state, const Frame &frame,
                        const double filter_time, const double dt)
    {
      const SolidBody<dim> &solid = body.get_solid();
      const DomainVector    lag   = extend<dim>(solid.compute_mean(state.positions) -
                                           solid.compute_mean(solid.get_initial_positions())) -
                               frame.origin;
      const DomainVector velocity = extend<dim>(body.get_mean_velocity(state));
      const double       a        = dt / filter_time; // implicit: stable for any step
      return (frame.velocity + a * (2. * velocity + lag / filter_time)) / ((1. + a) * (1. + a));
    }

    /** `Domain/Frame time` [s], or a beat, or a second where none is known. */
    template <int dim>
    double get_filter_time(const DomainParameters<dim> &domain, const Body<dim> &body)
    {
      if (domain.frame_time > 0.)
        return domain.frame_time;
      return body.get_beat_frequency() > 0. ? 1. / body.get_beat_frequency() : 1.;
    }
  } // namespace

  template <int dim>
  Frame move_frame(const Operators<dim> &operators, const State<dim> &state, const double dt)
  {
    const DomainParameters<dim> &domain = operators.parameters.domain;
    Frame next{state.frame.origin, state.frame.origin, state.frame.old_origin,
               state.frame.velocity};
    if (domain.frame == "fixed")
      return next;
    if (domain.frame == "moving")
    {
      const DomainVector shift =
          integrate_velocity<dim>(domain.frame_velocity, state.time.get_time(), dt);
      next.velocity = shift / dt;
      next.origin += shift;
      return next;
    }
    for (unsigned int b = 0; b < operators.bodies.size(); ++b)
    {
      const Body<dim> &body = *operators.bodies[b];
      if (body.get_name() == domain.frame)
        next.velocity =
            follow(body, state.bodies[b], state.frame, get_filter_time(domain, body), dt);
    }
    next.origin += dt * next.velocity;
    return next;
  }

  template <int dim>
  Tensor<1, dim> compute_grid_velocity(const State<dim> &state, const Frame &next, const double dt)
  {
    const TimeWeights weights = state.time.get_weights(dt);
    return restrict_to<dim>(weights.derivative[0] * (next.origin - next.old_origin) +
                            weights.derivative[2] * (next.older_origin - next.old_origin));
  }

  template <int dim>
  Vector<double> place_on_grid(const SolidBody<dim> &solid, const Vector<double> &positions,
                               const DomainVector &origin)
  {
    Vector<double> result(positions);
    if (origin != DomainVector())
      for (const auto &node : solid.get_nodes())
        set_value(result, node, get_value(positions, node) - restrict_to<dim>(origin));
    return result;
  }

#define INSTANTIATE(dim)                                                                           \
  template Frame          move_frame(const Operators<dim> &, const State<dim> &, double);          \
  template Tensor<1, dim> compute_grid_velocity(const State<dim> &, const Frame &, double);        \
  template Vector<double> place_on_grid(const SolidBody<dim> &, const Vector<double> &,            \
                                        const DomainVector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
