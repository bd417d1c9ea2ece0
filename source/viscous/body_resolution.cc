// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/viscous/body_resolution.h>

#include <algorithm>
#include <cmath>
#include <iomanip>

namespace caudal
{
  template <int dim>
  double get_finest_cell(const DomainParameters<dim> &domain)
  {
    return domain.get_cell_size(domain.get_finest_level()).norm() / std::sqrt(dim);
  }

  namespace
  {
    /** In a grid of cells with edges h_d there is a face each 1/|(n_d/h_d)_d| along n. */
    template <int dim>
    CountedThickness<dim> count_cells(const FaceThickness<dim> &face, const SolidBody<dim> &solid,
                                      const Tensor<1, dim> &cell)
    {
      CountedThickness<dim> result;
      result.thickness = face.thickness;
      for (unsigned int d = 0; d < dim; ++d)
        result.direction += face.direction[d] * solid.get_initial_axis(d);
      double cells_per_metre = 0;
      for (unsigned int d = 0; d < dim; ++d)
        cells_per_metre = std::hypot(cells_per_metre, result.direction[d] / cell[d]);
      result.n_cells = cells_per_metre * face.thickness;
      return result;
    }
  } // namespace

  template <int dim>
  BodyResolution<dim> measure_resolution(const Body<dim> &body, const DomainParameters<dim> &domain)
  {
    const SolidBody<dim> &solid = body.get_solid();
    const double volume = solid.get_reference_volume() / solid.get_triangulation().n_active_cells();
    const Tensor<1, dim> cell = domain.get_cell_size(domain.get_finest_level());

    BodyResolution<dim> result;
    result.spacing_ratio = std::pow(volume, 1. / dim) / solid.get_parameters().polynomial_degree /
                           get_finest_cell(domain);
    result.thinnest.resize(solid.get_parameters().regions.size());
    std::vector<std::pair<CountedThickness<dim>, double>> faces; // with areas
    double                                                half_area = 0;
    for (const FaceThickness<dim> &face : body.get_extent().faces)
    {
      faces.emplace_back(count_cells(face, solid, cell), face.area);
      half_area += 0.5 * face.area;
      CountedThickness<dim> &thinnest = result.thinnest[face.region];
      if (faces.back().first.n_cells < thinnest.n_cells)
        thinnest = faces.back().first;
    }
    std::sort(faces.begin(), faces.end(),
              [](const auto &a, const auto &b) { return a.first.n_cells < b.first.n_cells; });
    for (auto face = faces.begin(); face != faces.end() && half_area > 0; ++face)
    {
      result.typical = face->first;
      half_area -= face->second;
    }
    return result;
  }

  template <int dim>
  void check_resolution(const Operators<dim> &operators)
  {
    const auto &parameters = operators.parameters;
    for (const auto &body : operators.bodies)
    {
      const auto         typical = measure_resolution(*body, parameters.domain).typical;
      const double       n_cells = typical.n_cells;
      const unsigned int n_missing =
          n_cells < 1 ? std::ceil(std::log2(least_thickness / n_cells)) : 0;
      std::ostringstream text;
      text << std::setprecision(3) << "Domain/Levels: most of body " << body->get_name() << " is "
           << typical.thickness << " m thick or less, which is " << n_cells
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
  template double              get_finest_cell(const DomainParameters<dim> &);                     \
  template BodyResolution<dim> measure_resolution(const Body<dim> &,                               \
                                                  const DomainParameters<dim> &);                  \
  template void                check_resolution(const Operators<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
