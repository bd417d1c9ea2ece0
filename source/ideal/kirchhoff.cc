// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/ideal/kirchhoff.h>

#include <boost/math/quaternion.hpp>
#include <boost/numeric/odeint.hpp>

namespace caudal::ideal
{
  namespace
  {
    namespace odeint = boost::numeric::odeint;

    using Quaternion = boost::math::quaternion<double>;

    /** Lambda, Pi, quaternion, r/length. */
    using OdeState = std::array<double, 13>;

    Quaternion normalise(const std::array<double, 4> &q)
    {
      const Quaternion quaternion(q[0], q[1], q[2], q[3]);
      return quaternion / boost::math::abs(quaternion);
    }

    std::array<double, 4> get_components(const Quaternion &q)
    {
      return {{q.R_component_1(), q.R_component_2(), q.R_component_3(), q.R_component_4()}};
    }

    Quaternion make_imaginary(const Tensor<1, 3> &V)
    {
      return Quaternion(0., V[0], V[1], V[2]);
    }

    OdeState pack(const BodyState &body, const double length)
    {
      OdeState state;
      for (unsigned int i = 0; i < 6; ++i)
        state[i] = body.impulse[i];
      for (unsigned int i = 0; i < 4; ++i)
        state[6 + i] = body.quaternion[i];
      for (unsigned int i = 0; i < 3; ++i)
        state[10 + i] = body.position[i] / length;
      return state;
    }

    BodyState unpack(const OdeState &state, const double length)
    {
      BodyState body;
      for (unsigned int i = 0; i < 6; ++i)
        body.impulse[i] = state[i];
      body.quaternion = get_components(normalise({{state[6], state[7], state[8], state[9]}}));
      for (unsigned int i = 0; i < 3; ++i)
        body.position[i] = length * state[10 + i];
      return body;
    }

    OdeState compute_derivative(const MotionProblem &problem, const OdeState &state,
                                const double time)
    {
      const BodyState body     = unpack(state, problem.length);
      const double    argument = problem.rate * time;
      const Screw     velocity =
          problem.model->compute_motion(argument).compute_velocity(body.impulse, problem.rate);
      BodyState rate;
      rate.impulse = compute_impulse_rate(body.impulse, velocity,
                                          problem.force({argument, problem.rate, velocity}).screw);
      rate.quaternion =
          get_components(0.5 * normalise(body.quaternion) * make_imaginary(get_angular(velocity)));
      rate.position = body.rotate(get_linear(velocity));
      return pack(rate, problem.length);
    }
  } // namespace

  Screw compute_impulse_rate(const Screw &impulse, const Screw &velocity, const Screw &external)
  {
    const Tensor<1, 3> Lambda = get_angular(impulse), Pi = get_linear(impulse),
                       omega = get_angular(velocity), v = get_linear(velocity);
    return external + make_screw(cross_product_3d(Lambda, omega) + cross_product_3d(Pi, v),
                                 cross_product_3d(Pi, omega));
  }

  Tensor<1, 3> BodyState::rotate(const Tensor<1, 3> &V) const
  {
    const Quaternion q      = normalise(quaternion);
    const auto       result = get_components(q * make_imaginary(V) * boost::math::conj(q));
    return Tensor<1, 3>({result[1], result[2], result[3]});
  }

  BodyState advance_motion(const MotionProblem &problem, const BodyState &body, const double time,
                           const double end)
  {
    OdeState   state  = pack(body, problem.length);
    const auto system = [&](const OdeState &x, OdeState &rate, const double t) {
      rate = compute_derivative(problem, x, t);
    };
    if (problem.integrator == Integrator::given_steps)
      odeint::runge_kutta4<OdeState>().do_step(system, state, time, end - time);
    else
      try
      {
        // The shape has to be seen often enough in each stroke for its error estimate.
        const double                largest_step = 0.5 / problem.rate;
        const std::array<double, 2> times        = {{time, end}};
        odeint::integrate_times(odeint::make_controlled(problem.tolerance, problem.tolerance,
                                                        largest_step,
                                                        odeint::runge_kutta_dopri5<OdeState>()),
                                system, state, times.begin(), times.end(), largest_step,
                                odeint::null_observer(), odeint::max_step_checker(1000000));
      }
      catch (const odeint::odeint_error &error)
      {
        AssertThrow(false,
                    ExcMessage(std::string("The equations of motion can't be integrated: ") +
                               error.what() + ". Give a larger value for Integration/Tolerance."));
      }
    for (const double value : state)
      AssertThrow(std::isfinite(value),
                  ExcMessage("The motion is not finite at the time " + std::to_string(end) +
                             " s. Reduce Integration/Tolerance, or the steps of the output."));
    return unpack(state, problem.length);
  }
} // namespace caudal::ideal
