// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/base/collective.h>
#include <caudal/base/safe_file.h>
#include <caudal/mesh/shape.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace caudal
{
  namespace
  {
    /** A message as one line, without the indentation of deal.II's messages. */
    std::string join_words(const std::string &message)
    {
      std::istringstream words(message);
      std::string        line;
      for (std::string word; words >> word;)
        line += (line.empty() ? "" : " ") + word;
      return line;
    }

    /** The number of cells that are connected with the first one through common sides. */
    template <int dim>
    unsigned int count_connected_cells(const Triangulation<dim> &tria)
    {
      std::vector<bool> is_known(tria.n_active_cells(), false);
      std::vector<typename Triangulation<dim>::active_cell_iterator> open{tria.begin_active()};
      is_known[0]          = true;
      unsigned int n_cells = 0;
      while (!open.empty())
      {
        const auto cell = open.back();
        open.pop_back();
        ++n_cells;
        for (const unsigned int f : cell->face_indices())
          if (!cell->at_boundary(f) && !is_known[cell->neighbor(f)->active_cell_index()])
          {
            is_known[cell->neighbor(f)->active_cell_index()] = true;
            open.push_back(cell->neighbor(f));
          }
      }
      return n_cells;
    }

    /** A gmsh mesh; the physical ids are the regions, in increasing order. */
    template <int dim>
    class FileShape : public Shape<dim>
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter(
            "Name", file,
            "Name of a gmsh mesh (.msh, text or binary) of quadrilaterals or triangles (3D: "
            "hexahedra or tetrahedra), in metres; relative to the parameter file or else to the "
            "working directory. Its physical groups are the regions, by their names or, where "
            "they have none, in the order of their numbers. In an ideal fluid a closed mesh of "
            "quadrilaterals, outward oriented, as the surface of the straight body: nose at the "
            "smallest x, x towards the tail, y lateral, z dorsal; "
            ".msh, .ucd or .vtk. Its flat cells are not curved.",
            Patterns::FileName(Patterns::FileName::input));
        prm.add_parameter(
            "Scale", scale,
            "Factor by which the mesh is enlarged: 0.001 for one in millimetres [1].");
        prm.add_parameter("Shift", shift,
                          "Vector by which the mesh is moved then, in the body's frame [m].");
      }

      void check(const std::string &path) const override
      {
        require(!file.empty(), path, "Name",
                "no file is given. Give the name of a gmsh mesh (.msh).");
        check_positive(path + "/Scale", scale, "Give a positive factor.");
      }

      void check_divisions(const ShapeLengths &, const GridDivisions &,
                           const std::string &path) const override
      {
        const std::string reason = catch_file_error([&]() { read_whole_file(file); });
        require(reason.empty(), path, "File/Name",
                reason + ". Give the name of a gmsh mesh (.msh).");
      }

      std::string get_grid_entry() const override
      {
        return "File/Name";
      }

      std::string get_region_entry() const override
      {
        return "File/Name";
      }

      std::string get_file() const override
      {
        return file;
      }

      void make_grid(const ShapeLengths &, const GridDivisions &, const std::string &path,
                     Triangulation<dim> &tria) const override
      {
        const std::string name  = "<" + file + "> ";
        const std::string cells = dim == 2 ? "quadrilaterals" : "hexahedra";
        const std::string error = catch_error([&]() { read_gmsh(file, tria); });
        require(error.empty(), path, "File/Name",
                name + "can't be read as a mesh of " + cells + " in " + std::to_string(dim) +
                    "D. " + get_remedy(error) + " The reader's reason: " + join_words(error));
        GridTools::scale(scale, tria);
        GridTools::shift(shift, tria);

        std::set<std::vector<unsigned int>> distinct_cells;
        for (const auto &cell : tria.active_cell_iterators())
        {
          std::vector<unsigned int> vertices;
          for (const unsigned int v : cell->vertex_indices())
            vertices.push_back(cell->vertex_index(v));
          std::sort(vertices.begin(), vertices.end());
          distinct_cells.insert(vertices);
        }
        require(distinct_cells.size() == tria.n_active_cells(), path, "File/Name",
                name + "has cells twice, as gmsh writes them if physical groups overlap. Put each "
                       "cell into one group.");

        const unsigned int n_connected = count_connected_cells(tria);
        require(n_connected == tria.n_active_cells(), path, "File/Name",
                name + "falls into parts: only " + std::to_string(n_connected) + " of its " +
                    std::to_string(tria.n_active_cells()) +
                    " cells hold together by common sides. Let the nodes coincide where parts "
                    "touch (gmsh: Coherence, or BooleanFragments), or make parts that do not "
                    "touch bodies of their own.");

        for (const auto &face : tria.active_face_iterators())
          if (face->at_boundary())
            face->set_boundary_id(0);
      }

      GroupNames get_group_names() const override
      {
        return read_group_names(file, dim);
      }

    private:
      std::string    file;
      double         scale = 1;
      Tensor<1, dim> shift;

      /** What is likely wrong with a file that can't be read, and how to mend it. */
      static std::string get_remedy(const std::string &reason)
      {
        // deal.II names elements it does not know by their numbers in gmsh.
        if (reason.find("File format") != std::string::npos ||
            reason.find("binary") != std::string::npos)
          return "Save it as text (gmsh: Mesh.Binary = 0).";
        if (reason.find("lement type") != std::string::npos)
          return "Save it with elements of first order (gmsh: Mesh.ElementOrder = 1).";
        return "Save it again by gmsh.";
      }
    };

    const DimensionalRegistration<Shape, FileShape> registration("file", "a mesh from a file");
  } // namespace
} // namespace caudal
