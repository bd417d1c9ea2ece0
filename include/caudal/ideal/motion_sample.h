// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_motion_sample_h
#define caudal_ideal_motion_sample_h

#include <caudal/ideal/kirchhoff.h>

#include <boost/serialization/vector.hpp>

#include <vector>

namespace caudal::ideal
{
  /** The swimming body at one time. Vectors without another note are in the inertial frame. */
  struct MotionSample
  {
    double              time = 0.; ///< [s]
    BodyState           body;
    Screw               velocity;        ///< (omega, v) of the nose, in the body's frame
    Tensor<1, 3>        centre;          ///< of mass [m]
    Tensor<1, 3>        centre_velocity; ///< [m/s]
    double              energy = 0.;     ///< kinetic, of body and fluid [J]
    std::vector<double> coordinates;     ///< c_i of the modes
    std::vector<double> torques;         ///< Q_i of the joints [N m]; none if not known
    std::vector<double> powers;          ///< Q_i dc_i/dt [W]

    double get_power() const; ///< sum of the powers [W]

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &time &body &velocity &centre &centre_velocity &energy &coordinates &torques &powers;
    }
  };

  /**
   * Everything at @p time of a body that moves as advance_motion() says; torques if it
   * @p has_torques, which the model has to know for such a swim (see Torques).
   */
  MotionSample compute_sample(const MotionProblem &problem, const BodyState &body, double time,
                              bool has_torques);

  /** Averages and largest values over time of energy, powers and torques. */
  class EnergyAverages
  {
  public:
    /** @p weight is the sample's share of time [s]. */
    void add(const MotionSample &sample, double weight);

    /** The averages of a swim from rest at another rate, if these are those at 1 rad/s. */
    EnergyAverages at_rate(double rate) const;

    /** `<T>` [J] */
    double mean_energy() const
    {
      return energy / duration;
    }

    /** `<max(sum_i Q_i c_i', 0)>` [W] */
    double mean_positive_power() const
    {
      return positive_work / duration;
    }

    /** `sum_i <|Q_i c_i'|>` [W] */
    double mean_gross_power() const
    {
      return gross_work / duration;
    }

    double              largest_energy = 0.; ///< [J]
    std::vector<double> largest_torques;     ///< of each mode [N m]

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &largest_energy &largest_torques &duration &energy &positive_work &gross_work;
    }

  private:
    double duration = 0., energy = 0., positive_work = 0., gross_work = 0.;
  };

  /**
   * The averages over one stroke from rest at the rate of 1 rad/s, at @p n_phases equidistant
   * phases: the work of the whole cycle is independent of where it begins.
   */
  EnergyAverages average_stroke(StrokeModel &model, unsigned int n_phases, bool has_torques);
} // namespace caudal::ideal

#endif
