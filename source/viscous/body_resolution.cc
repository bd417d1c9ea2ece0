// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/viscous/body_resolution.h>

#include <cmath>
#include <iomanip>

namespace caudal
{
  template <int dim>
  double get_finest_cell(const DomainParameters<dim> &domain)
  {
    return domain.get_cell_size(domain.get_finest_level()).norm() / std::sqrt(dim);
  }

  template <int dim>
  BodyResolution measure_resolution(const Body<dim> &body, const DomainParameters<dim> &domain)
  {
    const SolidBody<dim> &solid  = body.get_solid();
    const BodyExtent     &extent = body.get_extent();
    const double volume = solid.get_reference_volume() / solid.get_triangulation().n_active_cells();
    return {std::pow(volume, 1. / dim) / solid.get_parameters().polynomial_degree /
                get_finest_cell(domain),
            extent.region_thickness, extent.typical_thickness};
  }

  template <int dim>
  void check_resolution(const Operators<dim> &operators)
  {
    const auto  &parameters = operators.parameters;
    const double cell       = get_finest_cell(parameters.domain);
    for (const auto &body : operators.bodies)
    {
      const double       typical = measure_resolution(*body, parameters.domain).typical;
      const double       n_cells = typical / cell;
      const unsigned int n_missing =
          n_cells < 1 ? std::ceil(std::log2(least_thickness / n_cells)) : 0;
      std::ostringstream text;
      text << std::setprecision(3) << "Domain/Levels: most of body " << body->get_name() << " is "
           << typical << " m thick or less, which is " << n_cells
           << " of the fluid's finest cells: it does not part the fluid on its two sides, and "
              "results mean nothing. Give "
           << parameters.domain.levels + n_missing
           << " levels, or set Coupling/Accept unresolved bodies to see it nevertheless.";
      AssertThrow(n_cells >= thinnest_meaningful || !body->undulates() ||
                      parameters.coupling.accept_unresolved_bodies,
                  ExcMessage(text.str()));
    }
  }

#define INSTANTIATE(dim)                                                                           \
  template double         get_finest_cell(const DomainParameters<dim> &);                          \
  template BodyResolution measure_resolution(const Body<dim> &, const DomainParameters<dim> &);    \
  template void           check_resolution(const Operators<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
