#include <caudal/base/expression.h>
#include <caudal/fluid/body_force.h>

namespace caudal
{
  namespace
  {
    const std::string path = "Fluid/Body force";
  }

  template <int dim>
  BodyForce<dim>::BodyForce(const FluidParameters<dim> &parameters, const double time)
      : expression(parameters.body_force)
      , components(dim)
  {
    if (!parameters.has_body_force())
      return;
    function = make_expression<dim>(path, expression, dim);
    function->set_time(time);
  }

  template <int dim>
  bool BodyForce<dim>::is_zero() const
  {
    return function == nullptr;
  }

  template <int dim>
  Tensor<1, dim> BodyForce<dim>::value(const Point<dim> &point)
  {
    Tensor<1, dim> force;
    if (is_zero())
      return force;
    function->vector_value(point, components);
    for (unsigned int d = 0; d < dim; ++d)
      force[d] = components[d];
    if (!numbers::is_finite(force.norm_square()))
      check_finite(path, expression, *function, point);
    return force;
  }

  template class BodyForce<2>;
  template class BodyForce<3>;
} // namespace caudal
