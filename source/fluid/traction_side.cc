// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/expression.h>
#include <caudal/fluid/boundary_condition.h>

namespace caudal
{
  namespace
  {
    /** -p n + mu du/dn = a function of place and time, whichever way the fluid flows. */
    template <int dim>
    class TractionSide : public OpenSide<dim>
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Traction", text,
                          "Force of what is outside on the fluid per area of this side, -p n + mu "
                          "du/dn, as function of x, y, (z,) t, components separated by ';' [Pa].",
                          Patterns::Anything());
      }

      void check(const std::string &path) const override
      {
        Expression<dim>(path + "/Traction", text, dim);
      }

      void set_up(const SharedInflow &, const std::string &path) override
      {
        traction = std::make_shared<Expression<dim>>(path + "/Traction", text, dim);
      }

      std::unique_ptr<Function<dim>> make_traction(const Tensor<1, dim> &,
                                                   const double time) const override
      {
        auto result = std::make_unique<Expression<dim>>(*traction);
        result->set_time(time);
        return result;
      }

    private:
      std::string                            text = dim == 2 ? "0; 0" : "0; 0; 0";
      std::shared_ptr<const Expression<dim>> traction;
    };

    const DimensionalRegistration<BoundaryCondition, TractionSide>
        registration("traction", "a given traction, whichever way the fluid flows");
  } // namespace
} // namespace caudal
