// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_swimming_shape_h
#define caudal_ideal_swimming_shape_h

#include <caudal/fish/gait.h>
#include <caudal/ideal/boundary_elements.h>
#include <caudal/ideal/deformation.h>
#include <caudal/ideal/torques.h>

namespace caudal::ideal
{
  /** Densities [kg/m^3]. */
  struct Densities
  {
    double fluid = 1000.;
    double body  = 1000.;
  };

  /** What the rigid motion of the body needs: the impulses are M q + rate P. */
  struct MotionCoefficients
  {
    Tensor<2, 6> mass;     ///< M, of body and fluid, for q = (omega, v) in the body's frame
    Screw        momentum; ///< P of the deformation, for dpsi/dt = 1

    /** q for the impulses @p impulse if the gait's argument advances at @p rate. */
    Screw compute_velocity(const Screw &impulse, double rate) const;
  };

  /**
   * Everything that depends on the shape of the body at one instant of the stroke, for unit
   * rate of the gait's argument psi (rad or s) and, where it says so, for a body that swims
   * from rest. At another rate, momenta grow in proportion to it, energy and torques to its
   * square, power to its cube.
   */
  struct StrokeState
  {
    MotionCoefficients  motion;
    double              deformation_energy = 0.; ///< T_dd [J s^2]
    Tensor<1, 3>        centre;                  ///< of mass, in the body's frame [m]
    std::vector<double> c;                       ///< coordinates of the modes
    std::vector<double> rates;                   ///< dc_i/dpsi
    TorqueCoefficients  torques;

    /** T from rest, T_dd - P.M^-1 P/2 [J s^2] */
    double compute_energy_from_rest() const;
  };

  /** Body, gait and fluid: computes the state at an instant by boundary elements. */
  class SwimmingShape
  {
  public:
    SwimmingShape(const Surface &surface, const Deformation &deformation, const Gait &gait,
                  const Densities &densities, Torques torques, MPI_Comm communicator);

    /** The state and, unless null, the potentials. */
    StrokeState compute_state(double argument, FullMatrix<double> *potentials = nullptr);

    const Surface     &surface;
    const Deformation &deformation;
    const Gait        &gait;
    const Densities    densities;
    const Torques      torques;
    BoundaryElements   boundary_elements;

    /** The number of drives in TorqueCoefficients. */
    unsigned int n_drives() const
    {
      return torques == Torques::any ? Drive::n : Drive::n_from_rest;
    }

  private:
    TorqueCoefficients  compute_torque_coefficients(ExteriorFlow             &flow,
                                                    const FullMatrix<double> &mass,
                                                    const GaitState          &at,
                                                    const MotionCoefficients &rigid);
    std::vector<double> compute_energy_gradient(ExteriorFlow &flow, const std::vector<double> &c,
                                                const Vector<double> &u) const;
  };
} // namespace caudal::ideal

#endif
