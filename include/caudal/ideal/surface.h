// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_surface_h
#define caudal_ideal_surface_h

#include <caudal/ideal/screw.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/tria.h>

#include <string>
#include <vector>

namespace caudal::ideal
{
  using namespace dealii;

  /** Section `Surface` of the .prm. */
  struct SurfaceParameters
  {
    unsigned int n_along  = 8;
    unsigned int n_across = 4;

    void add_parameters(ParameterHandler &prm);
    void check() const;
  };

  /**
   * A closed surface of curved quadrilaterals: the topology, the nodes of its
   * geometry and the unknowns of a potential on it. Where the nodes are is kept
   * elsewhere (SurfaceMotion), since the surface moves.
   *
   * The cubed sphere has no poles: six faces of a cube, with equal angles between
   * the lines of its grid, projected on the unit sphere. Both the geometry and the
   * potential are quadratic and continuous; its unknowns stand at the nodes.
   */
  class Surface
  {
  public:
    static constexpr unsigned int degree           = 2;
    static constexpr unsigned int n_nodes_per_cell = (degree + 1) * (degree + 1);

    /** The unit sphere or, if there is one, the mesh in a file. */
    explicit Surface(const SurfaceParameters &parameters, const std::string &file = "");

    unsigned int n_cells() const
    {
      return triangulation.n_active_cells();
    }

    /** The number of nodes, which is that of the unknowns: the panels of the boundary elements. */
    unsigned int n_nodes() const
    {
      return dof_handler.n_dofs();
    }

    /** The nodes of a cell, in the order of the shape functions of get_fe(). */
    const std::vector<types::global_dof_index> &get_nodes(const unsigned int cell) const
    {
      return nodes[cell];
    }

    /** The place of each node: on the unit sphere, or in the mesh of the file [m]. */
    const std::vector<Point<3>> &get_reference_points() const
    {
      return reference_points;
    }

    /**
     * For each node that at its mirror image, z -> -z, of the reference points; none if there
     * are nodes without one.
     */
    const std::vector<unsigned int> &get_mirror_images() const
    {
      return mirror_images;
    }

    /** Whether the surface comes from a file. */
    bool is_from_file() const
    {
      return from_file;
    }

    const FE_Q<2, 3> &get_fe() const
    {
      return fe;
    }

    const DoFHandler<2, 3> &get_dof_handler() const
    {
      return dof_handler;
    }

  private:
    void make_cubed_sphere(unsigned int n_along, unsigned int n_across);
    void read(const std::string &file_name);
    void number_nodes();

    const bool                                        from_file;
    Triangulation<2, 3>                               triangulation;
    const FE_Q<2, 3>                                  fe;
    DoFHandler<2, 3>                                  dof_handler;
    std::vector<std::vector<types::global_dof_index>> nodes;
    std::vector<Point<3>>                             reference_points;
    std::vector<unsigned int>                         mirror_images;
  };

  /**
   * For each point the number of that at its mirror image in the plane normal to the
   * coordinate @p d; an empty list if there is a point without one.
   */
  std::vector<unsigned int> find_mirror_images(const std::vector<Point<3>> &points, unsigned int d);

  /** Where the nodes of a surface are, and how they move if each mode c_i has unit rate. */
  struct SurfaceMotion
  {
    /**
     * The velocities of the nodes [m/s] of a body that moves with @p rigid = (omega, v) and
     * deforms at @p rate times the @p rates dc_i/dpsi.
     */
    std::vector<Tensor<1, 3>>
    compute_velocities(const Screw &rigid, const std::vector<double> &rates, double rate) const;

    std::vector<Point<3>>                  positions; ///< X [m], body frame
    std::vector<std::vector<Tensor<1, 3>>> modes;     ///< dX/dc_i by mode and node [m]

    /**
     * The positions in the undeformed body, by which quadrature rules are chosen; the same in
     * all shapes, so that what is integrated depends smoothly on the shape. If there are none,
     * those above.
     */
    std::vector<Point<3>> rest;
  };
} // namespace caudal::ideal

#endif
