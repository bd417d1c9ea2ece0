// A fish of elliptic sections is the same body as a plane grid, as a grid in space and as a closed
// surface: volumes, positive Jacobians, nodes that lie on the surface. An ellipsoid against its
// exact volume. Sentences for what a shape cannot give.

#include <caudal/fish/elliptic_body.h>
#include <caudal/mesh/body_grid.h>

#include <deal.II/grid/grid_tools.h>

#include <cmath>
#include <iostream>

#include "../entries.h"

using namespace caudal;

template <int dim>
struct ShapeFromEntries : BodyGridParameters<dim>
{
  explicit ShapeFromEntries(const Entries &entries)
  {
    set_entries(*this, "Shape", entries);
  }
};

// The volume, and the area of the section z = 0, from slices and from half-widths.
struct Size
{
  explicit Size(const StraightBody &body)
  {
    for (const BodySlice &slice : body.compute_slices())
      volume += slice.moments[0][0];
    const unsigned int n = 20000; // points, dense at the round ends
    for (unsigned int i = 0; i < n; ++i)
    {
      const double angle = numbers::PI * (i + 0.5) / n, L = body.get_length();
      area += 2. * body.half_width(0.5 * L * (1. - std::cos(angle))) * 0.5 * L * std::sin(angle) *
              numbers::PI / n;
    }
  }

  double volume = 0., area = 0.;
};

// How far the boundary's nodes are from the surface, over the half-axes there.
template <int dim>
double compute_distance(const Triangulation<dim> &tria, const StraightBody &body)
{
  double largest = 0.;
  for (const auto &face : tria.active_face_iterators())
    if (face->at_boundary())
      for (const unsigned int v : face->vertex_indices())
      {
        // The image of the point X of the unit ball
        const Point<dim> x = face->vertex(v);
        Point<3>         X(2. * x[0] / body.get_length() - 1., 0., 0.);
        const Point<3>   scale   = body.place(Point<3>(X[0], 1., 1.));
        double           squares = X[0] * X[0];
        for (unsigned int d = 1; d < dim; ++d)
          squares += std::pow(x[d] / scale[d], 2);
        largest = std::max(largest, std::abs(std::sqrt(squares) - 1.));
      }
  return largest;
}

template <int dim>
void report(const std::string &name, Entries entries, const std::string &elements)
{
  entries["Elements"] = elements;
  const ShapeFromEntries<dim> parameters(entries);
  const auto                  body = parameters.shape.make_straight_body("Shape");
  Triangulation<dim>          tria;
  make_body_grid(tria, parameters, parameters.divisions.region_boundaries.size() + 1, "Body x");
  const Size   size(*body);
  const double exact = dim == 2 ? size.area : size.volume;
  std::cout << name << ", " << dim << "D: " << tria.n_active_cells() << " cells, Jacobian "
            << (compute_min_scaled_jacobian(tria) > 0.05 ? "ok" : "bad") << ", volume off by "
            << std::round(1e4 * (GridTools::volume(tria) / exact - 1.)) / 1e2
            << " %, nodes on the surface " << (compute_distance(tria, *body) < 1e-9 ? "ok" : "bad")
            << std::endl;
}

template <class Action>
void expect_sentence(const Action &action)
{
  try
  {
    action();
    std::cout << "    no complaint" << std::endl;
  }
  catch (const ExceptionBase &exception)
  {
    exception.print_info(std::cout);
  }
}

int main()
{
  const Entries salmon         = {{"Type", "stations"},
                                  {"Length", "0.1"},
                                  {"Stations/Table",
                                   "0.0714, 2.5e-3, 3.5e-3; 0.2143, 5e-3, 9e-3; 0.3571, 6e-3, 11e-3; 0.5, "
                                           "5e-3, 9.5e-3; 0.6429, 3.2e-3, 6.5e-3; 0.7857, 1.7e-3, 3.5e-3; 0.9286, "
                                           "1e-3, 10e-3"}};
  Entries       regions        = salmon;
  regions["Region boundaries"] = "0.3, 0.8";
  report<2>("salmon", salmon, "40, 6");
  report<2>("salmon in three regions", regions, "80, 12");
  report<3>("salmon", salmon, "20, 4, 4");
  report<3>("salmon in three regions", regions, "40, 8, 10");

  const Entries ellipsoid = {{"Type", "ellipsoid"}, {"Ellipsoid/Axes", "0.5, 0.2, 0.1"}};
  const Size    size(*ShapeFromEntries<3>(ellipsoid).shape.make_straight_body("Shape"));
  std::cout << "ellipsoid against the exact one: volume "
            << (std::abs(size.volume / (4. / 3. * numbers::PI * 0.01) - 1.) < 1e-6 ? "ok" : "bad")
            << ", area " << (std::abs(size.area / (numbers::PI * 0.1) - 1.) < 1e-6 ? "ok" : "bad")
            << std::endl;
  report<2>("ellipsoid", ellipsoid, "20, 10");
  report<3>("ellipsoid", ellipsoid, "12, 8, 6");

  Triangulation<3> tria;
  expect_sentence([] { ShapeFromEntries<3>({}).shape.make_straight_body("Body x/Shape"); });
  expect_sentence([&] {
    make_body_grid(tria, ShapeFromEntries<3>({{"Type", "eel"}}), 1, "Body x");
  });
  expect_sentence([&] {
    make_body_grid(tria, ShapeFromEntries<3>({{"Type", "stations"}}), 1, "Body x");
  });
  Entries coarse     = salmon;
  coarse["Elements"] = "10, 2, 4";
  expect_sentence([&] { make_body_grid(tria, ShapeFromEntries<3>(coarse), 1, "Body x"); });
}
