// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_tests_ideal_pulsating_sphere_h
#define caudal_tests_ideal_pulsating_sphere_h

#include <caudal/fish/gait.h>
#include <caudal/ideal/deformation.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace caudal::ideal
{
  /**
   * A sphere of radius a with two axisymmetric modes along e_1,
   *   R = a (1 + eps (c_1 P_n(mu) + c_2 P_(n+1)(mu))) / N,   mu = X_1/|X|,
   * N such that the volume is that of the sphere. It is of uniform density at all times: the
   * centre of mass is that of the volume. The kinetic energy of the motion inside, relative to
   * the centre of mass, is left out, as it does not affect the motion of the whole.
   */
  class PulsatingSphere : public Deformation
  {
  public:
    PulsatingSphere(const Surface &surface, double radius, double amplitude, unsigned int order);

    unsigned int       n_modes() const override;
    SurfaceMotion      place(const std::vector<double> &c) const override;
    FullMatrix<double> compute_body_mass(const std::vector<double> &c) const override;
    double             compute_bend(const std::vector<double> &c) const override;
    bool               is_symmetric() const override;
    double             get_length() const override;

    // By differences of fourth order.
    std::vector<std::vector<Tensor<1, 3>>>
                        compute_mode_rates(const std::vector<double> &c,
                                           const std::vector<double> &rates) const override;
    std::vector<double> compute_body_energy_gradient(const std::vector<double> &c,
                                                     const std::vector<double> &u) const override;

  private:
    /** Calls visit(c + k step direction, weight) such that the weighted sum is the derivative. */
    template <class Visit>
    static void visit_neighbours(const std::vector<double> &c, const std::vector<double> &direction,
                                 const Visit &visit)
    {
      const double step = 1e-3;
      for (const auto &[k, weight] : {std::pair(-2., 1. / 12.), std::pair(-1., -8. / 12.),
                                      std::pair(1., 8. / 12.), std::pair(2., -1. / 12.)})
        visit(std::vector<double>{c[0] + k * step * direction[0], c[1] + k * step * direction[1]},
              weight / step);
    }

    /** R(mu) and dR/dc_i [m] without and with the factor 1/N. */
    struct Radius
    {
      double value, derivatives[2];
    };
    Radius get_raw_radius(double mu, const std::vector<double> &c) const;
    Radius get_scale(const std::vector<double> &c) const;
    Radius get_radius(double mu, const std::vector<double> &c, const Radius &scale) const;

    const std::vector<Point<3>> directions; // of the surface's nodes
    const double                radius, amplitude;
    const unsigned int          order;
  };
  /** The gait of a pulsating sphere: c = (cos psi, sin psi). */
  class PulsatingGait : public ModalGait
  {
  public:
    unsigned int n_coordinates() const override
    {
      return 2;
    }

  protected:
    GaitState evaluate_stroke(const double psi) const override
    {
      return {{std::cos(psi), std::sin(psi)}, {-std::sin(psi), std::cos(psi)}};
    }

    double mode(const unsigned int, const double) const override
    {
      return 0.; // the sphere has no spine
    }
  };

  /** For integrals over mu from -1 to 1. */
  inline const QGauss<1> &get_quadrature()
  {
    static const QGauss<1> quadrature(48);
    return quadrature;
  }

  inline PulsatingSphere::PulsatingSphere(const Surface &surface, const double radius,
                                          const double amplitude, const unsigned int order)
      : directions(surface.get_reference_points())
      , radius(radius)
      , amplitude(amplitude)
      , order(order)
  {}

  inline unsigned int PulsatingSphere::n_modes() const
  {
    return 2;
  }

  inline bool PulsatingSphere::is_symmetric() const
  {
    return false;
  }

  inline double PulsatingSphere::get_length() const
  {
    return 2. * radius;
  }

  inline double PulsatingSphere::compute_bend(const std::vector<double> &c) const
  {
    get_scale(c); // throws if the radius is negative
    return 0.;
  }

  inline PulsatingSphere::Radius PulsatingSphere::get_raw_radius(const double               mu,
                                                                 const std::vector<double> &c) const
  {
    const double first  = radius * amplitude * std::legendre(order, mu);
    const double second = radius * amplitude * std::legendre(order + 1, mu);
    return {radius + c[0] * first + c[1] * second, {first, second}};
  }

  inline PulsatingSphere::Radius PulsatingSphere::get_scale(const std::vector<double> &c) const
  {
    // The mean of R^3 is to be a^3.
    double cubes = 0., derivatives[2] = {0., 0.};
    for (unsigned int q = 0; q < get_quadrature().size(); ++q)
    {
      const Radius R = get_raw_radius(2. * get_quadrature().point(q)[0] - 1., c);
      AssertThrow(R.value > 0., ExcMessage("The radius of the sphere becomes negative."));
      const double weight = get_quadrature().weight(q);
      cubes += weight * R.value * R.value * R.value;
      for (unsigned int i = 0; i < 2; ++i)
        derivatives[i] += weight * 3. * R.value * R.value * R.derivatives[i];
    }
    const double scale = radius / std::cbrt(cubes);
    return {scale,
            {-scale * derivatives[0] / (3. * cubes), -scale * derivatives[1] / (3. * cubes)}};
  }

  inline PulsatingSphere::Radius PulsatingSphere::get_radius(const double               mu,
                                                             const std::vector<double> &c,
                                                             const Radius              &scale) const
  {
    const Radius raw = get_raw_radius(mu, c);
    Radius       result;
    result.value = scale.value * raw.value;
    for (unsigned int i = 0; i < 2; ++i)
      result.derivatives[i] = scale.value * raw.derivatives[i] + scale.derivatives[i] * raw.value;
    return result;
  }

  inline SurfaceMotion PulsatingSphere::place(const std::vector<double> &c) const
  {
    const Radius  scale = get_scale(c);
    SurfaceMotion motion;
    motion.modes.resize(2);
    for (const Point<3> &direction : directions)
    {
      const Radius R = get_radius(direction[0], c, scale);
      motion.positions.push_back(R.value * direction);
      motion.rest.push_back(radius * direction);
      for (unsigned int i = 0; i < 2; ++i)
        motion.modes[i].push_back(R.derivatives[i] * direction);
    }
    return motion;
  }

  inline FullMatrix<double> PulsatingSphere::compute_body_mass(const std::vector<double> &c) const
  {
    const double volume = 4. / 3. * numbers::PI * radius * radius * radius;
    const Radius scale  = get_scale(c);

    // Centre of the volume along e_1, and the moments int x^2 dV, int y^2 dV = int z^2 dV.
    double centre = 0., centre_by_mode[2] = {0., 0.}, along = 0., across = 0.;
    for (unsigned int q = 0; q < get_quadrature().size(); ++q)
    {
      const double mu      = 2. * get_quadrature().point(q)[0] - 1.;
      const double element = 4. * numbers::PI * get_quadrature().weight(q);
      const Radius R       = get_radius(mu, c, scale);
      const double cube = std::pow(R.value, 3), fifth = std::pow(R.value, 5) / 5.;
      centre += element * mu * cube * R.value / 4. / volume;
      for (unsigned int i = 0; i < 2; ++i)
        centre_by_mode[i] += element * mu * cube * R.derivatives[i] / volume;
      along += element * mu * mu * fifth;
      across += element * (1. - mu * mu) / 2. * fifth;
    }

    FullMatrix<double> mass(8, 8);
    mass(0, 0) = 2. * across;
    mass(1, 1) = mass(2, 2) = along + across;
    for (unsigned int d = 3; d < 6; ++d)
      mass(d, d) = volume;
    // Velocity of the centre: omega x (centre e_1).
    mass(1, 5) = mass(5, 1) = -volume * centre;
    mass(2, 4) = mass(4, 2) = volume * centre;
    for (unsigned int i = 0; i < 2; ++i)
    {
      mass(3, 6 + i) = mass(6 + i, 3) = volume * centre_by_mode[i];
      for (unsigned int j = 0; j < 2; ++j)
        mass(6 + i, 6 + j) = volume * centre_by_mode[i] * centre_by_mode[j];
    }
    return mass;
  }

  inline std::vector<std::vector<Tensor<1, 3>>>
  PulsatingSphere::compute_mode_rates(const std::vector<double> &c,
                                      const std::vector<double> &rates) const
  {
    // d^2X/(dc_i dc_j) is symmetric: the modes' derivatives in the direction of the rates.
    std::vector<std::vector<Tensor<1, 3>>> result(2, std::vector<Tensor<1, 3>>(directions.size()));
    visit_neighbours(c, rates, [&](const std::vector<double> &moved, const double weight) {
      const SurfaceMotion motion = place(moved);
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int node = 0; node < directions.size(); ++node)
          result[i][node] += weight * motion.modes[i][node];
    });
    return result;
  }

  inline std::vector<double>
  PulsatingSphere::compute_body_energy_gradient(const std::vector<double> &c,
                                                const std::vector<double> &u) const
  {
    const Vector<double> motion(u.begin(), u.end());
    std::vector<double>  gradient(2, 0.);
    for (unsigned int i = 0; i < 2; ++i)
      visit_neighbours(c, {i == 0 ? 1. : 0., i == 0 ? 0. : 1.},
                       [&](const std::vector<double> &moved, const double weight) {
                         gradient[i] +=
                             weight * 0.5 * compute_body_mass(moved).matrix_norm_square(motion);
                       });
    return gradient;
  }
} // namespace caudal::ideal

#endif
