// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_mesh_gmsh_file_h
#define caudal_mesh_gmsh_file_h

#include <deal.II/grid/tria.h>

#include <map>
#include <string>

namespace caudal
{
  using namespace dealii;

  /** Names of gmsh's physical groups by their numbers. */
  using GroupNames = std::map<types::material_id, std::string>;

  /**
   * Reads the gmsh mesh @p file (.msh, text of format 1 to 4.1 or binary) as the grid of a body.
   * Nodes that coincide become one, so that parts hold together; lines and faces are ignored, as a
   * body has no conditions on its boundary; triangles are cut into three quadrilaterals each
   * (tetrahedra into four hexahedra), and quadrilaterals beside them into four; elements of second
   * order are read as linear. Material ids are the numbers of the physical groups. Throws the
   * reason, a sentence of deal.II, if the file can't be read as a mesh.
   */
  template <int dim>
  void read_gmsh(const std::string &file, Triangulation<dim> &tria);

  /** The names of the groups of cells of the dimension @p dim in a mesh; none for most meshes. */
  GroupNames read_group_names(const std::string &file, int dim);
} // namespace caudal

#endif
