#include <caudal/base/expression.h>
#include <caudal/solid/surface_load.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/numerics/vector_tools_rhs.h>

#include <cmath>

namespace caudal
{
  template <int dim>
  SurfaceLoad<dim>::SurfaceLoad(const SolidBody<dim> &body)
      : body(body)
      , path(body.get_parameters().get_path() + "/Traction")
  {
    const std::string &expression = body.get_parameters().traction;
    if (!expression.empty())
      traction = make_expression<dim>(path, expression, dim);
  }

  template <int dim>
  void SurfaceLoad<dim>::add_to(Vector<double> &force, const double time) const
  {
    if (!traction)
      return;
    traction->set_time(time);
    const DoFHandler<dim> &dofs = body.get_dof_handler();
    Vector<double>         load(dofs.n_dofs());
    VectorTools::create_boundary_right_hand_side(dofs, QGauss<dim - 1>(dofs.get_fe().degree + 1),
                                                 *traction, load);
    AssertThrow(std::isfinite(load.l2_norm()),
                ExcMessage(path + ": <" + body.get_parameters().traction +
                           "> is not finite on the body's surface at t = " + std::to_string(time) +
                           " s. Give a function that is defined there."));
    force += load;
  }

  template class SurfaceLoad<2>;
  template class SurfaceLoad<3>;
} // namespace caudal
