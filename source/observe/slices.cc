// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/observe/fields.h>
#include <caudal/observe/flow_evaluation.h>
#include <caudal/observe/plane_cut.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace caudal
{
  namespace
  {
    /** Patches that were made elsewhere, with the names of their data. */
    template <int patch_dim, int dim>
    class ReadyPatches : public DataOutInterface<patch_dim, dim>
    {
    public:
      using Patch = DataOutBase::Patch<patch_dim, dim>;
      using Ranges =
          std::vector<std::tuple<unsigned int, unsigned int, std::string,
                                 DataComponentInterpretation::DataComponentInterpretation>>;

      std::vector<Patch>       patches;
      std::vector<std::string> names;
      Ranges                   vectors; // first and last column, name

      /** A field with so many components, as further columns. */
      void add_field(const std::string &name, const unsigned int n_components)
      {
        if (n_components > 1)
          vectors.emplace_back(names.size(), names.size() + n_components - 1, name,
                               DataComponentInterpretation::component_is_part_of_vector);
        names.insert(names.end(), n_components, name);
      }

    protected:
      const std::vector<Patch> &get_patches() const override
      {
        return patches;
      }
      std::vector<std::string> get_dataset_names() const override
      {
        return names;
      }
      Ranges get_nonscalar_data_ranges() const override
      {
        return vectors;
      }
    };

    /**
     * Cuts through the fluid along planes, with all that the fields of the fluid have: velocity,
     * pressure, vorticity and the additional fields, as exact at their points as the solution is.
     * In two dimensions they are cuts along lines. Planes stay where they are in the grid, also if
     * that moves.
     */
    template <int dim>
    class Slices : public FieldObserver<dim>
    {
    public:
      Slices()
          : FieldObserver<dim>(104, "slices")
      {}

      void add_parameters(ParameterHandler &prm) override
      {
        prm.enter_subsection("Output");
        prm.enter_subsection("Slices");
        prm.add_parameter("Planes", planes,
                          "Planes along which the fluid is cut, each by a point [m] and a normal "
                          "of any direction and length: x, y, z : nx, ny, nz; in two dimensions "
                          "lines, x, y : nx, ny. Planes are separated by ';'. They move with "
                          "Domain/Frame. The cuts are light files with what the fluid's fields "
                          "have: open slices.pvd (slices.xdmf). None: not done.");
        interval.add_parameter(prm);
        prm.leave_subsection();
        prm.leave_subsection();
      }

      void check(const std::string & /*path*/) const override
      {
        interval.check();
        for (const auto &[point, normal] : planes)
          AssertThrow(std::isfinite(point.norm()) && std::isfinite(normal.norm()) &&
                          normal.norm() > 0,
                      ExcMessage("Output/Slices/Planes: the plane " + describe(point, normal) +
                                 " needs finite numbers and a normal that is not zero. Give a "
                                 "point and a normal."));
      }

      void check_case(const Observation<dim> &start) const override
      {
        for (const auto &[point, normal] : planes)
          AssertThrow(meets_domain(make_plane(start.lattice, point, normal), start.lattice),
                      ExcMessage("Output/Slices/Planes: the plane " + describe(point, normal) +
                                 " does not meet the domain. Give a point in it, or change "
                                 "Domain/Size."));
      }

    protected:
      bool is_active() const override
      {
        return !planes.empty();
      }

      double get_interval(const OutputParameters &output) const override
      {
        return interval.get(output);
      }

      void write_fields(const Observation<dim>     &observation,
                        const ObserverContext<dim> &context) override
      {
        const auto derived = context.others.template get<Fields<dim>>().make_derived_fields();
        for (unsigned int k = 0; k < planes.size(); ++k)
        {
          const auto [point, normal] = planes[k];
          ReadyPatches<dim - 1, dim> slice;
          slice.add_field("velocity", dim);
          slice.add_field("pressure", 1);
          for (const auto &field : derived)
            slice.add_field(field->get_names()[0], field->get_names().size());
          const Plane<dim> plane = make_plane(observation.lattice, point, normal);
          slice.patches =
              collect(cut_cells(observation, plane, context.output.n_subdivisions, derived),
                      slice.names.size(), observation);
          this->add(slice, "slice_" + std::to_string(k + 1), observation, MPI_COMM_SELF);
        }
      }

    private:
      using Derived = typename Fields<dim>::Derived;
      using Patch   = DataOutBase::Patch<dim - 1, dim>;

      static constexpr unsigned int n_corners = std::tuple_size<PlanePiece<dim>>::value;

      std::vector<std::pair<Point<dim>, Tensor<1, dim>>> planes; // with normals of any length
      OwnInterval interval{"Output/Slices/Interval", "slices"};

      static std::string describe(const Point<dim> &point, const Tensor<1, dim> &normal)
      {
        std::ostringstream text;
        text << "(" << point << " : " << normal << ")";
        return text.str();
      }

      /** The smallest and the largest distance of a corner of the domain from the plane. */
      static std::pair<double, double> get_distances(const Plane<dim>       &plane,
                                                     const CellLattice<dim> &lattice)
      {
        std::pair<double, double> range{std::numeric_limits<double>::max(),
                                        std::numeric_limits<double>::lowest()};
        for (unsigned int v = 0; v < GeometryInfo<dim>::vertices_per_cell; ++v)
        {
          typename CellLattice<dim>::Coordinates corner;
          for (unsigned int d = 0; d < dim; ++d)
            corner[d] = ((v >> d) & 1) * lattice.get_number_of_cells(d, 0);
          const double distance = plane.get_distance(lattice.get_lower_corner(corner, 0));
          range = {std::min(range.first, distance), std::max(range.second, distance)};
        }
        return range;
      }

      static bool meets_domain(const Plane<dim> &plane, const CellLattice<dim> &lattice)
      {
        const auto [lowest, highest] = get_distances(plane, lattice);
        const double round_off       = 1e-9 * (highest - lowest);
        return lowest <= round_off && highest >= -round_off;
      }

      /** One on a side of the domain looks outwards, so that it belongs to the cells there. */
      static Plane<dim> make_plane(const CellLattice<dim> &lattice, const Point<dim> &point,
                                   const Tensor<1, dim> &normal)
      {
        Plane<dim> plane{point, normal / normal.norm()};
        const auto [lowest, highest] = get_distances(plane, lattice);
        if (lowest > -1e-9 * (highest - lowest))
          plane.normal *= -1;
        return plane;
      }

      /** The corners of all pieces in this rank's cells, each with its place and its columns. */
      static std::vector<double> cut_cells(const Observation<dim> &observation,
                                           const Plane<dim>       &plane,
                                           const unsigned int      n_subdivisions,
                                           const Derived          &derived)
      {
        FlowEvaluation<dim> evaluation(observation.space, observation.fluid);
        std::vector<double> numbers;
        for (const auto &cell : observation.space.get_triangulation().active_cell_iterators())
        {
          if (!cell->is_locally_owned() ||
              std::abs(plane.get_distance(cell->center())) > cell->diameter())
            continue;
          const auto           size = observation.space.get_cell_size(cell->level());
          const Tensor<1, dim> part = size / static_cast<double>(n_subdivisions);
          std::array<int, dim> first{}, last{};
          last.fill(n_subdivisions - 1);
          std::vector<Point<dim>> points, unit_points;
          any_cell_between(first, last, [&](const std::array<int, dim> &index) {
            Point<dim> lower = cell->vertex(0);
            for (unsigned int d = 0; d < dim; ++d)
              lower[d] += index[d] * part[d];
            for (const auto &piece : cut_box(plane, lower, part))
              points.insert(points.end(), piece.begin(), piece.end());
            return false;
          });
          if (points.empty())
            continue;
          for (const Point<dim> &point : points)
          {
            unit_points.emplace_back();
            for (unsigned int d = 0; d < dim; ++d)
              unit_points.back()[d] = std::clamp((point[d] - cell->vertex(0)[d]) / size[d], 0., 1.);
          }
          append(points, evaluation.evaluate(cell, unit_points), derived, numbers);
        }
        return numbers;
      }

      /** Appends to @p numbers what each point has: its place, and the columns of the slice. */
      static void append(const std::vector<Point<dim>>     &points,
                         const std::vector<FlowValue<dim>> &flow, const Derived &derived,
                         std::vector<double> &numbers)
      {
        DataPostprocessorInputs::Vector<dim> input;
        for (const FlowValue<dim> &value : flow)
        {
          input.solution_gradients.emplace_back(dim);
          for (unsigned int d = 0; d < dim; ++d)
            input.solution_gradients.back()[d] = value.gradient[d];
        }
        std::vector<std::vector<Vector<double>>> made;
        for (const auto &field : derived)
        {
          made.emplace_back(points.size(), Vector<double>(field->get_names().size()));
          field->evaluate_vector_field(input, made.back());
        }
        for (unsigned int q = 0; q < points.size(); ++q)
        {
          for (unsigned int d = 0; d < dim; ++d)
            numbers.push_back(points[q][d]);
          for (unsigned int d = 0; d < dim; ++d)
            numbers.push_back(flow[q].velocity[d]);
          numbers.push_back(flow[q].pressure);
          for (const auto &values : made)
            numbers.insert(numbers.end(), values[q].begin(), values[q].end());
        }
      }

      /** The pieces of all ranks as patches of rank 0, in the laboratory's frame. */
      static std::vector<Patch> collect(const std::vector<double> &numbers,
                                        const unsigned int         n_columns,
                                        const Observation<dim>    &observation)
      {
        const Tensor<1, dim> origin = restrict_to<dim>(observation.origin);
        std::vector<Patch>   patches;
        for (const auto &of_rank :
             Utilities::MPI::gather(observation.space.get_communicator(), numbers))
          for (auto number = of_rank.begin(); number != of_rank.end();)
          {
            Patch patch;
            patch.patch_index    = patches.size();
            patch.n_subdivisions = 1;
            patch.reference_cell = ReferenceCells::get_hypercube<dim - 1>();
            patch.data.reinit(n_columns, n_corners);
            for (unsigned int corner = 0; corner < n_corners; ++corner)
            {
              for (unsigned int d = 0; d < dim; ++d)
                patch.vertices[corner][d] = *number++ + origin[d];
              for (unsigned int column = 0; column < n_columns; ++column)
                patch.data(column, corner) = *number++;
            }
            patches.push_back(patch);
          }
        return patches;
      }
    };

    const DimensionalRegistration<Observer, Slices> registration("slices",
                                                                 "cuts through the fluid");
  } // namespace
} // namespace caudal
