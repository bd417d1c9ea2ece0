#include <deal.II/base/patterns.h>

#include <caudal/mesh/body_grid.h>
#include <caudal/mesh/body_shape.h>

#include <cmath>
#include <set>

namespace caudal
{
  template <int dim>
  void BodyGridParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    const Patterns::Double any_number;
    prm.enter_subsection("Shape");
    prm.add_parameter("Type", type,
                      "Shape of the body: a NACA four-digit airfoil (naca), a disc, an ellipse, a "
                      "ring, a beam or rectangle, a quadrilateral, Carling's eel, a cylinder with "
                      "flag (Turek and Hron's; its "
                      "regions are cylinder and flag), or a mesh from a file. In 3D: disc "
                      "(a ball), ellipse (an ellipsoid), beam, rectangle (boxes) and file.",
                      Patterns::Selection(get_body_shapes<2>().get_names()));
    prm.add_parameter("NACA digits", naca_digits,
                      "Camber [hundredths of the chord], its position [tenths], and thickness "
                      "[hundredths, two digits] of the naca shape.");
    prm.add_parameter(
        "Length", length,
        "Length along the axis [m]: chord of naca, length of eel, beam and rectangle, "
        "full axis of ellipse, part of the flag that sticks out of the cylinder.",
        any_number);
    prm.add_parameter("Thickness", thickness,
                      "Extent across the axis [m]: height of beam, rectangle and flag, full second "
                      "axis of ellipse.",
                      any_number);
    prm.add_parameter("Width", width,
                      "Extent in the third direction [m] of beam, rectangle and ellipse; 3D only.",
                      any_number);
    prm.add_parameter("Radius", radius, "Radius of disc and cylinder, inner radius of ring [m].",
                      any_number);
    prm.add_parameter("Wall thickness", wall_thickness, "Outer minus inner radius of ring [m].",
                      any_number);
    prm.add_parameter(
        "Elements", elements,
        "Number of elements along and across the body (3D: along, across, in the third "
        "direction); round and across the wall of ring; of the flag alone. The round nose of "
        "naca and eel adds a few. Of disc and ellipse only the product counts: they get about that "
        "many "
        "elements.",
        Patterns::List(Patterns::Integer(1), dim, dim));
    prm.add_parameter("Vertices", vertices,
                      "The four corners of quadrilateral, counter-clockwise, the first side along "
                      "the body; coordinates separated by ',', points by ';' [m].");
    prm.add_parameter(
        "File", file,
        "Name of a gmsh mesh (.msh) of quadrilaterals (3D: hexahedra), in metres, for "
        "the type file; relative to the working directory. Its physical ids, in increasing "
        "order, are the regions.");
    prm.add_parameter(
        "Position", position,
        "Where the origin of the shape is put at the start [m]: nose of naca and eel, "
        "middle of the root edge of beam, centre of disc, cylinder, ellipse, ring and rectangle, "
        "origin of the vertices or of the mesh from a file.");
    prm.add_parameter("Rotation", rotation,
                      "Angle from the x axis to the axis of the shape, about its origin "
                      "(3D: about z), counter-clockwise [degrees].",
                      any_number);
    prm.add_parameter("Region boundaries", region_boundaries,
                      "Places, as increasing fractions of the length, that separate the regions of "
                      "the body, from the front (low x) to the back; none: one region. Not for the "
                      "types file and cylinder with flag.",
                      Patterns::List(Patterns::Double(0., 1.), 0));
    prm.leave_subsection();
  }

  template <int dim>
  void BodyGridParameters<dim>::check(const std::string &path) const
  {
    const std::string shape = path + "/Shape/";

    // Names of plane shapes are known in 3D, too: just not made.
    const std::string names = get_body_shapes<dim>().get_names();
    AssertThrow(("|" + names + "|").find("|" + type + "|") != std::string::npos,
                ExcMessage(shape + "Type: the shape <" + type + "> is available in 2D only. " +
                           "Choose one of " + get_body_shapes<dim>().get_names(", ") + "."));

    AssertThrow(elements.size() == dim,
                ExcMessage(shape + "Elements: there are " + std::to_string(elements.size()) +
                           " numbers. Give " + std::to_string(dim) + "."));
    for (unsigned int i = 0; i < region_boundaries.size(); ++i)
      AssertThrow(region_boundaries[i] > (i == 0 ? 0. : region_boundaries[i - 1]) &&
                      region_boundaries[i] < 1.,
                  ExcMessage(shape +
                             "Region boundaries: " + Patterns::Tools::to_string(region_boundaries) +
                             " does not increase between 0 and 1. Give increasing fractions of "
                             "the length, without its ends."));
    AssertThrow(type == "file" || elements[0] > region_boundaries.size(),
                ExcMessage(shape + "Elements: " + std::to_string(elements[0]) +
                           " along the body are fewer than its " +
                           std::to_string(region_boundaries.size() + 1) +
                           " regions. Give one for each at least."));

    get_body_shapes<dim>().create(type, *this)->check(path);
  }

  namespace
  {
    /** Renumbers the material ids to 0, 1, ... in increasing order. */
    template <int dim>
    void number_regions(Triangulation<dim> &tria, const unsigned int n_regions,
                        const std::string &entry)
    {
      std::set<types::material_id> ids;
      for (const auto &cell : tria.active_cell_iterators())
        ids.insert(cell->material_id());
      AssertThrow(ids.size() == n_regions,
                  ExcMessage(entry + ": the grid has cells of the regions " +
                             Patterns::Tools::to_string(ids) +
                             " (material ids), but the body has " + std::to_string(n_regions) +
                             " regions. Make the two agree."));
      for (const auto &cell : tria.active_cell_iterators())
        cell->set_material_id(std::distance(ids.begin(), ids.find(cell->material_id())));
    }
  } // namespace

  template <int dim>
  void make_body_grid(Triangulation<dim> &tria, const BodyGridParameters<dim> &parameters,
                      const unsigned int n_regions, const std::string &path)
  {
    parameters.check(path);
    const auto         shape        = get_body_shapes<dim>().create(parameters.type, parameters);
    const bool         divided      = shape->has_own_regions();
    const bool         from_file    = parameters.type == "file";
    const std::string  entries      = path + "/Shape/";
    const unsigned int n_boundaries = parameters.region_boundaries.size();
    AssertThrow(n_boundaries == (divided ? 0 : n_regions - 1),
                ExcMessage(entries + "Region boundaries: there are " +
                           std::to_string(n_boundaries) + ", but the body has " +
                           std::to_string(n_regions) + " regions. Give " +
                           (divided ? "none, as a " + parameters.type + " has regions of its own."
                                    : "one fewer than regions.")));

    shape->make_grid(tria, path);
    tria.reset_all_manifolds();
    tria.set_all_manifold_ids(numbers::flat_manifold_id);

    number_regions(tria, n_regions,
                   entries + (from_file ? "File"
                              : divided ? "Type"
                                        : "Region boundaries"));
    AssertThrow(compute_min_scaled_jacobian(tria) > 0.,
                ExcMessage(entries + (from_file ? "File" : "Elements") +
                           ": the grid has inverted or non-convex cells (scaled Jacobian " +
                           std::to_string(compute_min_scaled_jacobian(tria)) +
                           "). Give a better one."));
  }

  template <int dim>
  Point<dim> place_in_domain(const BodyGridParameters<dim> &parameters,
                             const Point<dim>              &reference_point)
  {
    const double angle = parameters.rotation * numbers::PI / 180.;
    const double c = std::cos(angle), s = std::sin(angle);

    Point<dim> rotated = reference_point;
    rotated[0]         = c * reference_point[0] - s * reference_point[1];
    rotated[1]         = s * reference_point[0] + c * reference_point[1];
    return parameters.position + rotated;
  }

  template struct BodyGridParameters<2>;
  template struct BodyGridParameters<3>;

  template void make_body_grid(Triangulation<2> &, const BodyGridParameters<2> &,
                               const unsigned int, const std::string &);
  template void make_body_grid(Triangulation<3> &, const BodyGridParameters<3> &,
                               const unsigned int, const std::string &);

  template Point<2> place_in_domain(const BodyGridParameters<2> &, const Point<2> &);
  template Point<3> place_in_domain(const BodyGridParameters<3> &, const Point<3> &);
} // namespace caudal
