#ifndef caudal_fluid_body_force_h
#define caudal_fluid_body_force_h

#include <caudal/fluid/fluid_parameters.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/lac/vector.h>

#include <memory>

namespace caudal
{
  /** The force f(x, t) on the fluid that `Fluid/Body force` gives [N/m^3], at one time. */
  template <int dim>
  class BodyForce
  {
  public:
    BodyForce(const FluidParameters<dim> &parameters, double time);

    /** Whether there is none anywhere. */
    bool is_zero() const;

    /** Throws if the force is not finite at @p point. */
    Tensor<1, dim> value(const Point<dim> &point);

  private:
    const std::string                    expression;
    std::unique_ptr<FunctionParser<dim>> function;
    Vector<double>                       components;
  };
} // namespace caudal

#endif
