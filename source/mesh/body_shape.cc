#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>

#include <caudal/mesh/body_shape.h>
#include <caudal/mesh/cylinder_with_flag.h>
#include <caudal/mesh/outline.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <numeric>
#include <set>
#include <sstream>

namespace caudal
{
  template <int dim>
  BodyShape<dim>::BodyShape(const BodyGridParameters<dim> &parameters)
      : parameters(parameters)
  {}

  namespace
  {
    void require(const bool condition, const std::string &path, const std::string &entry,
                 const std::string &sentences)
    {
      AssertThrow(condition, ExcMessage(path + "/Shape/" + entry + ": " + sentences));
    }

    void require_positive(const double value, const std::string &path, const std::string &entry)
    {
      std::string name = entry;
      name[0]          = std::tolower(name[0]);
      std::ostringstream sentences;
      sentences << "the " << name << " is " << value << " m. Give a positive " << name << ".";
      require(value > 0. && std::isfinite(value), path, entry, sentences.str());
    }

    /** Sets the material ids from the cells' centres, by their place along the length. */
    template <int dim>
    void assign_regions(Triangulation<dim> &tria, const std::vector<double> &region_boundaries)
    {
      const BoundingBox<dim> box    = GridTools::compute_bounding_box(tria);
      const double           begin  = box.lower_bound(0);
      const double           length = box.side_length(0);
      for (const auto &cell : tria.active_cell_iterators())
        cell->set_material_id(get_region((cell->center()[0] - begin) / length, region_boundaries));
    }

    /** NACA airfoils and the eel: quadrilaterals inside an Outline. */
    class SlenderShape : public BodyShape<2>
    {
    public:
      using BodyShape<2>::BodyShape;

      void check(const std::string &path) const override
      {
        require_positive(parameters.length, path, "Length");
        require(parameters.elements[1] >= 4, path, "Elements",
                "there are " + std::to_string(parameters.elements[1]) +
                    " elements across the body. Give at least four: they wrap round the nose.");

        const auto &boundaries = parameters.region_boundaries;
        const Nose  nose(*make_outline(path), parameters.elements[1]);
        require(boundaries.empty() || boundaries.front() > nose.core, path, "Region boundaries",
                "the first one lies within the round nose of the grid, which ends at " +
                    std::to_string(nose.core) + ". Give a larger fraction.");
      }

      void make_grid(Triangulation<2> &tria, const std::string &path) const override
      {
        make_outline_grid(tria, *make_outline(path), parameters.length,
                          parameters.region_boundaries, parameters.elements[0],
                          parameters.elements[1]);
      }

    private:
      virtual std::unique_ptr<Outline> make_outline(const std::string &path) const = 0;
    };

    class NacaShape : public SlenderShape
    {
    public:
      using SlenderShape::SlenderShape;

    private:
      std::unique_ptr<Outline> make_outline(const std::string &path) const override
      {
        const std::string &digits = parameters.naca_digits;
        require(digits.size() == 4 && digits.find_first_not_of("0123456789") == std::string::npos,
                path, "NACA digits",
                "<" + digits + "> is no four-digit airfoil. Give four digits, such as 0012.");
        require(digits.substr(2) != "00", path, "NACA digits",
                "an airfoil " + digits + " has no thickness. Give last two digits above 00.");
        require((digits[0] == '0') == (digits[1] == '0'), path, "NACA digits",
                "of camber and its position in " + digits +
                    " just one is zero. Give both (2412) or none (0012).");
        return std::make_unique<NacaOutline>(digits);
      }
    };

    class EelShape : public SlenderShape
    {
    public:
      using SlenderShape::SlenderShape;

    private:
      std::unique_ptr<Outline> make_outline(const std::string &) const override
      {
        return std::make_unique<EelOutline>();
      }
    };

    class RingShape : public BodyShape<2>
    {
    public:
      using BodyShape<2>::BodyShape;

      void check(const std::string &path) const override
      {
        require_positive(parameters.radius, path, "Radius");
        require_positive(parameters.wall_thickness, path, "Wall thickness");
        require(parameters.elements[0] >= 8, path, "Elements",
                "there are " + std::to_string(parameters.elements[0]) +
                    " elements round the ring. Give at least eight.");
      }

      void make_grid(Triangulation<2> &tria, const std::string &) const override
      {
        GridGenerator::concentric_hyper_shells(tria, Point<2>(), parameters.radius,
                                               parameters.radius + parameters.wall_thickness,
                                               parameters.elements[1], 0., parameters.elements[0]);
        assign_regions(tria, parameters.region_boundaries);
      }
    };

    /** The ellipsoid with these semi-axes, of about @p n_cells cells: 12 m^2 (2D) or 32 m^3 (3D).
     */
    template <int dim>
    void make_ellipsoid(Triangulation<dim> &tria, const Tensor<1, dim> &semi_axes,
                        const double n_cells)
    {
      Triangulation<dim> coarse;
      GridGenerator::hyper_ball_balanced(coarse);
      const double m = std::pow(n_cells / coarse.n_active_cells(), 1. / dim);
      subdivide(coarse, std::max(1L, std::lround(m)), tria);
      GridTools::transform(
          [&](Point<dim> p) {
            for (unsigned int d = 0; d < dim; ++d)
              p[d] *= semi_axes[d];
            return p;
          },
          tria);
    }

    template <int dim>
    double count_cells(const BodyGridParameters<dim> &parameters)
    {
      return std::accumulate(parameters.elements.begin(), parameters.elements.end(), 1.,
                             std::multiplies<double>());
    }

    template <int dim>
    class DiscShape : public BodyShape<dim>
    {
    public:
      using BodyShape<dim>::BodyShape;

      void check(const std::string &path) const override
      {
        require_positive(this->parameters.radius, path, "Radius");
      }

      void make_grid(Triangulation<dim> &tria, const std::string &) const override
      {
        Tensor<1, dim> semi_axes;
        for (unsigned int d = 0; d < dim; ++d)
          semi_axes[d] = this->parameters.radius;
        make_ellipsoid(tria, semi_axes, count_cells(this->parameters));
        assign_regions(tria, this->parameters.region_boundaries);
      }
    };

    /** The sides of the box round an ellipse, rectangle or beam. */
    template <int dim>
    Tensor<1, dim> get_sides(const BodyGridParameters<dim> &parameters)
    {
      Tensor<1, dim> sides;
      sides[0] = parameters.length;
      sides[1] = parameters.thickness;
      if constexpr (dim == 3)
        sides[2] = parameters.width;
      return sides;
    }

    template <int dim>
    void check_sides(const BodyGridParameters<dim> &parameters, const std::string &path)
    {
      require_positive(parameters.length, path, "Length");
      require_positive(parameters.thickness, path, "Thickness");
      if (dim == 3)
        require_positive(parameters.width, path, "Width");
    }

    template <int dim>
    class EllipseShape : public BodyShape<dim>
    {
    public:
      using BodyShape<dim>::BodyShape;

      void check(const std::string &path) const override
      {
        check_sides(this->parameters, path);
      }

      void make_grid(Triangulation<dim> &tria, const std::string &) const override
      {
        make_ellipsoid(tria, 0.5 * get_sides(this->parameters), count_cells(this->parameters));
        assign_regions(tria, this->parameters.region_boundaries);
      }
    };

    /** The lengths of the elements along the body, as fractions; regions end between elements. */
    template <int dim>
    std::vector<double> compute_steps_along(const BodyGridParameters<dim> &parameters)
    {
      const std::vector<double> stations =
          compute_stations(0., parameters.region_boundaries, parameters.elements[0]);
      std::vector<double> steps;
      for (unsigned int i = 1; i < stations.size(); ++i)
        steps.push_back(stations[i] - stations[i - 1]);
      return steps;
    }

    /** A beam, whose origin is the middle of its root, or a rectangle, whose origin is its centre.
     */
    template <int dim>
    class BoxShape : public BodyShape<dim>
    {
    public:
      BoxShape(const BodyGridParameters<dim> &parameters, const double origin)
          : BodyShape<dim>(parameters)
          , origin(origin)
      {}

      void check(const std::string &path) const override
      {
        check_sides(this->parameters, path);
      }

      void make_grid(Triangulation<dim> &tria, const std::string &) const override
      {
        const auto          &parameters = this->parameters;
        const Tensor<1, dim> sides      = get_sides(parameters);

        std::vector<std::vector<double>> steps(dim);
        for (const double step : compute_steps_along(parameters))
          steps[0].push_back(sides[0] * step);

        Point<dim> lower, upper;
        lower[0] = -origin * sides[0];
        upper[0] = lower[0] + sides[0];
        for (unsigned int d = 1; d < dim; ++d)
        {
          steps[d].assign(parameters.elements[d], sides[d] / parameters.elements[d]);
          lower[d] = -0.5 * sides[d];
          upper[d] = 0.5 * sides[d];
        }
        GridGenerator::subdivided_hyper_rectangle(tria, steps, lower, upper);
        assign_regions(tria, parameters.region_boundaries);
      }

    private:
      /** The origin's place along the length, as a fraction. */
      const double origin;
    };

    /** The bilinear image of the unit square: between four corners. */
    class QuadrilateralShape : public BodyShape<2>
    {
    public:
      using BodyShape<2>::BodyShape;

      void check(const std::string &path) const override
      {
        const auto &v = parameters.vertices;
        require(v.size() == 4, path, "Vertices",
                "there are " + std::to_string(v.size()) + " points. Give four corners.");
        for (unsigned int i = 0; i < 4; ++i)
        {
          const Tensor<1, 2> a = v[(i + 1) % 4] - v[i], b = v[(i + 2) % 4] - v[(i + 1) % 4];
          require(a[0] * b[1] - a[1] * b[0] > 0., path, "Vertices",
                  "the corners are not those of a convex quadrilateral, counter-clockwise. Give "
                  "them in that order.");
        }
      }

      void make_grid(Triangulation<2> &tria, const std::string &) const override
      {
        const std::vector<std::vector<double>> steps{
            compute_steps_along(parameters),
            std::vector<double>(parameters.elements[1], 1. / parameters.elements[1])};
        GridGenerator::subdivided_hyper_rectangle(tria, steps, Point<2>(), Point<2>(1., 1.));
        assign_regions(tria, parameters.region_boundaries);
        const auto &v = parameters.vertices;
        GridTools::transform(
            [&v](const Point<2> &p) {
              return Point<2>((1. - p[1]) * ((1. - p[0]) * v[0] + p[0] * v[1]) +
                              p[1] * ((1. - p[0]) * v[3] + p[0] * v[2]));
            },
            tria);
      }
    };

    class FlagShape : public BodyShape<2>
    {
    public:
      using BodyShape<2>::BodyShape;

      void check(const std::string &path) const override
      {
        require_positive(parameters.radius, path, "Radius");
        require_positive(parameters.length, path, "Length");
        require_positive(parameters.thickness, path, "Thickness");
        require(parameters.thickness < parameters.radius, path, "Thickness",
                "the flag is thicker than the cylinder's radius. Give a thinner flag or a larger "
                "Shape/Radius.");
      }

      bool has_own_regions() const override
      {
        return true;
      }

      void make_grid(Triangulation<2> &tria, const std::string &) const override
      {
        make_cylinder_with_flag(tria, parameters.radius, parameters.length, parameters.thickness,
                                parameters.elements[0], parameters.elements[1]);
      }
    };

    /** A gmsh mesh; the physical ids are the regions, in increasing order. */
    template <int dim>
    class FileShape : public BodyShape<dim>
    {
    public:
      using BodyShape<dim>::BodyShape;

      void check(const std::string &path) const override
      {
        const std::string &file = this->parameters.file;
        require(!file.empty(), path, "File",
                "no file is given. Give the name of a gmsh mesh (.msh).");
        require(std::ifstream(file).good(), path, "File",
                "<" + file + "> can't be opened. Give the name of a gmsh mesh (.msh).");
      }

      bool has_own_regions() const override
      {
        return true;
      }

      void make_grid(Triangulation<dim> &tria, const std::string &path) const override
      {
        const std::string name  = "<" + this->parameters.file + "> ";
        const std::string cells = dim == 2 ? "quadrilaterals" : "hexahedra";
        const std::string error = read(tria);
        require(error.empty(), path, "File",
                name + "can't be read as a mesh of " + cells + " in " + std::to_string(dim) +
                    "D. Save it again by gmsh. The reader's reason: " + error);
        require(tria.all_reference_cells_are_hyper_cube(), path, "File",
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
        require(distinct_cells.size() == tria.n_active_cells(), path, "File",
                name + "has cells twice, as gmsh writes them if physical groups overlap. Put each "
                       "cell into one group.");

        for (const auto &face : tria.active_face_iterators())
          if (face->at_boundary())
            face->set_boundary_id(0);
      }

    private:
      /** Reads the file; returns the reason if that fails, else an empty string. */
      std::string read(Triangulation<dim> &tria) const
      {
        std::ostringstream reason;
        try
        {
          std::ifstream file(this->parameters.file);
          GridIn<dim>(tria).read_msh(file);
        }
        catch (const ExceptionBase &exception)
        {
          exception.print_info(reason);
        }
        catch (const std::exception &exception)
        {
          reason << exception.what();
        }

        // As one line, without the indentation of deal.II's messages.
        std::istringstream words(reason.str());
        std::string        line;
        for (std::string word; words >> word;)
          line += (line.empty() ? "" : " ") + word;
        return line;
      }
    };

    template <int dim>
    using Creators =
        std::map<std::string,
                 typename Factory<BodyShape<dim>, const BodyGridParameters<dim> &>::Creator>;

    template <class Shape, int dim>
    std::unique_ptr<BodyShape<dim>> create(const BodyGridParameters<dim> &parameters)
    {
      return std::make_unique<Shape>(parameters);
    }

    template <int dim>
    Creators<dim> make_creators()
    {
      Creators<dim> creators;
      creators["disc"]    = create<DiscShape<dim>, dim>;
      creators["ellipse"] = create<EllipseShape<dim>, dim>;
      creators["file"]    = create<FileShape<dim>, dim>;
      creators["beam"]    = [](const BodyGridParameters<dim> &parameters) {
        return std::make_unique<BoxShape<dim>>(parameters, 0.);
      };
      creators["rectangle"] = [](const BodyGridParameters<dim> &parameters) {
        return std::make_unique<BoxShape<dim>>(parameters, 0.5);
      };
      if constexpr (dim == 2)
      {
        creators["naca"]               = create<NacaShape, dim>;
        creators["eel"]                = create<EelShape, dim>;
        creators["ring"]               = create<RingShape, dim>;
        creators["quadrilateral"]      = create<QuadrilateralShape, 2>;
        creators["cylinder with flag"] = create<FlagShape, dim>;
      }
      return creators;
    }
  } // namespace

  template <int dim>
  const Factory<BodyShape<dim>, const BodyGridParameters<dim> &> &get_body_shapes()
  {
    static const Factory<BodyShape<dim>, const BodyGridParameters<dim> &> shapes(
        "body shape", make_creators<dim>());
    return shapes;
  }

  template class BodyShape<2>;
  template class BodyShape<3>;
  template const Factory<BodyShape<2>, const BodyGridParameters<2> &> &get_body_shapes<2>();
  template const Factory<BodyShape<3>, const BodyGridParameters<3> &> &get_body_shapes<3>();
} // namespace caudal
