// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/ideal/bending_body.h>

#include <numeric>

namespace caudal::ideal
{
  namespace
  {
    /** A vector of the plane of the bend. */
    Tensor<1, 3> in_space(const Tensor<1, 2> &vector)
    {
      return Point<3>(vector[0], vector[1], 0.);
    }

    /** theta' of the spine for these rates of the coordinates. */
    double get_turn(const SpinePoint &spine, const std::vector<double> &rates)
    {
      return std::inner_product(rates.begin(), rates.end(), spine.turn_by_c.begin(), 0.);
    }
  } // namespace

  BendingBody::BendingBody(const Surface &surface, const StraightBody &body, const Gait &gait)
      : gait(gait)
      , length(body.get_length())
      , symmetric(body.is_symmetric())
      , slices(body.compute_slices())
  {
    for (unsigned int k = 0; k <= Spine::n_intervals; ++k)
    {
      stations.push_back(length * k / Spine::n_intervals);
      half_widths.push_back(body.half_width(stations.back()));
    }
    std::vector<double> places;
    for (const Point<3> &reference : surface.get_reference_points())
    {
      node_places.push_back(body.place(reference));
      places.push_back(node_places.back()[0]);
    }
    node_spine = std::make_unique<Spine>(gait, places);
    places.clear();
    for (const BodySlice &slice : slices)
      places.push_back(slice.s);
    slice_spine   = std::make_unique<Spine>(gait, places);
    station_spine = std::make_unique<Spine>(gait, stations);
  }

  SurfaceMotion BendingBody::place(const std::vector<double> &c) const
  {
    const std::vector<SpinePoint> spine = node_spine->bend(c);
    SurfaceMotion                 motion;
    motion.rest = node_places;
    motion.modes.assign(n_modes(), std::vector<Tensor<1, 3>>(spine.size()));
    for (unsigned int node = 0; node < spine.size(); ++node)
    {
      const SpinePoint &at = spine[node];
      const double      y  = node_places[node][1];
      Point<3>          X(0., 0., node_places[node][2]);
      X += in_space(at.position + y * at.get_normal());
      motion.positions.push_back(X);
      for (unsigned int i = 0; i < n_modes(); ++i)
        motion.modes[i][node] = in_space(at.position_by_c[i] - y * at.turn_by_c[i] * at.tangent);
    }
    return motion;
  }

  FullMatrix<double> BendingBody::compute_body_mass(const std::vector<double> &c) const
  {
    const std::vector<SpinePoint> spine = slice_spine->bend(c);
    const unsigned int            n     = 6 + n_modes();
    FullMatrix<double>            mass(n, n);

    // The velocity of the slice's point (y, z) is that of its centre, plus y times the second,
    // plus z times the third; here for unit rate of each motion.
    std::array<std::vector<Tensor<1, 3>>, 3> velocity;
    velocity.fill(std::vector<Tensor<1, 3>>(n));
    for (unsigned int k = 0; k < spine.size(); ++k)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        Tensor<1, 3> axis;
        axis[d]            = 1.;
        velocity[0][d]     = cross_product_3d(axis, in_space(spine[k].position));
        velocity[1][d]     = cross_product_3d(axis, in_space(spine[k].get_normal()));
        velocity[2][d]     = cross_product_3d(axis, Tensor<1, 3>(Point<3>(0., 0., 1.)));
        velocity[0][3 + d] = axis;
      }
      for (unsigned int i = 0; i < n_modes(); ++i)
      {
        velocity[0][6 + i] = in_space(spine[k].position_by_c[i]);
        velocity[1][6 + i] = in_space(-spine[k].turn_by_c[i] * spine[k].tangent);
      }
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = 0; b < 3; ++b)
          if (const double moment = slices[k].moments[a][b]; moment != 0.)
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int j = 0; j < n; ++j)
                mass(i, j) += moment * (velocity[a][i] * velocity[b][j]);
    }
    return mass;
  }

  std::vector<std::vector<Tensor<1, 3>>>
  BendingBody::compute_mode_rates(const std::vector<double> &c,
                                  const std::vector<double> &rates) const
  {
    const std::vector<SpinePoint>          spine = node_spine->bend(c, rates);
    std::vector<std::vector<Tensor<1, 3>>> result(n_modes(),
                                                  std::vector<Tensor<1, 3>>(spine.size()));
    for (unsigned int node = 0; node < spine.size(); ++node)
    {
      const SpinePoint &at   = spine[node];
      const double      turn = get_turn(at, rates), y = node_places[node][1];
      for (unsigned int i = 0; i < n_modes(); ++i)
        result[i][node] =
            in_space(at.position_by_c_rate[i] - y * (at.turn_by_c_rate[i] * at.tangent +
                                                     at.turn_by_c[i] * turn * at.get_normal()));
    }
    return result;
  }

  std::vector<double> BendingBody::compute_body_energy_gradient(const std::vector<double> &c,
                                                                const std::vector<double> &u) const
  {
    const std::vector<double>     rates(u.begin() + 6, u.end());
    const std::vector<SpinePoint> spine = slice_spine->bend(c, rates);
    const Tensor<1, 3>  omega = Point<3>(u[0], u[1], u[2]), v = Point<3>(u[3], u[4], u[5]);
    std::vector<double> gradient(n_modes(), 0.);
    for (unsigned int k = 0; k < spine.size(); ++k)
    {
      const SpinePoint  &at      = spine[k];
      const double       turn    = get_turn(at, rates);
      const Tensor<1, 3> tangent = in_space(at.tangent), normal = in_space(at.get_normal());
      // Velocities as in compute_body_mass(); the third one does not depend on the bend.
      Tensor<1, 3> velocity[3] = {v + cross_product_3d(omega, in_space(at.position)),
                                  cross_product_3d(omega, normal) - turn * tangent,
                                  cross_product_3d(omega, Tensor<1, 3>(Point<3>(0., 0., 1.)))};
      for (unsigned int i = 0; i < n_modes(); ++i)
        velocity[0] += rates[i] * in_space(at.position_by_c[i]);
      for (unsigned int i = 0; i < n_modes(); ++i)
      {
        const Tensor<1, 3> by_mode[2] = {
            cross_product_3d(omega, in_space(at.position_by_c[i])) +
                in_space(at.position_by_c_rate[i]),
            -at.turn_by_c[i] * (cross_product_3d(omega, tangent) + turn * normal) -
                at.turn_by_c_rate[i] * tangent};
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b < 2; ++b)
            gradient[i] += slices[k].moments[a][b] * (velocity[a] * by_mode[b]);
      }
    }
    return gradient;
  }

  double BendingBody::compute_bend(const std::vector<double> &c) const
  {
    const std::vector<double> curvature = gait.compute_curvature(stations, c);
    double                    largest   = 0.;
    for (unsigned int k = 0; k < stations.size(); ++k)
      largest = std::max(largest, half_widths[k] * std::abs(curvature[k]));

    // Parts that are farther apart along the spine than a half-circle may have met.
    const std::vector<SpinePoint> spine = station_spine->bend(c);
    for (unsigned int k = 0; k < stations.size(); ++k)
      for (unsigned int l = 0; l < k; ++l)
      {
        const double widths = half_widths[k] + half_widths[l];
        if (stations[k] - stations[l] > 0.5 * numbers::PI * widths)
          largest = std::max(largest, widths / (spine[k].position - spine[l].position).norm());
      }
    return largest;
  }
} // namespace caudal::ideal
