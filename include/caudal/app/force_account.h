#ifndef caudal_app_force_account_h
#define caudal_app_force_account_h

#include <caudal/app/time_scheme.h>
#include <caudal/io/statistics.h>

#include <deal.II/base/bounding_box.h>

#include <boost/serialization/deque.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <deque>
#include <optional>

namespace caudal
{
  /** d/dt of sampled values at the last of them, from the last three: of second order. */
  template <int dim>
  class BackwardDifference
  {
  public:
    void add(double time, const Tensor<1, dim> &value);

    /** Of first order from two samples, zero from one. */
    Tensor<1, dim> get_derivative() const;

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &samples;
    }

  private:
    std::deque<std::pair<double, Tensor<1, dim>>> samples;
  };

  /**
   * The force of the surrounding fluid on the bodies, by up to three accounts
   * that should agree (per metre of span in 2D):
   * - body force: d/dt int_B rho u - int_B f, f the force density on the fluid;
   * - feedback force: the same with the feedback forces alone; for bodies that
   *   are held and neither swim nor have another density than the fluid;
   * - control volume: the momentum balance of the flow round all bodies.
   * The inertia of the fluid in the place of the bodies B is part of all of them.
   */
  template <int dim>
  class ForceAccount
  {
  public:
    explicit ForceAccount(const ImmersedSystem<dim> &system);

    /** After each step. */
    void update(double time);

    /** int_B f of a body [N/m], the resultant of all its forces on the fluid. */
    const Tensor<1, dim> &get_resultant(const unsigned int body) const
    {
      return resultants[body];
    }

    void set_body_statistics(unsigned int body, Statistics &statistics) const;
    void set_control_volume_statistics(Statistics &statistics) const;

    /** What later forces depend on. */
    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &flow_momentum &body_momenta;
    }

  private:
    ImmersedSystem<dim>                  system;
    std::optional<BoundingBox<dim>>      control_volume;
    BackwardDifference<dim>              flow_momentum;
    std::vector<BackwardDifference<dim>> body_momenta;
    std::vector<Tensor<1, dim>>          resultants, body_forces, feedback_forces;
    Tensor<1, dim>                       control_volume_force;
  };
} // namespace caudal

#endif
