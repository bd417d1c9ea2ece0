// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_mesh_gmsh_binary_h
#define caudal_mesh_gmsh_binary_h

#include <string>

namespace caudal
{
  /** Whether the contents of a gmsh mesh say that its numbers are binary. */
  bool is_binary_mesh(const std::string &contents);

  /**
   * The text of the same mesh, as gmsh writes it in the same format, 2.2 or 4.1; sections that
   * describe neither nodes, elements, groups nor names are left out. Throws the reason if the
   * contents end too early or are not what they say. (gmsh's own library stops the program on
   * some damaged files.) Source: the gmsh manual, "MSH file format".
   */
  std::string convert_binary_mesh(const std::string &contents);
} // namespace caudal

#endif
