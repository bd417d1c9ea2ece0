#ifndef caudal_potential_stroke_model_h
#define caudal_potential_stroke_model_h

#include <caudal/potential/boundary_elements.h>
#include <caudal/potential/gait.h>
#include <caudal/potential/trigonometric_table.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/vector.h>

#include <memory>

namespace caudal::potential
{
  /** Densities [kg/m^3]. */
  struct Densities
  {
    double fluid = 1000.;
    double body  = 1000.;
  };

  /** Rotation and translation: (omega, v), or the impulses (Lambda, Pi). */
  using Screw = Tensor<1, 6>;

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
    std::vector<double> rates;                   ///< dc_i/dpsi
    std::vector<double> momenta;         ///< from rest: (G dc/dpsi)_i, G = M_cc - M_cq M_qq^-1 M_qc
    std::vector<double> energy_gradient; ///< from rest: (1/2) dc/dpsi^T (dG/dc_i) dc/dpsi

    /** T from rest, T_dd - P.M^-1 P/2 [J s^2] */
    double compute_energy_from_rest() const;
  };

  /** How the body and the fluid around it respond to the gait, at any instant. */
  class StrokeModel
  {
  public:
    virtual ~StrokeModel() = default;

    virtual MotionCoefficients compute_motion(double argument) = 0;
    virtual StrokeState        compute_state(double argument)  = 0;

    /** Torques of the modes from rest, Q_i = d/dpsi (G dc/dpsi)_i - (1/2) dc/dpsi^T (d_i G)
     * dc/dpsi. */
    virtual std::vector<double> compute_torques(double argument) = 0;

    /** d(centre of mass)/dpsi in the body's frame [m]. */
    virtual Tensor<1, 3> compute_centre_rate(double argument) = 0;

    /** The potentials of Potentials::values at the surface's nodes. */
    virtual FullMatrix<double> compute_potentials(double argument) = 0;
  };

  /** Body, gait and fluid: computes the state at an instant by boundary elements. */
  class SwimmingShape
  {
  public:
    SwimmingShape(const Surface &surface, const Deformation &deformation, const Gait &gait,
                  const Densities &densities, bool with_torques, MPI_Comm communicator);

    /** The state and, unless null, the potentials. */
    StrokeState compute_state(double argument, FullMatrix<double> *potentials = nullptr);

    const Surface     &surface;
    const Deformation &deformation;
    const Gait        &gait;
    const Densities    densities;
    const bool         with_torques;
    BoundaryElements   boundary_elements;
  };

  /** A new surface at each instant. */
  std::unique_ptr<StrokeModel> create_brute_force(SwimmingShape &shape, double increment);
} // namespace caudal::potential

#endif
