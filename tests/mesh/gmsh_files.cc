// SPDX-License-Identifier: LGPL-2.1-or-later
// Meshes as gmsh and its users write them: what becomes of parts that only touch, of lines inside,
// triangles, tetrahedra, elements of second order in the formats 1, 2.2 and 4.1, and of names.

#include <caudal/base/collective.h>
#include <caudal/mesh/gmsh_file.h>

#include <deal.II/grid/grid_tools.h>

#include <fstream>
#include <iostream>

using namespace caudal;

template <int dim>
void read(const std::string &what, const std::string &text)
{
  std::ofstream("mesh.msh") << text;
  Triangulation<dim> mesh;
  std::cout << what << ": ";
  const std::string error = catch_error([&]() { read_gmsh("mesh.msh", mesh); });
  if (!error.empty())
  {
    std::cout << error << '\n';
    return;
  }
  std::map<types::material_id, unsigned int> n_cells;
  for (const auto &cell : mesh.active_cell_iterators())
    ++n_cells[cell->material_id()];
  std::cout << mesh.n_used_vertices() << " vertices, volume " << GridTools::volume(mesh);
  const GroupNames names = read_group_names("mesh.msh", dim);
  for (const auto &[id, n] : n_cells)
    std::cout << ", " << n << " cells of " << id
              << (names.count(id) > 0 ? " (" + names.at(id) + ")" : "");
  std::cout << '\n';
}

/** Numbers as binary files hold them. */
template <typename Number>
std::string bytes(const std::initializer_list<Number> numbers)
{
  return std::string(reinterpret_cast<const char *>(numbers.begin()),
                     numbers.size() * sizeof(Number));
}

std::string make_binary_square_of_format_2()
{
  std::string nodes;
  for (int i = 0; i < 4; ++i)
    nodes += bytes<int>({i + 1}) + bytes<double>({double(i == 1 || i == 2), double(i > 1), 0});
  return "$MeshFormat\n2.2 1 8\n" + bytes<int>({1}) + "\n$EndMeshFormat\n" +
         "$PhysicalNames\n1\n2 7 \"fin\"\n$EndPhysicalNames\n$Nodes\n4\n" + nodes +
         "\n$EndNodes\n$Elements\n2\n" + bytes<int>({1, 1, 2, 1, 9, 3, 2, 3}) +
         bytes<int>({3, 1, 2, 2, 7, 1, 1, 2, 3, 4}) + "\n$EndElements\n";
}

/** A triangle of second order on an entity of the group 3, beside a point in no group. */
std::string make_binary_triangle_of_format_4()
{
  using Counts             = std::initializer_list<std::size_t>;
  const std::string entity = bytes<int>({1}) + bytes<double>({0, 0, 0, 1, 1, 0}) +
                             bytes(Counts{1}) + bytes<int>({3}) + bytes(Counts{0});
  return "$MeshFormat\n4.1 1 8\n" + bytes<int>({1}) + "\n$EndMeshFormat\n$Entities\n" +
         bytes(Counts{1, 0, 1, 0}) + bytes<int>({1}) + bytes<double>({0, 0, 0}) + bytes(Counts{0}) +
         entity + "\n$EndEntities\n$Nodes\n" + bytes(Counts{1, 6, 1, 6}) + bytes<int>({2, 1, 0}) +
         bytes(Counts{6, 1, 2, 3, 4, 5, 6}) +
         bytes<double>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0.5, 0, 0, 0.5, 0.5, 0, 0, 0.5, 0}) +
         "\n$EndNodes\n$Elements\n" + bytes(Counts{1, 1, 1, 1}) + bytes<int>({2, 1, 9}) +
         bytes(Counts{1, 1, 1, 2, 3, 4, 5, 6}) + "\n$EndElements\n";
}

int main()
{
  const std::string format_2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  const std::string square   = "1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n";

  read<2>("two quadrilaterals with names, a line between them",
          format_2 +
              "$PhysicalNames\n3\n1 9 \"joint\"\n2 2 \"head\"\n2 1 \"tail\"\n$EndPhysicalNames\n" +
              "$Nodes\n6\n" + square + "5 2 0 0\n6 2 1 0\n$EndNodes\n" +
              "$Elements\n3\n1 1 2 9 3 2 3\n2 3 2 2 1 1 2 3 4\n3 3 2 1 2 2 5 6 3\n$EndElements\n");
  read<2>("two that have their own nodes where they touch",
          format_2 + "$Nodes\n8\n" + square + "5 1 0 0\n6 2 0 0\n7 2 1 0\n8 1 1 0\n$EndNodes\n" +
              "$Elements\n2\n1 3 2 1 1 1 2 3 4\n2 3 2 1 2 5 6 7 8\n$EndElements\n");
  read<2>("a triangle beside a quadrilateral",
          format_2 + "$Nodes\n5\n" + square + "5 2 0 0\n$EndNodes\n" +
              "$Elements\n2\n1 3 2 1 1 1 2 3 4\n2 2 2 1 1 2 5 3\n$EndElements\n");
  read<3>("a tetrahedron", format_2 + "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n" +
                               "$Elements\n1\n1 4 2 1 1 1 2 3 4\n$EndElements\n");

  const std::string middles = "5 0.5 0 0\n6 1 0.5 0\n7 0.5 1 0\n8 0 0.5 0\n9 0.5 0.5 0\n";
  read<2>("second order, format 2.2",
          format_2 + "$Nodes\n9\n" + square + middles + "$EndNodes\n$Elements\n2\n" +
              "1 8 2 7 1 1 2 5\n2 10 2 3 1 1 2 3 4 5 6 7 8 9\n$EndElements\n");
  read<2>("second order, format 1", "$NOD\n8\n" + square +
                                        middles.substr(0, middles.rfind("9 0.5")) +
                                        "$ENDNOD\n$ELM\n1\n1 16 3 1 8 1 2 3 4 5 6 7 8\n$ENDELM\n");
  read<2>("second order, format 4.1",
          "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 1 0\n1 0 0 0 1 1 0 1 3 0\n"
          "$EndEntities\n$Nodes\n1 6 1 6\n2 1 0 6\n1\n2\n3\n4\n5\n6\n0 0 0\n1 0 0\n0 1 0\n"
          "0.5 0 0\n0.5 0.5 0\n0 0.5 0\n$EndNodes\n"
          "$Elements\n1 1 1 1\n2 1 9 1\n1 1 2 3 4 5 6\n$EndElements\n");

  read<2>("a section without end", format_2 + "$Nodes\n4\n" + square);
  read<2>("a section within another one", format_2 + "$Nodes\n4\n" + square + "$Elements\n");

  const std::string binary = make_binary_square_of_format_2();
  read<2>("binary, format 2.2", binary);
  read<2>("binary, second order, format 4.1", make_binary_triangle_of_format_4());
  read<2>("a binary file that ends too early", binary.substr(0, binary.find("$EndNodes") - 9));
  std::string fewer = binary;
  fewer.replace(fewer.find("$Nodes\n4"), 8, "$Nodes\n3");
  read<2>("one that has more nodes than it says", fewer);
  read<2>("one of another machine", "$MeshFormat\n4.1 1 8\n" + bytes<int>({1 << 24}) + "\n");
  read<2>("an older binary format", "$MeshFormat\n4.0 1 8\n");
}
