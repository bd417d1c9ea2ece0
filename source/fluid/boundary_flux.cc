// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fluid/boundary_flux.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>
#include <sstream>

namespace caudal
{
  namespace
  {
    // Functions of time are looked at this often, ends included.
    constexpr unsigned int n_times   = 17;
    constexpr double       tolerance = 1e-6;

    /** What flows out of the domain, and what flows either way [m^2/s, in 3D m^3/s]. */
    struct Flux
    {
      double net = 0, total = 0;
    };

    /** The flux of the velocities that are prescribed at @p time. */
    template <int dim>
    Flux compute_prescribed_flux(const FluidSpace<dim> &space, const double time)
    {
      FieldVector velocity = space.make_velocity_vector();
      space.get_constraints(time).distribute(velocity);
      velocity.update_ghost_values();

      const QGauss<dim - 1>            quadrature(space.velocity_element.degree + 1);
      FEFaceValues<dim>                values(space.velocity_element, quadrature,
                                              update_values | update_normal_vectors | update_JxW_values);
      const FEValuesExtractors::Vector components(0);
      std::vector<Tensor<1, dim>>      u(quadrature.size());
      Flux                             flux;
      for (const auto &cell : space.velocity_dofs.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
        {
          if (!cell->is_locally_owned() || !cell->at_boundary(f) ||
              !space.get_boundary_condition(cell->face(f)->boundary_id()).has_velocity())
            continue;
          values.reinit(cell, f);
          values[components].get_function_values(velocity, u);
          double of_face = 0;
          for (unsigned int q = 0; q < u.size(); ++q)
            of_face += u[q] * values.normal_vector(q) * values.JxW(q);
          flux.net += of_face;
          flux.total += std::abs(of_face);
        }
      return {Utilities::MPI::sum(flux.net, space.get_communicator()),
              Utilities::MPI::sum(flux.total, space.get_communicator())};
    }
  } // namespace

  template <int dim>
  void check_boundary_flux(const FluidSpace<dim> &space, const double end_time)
  {
    bool has_velocity = false;
    for (unsigned int side = 0; side < 2 * dim; ++side)
    {
      const BoundaryCondition<dim> &condition = space.get_boundary_condition(side);
      if (condition.is_open())
        return;
      has_velocity = has_velocity || condition.has_velocity();
    }
    for (unsigned int k = 0; k < n_times && has_velocity; ++k)
    {
      const double       time = end_time * k / (n_times - 1);
      const Flux         flux = compute_prescribed_flux(space, time);
      std::ostringstream text;
      text << "Fluid/Boundary conditions: at t = " << time << " s the prescribed velocities let "
           << std::abs(flux.net) << (dim == 2 ? " m^2/s" : " m^3/s") << " more "
           << (flux.net < 0 ? "in than out" : "out than in")
           << ", and no side is open: there is no incompressible flow. Set a side to outflow, or "
              "give velocities whose fluxes cancel.";
      AssertThrow(!(std::abs(flux.net) > tolerance * flux.total), ExcMessage(text.str()));
    }
  }

  template void check_boundary_flux(const FluidSpace<2> &, double);
  template void check_boundary_flux(const FluidSpace<3> &, double);
} // namespace caudal
