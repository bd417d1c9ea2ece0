#include <caudal/solid/surface_load.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/numerics/vector_tools_rhs.h>

namespace caudal
{
  template <int dim>
  SurfaceLoad<dim>::SurfaceLoad(const SolidBody<dim> &body)
      : body(body)
  {
    const SolidParameters<dim> &parameters = body.get_parameters();
    if (!parameters.traction.empty())
      traction = std::make_unique<Expression<dim>>(parameters.get_path() + "/Traction",
                                                   parameters.traction, dim);
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
    force += load;
  }

  template class SurfaceLoad<2>;
  template class SurfaceLoad<3>;
} // namespace caudal
