// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_swimming_shape_h
#define caudal_ideal_swimming_shape_h

#include <caudal/fish/gait.h>
#include <caudal/ideal/deformation.h>
#include <caudal/ideal/exterior_flow.h>

#include <deal.II/base/symmetric_tensor.h>

namespace caudal::ideal
{
  /** Densities [kg/m^3]. */
  struct Densities
  {
    double fluid = 1000.;
    double body  = 1000.;
  };

  /** The torques of the joints that are wanted; those of any swim cost many times as much. */
  enum class Torques
  {
    none,
    from_rest, ///< at the start, and without external forces
    any
  };

  /**
   * What drives the body: the gait, and the impulses that it has not got from its gait. By
   * default the gait alone, at the unit rate of its argument.
   */
  struct Drive
  {
    double rate = 1.;    ///< dpsi/dt
    Screw  impulse;      ///< (Lambda, Pi)
    Screw  impulse_rate; ///< its derivative by time, in the body's frame

    /** Their number, without and with impulses. */
    static constexpr unsigned int n_from_rest = 1, n = 7;

    /** z: the rate, then the impulses. */
    double get(const unsigned int a) const
    {
      return a == 0 ? rate : impulse[a - 1];
    }

    double get_derivative(const unsigned int a) const
    {
      return a == 0 ? 0. : impulse_rate[a - 1];
    }
  };

  /**
   * What the torques of the modes need. A body whose drives are z moves with u = (q, dc/dt) =
   * sum_a z_a u_a: u_0 is the motion from rest for unit rate of the gait, u_a = (M^-1 e_a, 0)
   * that of a unit impulse. M is the mass matrix of all motions.
   */
  struct TorqueCoefficients
  {
    std::vector<double> momenta; ///< (M u_a)_i by mode i, then drive a

    /**
     * By mode i, then pairs a <= b: dT/dc_i at fixed u = sum_(a<=b) z_a z_b times these, of
     * which those of a = b are u_a^T (dM/dc_i) u_a/2.
     */
    std::vector<double> energy_gradient;
  };

  /** What the rigid motion of the body needs: the impulses are M q + rate P. */
  struct MotionCoefficients
  {
    SymmetricTensor<2, 6> mass; ///< M, of body and fluid, for q = (omega, v) in the body's frame
    Screw                 momentum; ///< P of the deformation, for dpsi/dt = 1

    /** q for the impulses @p impulse if the gait's argument advances at @p rate. */
    Screw compute_velocity(const Screw &impulse, double rate) const;

    /** Adds @p factor times the other ones. */
    void add(double factor, const MotionCoefficients &other);

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &mass &momentum;
    }
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

    /** Adds @p factor times the other one, but for the coordinates and their rates. */
    void add(double factor, const StrokeState &other);

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &motion &deformation_energy &centre &c &rates &torques.momenta &torques
          .energy_gradient;
    }
  };

  /** A state with the potentials that belong to it, Potentials::values. */
  struct StrokeSolution
  {
    StrokeState        state;
    FullMatrix<double> potentials;

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &state &potentials;
    }
  };

  /** Body, gait and fluid: computes the state at an instant by boundary elements. */
  class SwimmingShape
  {
  public:
    SwimmingShape(const Surface &surface, const Deformation &deformation, const Gait &gait,
                  const Densities &densities, Torques torques, MPI_Comm communicator);

    StrokeSolution solve(double argument);

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
