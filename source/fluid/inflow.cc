// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/base/expression.h>
#include <caudal/fluid/boundary_condition.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    /** A velocity times the factor with which it has grown. */
    template <int dim>
    class RampedVelocity : public Function<dim>
    {
    public:
      RampedVelocity(const Expression<dim> &velocity, const double ramp, const double time)
          : Function<dim>(dim)
          , velocity(velocity)
          , factor(time < ramp ? 0.5 * (1 - std::cos(numbers::PI * time / ramp)) : 1)
      {
        this->velocity.set_time(time);
      }

      double value(const Point<dim> &point, const unsigned int component) const override
      {
        return factor * velocity.value(point, component);
      }

    private:
      Expression<dim> velocity;
      const double    factor;
    };

    /** u = the velocity of this side, or that of all inflow sides. */
    template <int dim>
    class Inflow : public BoundaryCondition<dim>
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Velocity", own.velocity,
                          "Velocity on this side as function of x, y, (z,) t, components separated "
                          "by ';' [m/s]; empty: Fluid/Inflow velocity, with its ramp.",
                          Patterns::Anything());
        prm.add_parameter("Ramp", own.ramp,
                          "Time during which the velocity of this side grows as "
                          "(1-cos(pi t/ramp))/2 [s].");
      }

      void check(const std::string &path) const override
      {
        check_not_negative(path + "/Ramp", own.ramp);
        AssertThrow(own.ramp == 0 || !own.velocity.empty(),
                    ExcMessage(path + "/Ramp: it belongs to the Velocity of this side, which is "
                                      "empty. Give one, or set Fluid/Inflow ramp."));
        if (!own.velocity.empty())
          Expression<dim>(path + "/Velocity", own.velocity, dim);
      }

      void set_up(const SharedInflow &shared, const std::string &path) override
      {
        const bool is_own = !own.velocity.empty();
        ramp              = is_own ? own.ramp : shared.ramp;
        velocity =
            std::make_shared<Expression<dim>>(is_own ? path + "/Velocity" : "Fluid/Inflow velocity",
                                              is_own ? own.velocity : shared.velocity, dim);
      }

      ComponentMask get_prescribed_components(const unsigned int) const override
      {
        return ComponentMask(dim, true);
      }

      unsigned int get_rank() const override
      {
        return 1;
      }

      bool has_velocity() const override
      {
        return true;
      }

      std::unique_ptr<Function<dim>> make_velocity(const double time) const override
      {
        return std::make_unique<RampedVelocity<dim>>(*velocity, ramp, time);
      }

    private:
      SharedInflow                           own;
      std::shared_ptr<const Expression<dim>> velocity;
      double                                 ramp = 0;
    };

    const DimensionalRegistration<BoundaryCondition, Inflow> registration("inflow",
                                                                          "the inflow velocity");
  } // namespace
} // namespace caudal
