#ifndef caudal_fish_gait_h
#define caudal_fish_gait_h

#include <caudal/fish/ramp.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <string>

namespace caudal
{
  using namespace dealii;

  /**
   * A prescribed deformation of the body: the shape that the point s of the
   * reference shape (body frame: origin at the nose, x towards the tail, y
   * lateral) takes at a time. It is meant up to a rigid motion: the body finds
   * its own place and direction from the balance of its momenta.
   */
  template <int dim>
  class Gait
  {
  public:
    virtual ~Gait() = default;

    /** Computes the shape at @p time [s], of which the functions below then speak. */
    virtual void set_time(const double time) = 0;

    /** X(s) [m] */
    virtual Point<dim> position(const Point<dim> &s) const = 0;

    /** dX/dt(s) [m/s] */
    virtual Tensor<1, dim> velocity(const Point<dim> &s) const = 0;
  };

  /**
   * Section `Gait` of a body: a motion of its midline m(s,t), which keeps its
   * length, s being the arc length. Cross sections stay straight and normal to
   * it, X(s,n) = m(s,t) + n normal(s,t), so that a symmetric body keeps its area.
   *
   * `none`: nothing is prescribed.
   * `travelling wave`: the lateral displacement
   *   y = r(t) a L (s/L + b)/(1 + b) sin(2 pi (k s/L - f t));
   *   a = 0.125, b = 0.03125, k = 1 is the eel of Kern and Koumoutsakos, J. Exp.
   *   Biol. 209, 2006, and of Carling et al., J. Exp. Biol. 201, 1998.
   * `curvature`: the midline's curvature kappa(s,t), times r(t).
   * r is the start-up ramp, L the body length.
   */
  struct GaitParameters
  {
    std::string type = "none";
    StartUpRamp ramp;

    double amplitude   = 0.125;
    double offset      = 0.03125;
    double wave_number = 1.;
    double frequency   = 1.;

    std::string curvature = "0";

    /** Declares the section in the one that @p prm is in. */
    void add_parameters(ParameterHandler &prm);

    /** Throws a sentence about the first bad entry; @p path is the body's section. */
    void check(const std::string &path) const;
  };

  /** The gait that @p parameters describe of a body of length @p length [m]; null if `none`. */
  template <int dim>
  std::unique_ptr<Gait<dim>> create_gait(const GaitParameters &parameters, const double length);
} // namespace caudal

#endif
