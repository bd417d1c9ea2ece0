// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_gait_h
#define caudal_fish_gait_h

#include <caudal/base/plugin.h>
#include <caudal/fish/ramp.h>

#include <limits>
#include <vector>

namespace caudal
{
  /** The coordinates c_i of a gait and their derivatives by its argument. */
  struct GaitState
  {
    std::vector<double> c, rates;
  };

  /**
   * The angle theta between the spine's tangent and the x axis [rad] at some places along the
   * spine, and its derivatives with respect to the coordinates: by coordinate, then place.
   */
  struct SpineAngles
  {
    std::vector<double>              theta;
    std::vector<std::vector<double>> by_c;      ///< H_i = d theta/dc_i
    std::vector<std::vector<double>> by_c_rate; ///< sum_j c_j' dH_i/dc_j; empty where it is zero
  };

  /** The entries of section `Gait` that the gaits share. */
  struct SharedGaitParameters
  {
    StartUpRamp         ramp;
    std::vector<double> frequencies = {0.95};
    double              wave_number = 1.;
    double              bias        = 0.;
    double              growth      = 0.;
  };

  /**
   * A prescribed deformation of the body in its plane: the inclination theta(s) of its spine,
   * which keeps its length, s being the arc length from the nose [m]. It depends on coordinates
   * c_i, which are functions of the gait's argument: the phase psi = 2 pi f t of a periodic gait,
   * so that it does not depend on the frequency f, and the time t of any other one.
   *
   * This base class is for gaits of which theta is a function of s and the argument: that is
   * their only coordinate. Those whose theta is a sum of modes derive from ModalGait.
   */
  class Gait : public Plugin
  {
  public:
    /** Prepares the gait for a body of length @p length [m]. */
    virtual void set_up(const SharedGaitParameters &shared, double length);

    /** Whether it prescribes anything to a body that is otherwise driven by its muscles. */
    virtual bool is_prescribed() const
    {
      return true;
    }

    /** Whether it is a function of the phase; not so during a start-up. */
    bool is_periodic() const
    {
      return has_period() && shared.ramp.duration == 0.;
    }

    /** The frequencies to swim with [Hz]; one that has no meaning for a gait without period. */
    virtual std::vector<double> get_frequencies() const
    {
      return shared.frequencies;
    }

    /** Frequency of the beat [Hz]; 0 if nothing is prescribed, or nothing that is known to repeat.
     */
    double get_beat_frequency() const
    {
      return is_prescribed() && has_period() ? get_frequencies()[0] : 0.;
    }

    /** The derivative of the argument by time [1/s], if the frequency is @p frequency [Hz]. */
    double get_argument_rate(const double frequency) const
    {
      return is_periodic() ? 2. * numbers::PI * frequency : 1.;
    }

    /** The last time [s] of which the gait knows something. */
    virtual double get_end() const
    {
      return std::numeric_limits<double>::max();
    }

    /** What is worth to be known of data that it was made from; empty: nothing. */
    virtual std::string describe() const
    {
      return "";
    }

    /** The length of the body's spine [m]. */
    double get_length() const
    {
      return length;
    }

    virtual unsigned int n_coordinates() const
    {
      return 1;
    }

    /** What a coordinate is called in tables. */
    virtual std::string get_coordinate_name() const
    {
      return "mode";
    }

    /** The coordinates at the phase [rad] or time [s]. */
    virtual GaitState evaluate(double argument) const;

    /** Numbers that are the same for two arguments if the spine is the same. */
    virtual std::vector<double> describe_shape(double argument) const;

    /**
     * The spine's angles at the places @p s [m] for the coordinates @p c; with @p rates also
     * the rates of their derivatives. Here by differences of fourth order.
     */
    virtual SpineAngles compute_angles(const std::vector<double> &s, const std::vector<double> &c,
                                       const std::vector<double> &rates = {}) const;

    /** A quantity of the spine and its derivative by the argument. */
    struct Motion
    {
      double value = 0.;
      double rate  = 0.;
    };

    /**
     * Whether sections are shifted sideways, each at its fixed x, instead of turning with a spine
     * that keeps its length: then the gait is y(x) of compute_shifts() alone.
     */
    virtual bool shifts_sections() const
    {
      return false;
    }

    /** The lateral displacements y at the places @p x [m], if shifts_sections(). */
    virtual std::vector<Motion> compute_shifts(const std::vector<double> &x, double argument) const;

    /** The spine's curvature at the places @p s, by a difference [1/m]. */
    std::vector<double> compute_curvature(const std::vector<double> &s,
                                          const std::vector<double> &c) const;

  protected:
    /** The inclinations theta at the places @p s [m]. */
    virtual std::vector<Motion> compute_inclinations(const std::vector<double> &s,
                                                     double                     argument) const;

    /** Whether it would be a function of the phase without a start-up. */
    virtual bool has_period() const
    {
      return true;
    }

    SharedGaitParameters shared;
    double               length = 1.; // [m]
  };

  /** A gait of which theta(s) = sum_i c_i H_i(s), with H_i(0) = 0; a start-up scales the c_i. */
  class ModalGait : public Gait
  {
  public:
    GaitState           evaluate(double argument) const final;
    std::vector<double> describe_shape(double argument) const final;
    SpineAngles         compute_angles(const std::vector<double> &s, const std::vector<double> &c,
                                       const std::vector<double> &rates = {}) const final;

  protected:
    /** The coordinates without start-up: at the phase [rad], or time [s] if has_period(). */
    virtual GaitState evaluate_stroke(double argument) const = 0;

    /** H_i(s); s in m. */
    virtual double mode(unsigned int i, double s) const = 0;
  };

  /** Section `Gait` of a body. */
  struct GaitParameters
  {
    Choice<Gait>         type;
    SharedGaitParameters shared;

    explicit GaitParameters(const std::string &default_type = "none");

    /** Declares the section in the one that @p prm is in. */
    void add_parameters(ParameterHandler &prm);

    /** Throws a sentence about the first bad entry; @p path is the body's section. */
    void check(const std::string &path) const;

    /** The chosen gait, for a body of length @p length [m]. */
    std::unique_ptr<Gait> create(double length) const;
  };

  /**
   * Whether each half of the stroke is the other one played backwards: then there is no net
   * motion, at any speed of the strokes (E. M. Purcell, Am. J. Phys. 45, 1977,
   * doi:10.1119/1.10903, whose argument holds in an ideal fluid as well).
   */
  bool is_reciprocal(const Gait &gait);

  /** Whether c(psi + pi) = -c(psi): the second half of the stroke mirrors the first one. */
  bool has_glide_symmetry(const Gait &gait);
} // namespace caudal

#endif
