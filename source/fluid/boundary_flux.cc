// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fluid/boundary_flux.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>

namespace caudal
{
  // Functions of time are looked at this often, ends included.
  constexpr unsigned int n_times = 17;

  template <int dim>
  ScaledOutflow<dim>::ScaledOutflow(std::unique_ptr<Function<dim>> velocity,
                                    const unsigned int side, const double factor)
      : Function<dim>(dim)
      , velocity(std::move(velocity))
      , side(side)
      , factor(factor)
  {}

  template <int dim>
  double ScaledOutflow<dim>::value(const Point<dim> &point, const unsigned int component) const
  {
    const double value     = velocity->value(point, component);
    const bool   flows_out = component == side / 2 && (side % 2 == 1 ? value > 0 : value < 0);
    return flows_out ? factor * value : value;
  }

  template <int dim>
  BoundaryFlux compute_boundary_flux(const FluidSpace<dim>           &space,
                                     const AffineConstraints<double> &constraints)
  {
    FieldVector velocity = space.make_velocity_vector();
    constraints.distribute(velocity);
    velocity.update_ghost_values();

    const QGauss<dim - 1>            quadrature(space.velocity_element.degree + 1);
    FEFaceValues<dim>                values(space.velocity_element, quadrature,
                                            update_values | update_normal_vectors | update_JxW_values);
    const FEValuesExtractors::Vector components(0);
    std::vector<Tensor<1, dim>>      u(quadrature.size());
    BoundaryFlux                     flux;
    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
      {
        if (!cell->is_locally_owned() || !cell->at_boundary(f))
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

  template <int dim>
  double check_boundary_flux(const FluidSpace<dim> &space, const double end_time)
  {
    double largest_change = 0;
    for (unsigned int k = 0; k < n_times && space.balances_fluxes(); ++k)
      largest_change =
          std::max(largest_change,
                   std::abs(space.get_outflow_factor({end_time * k / (n_times - 1), {}}) - 1));
    return largest_change;
  }

#define INSTANTIATE(dim)                                                                           \
  template class ScaledOutflow<dim>;                                                               \
  template BoundaryFlux compute_boundary_flux(const FluidSpace<dim> &,                             \
                                              const AffineConstraints<double> &);                  \
  template double       check_boundary_flux(const FluidSpace<dim> &, double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
