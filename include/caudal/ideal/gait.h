#ifndef caudal_ideal_gait_h
#define caudal_ideal_gait_h

#include <caudal/ideal/deformation.h>
#include <caudal/ideal/shape.h>

#include <memory>
#include <string>
#include <vector>

namespace caudal::ideal
{
  /** Section `Gait` of the .prm. */
  struct GaitParameters
  {
    std::string         type        = "arctangent";
    std::vector<double> frequencies = {0.95};
    double              wave_number = 1.;
    double              bias        = 0.;
    double              amplitude   = 30.;
    double              growth      = 0.;
    double              curvature   = 2.;
    std::string         table;
    bool                table_is_periodic = true;
    double              sphere_amplitude  = 0.1;
    unsigned int        sphere_order      = 2;

    void add_parameters(ParameterHandler &prm);
    void check() const;
  };

  /** The coordinates of the deformation, and their derivatives by the gait's argument. */
  struct GaitState
  {
    std::vector<double> c, rates;
  };

  /**
   * The coordinates c_i of the deformation over time. The argument of a periodic gait is its
   * phase psi = 2 pi f t, so that it does not depend on the frequency f; of any other the time.
   */
  class Gait
  {
  public:
    virtual ~Gait() = default;

    /** At the phase [rad] or time [s]. */
    virtual GaitState evaluate(double argument) const = 0;

    virtual bool is_periodic() const
    {
      return true;
    }

    /** The frequencies to swim with [Hz]; one that has no meaning for a gait without period. */
    virtual std::vector<double> get_frequencies() const = 0;

    /** The last time [s] of which the gait knows something. */
    virtual double get_end() const;

    /** The body whose shape the coordinates determine. */
    virtual std::unique_ptr<Deformation> create_deformation(const Surface &surface,
                                                            const Shape   &shape) const = 0;
  };

  /**
   * The gait that @p parameters describe. Joint angles at s_i = i L/7, i = 1..6, with
   * u_i = psi - 2 pi k s_i/L and the bias angle gamma:
   *
   * `arctangent`: c_i = arctan(sin u_i) + gamma, the paper's motion;
   * `sine`: c_i = A ((1 - g) + g s_i/L) sin u_i + gamma;
   * `table`: c_i from a file, between its rows by cubic splines.
   *
   * Others: `curvature`, the spine's curvature K ((1 - g) + g s/L) sin(psi - 2 pi k s/L);
   * `deforming sphere`, see PulsatingSphere; `none`, a rigid body.
   */
  std::unique_ptr<Gait> create_gait(const GaitParameters &parameters);

  /**
   * Whether each half of the stroke is the other one played backwards: then there is no net
   * motion, at any speed of the strokes (E. M. Purcell, Am. J. Phys. 45, 1977,
   * doi:10.1119/1.10903, whose argument holds in an ideal fluid as well).
   */
  bool is_reciprocal(const Gait &gait);

  /** Whether c(psi + pi) = -c(psi): the second half of the stroke mirrors the first one. */
  bool has_glide_symmetry(const Gait &gait);
} // namespace caudal::ideal

#endif
