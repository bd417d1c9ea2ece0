// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_mesh_body_grid_h
#define caudal_mesh_body_grid_h

#include <caudal/base/parameter_file.h>
#include <caudal/mesh/shape.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <deal.II/grid/tria.h>

#include <string>
#include <vector>

namespace caudal
{
  /**
   * Section `Shape` of a body in a viscous fluid: its shape, grid and initial place. Which
   * entries a shape uses stands in their descriptions.
   */
  template <int dim>
  struct BodyGridParameters
  {
    ShapeParameters<dim> shape;
    std::string          elements = "automatic";
    std::vector<double>  region_boundaries;
    Point<dim>           position;
    double               rotation = 0.;

    void add_parameters(ParameterHandler &prm);

    /** Entries of any body that had other names in earlier versions. */
    static std::vector<RenamedEntry> get_renamed_entries();

    /** Throws a sentence on values that can't work; @p path is "Body fish", for example. */
    void check(const std::string &path) const;

    /** Whether the elements follow from the fluid's spacing. */
    bool has_automatic_elements() const
    {
      return elements == "automatic";
    }
    /** The divisions, with elements as large as @p spacing [m] where they are automatic. */
    GridDivisions get_divisions(double spacing, const std::string &path) const;
  };

  /**
   * The body's grid in its own frame [m]: straight-sided quadrilaterals or hexahedra on one
   * level; the material id is the number of the region in @p regions, all boundary ids are 0.
   *
   * Cells belong to the region their centre lies in. For naca, eel, beam, rectangle
   * and quadrilateral each region boundary is a grid line. Automatic elements become about as
   * large as @p spacing [m].
   */
  template <int dim>
  void make_body_grid(Triangulation<dim> &tria, const BodyGridParameters<dim> &parameters,
                      double spacing, const std::vector<std::string> &regions,
                      const std::string &path);

  /** X = position + R(rotation) s: where the point s of the body's own frame is at the start. */
  template <int dim>
  Point<dim> place_in_domain(const BodyGridParameters<dim> &parameters,
                             const Point<dim>              &reference_point);

  /**
   * How thick a body is at a face of its boundary: the distance from the face's centre, along the
   * inward normal, to the opposite side, which looks the other way; and how high the element
   * there is, its volume over the face's area.
   */
  template <int dim>
  struct FaceThickness
  {
    double         thickness; // [m]
    double         height;    // [m]
    Point<dim>     centre;    // in the body's own frame
    Tensor<1, dim> direction; // the normal, in the body's own frame
    double         area;      // of the face [m^(dim-1)]
    unsigned int   region;
  };

  /** Lengths of a body. */
  template <int dim>
  struct BodyExtent
  {
    double length = 0; ///< along the axis x [m]

    std::vector<FaceThickness<dim>> faces; ///< of the whole boundary
  };

  template <int dim>
  BodyExtent<dim> compute_extent(const Triangulation<dim> &tria);

  /** For each of the @p points of a body the ends of the line along y through it, in the body. */
  template <int dim>
  std::vector<std::pair<double, double>>
  compute_lateral_ends(const Triangulation<dim> &tria, const std::vector<Point<dim>> &points);

  /**
   * The smallest scaled Jacobian of the grid, over all corners of all cells:
   * the determinant of a corner's edges over the product of their lengths (1
   * for a right angle; positive everywhere means convex cells in 2D).
   */
  template <int dim>
  double compute_min_scaled_jacobian(const Triangulation<dim> &tria);
} // namespace caudal

#endif
