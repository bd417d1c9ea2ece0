// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_boundary_condition_h
#define caudal_fluid_boundary_condition_h

#include <caudal/base/plugin.h>

#include <deal.II/base/function.h>
#include <deal.II/fe/component_mask.h>

namespace caudal
{
  /** The inflow velocity of all sides that have none of their own, section `Fluid`. */
  struct SharedInflow
  {
    std::string velocity; // components separated by ';' [m/s]
    double      ramp = 0; // time during which it grows [s]
  };

  /** A condition on a side of the domain, whose normal n is along an axis. */
  template <int dim>
  class BoundaryCondition : public Plugin
  {
  public:
    /**
     * Takes what concerns all sides; @p path is that of its section. To be called before the
     * functions below.
     */
    virtual void set_up(const SharedInflow & /*shared*/, const std::string & /*path*/) {}

    /** The components of the velocity that are prescribed if the @p normal is along this axis. */
    virtual ComponentMask get_prescribed_components(unsigned int normal) const = 0;

    /** Where sides meet, the one of lower rank decides on what both prescribe. */
    virtual unsigned int get_rank() const
    {
      return 2;
    }

    /** Whether other than zero velocities are prescribed, which may depend on time. */
    virtual bool has_velocity() const
    {
      return false;
    }

    /** The prescribed velocity at @p time [m/s], if there is one. */
    virtual std::unique_ptr<Function<dim>> make_velocity(double /*time*/) const
    {
      return std::make_unique<Functions::ZeroFunction<dim>>(dim);
    }

    /** Whether the traction is prescribed, so that the fluid passes as it likes. */
    virtual bool is_open() const
    {
      return false;
    }

    /**
     * The traction -p n + mu du/dn that is prescribed on an open side with the outer @p normal n at
     * @p time [Pa]; null where it is zero.
     */
    virtual std::unique_ptr<Function<dim>> make_traction(const Tensor<1, dim> & /*normal*/,
                                                         double /*time*/) const
    {
      return {};
    }

    /** Whether `Fluid/Backflow stabilisation` may change an open side where the flow reverses. */
    virtual bool resists_backflow() const
    {
      return false;
    }
  };

  /** A side of which the traction is prescribed, and no component of the velocity. */
  template <int dim>
  class OpenSide : public BoundaryCondition<dim>
  {
  public:
    ComponentMask get_prescribed_components(const unsigned int) const override
    {
      return ComponentMask(dim, false);
    }

    bool is_open() const override
    {
      return true;
    }
  };
} // namespace caudal

#endif
