// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/mesh/surface_layer.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>

namespace caudal
{
  namespace
  {
    template <int dim>
    Quadrature<dim> make_product(const std::array<Quadrature<1>, dim> &lines)
    {
      if constexpr (dim == 2)
        return QAnisotropic<2>(lines[0], lines[1]);
      else
        return QAnisotropic<3>(lines[0], lines[1], lines[2]);
    }

    template <int dim>
    std::array<Quadrature<1>, dim> make_lines(const std::array<unsigned int, dim> &n_points)
    {
      std::array<Quadrature<1>, dim> lines;
      for (unsigned int d = 0; d < dim; ++d)
        lines[d] = QGauss<1>(n_points[d]);
      return lines;
    }
  } // namespace

  template <int dim>
  Quadrature<dim> make_surface_quadrature(const unsigned int                   face,
                                          const std::array<unsigned int, dim> &n_points)
  {
    std::array<Quadrature<1>, dim> lines = make_lines<dim>(n_points);
    // A little inside, so that a body at a side of the domain has its points in it.
    const double inside = 1e-10;
    const double side = GeometryInfo<dim>::unit_normal_orientation[face] > 0 ? 1. - inside : inside;
    lines[GeometryInfo<dim>::unit_normal_direction[face]] = Quadrature<1>(Point<1>(side));
    return make_product<dim>(lines);
  }

  template <int dim>
  Quadrature<dim> make_volume_quadrature(const std::array<unsigned int, dim> &n_points)
  {
    return make_product<dim>(make_lines<dim>(n_points));
  }

  template Quadrature<2> make_surface_quadrature<2>(unsigned int,
                                                    const std::array<unsigned int, 2> &);
  template Quadrature<3> make_surface_quadrature<3>(unsigned int,
                                                    const std::array<unsigned int, 3> &);
  template Quadrature<2> make_volume_quadrature<2>(const std::array<unsigned int, 2> &);
  template Quadrature<3> make_volume_quadrature<3>(const std::array<unsigned int, 3> &);
} // namespace caudal
