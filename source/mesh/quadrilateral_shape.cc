// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/mesh/shape.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

namespace caudal
{
  namespace
  {
    /** The bilinear image of the unit square: between four corners. */
    template <int dim>
    class QuadrilateralShape : public Shape<dim>
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Vertices", vertices,
                          "The four corners, counter-clockwise, the first side along the body; "
                          "coordinates separated by ',', points by ';' [m].");
      }

      bool has_grid() const override
      {
        return dim == 2;
      }

      void check(const std::string &path) const override
      {
        const auto &v = vertices;
        require(v.size() == 4, path, "Vertices",
                "there are " + std::to_string(v.size()) + " points. Give four corners.");
        for (unsigned int i = 0; i < 4; ++i)
        {
          const Tensor<1, 2> a = v[(i + 1) % 4] - v[i], b = v[(i + 2) % 4] - v[(i + 1) % 4];
          require(a[0] * b[1] - a[1] * b[0] > 0., path, "Vertices",
                  "the corners are not those of a convex quadrilateral, counter-clockwise. Give "
                  "them in that order.");
        }
      }

      void make_grid(const ShapeLengths &, const GridDivisions &divisions, const std::string &,
                     Triangulation<dim> &tria) const override
      {
        if constexpr (dim == 2)
        {
          const auto                     &v        = vertices;
          const std::vector<unsigned int> elements = divisions.get_elements(
              Tensor<1, 2>({0.5 * (v[0].distance(v[1]) + v[2].distance(v[3])),
                            0.5 * (v[1].distance(v[2]) + v[3].distance(v[0]))}));
          const std::vector<std::vector<double>> steps{
              divisions.compute_steps_along(elements[0]),
              std::vector<double>(elements[1], 1. / elements[1])};
          GridGenerator::subdivided_hyper_rectangle(tria, steps, Point<2>(), Point<2>(1., 1.));
          assign_regions(tria, divisions.region_boundaries);
          GridTools::transform(
              [&v](const Point<2> &p) {
                return Point<2>((1. - p[1]) * ((1. - p[0]) * v[0] + p[0] * v[1]) +
                                p[1] * ((1. - p[0]) * v[3] + p[0] * v[2]));
              },
              tria);
        }
      }

    private:
      std::vector<Point<2>> vertices;
    };

    const DimensionalRegistration<Shape, QuadrilateralShape>
        registration("quadrilateral", "a quadrilateral with given corners (2D)");
  } // namespace
} // namespace caudal
