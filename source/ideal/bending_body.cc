#include <caudal/ideal/bending_body.h>

#include <deal.II/base/quadrature_lib.h>

namespace caudal::ideal
{
  namespace
  {
    // A multiple of seven, so that the hats' kinks lie between intervals.
    const unsigned int n_intervals = 112;
    const unsigned int n_points    = 4;

    /** sum_i factors_i H_i */
    double combine(const double *const H, const std::vector<double> &factors)
    {
      double sum = 0.;
      for (std::size_t i = 0; i < factors.size(); ++i)
        sum += factors[i] * H[i];
      return sum;
    }

    class Joints : public SpineModes
    {
    public:
      explicit Joints(const double length)
          : length(length)
          , half_width(length / (n_joints + 1))
      {}

      unsigned int n_modes() const override
      {
        return n_joints;
      }

      double angle(const unsigned int i, const double s) const override
      {
        const double x = std::clamp((s - get_joint(length, i + 1)) / half_width, -1., 1.);
        return 0.5 + x - 0.5 * x * std::abs(x);
      }

      double curvature(const unsigned int i, const double s) const override
      {
        const double x = std::abs(s - get_joint(length, i + 1)) / half_width;
        return std::max(0., 1. - x) / half_width;
      }

    private:
      const double length, half_width;
    };

    class CurvatureWave : public SpineModes
    {
    public:
      CurvatureWave(const double length, const double curvature, const double growth,
                    const double wave_number)
          : start(curvature / length * (1. - growth))
          , slope(curvature / length * growth / length)
          , w(2. * numbers::PI * wave_number / length)
      {}

      unsigned int n_modes() const override
      {
        return 2;
      }

      double angle(const unsigned int i, const double s) const override
      {
        if (w == 0.)
          return i == 0 ? start * s + 0.5 * slope * s * s : 0.;
        const double K = start + slope * s;
        return i == 0 ? K * std::sin(w * s) / w + slope * (std::cos(w * s) - 1.) / (w * w)
                      : (start - K * std::cos(w * s)) / w + slope * std::sin(w * s) / (w * w);
      }

      double curvature(const unsigned int i, const double s) const override
      {
        return (start + slope * s) * (i == 0 ? std::cos(w * s) : std::sin(w * s));
      }

    private:
      const double start, slope, w;
    };

    class NoModes : public SpineModes
    {
    public:
      unsigned int n_modes() const override
      {
        return 0;
      }

      double angle(const unsigned int, const double) const override
      {
        return 0.;
      }

      double curvature(const unsigned int, const double) const override
      {
        return 0.;
      }
    };
  } // namespace

  double get_joint(const double length, const unsigned int i)
  {
    return length * i / (n_joints + 1);
  }

  std::unique_ptr<SpineModes> create_joints(const double length)
  {
    return std::make_unique<Joints>(length);
  }

  std::unique_ptr<SpineModes> create_curvature_wave(const double length, const double curvature,
                                                    const double growth, const double wave_number)
  {
    return std::make_unique<CurvatureWave>(length, curvature, growth, wave_number);
  }

  std::unique_ptr<SpineModes> create_no_modes()
  {
    return std::make_unique<NoModes>();
  }

  BendingBody::BendingBody(const Surface &surface, const Shape &shape,
                           std::unique_ptr<SpineModes> spine_modes)
      : modes(std::move(spine_modes))
      , length(shape.get_length())
      , symmetric(shape.is_symmetric())
      , sections(shape.compute_sections())
  {
    for (unsigned int k = 0; k <= n_intervals; ++k)
    {
      grid.push_back(make_station(length * k / n_intervals));
      half_widths.push_back(shape.half_width(length * k / n_intervals));
    }
    for (const Point<3> &reference : surface.get_reference_points())
    {
      node_places.push_back(shape.place(reference));
      node_stations.push_back(make_station(node_places.back()[0]));
    }
    for (const Section &section : sections)
      section_stations.push_back(make_station(section.s));
  }

  unsigned int BendingBody::n_modes() const
  {
    return modes->n_modes();
  }

  bool BendingBody::is_symmetric() const
  {
    return symmetric;
  }

  double BendingBody::get_length() const
  {
    return length;
  }

  BendingBody::Station BendingBody::make_station(const double s) const
  {
    const double interval = length / n_intervals;
    Station      station;
    // The grid's own ends belong to the interval before them.
    station.interval =
        std::clamp<int>(static_cast<int>(std::ceil(s / interval - 1e-9)) - 1, 0, n_intervals - 1);
    const double    left = station.interval * interval;
    const QGauss<1> gauss(n_points);
    for (unsigned int q = 0; q < n_points; ++q)
    {
      station.weights.push_back((s - left) * gauss.weight(q));
      for (unsigned int i = 0; i < n_modes(); ++i)
        station.angles.push_back(modes->angle(i, left + (s - left) * gauss.point(q)[0]));
    }
    for (unsigned int i = 0; i < n_modes(); ++i)
      station.angle.push_back(modes->angle(i, s));
    return station;
  }

  std::vector<BendingBody::BentSpine> BendingBody::bend(const std::vector<Station> &stations,
                                                        const std::vector<double>  &c,
                                                        const std::vector<double>  &rates) const
  {
    const unsigned int n = n_modes(), n_rates = rates.size();

    const auto get_angle = [&](const double *const H) { return combine(H, c); };
    // Adds the integrals of t, H_i n and -H_i theta' t over the piece of the station's interval.
    const auto advance = [&](const Station &station, BentSpine spine) {
      for (unsigned int q = 0; q < n_points; ++q)
      {
        const double *const H     = &station.angles[q * n];
        const double        theta = get_angle(H), ds = station.weights[q];
        const Point<3>      t(std::cos(theta), std::sin(theta), 0.);
        spine.place += ds * t;
        for (unsigned int i = 0; i < n; ++i)
          spine.place_by_mode[i] += ds * H[i] * Point<3>(-t[1], t[0], 0.);
        const double turn = combine(H, rates);
        for (unsigned int i = 0; i < n_rates; ++i)
          spine.rate_by_mode[i] -= ds * H[i] * turn * t;
      }
      const double theta = get_angle(station.angle.data());
      spine.tangent      = Point<3>(std::cos(theta), std::sin(theta), 0.);
      spine.normal       = Point<3>(-std::sin(theta), std::cos(theta), 0.);
      return spine;
    };

    std::vector<BentSpine> left_ends(1), result;
    left_ends[0].place_by_mode.resize(n);
    left_ends[0].rate_by_mode.resize(n_rates);
    for (unsigned int k = 1; k < n_intervals; ++k)
      left_ends.push_back(advance(grid[k], left_ends[k - 1]));
    for (const Station &station : stations)
      result.push_back(advance(station, left_ends[station.interval]));
    return result;
  }

  SurfaceMotion BendingBody::place(const std::vector<double> &c) const
  {
    const std::vector<BentSpine> spine = bend(node_stations, c);
    SurfaceMotion                motion;
    motion.rest = node_places;
    motion.modes.assign(n_modes(), std::vector<Tensor<1, 3>>(spine.size()));
    for (unsigned int node = 0; node < spine.size(); ++node)
    {
      const double y = node_places[node][1];
      Point<3>     X(0., 0., node_places[node][2]);
      X += spine[node].place + y * spine[node].normal;
      motion.positions.push_back(X);
      for (unsigned int i = 0; i < n_modes(); ++i)
        motion.modes[i][node] =
            spine[node].place_by_mode[i] - y * node_stations[node].angle[i] * spine[node].tangent;
    }
    return motion;
  }

  FullMatrix<double> BendingBody::compute_body_mass(const std::vector<double> &c) const
  {
    const std::vector<BentSpine> spine = bend(section_stations, c);
    const unsigned int           n     = 6 + n_modes();
    FullMatrix<double>           mass(n, n);

    // The velocity of the section's point (y, z) is that of its centre, plus y times the second,
    // plus z times the third; here for unit rate of each motion.
    std::array<std::vector<Tensor<1, 3>>, 3> velocity;
    velocity.fill(std::vector<Tensor<1, 3>>(n));
    for (unsigned int k = 0; k < spine.size(); ++k)
    {
      const Tensor<1, 3> e3 = Point<3>(0., 0., 1.);
      for (unsigned int d = 0; d < 3; ++d)
      {
        Tensor<1, 3> axis;
        axis[d]            = 1.;
        velocity[0][d]     = cross_product_3d(axis, spine[k].place);
        velocity[1][d]     = cross_product_3d(axis, spine[k].normal);
        velocity[2][d]     = cross_product_3d(axis, e3);
        velocity[0][3 + d] = axis;
      }
      for (unsigned int i = 0; i < n_modes(); ++i)
      {
        velocity[0][6 + i] = spine[k].place_by_mode[i];
        velocity[1][6 + i] = -section_stations[k].angle[i] * spine[k].tangent;
      }
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = 0; b < 3; ++b)
          if (const double moment = sections[k].moments[a][b]; moment != 0.)
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
    const std::vector<BentSpine>           spine = bend(node_stations, c, rates);
    std::vector<std::vector<Tensor<1, 3>>> result(n_modes(),
                                                  std::vector<Tensor<1, 3>>(spine.size()));
    for (unsigned int node = 0; node < spine.size(); ++node)
    {
      const std::vector<double> &H    = node_stations[node].angle;
      const double               turn = combine(H.data(), rates), y = node_places[node][1];
      for (unsigned int i = 0; i < n_modes(); ++i)
        result[i][node] = spine[node].rate_by_mode[i] - y * H[i] * turn * spine[node].normal;
    }
    return result;
  }

  std::vector<double> BendingBody::compute_body_energy_gradient(const std::vector<double> &c,
                                                                const std::vector<double> &u) const
  {
    const std::vector<double>    rates(u.begin() + 6, u.end());
    const std::vector<BentSpine> spine = bend(section_stations, c, rates);
    const Tensor<1, 3>           omega = Point<3>(u[0], u[1], u[2]), v = Point<3>(u[3], u[4], u[5]);
    std::vector<double>          gradient(n_modes(), 0.);
    for (unsigned int k = 0; k < spine.size(); ++k)
    {
      const std::vector<double> &H    = section_stations[k].angle;
      const double               turn = combine(H.data(), rates);
      // Velocities as in compute_body_mass(); the third one does not depend on the bend.
      Tensor<1, 3> velocity[3] = {v + cross_product_3d(omega, spine[k].place),
                                  cross_product_3d(omega, spine[k].normal) -
                                      turn * spine[k].tangent,
                                  cross_product_3d(omega, Tensor<1, 3>(Point<3>(0., 0., 1.)))};
      for (unsigned int i = 0; i < n_modes(); ++i)
        velocity[0] += rates[i] * spine[k].place_by_mode[i];
      for (unsigned int i = 0; i < n_modes(); ++i)
      {
        const Tensor<1, 3> by_mode[2] = {
            cross_product_3d(omega, spine[k].place_by_mode[i]) + spine[k].rate_by_mode[i],
            -H[i] * (cross_product_3d(omega, spine[k].tangent) + turn * spine[k].normal)};
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b < 2; ++b)
            gradient[i] += sections[k].moments[a][b] * (velocity[a] * by_mode[b]);
      }
    }
    return gradient;
  }

  double BendingBody::compute_bend(const std::vector<double> &c) const
  {
    double largest = 0.;
    for (unsigned int k = 0; k <= n_intervals; ++k)
    {
      double curvature = 0.;
      for (unsigned int i = 0; i < n_modes(); ++i)
        curvature += c[i] * modes->curvature(i, length * k / n_intervals);
      largest = std::max(largest, half_widths[k] * std::abs(curvature));
    }

    // Parts that are farther apart along the spine than a half-circle may have met.
    const std::vector<BentSpine> spine = bend(grid, c);
    for (unsigned int k = 0; k <= n_intervals; ++k)
      for (unsigned int l = 0; l < k; ++l)
      {
        const double widths = half_widths[k] + half_widths[l];
        if (length * (k - l) / n_intervals > 0.5 * numbers::PI * widths)
          largest = std::max(largest, widths / (spine[k].place - spine[l].place).norm());
      }
    return largest;
  }
} // namespace caudal::ideal
