#ifndef caudal_ideal_pulsating_sphere_h
#define caudal_ideal_pulsating_sphere_h

#include <caudal/ideal/deformation.h>

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

  private:
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
} // namespace caudal::ideal

#endif
