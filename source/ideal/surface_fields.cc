#include <caudal/ideal/surface_fields.h>
#include <caudal/ideal/surface_quadrature.h>

namespace caudal::ideal
{
  SurfaceFields compute_surface_fields(const Surface &surface, const std::vector<Point<3>> &nodes,
                                       const std::vector<Tensor<1, 3>> &node_velocities,
                                       const Vector<double>            &potential,
                                       const Vector<double> &potential_rate, const double density)
  {
    const unsigned int        n = surface.n_nodes();
    SurfaceFields             fields{Vector<double>(n), std::vector<Tensor<1, 3>>(n)};
    std::vector<unsigned int> n_cells(n, 0);
    const ReferenceRule       at_nodes(Quadrature<2>(surface.get_fe().get_unit_support_points()),
                                       surface.get_fe());
    for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
    {
      const auto &cell_nodes = surface.get_nodes(cell);
      for (unsigned int q = 0; q < cell_nodes.size(); ++q)
      {
        Tensor<1, 3> along_x, along_y;
        Tensor<1, 2> derivative;
        for (unsigned int k = 0; k < cell_nodes.size(); ++k)
        {
          const Tensor<1, 2> &gradient = at_nodes.gradients[q][k];
          along_x += gradient[0] * nodes[cell_nodes[k]];
          along_y += gradient[1] * nodes[cell_nodes[k]];
          derivative += potential(cell_nodes[k]) * gradient;
        }
        Tensor<1, 3> normal = cross_product_3d(along_x, along_y);
        const double area   = normal.norm();
        normal /= area;
        const Tensor<1, 3> dual_x = cross_product_3d(along_y, normal) / area;
        const Tensor<1, 3> dual_y = cross_product_3d(normal, along_x) / area;
        const auto         node   = cell_nodes[q];
        fields.velocity[node] += derivative[0] * dual_x + derivative[1] * dual_y +
                                 (node_velocities[node] * normal) * normal;
        ++n_cells[node];
      }
    }
    for (unsigned int node = 0; node < n; ++node)
    {
      Tensor<1, 3> &gradient = fields.velocity[node];
      gradient /= n_cells[node];
      fields.pressure(node) = -density * (potential_rate(node) - node_velocities[node] * gradient +
                                          0.5 * gradient.norm_square());
    }
    return fields;
  }
} // namespace caudal::ideal
