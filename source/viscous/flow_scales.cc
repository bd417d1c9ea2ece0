// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/expression.h>
#include <caudal/viscous/flow_scales.h>

#include <algorithm>

namespace caudal
{
  namespace
  {
    // A fish at a Strouhal number of 0.3 with a tail that sweeps a fifth of its length swims
    // 0.2/0.3 lengths a beat (Triantafyllou et al. 1993, doi:10.1006/jfls.1993.1012).
    constexpr double lengths_per_beat = 0.2 / 0.3;

    // What fish of all sizes reach in steady swimming (Bainbridge 1958, doi:10.1242/jeb.35.1.109).
    constexpr double lengths_per_second = 1;

    // Functions are looked at in so many points of a direction, and at so many times.
    constexpr unsigned int n_points = 9;

    /** The largest modulus of @p velocity on the face of the box that @p side says, or in it. */
    template <int dim>
    double find_largest(const Function<dim> &velocity, const DomainParameters<dim> &domain,
                        const unsigned int side = numbers::invalid_unsigned_int)
    {
      double         largest = 0;
      Vector<double> value(dim);
      for (unsigned int index = 0; index < Utilities::fixed_power<dim>(n_points); ++index)
      {
        Point<dim>   point  = domain.lower_corner;
        unsigned int rest   = index;
        bool         is_new = true; // across the face all points are the same one
        for (unsigned int d = 0; d < dim; ++d, rest /= n_points)
        {
          const double share = 1. * (rest % n_points) / (n_points - 1);
          point[d] += domain.size[d] * (d == side / 2 ? 1. * (side % 2) : share);
          is_new = is_new && (d != side / 2 || share == 0);
        }
        if (!is_new)
          continue;
        velocity.vector_value(point, value);
        largest = std::max(largest, value.l2_norm());
      }
      return largest;
    }

    template <int dim>
    double find_largest_inflow(const RunParameters<dim> &parameters)
    {
      const auto conditions = parameters.fluid.create_boundary_conditions();
      double     largest    = 0;
      for (unsigned int side = 0; side < conditions.size(); ++side)
        for (unsigned int k = 1; k <= n_points && conditions[side]->has_velocity(); ++k)
        {
          const double time = parameters.time.end_time * k / n_points;
          largest           = std::max(largest, find_largest(*conditions[side]->make_velocity(time),
                                                             parameters.domain, side));
        }
      return largest;
    }
  } // namespace

  template <int dim>
  double estimate_swimming_speed(const Body<dim> &body)
  {
    if (!body.swims())
      return 0;
    const double frequency = body.get_beat_frequency();
    return body.get_length() * (frequency > 0 ? lengths_per_beat * frequency : lengths_per_second);
  }

  template <int dim>
  FlowScales estimate_scales(const RunParameters<dim> &parameters, const Bodies<dim> &bodies)
  {
    FlowScales scales;
    scales.speed = std::max(find_largest_inflow(parameters),
                            find_largest(Expression<dim>("Fluid/Initial velocity",
                                                         parameters.fluid.initial_velocity, dim),
                                         parameters.domain));
    for (const auto &body : bodies)
    {
      const double speed = estimate_swimming_speed(*body);
      if (speed > scales.speed)
      {
        scales.speed    = speed;
        scales.is_guess = body->get_beat_frequency() == 0;
      }
      scales.length = std::max(scales.length, body->get_length());
    }
    if (bodies.empty())
      scales.length = parameters.domain.get_shortest_side();
    return scales;
  }

  template double     estimate_swimming_speed(const Body<2> &);
  template double     estimate_swimming_speed(const Body<3> &);
  template FlowScales estimate_scales(const RunParameters<2> &, const Bodies<2> &);
  template FlowScales estimate_scales(const RunParameters<3> &, const Bodies<3> &);
} // namespace caudal
