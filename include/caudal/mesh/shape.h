// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_mesh_shape_h
#define caudal_mesh_shape_h

#include <caudal/base/plugin.h>
#include <caudal/mesh/gmsh_file.h>
#include <caudal/mesh/straight_body.h>

#include <deal.II/base/tensor.h>
#include <deal.II/grid/tria.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace caudal
{
  /** Throws unless the length is positive; @p path is that of section `Shape`. */
  void require_positive(double value, const std::string &path, const std::string &entry);

  /** Throws "<path>/<entry>: <sentences>" unless the condition holds. */
  void require(bool condition, const std::string &path, const std::string &entry,
               const std::string &sentences);

  /** Entries of section `Shape` that several shapes share [m]. */
  struct ShapeLengths
  {
    double length    = 1.;
    double thickness = 0.1;
    double width     = 0.1;
    double radius    = 0.1;

    /** The sides of the box round an ellipse, rectangle or beam. */
    template <int dim>
    Tensor<1, dim> get_sides() const
    {
      const double   sides[] = {length, thickness, width};
      Tensor<1, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = sides[d];
      return result;
    }

    /** Throws unless they are positive; @p path is that of section `Shape`. */
    template <int dim>
    void check_sides(const std::string &path) const
    {
      require_positive(length, path, "Length");
      require_positive(thickness, path, "Thickness");
      if (dim == 3)
        require_positive(width, path, "Width");
    }
  };

  /** How a shape is divided into elements and regions: entries of section `Shape`, too. */
  struct GridDivisions
  {
    std::vector<unsigned int> elements; ///< along, across, in the third direction; or none,
    double                    spacing;  ///< and this is how large they should be [m]
    std::vector<double>       region_boundaries; ///< increasing fractions of the length

    /** Whether the number of elements follows from their spacing. */
    bool is_automatic() const
    {
      return elements.empty();
    }
    /** Elements across @p length: one where it is less than 1.6 of them, as it would be halves. */
    unsigned int count_elements(double length) const;
    /** The numbers of elements of a body with these sides: as given, or by the spacing. */
    template <int dim>
    std::vector<unsigned int> get_elements(const Tensor<1, dim> &sides) const;
    /**
     * The lengths of @p n_along elements along the body, as fractions; regions end between
     * elements.
     */
    std::vector<double> compute_steps_along(unsigned int n_along) const;
  };

  /**
   * The shape of a body, at rest and in its own frame: origin at the nose (naca, eel, stations,
   * ellipsoid), at the middle of the root edge (beam) or at the centre (the others), axis along
   * +x. It offers what it can: a grid, in two dimensions or in three, and a closed surface.
   */
  template <int dim>
  class Shape : public Plugin
  {
  public:
    /** Whether it can be divided into quadrilaterals or hexahedra. */
    virtual bool has_grid() const
    {
      return true;
    }

    /**
     * Throws a sentence about the first shared entry that this shape uses and that can't work;
     * @p path is that of section `Shape`.
     */
    virtual void check_lengths(const ShapeLengths & /*lengths*/, const std::string & /*path*/) const
    {}
    virtual void check_divisions(const ShapeLengths & /*lengths*/,
                                 const GridDivisions & /*divisions*/,
                                 const std::string & /*path*/) const
    {}

    /** Makes the grid [m]. There is one material id for each region, in the regions' order. */
    virtual void make_grid(const ShapeLengths &lengths, const GridDivisions &divisions,
                           const std::string &path, Triangulation<dim> &tria) const = 0;

    /** The entry that decides on the elements, for messages about them. */
    virtual std::string get_grid_entry() const
    {
      return "Elements";
    }

    /** The entry that divides the body into regions, if that is not `Region boundaries`. */
    virtual std::string get_region_entry() const
    {
      return "";
    }

    /** Names of the grid's material ids, if it brings names; then regions are known by them. */
    virtual GroupNames get_group_names() const
    {
      return {};
    }

    /** Whether make_straight_body() can give the body's surface. */
    virtual bool has_surface() const
    {
      return false;
    }

    /** The body with a closed surface, if it has one; null otherwise. */
    virtual std::unique_ptr<StraightBody> make_straight_body(const ShapeLengths & /*lengths*/) const
    {
      return nullptr;
    }

    /** The file with a mesh that the body is made from; empty if there is none. */
    virtual std::string get_file() const
    {
      return "";
    }
  };

  /** Type and size of a body: the part of section `Shape` that both fluids know. */
  template <int dim>
  struct ShapeParameters
  {
    Choice<Shape<dim>> type;
    ShapeLengths       lengths;

    explicit ShapeParameters(const std::string &default_type = "naca", double default_length = 1.);

    /** Declares the entries in the section that @p prm is in. */
    void add_entries(ParameterHandler &prm);

    /** Throws a sentence about the first bad entry; @p path is that of section `Shape`. */
    void check(const std::string &path) const;

    /** The body with a closed surface; throws a sentence if the shape has none. */
    std::unique_ptr<StraightBody> make_straight_body(const std::string &path) const;
  };

  /** The names of the shapes that have (@p property) what is asked for, separated by commas. */
  template <int dim>
  std::string list_shapes(const std::function<bool(const Shape<dim> &)> &property)
  {
    std::string names;
    for (const auto &[name, member] : Registry<Shape<dim>>::get_members())
      if (property(*member.create()))
        names += (names.empty() ? "" : ", ") + name;
    return names;
  }

  /** The number of the region that the place @p s, as a fraction of the length, lies in. */
  unsigned int get_region(double s, const std::vector<double> &region_boundaries);

  /** Sets the material ids from the cells' centres, by their place along the length. */
  template <int dim>
  void assign_regions(Triangulation<dim> &tria, const std::vector<double> &region_boundaries);

  /**
   * The places that divide [@p first, 1] into @p n_columns columns, such that
   * each region boundary is one of them and the columns are as uniform as that
   * allows (at least one in each region).
   */
  std::vector<double> compute_columns(double first, const std::vector<double> &region_boundaries,
                                      unsigned int n_columns);

  /**
   * Scales the grid about the origin so that it has this volume: a polygon inscribed in a circle
   * has less.
   */
  template <int dim>
  void scale_to_volume(Triangulation<dim> &tria, double volume);

  /** Splits each cell of the curved @p coarse into @p n straight-sided ones in each direction. */
  template <int dim>
  void subdivide(const Triangulation<dim> &coarse, unsigned int n, Triangulation<dim> &tria);
} // namespace caudal

#endif
