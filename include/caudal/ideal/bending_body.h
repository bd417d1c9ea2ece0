#ifndef caudal_ideal_bending_body_h
#define caudal_ideal_bending_body_h

#include <caudal/ideal/deformation.h>
#include <caudal/ideal/shape.h>

#include <memory>

namespace caudal::ideal
{
  /** How the spine's tangent angle depends on the coordinates: theta(s) = sum_i c_i H_i(s). */
  class SpineModes
  {
  public:
    virtual ~SpineModes() = default;

    virtual unsigned int n_modes() const = 0;

    /** H_i(s), H_i(0) = 0; s in m. */
    virtual double angle(unsigned int i, double s) const = 0;

    /** dH_i/ds [1/m] */
    virtual double curvature(unsigned int i, double s) const = 0;
  };

  /**
   * Six joints between seven sections of equal length: c_i is the angle of the joint at
   * s_i = i L/7 [rad], spread over the half-width L/7 by a hat function, so that the spine is
   * twice differentiable.
   */
  std::unique_ptr<SpineModes> create_joints(double length);

  /**
   * A wave of curvature kappa = c_1 K cos(w s) + c_2 K sin(w s), w = 2 pi k/L: with
   * c = (sin psi, -cos psi) it is K sin(psi - w s). K(s) = curvature/L ((1 - g) + g s/L).
   */
  std::unique_ptr<SpineModes> create_curvature_wave(double length, double curvature, double growth,
                                                    double wave_number);

  /** A straight spine. */
  std::unique_ptr<SpineModes> create_no_modes();

  /** The joint's position i = 1..6, s_i [m]. */
  double                 get_joint(double length, unsigned int i);
  constexpr unsigned int n_joints = 6;

  /**
   * A straight body bent in its plane. The spine c(s), dc/ds = t = (cos theta, sin theta, 0),
   * starts at the nose, the frame's origin, in the direction of e_1; sections stay rigid and
   * normal to it, X = c(s) + y n(s) + z e_3. Then dX/dc_i = W_i - y H_i t, W_i = int H_i n ds.
   */
  class BendingBody : public Deformation
  {
  public:
    BendingBody(const Surface &surface, const Shape &shape, std::unique_ptr<SpineModes> modes);

    unsigned int       n_modes() const override;
    SurfaceMotion      place(const std::vector<double> &c) const override;
    FullMatrix<double> compute_body_mass(const std::vector<double> &c) const override;
    double             compute_bend(const std::vector<double> &c) const override;
    bool               is_symmetric() const override;
    double             get_length() const override;

    std::vector<std::vector<Tensor<1, 3>>>
    compute_mode_rates(const std::vector<double> &c,
                       const std::vector<double> &rates) const override;

    std::vector<double> compute_body_energy_gradient(const std::vector<double> &c,
                                                     const std::vector<double> &u) const override;

  private:
    /** A place on the spine with all that does not depend on c. */
    struct Station
    {
      unsigned int        interval;
      std::vector<double> weights; // of the points between the interval's left end and s [m]
      std::vector<double> angles;  // H_i there; by point, mode
      std::vector<double> angle;   // H_i at s
    };

    /** The bent spine at a station. */
    struct BentSpine
    {
      Tensor<1, 3>              place, tangent, normal;
      std::vector<Tensor<1, 3>> place_by_mode; // W_i
      std::vector<Tensor<1, 3>> rate_by_mode;  // sum_j c_j' dW_i/dc_j, if there are rates
    };

    Station                make_station(double s) const;
    std::vector<BentSpine> bend(const std::vector<Station> &stations, const std::vector<double> &c,
                                const std::vector<double> &rates = {}) const;

    const std::unique_ptr<SpineModes> modes;
    const double                      length;
    const bool                        symmetric;

    std::vector<Station>  grid;          // the ends of equal intervals
    std::vector<Station>  node_stations; // of the surface
    std::vector<Point<3>> node_places;   // (s, y, z)
    std::vector<Section>  sections;
    std::vector<Station>  section_stations;
    std::vector<double>   half_widths; // at the grid's ends
  };
} // namespace caudal::ideal

#endif
