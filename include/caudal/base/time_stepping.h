// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_time_stepping_h
#define caudal_base_time_stepping_h

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace caudal
{
  /** Section `Time` of the .prm. */
  struct TimeParameters
  {
    std::string  scheme                    = "semi-implicit";
    double       end_time                  = 5.;
    double       step                      = 2e-3;
    bool         adaptive                  = false;
    double       largest_step              = 5e-3;
    double       smallest_step             = 1e-7;
    double       body_cfl                  = 1.;
    double       convective_cfl            = 2.;
    double       error_tolerance           = 0.1;
    unsigned int largest_number_of_retries = 6;

    void add_parameters(dealii::ParameterHandler &prm);
    void check() const;
    bool is_explicit() const;
  };

  /**
   * Weights of a two-step formula with variable step,
   * dy/dt(t^{n+1}) ~ derivative[0] y^{n+1} + derivative[1] y^n + derivative[2] y^{n-1},
   * and of the extrapolation y(t^{n+1}) ~ extrapolation[0] y^n + extrapolation[1] y^{n-1}.
   *
   * A velocity that transports is extrapolated further, by transport[0] y^n + transport[1] y^{n-1}
   * + transport[2] y^{n-2}: linearly, and by the part @p curvature of what a parabola adds. With
   * two thirds of it the error of the linear one, which makes the lift of unsteady flows too large,
   * and that of the formula, which makes it too small, cancel (prm/benchmarks/README.md).
   */
  struct TimeWeights
  {
    double derivative[3];
    double extrapolation[2];
    double transport[3];

    /**
     * The backward differentiation formula of second order; of first order for @p previous_step =
     * 0. With @p older_step = 0, of the step before that one, transport is extrapolated linearly.
     */
    static TimeWeights backward_differentiation(double step, double previous_step,
                                                double older_step, double curvature);
  };

  /** The time level of a state, and the size of the step that comes next. */
  class TimeStepper
  {
  public:
    /** @p parameters have to outlive the object. */
    explicit TimeStepper(const TimeParameters &parameters);

    double get_time() const
    {
      return time;
    }
    /** The size of the coming step [s]. */
    double get_step() const
    {
      return step;
    }
    double get_previous_step() const
    {
      return previous_step;
    }
    /** The step before the previous one [s]; 0 if there was none. */
    double get_older_step() const
    {
      return older_step;
    }
    unsigned int get_step_number() const
    {
      return step_number;
    }
    bool is_at_end() const;

    /** Weights of a coming step of length @p step (BDF1 in the first, then BDF2). */
    TimeWeights get_weights(double step) const;

    /** What decides the next step's size. */
    struct Indicators
    {
      /** Largest displacement of a body point in the step, in fluid spacings. */
      double body_cfl = 0;
      /** max |u| dt / h. */
      double convective_cfl = 0;
      /** Largest difference of predicted and computed body position, in fluid spacings. */
      double error = 0;

      template <class Archive>
      void serialize(Archive &archive, unsigned int /*version*/)
      {
        archive &body_cfl &convective_cfl &error;
      }
    };

    /** A step was taken: t^n := t^n + @p step; the size of the next one follows from @p indicators.
     */
    void accept(double step, const Indicators &indicators);

    /**
     * Half of the @p failed_step, which is the retry with the number @p n_retries, from 0 on, if
     * the parameters allow it; else throws. @p reason is a sentence on the failure.
     */
    double halve(double failed_step, unsigned int n_retries, const std::string &reason) const;

    /** Throws if the coming step is to be smaller than the parameters allow. */
    void check_step() const;

    /** After the state was read back: chooses the coming step as accept() did. */
    void resume();

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &time &regular_step &previous_step &older_step &convective_rate &step_number;
    }

  private:
    const TimeParameters *parameters;
    double                time            = 0;
    double                step            = 0;
    double                regular_step    = 0;
    double                previous_step   = 0;
    double                older_step      = 0;
    double                convective_rate = 0; // convective CFL number over step [1/s]
    unsigned int          step_number     = 0;

    void choose_step();
  };
} // namespace caudal

#endif
