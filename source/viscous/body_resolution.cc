// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/viscous/body_resolution.h>

#include <algorithm>
#include <cmath>
#include <iomanip>

namespace caudal
{
  namespace
  {
    /** In a grid of cells with edges h_d there is a face each 1/|(n_d/h_d)_d| along n. */
    template <int dim>
    double count_cells_per_metre(const Tensor<1, dim> &direction, const Tensor<1, dim> &cell)
    {
      double cells_per_metre = 0;
      for (unsigned int d = 0; d < dim; ++d)
        cells_per_metre = std::hypot(cells_per_metre, direction[d] / cell[d]);
      return cells_per_metre;
    }

    template <int dim>
    void measure_layer(const Body<dim> &body, const Tensor<1, dim> &cell,
                       BodyResolution<dim> &result)
    {
      const SolidBody<dim> &solid    = body.get_solid();
      double                low_area = 0, high_area = 0, area = 0;
      const double          size = solid.get_parameters().get_element_size(1.);
      result.least_height        = lowest_layer * size;
      result.most_height         = highest_layer * size;
      result.lowest.n_cells      = std::numeric_limits<double>::infinity();
      result.highest.n_cells     = 0;
      for (const FaceThickness<dim> &face : body.get_extent().faces)
      {
        const Tensor<1, dim>   direction = solid.rotate_to_domain(face.direction);
        const LayerHeight<dim> layer{face.height * count_cells_per_metre(direction, cell),
                                     place_in_domain(solid.get_parameters().grid, face.centre),
                                     direction};
        if (layer.n_cells < result.lowest.n_cells)
          result.lowest = layer;
        if (layer.n_cells > result.highest.n_cells)
          result.highest = layer;
        area += face.area;
        // A thin body can't have less than one element across.
        const bool spans_body = face.height > 0.75 * face.thickness;
        low_area += layer.n_cells < result.least_height && !spans_body ? face.area : 0;
        high_area += layer.n_cells > result.most_height ? face.area : 0;
      }
      result.share_too_low  = low_area / area;
      result.share_too_high = high_area / area;
    }
  } // namespace

  template <int dim>
  BodyResolution<dim> measure_resolution(const Body<dim> &body, const DomainParameters<dim> &domain)
  {
    const SolidBody<dim> &solid = body.get_solid();
    const double volume = solid.get_reference_volume() / solid.get_triangulation().n_active_cells();
    const Tensor<1, dim> cell = domain.get_cell_size(domain.get_finest_level());

    BodyResolution<dim> result;
    measure_layer(body, cell, result);
    result.spacing_ratio = std::pow(volume, 1. / dim) / solid.get_parameters().polynomial_degree /
                           domain.get_finest_cell();
    result.thinnest.resize(solid.get_parameters().regions.size());
    std::vector<std::pair<CountedThickness<dim>, double>> faces; // with areas
    double                                                half_area = 0;
    for (const FaceThickness<dim> &face : body.get_extent().faces)
    {
      const Tensor<1, dim> direction = solid.rotate_to_domain(face.direction);
      faces.emplace_back(
          CountedThickness<dim>{face.thickness,
                                face.thickness * count_cells_per_metre(direction, cell), direction},
          face.area);
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
  template BodyResolution<dim> measure_resolution(const Body<dim> &,                               \
                                                  const DomainParameters<dim> &);                  \
  template void                check_resolution(const Operators<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
