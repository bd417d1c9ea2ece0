// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/collective.h>
#include <caudal/mesh/shape.h>

#include <deal.II/grid/grid_in.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

namespace caudal
{
  namespace
  {
    /** A gmsh mesh; the physical ids are the regions, in increasing order. */
    template <int dim>
    class FileShape : public Shape<dim>
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter(
            "Name", file,
            "Name of a gmsh mesh (.msh) of quadrilaterals (3D: hexahedra), in metres; relative to "
            "the working directory. Its physical ids, in increasing order, are the regions. In an "
            "ideal fluid a closed mesh of quadrilaterals, outward oriented, as the surface of the "
            "straight body: nose at the smallest x, x towards the tail, y lateral, z dorsal; "
            ".msh, .ucd or .vtk. Its flat cells are not curved.",
            Patterns::Anything());
      }

      void check(const std::string &path) const override
      {
        require(!file.empty(), path, "Name",
                "no file is given. Give the name of a gmsh mesh (.msh).");
      }

      void check_divisions(const ShapeLengths &, const GridDivisions &,
                           const std::string &path) const override
      {
        require(std::ifstream(file).good(), path, "File/Name",
                "<" + file + "> can't be opened. Give the name of a gmsh mesh (.msh).");
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
        const std::string error = read(tria);
        require(error.empty(), path, "File/Name",
                name + "can't be read as a mesh of " + cells + " in " + std::to_string(dim) +
                    "D. Save it again by gmsh. The reader's reason: " + error);
        require(tria.all_reference_cells_are_hyper_cube(), path, "File/Name",
                name + "has other cells than " + cells + ". Mesh it with gmsh's " +
                    (dim == 2 ? "Mesh.RecombineAll=1." : "Mesh.SubdivisionAlgorithm=2."));

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

        for (const auto &face : tria.active_face_iterators())
          if (face->at_boundary())
            face->set_boundary_id(0);
      }

    private:
      std::string file;

      /** Reads the file; returns the reason if that fails, else an empty string. */
      std::string read(Triangulation<dim> &tria) const
      {
        std::istringstream words(catch_error([&]() {
          std::ifstream stream(file);
          GridIn<dim>(tria).read_msh(stream);
        }));
        // As one line, without the indentation of deal.II's messages.
        std::string line;
        for (std::string word; words >> word;)
          line += (line.empty() ? "" : " ") + word;
        return line;
      }
    };

    const DimensionalRegistration<Shape, FileShape> registration("file", "a mesh from a file");
  } // namespace
} // namespace caudal
