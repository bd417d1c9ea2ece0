// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/safe_file.h>
#include <caudal/mesh/gmsh_binary.h>
#include <caudal/mesh/gmsh_file.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <sstream>

namespace caudal
{
  namespace
  {
    // Nodes that are nearer, beside the mesh's diameter, are one.
    constexpr double smallest_distance = 1e-9;

    /** Cuts cells so that only quadrilaterals or hexahedra are left. */
    template <int dim>
    class Cutter
    {
    public:
      Cutter(std::vector<Point<dim>> &vertices, const std::vector<CellData<dim>> &cells)
          : vertices(vertices)
      {
        for (const CellData<dim> &cell : cells)
          cut(cell);
      }

      std::vector<CellData<dim>> pieces;

    private:
      std::vector<Point<dim>> &vertices;

      /** The vertices in the middle of edges, faces and cells, by the sorted ones around them. */
      std::map<std::vector<unsigned int>, unsigned int> middles;

      unsigned int get_middle(std::vector<unsigned int> corners)
      {
        std::sort(corners.begin(), corners.end());
        const auto found = middles.emplace(corners, vertices.size());
        if (found.second)
        {
          Point<dim> middle;
          for (const unsigned int corner : corners)
            middle += vertices[corner] / static_cast<double>(corners.size());
          vertices.push_back(middle);
        }
        return found.first->second;
      }

      void add(const std::vector<unsigned int> &corners, const types::material_id material)
      {
        CellData<dim> piece(corners.size());
        std::copy(corners.begin(), corners.end(), piece.vertices.begin());
        piece.material_id = material;
        pieces.push_back(piece);
      }

      /** A piece at each vertex. Corners are numbered lexicographically, as deal.II does. */
      void cut(const CellData<dim> &cell)
      {
        // deal.II's container of them depends on its version.
        const std::vector<unsigned int> v(cell.vertices.begin(), cell.vertices.end());
        const unsigned int              middle = get_middle(v);
        if (dim == 2 && v.size() == 3)
          for (unsigned int i = 0; i < 3; ++i)
          {
            const unsigned int a = v[i], b = v[(i + 1) % 3], c = v[(i + 2) % 3];
            add({a, get_middle({a, b}), get_middle({a, c}), middle}, cell.material_id);
          }
        else if (dim == 2)
          for (const auto &[a, b, c] : {std::array<unsigned int, 3>{{v[0], v[1], v[2]}},
                                        std::array<unsigned int, 3>{{v[1], v[3], v[0]}},
                                        std::array<unsigned int, 3>{{v[3], v[2], v[1]}},
                                        std::array<unsigned int, 3>{{v[2], v[0], v[3]}}})
            add({a, get_middle({a, b}), get_middle({a, c}), middle}, cell.material_id);
        else
        {
          AssertThrow(v.size() == 4, ExcMessage("it has tetrahedra beside hexahedra"));
          // Even permutations: each vertex sees the others in the same sense.
          for (const auto &[a, b, c, d] : {std::array<unsigned int, 4>{{v[0], v[1], v[2], v[3]}},
                                           std::array<unsigned int, 4>{{v[1], v[0], v[3], v[2]}},
                                           std::array<unsigned int, 4>{{v[2], v[3], v[0], v[1]}},
                                           std::array<unsigned int, 4>{{v[3], v[2], v[1], v[0]}}})
            add({a, get_middle({a, b}), get_middle({a, c}), get_middle({a, b, c}),
                 get_middle({a, d}), get_middle({a, b, d}), get_middle({a, c, d}), middle},
                cell.material_id);
        }
      }
    };

    /** gmsh's numbers of elements of second order, the corners' number and the linear element's. */
    const std::map<int, std::pair<unsigned int, int>> linear_elements = {
        {8, {2, 1}},  {9, {3, 2}},  {10, {4, 3}}, {16, {4, 3}},
        {11, {4, 4}}, {12, {8, 5}}, {17, {8, 5}}};

    /** The words of @p line from number @p begin on, at most @p count of them. */
    std::string get_words(const std::string &line, const unsigned int begin,
                          const unsigned int count)
    {
      std::istringstream stream(line);
      std::string        result, word;
      for (unsigned int i = 0; i < begin + count && stream >> word; ++i)
        if (i >= begin)
          result += word + ' ';
      return result;
    }

    /** An element of format 1 or 2: number, type, tags (two, or so many as it says), nodes. */
    std::string make_linear_element(const std::string &line, const bool is_first_format)
    {
      std::istringstream words(line);
      int                number = 0, type = 0;
      unsigned int       n_tags = 2;
      words >> number >> type;
      const auto found = linear_elements.find(type);
      if (found == linear_elements.end())
        return line;
      if (!is_first_format)
        words >> n_tags;
      const auto [n_corners, linear_type] = found->second;
      // In format 1 the number of nodes stands behind the tags, else that of tags before them.
      const std::string tags = is_first_format
                                   ? get_words(line, 2, n_tags) + std::to_string(n_corners) + ' '
                                   : get_words(line, 2, n_tags + 1);
      return std::to_string(number) + ' ' + std::to_string(linear_type) + ' ' + tags +
             get_words(line, 3 + n_tags, n_corners);
    }

    /** A block of format 4: two tags, type and number of elements, then their lines. */
    std::string make_linear_block(const std::string &header, std::istream &lines)
    {
      std::istringstream words(header);
      int                first = 0, second = 0, type = 0;
      unsigned int       n_elements = 0;
      words >> first >> second >> type >> n_elements;
      const auto  found     = linear_elements.find(type);
      const bool  is_linear = found == linear_elements.end();
      std::string result    = is_linear
                                  ? header
                                  : get_words(header, 0, 2) + std::to_string(found->second.second) +
                                     ' ' + std::to_string(n_elements);
      std::string line;
      for (unsigned int e = 0; e < n_elements && std::getline(lines, line); ++e)
        result += '\n' + (is_linear ? line : get_words(line, 0, 1 + found->second.first));
      return result;
    }

    /** Throws unless each section, "$Nodes" for example, has its end: deal.II looks for it for
     * ever. */
    void check_sections(const std::string &text)
    {
      std::istringstream stream(text);
      std::string        open;
      for (std::string line; std::getline(stream, line);)
      {
        if (line[0] != '$')
          continue;
        const std::string name   = Utilities::trim(line).substr(1);
        const bool        is_end = name.rfind("End", 0) == 0 || name.rfind("END", 0) == 0;
        AssertThrow(
            is_end ? name.substr(3) == open : open.empty(),
            ExcMessage("the section $" + open + " has no end before the line <" + line + ">."));
        open = is_end ? "" : name;
      }
      AssertThrow(open.empty(), ExcMessage("the section $" + open + " has no end."));
    }

    /**
     * The text of a mesh, format 1 to 4.1, in which elements of second order are linear: gmsh
     * counts an element's corners before its other nodes.
     */
    std::string make_linear(const std::string &text)
    {
      std::istringstream stream(text);
      std::string        result, line;
      double             version      = 1;
      bool               is_element   = false;
      bool               is_new_group = false; // its first line counts the elements
      for (; std::getline(stream, line); result += line + '\n')
        if (line.rfind("$MeshFormat", 0) == 0)
        {
          result += line + '\n';
          std::getline(stream, line);
          version = std::atof(line.c_str());
        }
        else if (line[0] == '$')
          is_element = is_new_group = line.rfind("$Elements", 0) == 0 || line.rfind("$ELM", 0) == 0;
        else if (is_new_group)
          is_new_group = false;
        else if (is_element)
          line = version < 4 ? make_linear_element(line, version < 2)
                             : make_linear_block(line, stream);
      return result;
    }

    /** A grid that mends what it is made of. */
    template <int dim>
    class MendedTriangulation : public Triangulation<dim>
    {
    public:
      using Triangulation<dim>::create_triangulation;

      void create_triangulation(const std::vector<Point<dim>>    &all_vertices,
                                const std::vector<CellData<dim>> &all_cells,
                                const SubCellData & /*boundary*/) override
      {
        std::vector<Point<dim>>    vertices = all_vertices;
        std::vector<CellData<dim>> cells    = all_cells;
        SubCellData                none;
        GridTools::delete_unused_vertices(vertices, cells, none);
        std::vector<unsigned int> considered(vertices.size());
        std::iota(considered.begin(), considered.end(), 0);
        const auto   box      = BoundingBox<dim>(vertices).get_boundary_points();
        const double diameter = box.first.distance(box.second);
        GridTools::delete_duplicated_vertices(vertices, cells, none, considered,
                                              smallest_distance * diameter);
        const bool has_simplices =
            std::any_of(cells.begin(), cells.end(), [](const CellData<dim> &cell) {
              return cell.vertices.size() != GeometryInfo<dim>::vertices_per_cell;
            });
        if (has_simplices)
          cells = Cutter<dim>(vertices, cells).pieces;
        GridTools::invert_all_negative_measure_cells(vertices, cells);
        GridTools::consistently_order_cells(cells);
        Triangulation<dim>::create_triangulation(vertices, cells, none);
      }
    };
  } // namespace

  template <int dim>
  void read_gmsh(const std::string &file, Triangulation<dim> &tria)
  {
    const std::string contents = read_whole_file(file);
    const std::string text =
        is_binary_mesh(contents) ? convert_binary_mesh(contents) : read_text_file(file);
    check_sections(text);
    std::istringstream       stream(make_linear(text));
    MendedTriangulation<dim> mended;
    GridIn<dim>(mended).read_msh(stream);
    tria.copy_triangulation(mended);
  }

  GroupNames read_group_names(const std::string &file, const int dim)
  {
    const std::string begins = "$PhysicalNames";
    const std::string text   = read_whole_file(file);
    const std::size_t begin  = text.find(begins);
    GroupNames        names;
    if (begin == std::string::npos)
      return names;
    std::istringstream lines(text.substr(begin + begins.size()));
    unsigned int       n_names = 0;
    lines >> n_names;
    for (unsigned int k = 0; k < n_names && lines; ++k)
    {
      int                group_dimension = -1;
      types::material_id number          = 0;
      std::string        name;
      lines >> group_dimension >> number;
      std::getline(lines, name, '"');
      std::getline(lines, name, '"');
      if (lines && group_dimension == dim)
        names[number] = name;
    }
    return names;
  }

  template void read_gmsh(const std::string &, Triangulation<2> &);
  template void read_gmsh(const std::string &, Triangulation<3> &);
} // namespace caudal
