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
    using OdeState = std::vector<double>;

    Quaternion normalise(const std::array<double, 4> &q)
    {
      const Quaternion quaternion(q[0], q[1], q[2], q[3]);
      return quaternion / boost::math::abs(quaternion);
    }

    Tensor<1, 3> rotate_by(const Quaternion &q, const Tensor<1, 3> &V)
    {
      const Quaternion result = q * Quaternion(0., V[0], V[1], V[2]) * boost::math::conj(q);
      return Point<3>(result.R_component_2(), result.R_component_3(), result.R_component_4());
    }

    OdeState pack(const BodyState &body, const double length)
    {
      OdeState state(13);
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
      const Quaternion q = normalise({{state[6], state[7], state[8], state[9]}});
      body.quaternion    = {
             {q.R_component_1(), q.R_component_2(), q.R_component_3(), q.R_component_4()}};
      for (unsigned int i = 0; i < 3; ++i)
        body.position[i] = length * state[10 + i];
      return body;
    }

    Tensor<1, 3> get_part(const Screw &screw, const unsigned int first)
    {
      return Point<3>(screw[first], screw[first + 1], screw[first + 2]);
    }

    OdeState compute_derivative(const MotionProblem &problem, const OdeState &state,
                                const double time)
    {
      const BodyState body     = unpack(state, problem.length);
      const double    argument = problem.rate * time;
      const Screw     velocity =
          problem.model->compute_motion(argument).compute_velocity(body.impulse, problem.rate);
      const Tensor<1, 3> omega = get_part(velocity, 0), v = get_part(velocity, 3);
      const Screw        external =
          problem.force ? problem.force({argument, problem.rate, velocity}).screw : Screw();
      BodyState rate;
      rate.impulse = compute_impulse_rate(body.impulse, velocity, external);
      const Quaternion q(body.quaternion[0], body.quaternion[1], body.quaternion[2],
                         body.quaternion[3]);
      const Quaternion turn = 0.5 * q * Quaternion(0., omega[0], omega[1], omega[2]);
      rate.quaternion       = {
                {turn.R_component_1(), turn.R_component_2(), turn.R_component_3(), turn.R_component_4()}};
      rate.position = body.rotate(v);
      return pack(rate, problem.length);
    }
  } // namespace

  Screw compute_impulse_rate(const Screw &impulse, const Screw &velocity, const Screw &external)
  {
    const Tensor<1, 3> Lambda = get_part(impulse, 0), Pi = get_part(impulse, 3),
                       omega = get_part(velocity, 0), v = get_part(velocity, 3);
    const Tensor<1, 3> torque = cross_product_3d(Lambda, omega) + cross_product_3d(Pi, v);
    const Tensor<1, 3> force  = cross_product_3d(Pi, omega);
    Screw              rate   = external;
    for (unsigned int d = 0; d < 3; ++d)
    {
      rate[d] += torque[d];
      rate[3 + d] += force[d];
    }
    return rate;
  }

  Tensor<1, 3> BodyState::rotate(const Tensor<1, 3> &V) const
  {
    return rotate_by(normalise(quaternion), V);
  }

  Tensor<1, 3> BodyState::rotate_back(const Tensor<1, 3> &V) const
  {
    return rotate_by(boost::math::conj(normalise(quaternion)), V);
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
