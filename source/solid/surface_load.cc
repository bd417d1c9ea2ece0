// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/expression.h>
#include <caudal/solid/load.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/numerics/vector_tools_rhs.h>

namespace caudal
{
  namespace
  {
    template <int dim>
    class SurfaceLoad : public Load<dim>
    {
    public:
      explicit SurfaceLoad(const SolidBody<dim> &body)
          : body(body)
          , traction(
                std::make_unique<Expression<dim>>(body.get_parameters().get_path() + "/Traction",
                                                  body.get_parameters().traction, dim))
      {}

      LoadAccount get_account() const override
      {
        return LoadAccount::muscle;
      }

      void add(const BodyMotion &motion, Vector<double> &force, BodyResponse *) const override
      {
        traction->set_time(motion.time);
        const DoFHandler<dim> &dofs = body.get_dof_handler();
        Vector<double>         load(dofs.n_dofs());
        VectorTools::create_boundary_right_hand_side(
            dofs, QGauss<dim - 1>(dofs.get_fe().degree + 1), *traction, load);
        force += load;
      }

    private:
      const SolidBody<dim>                  &body;
      const std::unique_ptr<Expression<dim>> traction;
    };
  } // namespace

  template <int dim>
  std::unique_ptr<Load<dim>> make_surface_load(const SolidBody<dim> &body)
  {
    return std::make_unique<SurfaceLoad<dim>>(body);
  }

  template std::unique_ptr<Load<2>> make_surface_load(const SolidBody<2> &);
  template std::unique_ptr<Load<3>> make_surface_load(const SolidBody<3> &);
} // namespace caudal
