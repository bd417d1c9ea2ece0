// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/expression.h>
#include <caudal/fluid/boundary_condition.h>

namespace caudal
{
  namespace
  {
    /** The traction -p n of a pressure. */
    template <int dim>
    class PressureTraction : public Function<dim>
    {
    public:
      PressureTraction(const Expression<dim> &pressure, const Tensor<1, dim> &normal,
                       const double time)
          : Function<dim>(dim)
          , pressure(pressure)
          , normal(normal)
      {
        this->pressure.set_time(time);
      }

      double value(const Point<dim> &point, const unsigned int component) const override
      {
        return -pressure.value(point) * normal[component];
      }

    private:
      Expression<dim>      pressure;
      const Tensor<1, dim> normal;
    };

    /** -p n + mu du/dn = -p n of the pressure outside, whichever way the fluid flows. */
    template <int dim>
    class PressureSide : public OpenSide<dim>
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Pressure", text,
                          "Pressure outside of this side, as function of x, y, (z,) t [Pa]; with "
                          "gravity, that of fluid at rest is rho g times the depth.",
                          Patterns::Anything());
      }

      void check(const std::string &path) const override
      {
        Expression<dim>(path + "/Pressure", text, 1);
      }

      void set_up(const SharedInflow &, const std::string &path) override
      {
        pressure = std::make_shared<Expression<dim>>(path + "/Pressure", text, 1);
      }

      std::unique_ptr<Function<dim>> make_traction(const Tensor<1, dim> &normal,
                                                   const double          time) const override
      {
        return std::make_unique<PressureTraction<dim>>(*pressure, normal, time);
      }

    private:
      std::string                            text = "0";
      std::shared_ptr<const Expression<dim>> pressure;
    };

    const DimensionalRegistration<BoundaryCondition, PressureSide>
        registration("pressure", "a given pressure, whichever way the fluid flows");
  } // namespace
} // namespace caudal
