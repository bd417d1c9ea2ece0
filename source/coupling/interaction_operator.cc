// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/coupling/deformed_cell.h>
#include <caudal/coupling/interaction_operator.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_tools.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace caudal
{
  void CouplingParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Coupling");
    kernel.add_parameters(prm);
    prm.add_parameter(
        "Quadrature density", quadrature_density,
        "Smallest number of quadrature points of the deformed body per fluid spacing, "
        "in each direction [1].");
    prm.add_parameter("Accept unresolved bodies", accept_unresolved_bodies,
                      "Run although most of a body is thinner than half a cell of the fluid. "
                      "Its results mean nothing, and are marked so.");
    prm.leave_subsection();
  }

  void CouplingParameters::check() const
  {
    kernel.check("Coupling");
    check_value(quadrature_density > 0 && quadrature_density <= 20, "Coupling/Quadrature density",
                quadrature_density, "Give a number between 0 and 20.");
  }

  /**
   * Collects the interaction of one body cell after the other with the fluid
   * cells around it: dense blocks first, then loose entries of the matrix.
   */
  template <int dim>
  class InteractionOperator<dim>::Assembler
  {
  public:
    Assembler(const Coupling &coupling, const Fluid &fluid, const DoFHandler<dim> &body_dofs)
        : inhomogeneity(body_dofs.n_dofs())
        , coupling(coupling)
        , cells(fluid.cells)
        , velocity_dofs(fluid.velocity_dofs)
        , constraints(fluid.constraints)
        , body_element(body_dofs.get_fe())
        , element(velocity_dofs.get_fe())
        , n_kernels(coupling.kernel->is_isotropic() ? 1 : dim)
        , n_nodes(body_element.n_dofs_per_cell() / dim)
        , n_s(element.n_dofs_per_cell() / dim)
        , lexicographic(FETools::hierarchic_to_lexicographic_numbering<dim>(2))
        , finest_level(cells.get_lattice().get_finest_level())
        , origin(cells.get_lattice().get_lower_corner({}, 0))
        , indices(element.n_dofs_per_cell())
    {}

    /**
     * Adds a quadrature point; @p shape holds the values of the body's scalar
     * shape functions. Returns the part of the kernel's integral that this
     * rank's cells, from the finest to the coarsest of these levels, have seen.
     */
    double add_point(const Point<dim> &point, const double weight, const std::vector<double> &shape,
                     const unsigned int coarsest_level)
    {
      double seen = 0;
      for (unsigned int level = finest_level + 1; seen == 0 && level-- > coarsest_level;)
        seen = add_point_on(level, point, weight, shape);
      return seen;
    }

    /** Ends a body cell: turns its blocks into entries, resolving the constraints. */
    void finish_cell(const std::vector<types::global_dof_index> &body_indices)
    {
      for (const auto &[place, block] : blocks)
        if (block.cell != nullptr)
        {
          typename DoFHandler<dim>::active_cell_iterator(**block.cell, &velocity_dofs)
              ->get_dof_indices(indices);
          for (unsigned int component = 0; component < dim; ++component)
            for (unsigned int s = 0; s < n_s; ++s)
            {
              const auto    index = indices[element.component_to_system_index(component, s)];
              const bool    is_constrained = constraints.is_constrained(index);
              const double *value =
                  block.values.data() + (n_kernels == 1 ? 0 : component) * n_nodes * n_s + s;
              for (unsigned int a = 0; a < n_nodes; ++a, value += n_s)
              {
                const unsigned int row =
                    body_indices[body_element.component_to_system_index(component, a)];
                if (!is_constrained)
                  entries.push_back({row, index, *value});
                else
                {
                  for (const auto &[master, factor] : *constraints.get_constraint_entries(index))
                    entries.push_back({row, master, factor * *value});
                  inhomogeneity[row] += constraints.get_inhomogeneity(index) * *value;
                }
              }
            }
        }
      blocks.clear();
    }

    std::vector<LooseEntry> entries;
    /** What this rank's inhomogeneous constraints contribute to G u. */
    Vector<double> inhomogeneity;

  private:
    struct Block
    {
      const typename ActiveCells<dim>::Cell *cell;   // nullptr: not this rank's
      std::vector<double>                    values; // [kernel][body node][fluid node]
    };

    const Coupling                      &coupling;
    const ActiveCells<dim>              &cells;
    const DoFHandler<dim>               &velocity_dofs;
    const AffineConstraints<double>     &constraints;
    const FiniteElement<dim>            &body_element;
    const FiniteElement<dim>            &element;
    const unsigned int                   n_kernels, n_nodes, n_s;
    const std::vector<unsigned int>      lexicographic;
    const unsigned int                   finest_level;
    const Point<dim>                     origin;
    std::vector<types::global_dof_index> indices;

    std::map<std::pair<unsigned int, typename CellLattice<dim>::Coordinates>, Block> blocks;

    double add_point_on(const unsigned int level, const Point<dim> &point, const double weight,
                        const std::vector<double> &shape)
    {
      const Tensor<1, dim> cell_size = cells.get_lattice().get_cell_size(level);
      double               seen      = 0;
      for (unsigned int k = 0; k < n_kernels; ++k)
      {
        std::array<LineWeights, dim> lines;
        unsigned int                 n_cells = 1;
        for (unsigned int d = 0; d < dim; ++d)
        {
          lines[d] = (k == d ? coupling.along : coupling.across)
                         .evaluate((point[d] - origin[d]) / cell_size[d]);
          n_cells *= lines[d].cells.size();
        }
        for (unsigned int c = 0; c < n_cells; ++c)
        {
          typename CellLattice<dim>::Coordinates coordinates;
          const std::array<double, 3>           *factors[dim];
          double                                 total = 1;
          for (unsigned int d = 0, rest = c; d < dim; rest /= lines[d].cells.size(), ++d)
          {
            const unsigned int position = rest % lines[d].cells.size();
            coordinates[d]              = lines[d].first_cell + position;
            factors[d]                  = &lines[d].cells[position];
            total *= lines[d].get_total(position);
          }
          if (std::abs(total) < 1e-14) // the kernel only touches this cell
            continue;
          Block &block = find_block(coordinates, level);
          if (block.cell == nullptr)
            continue;
          seen += total / n_kernels;
          double fluid_weights[27];
          for (unsigned int s = 0; s < n_s; ++s)
          {
            fluid_weights[s] = weight;
            for (unsigned int d = 0, rest = lexicographic[s]; d < dim; rest /= 3, ++d)
              fluid_weights[s] *= (*factors[d])[rest % 3];
          }
          double *entry = block.values.data() + k * n_nodes * n_s;
          for (unsigned int a = 0; a < n_nodes; ++a)
            for (unsigned int s = 0; s < n_s; ++s, ++entry)
              *entry += shape[a] * fluid_weights[s];
        }
      }
      return seen;
    }

    Block &find_block(const typename CellLattice<dim>::Coordinates &coordinates,
                      const unsigned int                            level)
    {
      const auto block = blocks.find({level, coordinates});
      if (block != blocks.end())
        return block->second;
      const auto        *cell = cells.find(coordinates, level);
      const unsigned int size = cell == nullptr ? 0 : n_kernels * n_nodes * n_s;
      return blocks.insert({{level, coordinates}, Block{cell, std::vector<double>(size)}})
          .first->second;
    }
  };

  Coupling::Coupling(const CouplingParameters &parameters)
      : kernel(parameters.kernel.create())
      , along(*kernel)
      , across(kernel->across())
      , quadrature_density(parameters.quadrature_density)
  {}

  namespace
  {
    /** The place of the point with the number @p index, counted over all cells. */
    template <int dim>
    Point<dim> find_point(DeformedCell<dim> &body_cell, const DoFHandler<dim> &dofs,
                          const unsigned int index)
    {
      Point<dim>   place;
      unsigned int begin = 0;
      for (const auto &cell : dofs.active_cell_iterators())
      {
        body_cell.reinit(cell);
        const unsigned int end = begin + body_cell.n_points();
        if (begin <= index && index < end)
          body_cell.for_each_point([&](const Point<dim> &point, const double, const auto &) {
            if (begin++ == index)
              place = point;
          });
        begin = end;
      }
      return place;
    }

    template <int dim>
    [[noreturn]] void throw_not_covered(const CellLattice<dim> &lattice, const Point<dim> &point,
                                        const std::string &name)
    {
      std::ostringstream message;
      message << "Body " << name << ": near (" << point << ") ";
      if (lattice.is_inside(lattice.get_coordinates(point, lattice.get_finest_level()),
                            lattice.get_finest_level()))
        message
            << "the support of the kernel leaves the finest level of the grid or touches a side "
               "of the domain. Increase Refinement/Body margin, adapt the grid more often "
               "(Refinement/Interval), keep the body away from the sides, or use the kernel "
               "dirac (Coupling/Kernel), which reaches no further than the body.";
      else
        message
            << "the body leaves the domain. Enlarge it (Domain/Size) or start the body elsewhere "
               "(Body "
            << name << "/Shape/Position).";
      throw ExcMessage(message.str());
    }
  } // namespace

  template <int dim>
  InteractionOperator<dim>::InteractionOperator(const Coupling &coupling, const Fluid &fluid,
                                                const Body &body)
      : partitioner(fluid.partitioner)
  {
    const CellLattice<dim> &lattice = fluid.cells.get_lattice();
    const unsigned int      finest  = lattice.get_finest_level();
    const double            spacing = 0.5 * lattice.get_cell_size(finest).norm() / std::sqrt(dim);

    Assembler           assembler(coupling, fluid, body.dofs);
    DeformedCell<dim>   body_cell(body.dofs, body.positions, spacing / coupling.quadrature_density,
                                  body.surface_weight);
    const double        margin = coupling.get_support() + 0.1; // round-off decides about touching
    std::vector<double> seen;                                  // of the kernel around each point
    for (const auto &cell : body.dofs.active_cell_iterators())
    {
      body_cell.reinit(cell);
      const bool is_interior = !body.interior.empty() && body.interior[cell->active_cell_index()];
      const unsigned int coarsest = is_interior ? fluid.cells.get_coarsest_level() : finest;
      bool               meets    = false;
      for (unsigned int level = coarsest; level <= finest; ++level)
        meets = meets || fluid.cells.meet(body_cell.get_box(), margin, level);
      if (meets)
      {
        body_cell.for_each_point([&](const auto &point, const double weight, const auto &shape) {
          seen.push_back(assembler.add_point(point, weight, shape, coarsest));
        });
        assembler.finish_cell(body_cell.get_indices());
      }
      else // it is of no concern to this rank
        seen.resize(seen.size() + body_cell.n_points(), 0.);
    }

    const MPI_Comm communicator = partitioner->get_mpi_communicator();
    Utilities::MPI::sum(seen, communicator, seen);
    const auto first_not_covered = std::find_if(
        seen.begin(), seen.end(), [](const double part) { return !(std::abs(part - 1) < 1e-8); });
    if (first_not_covered != seen.end())
      throw_not_covered(lattice, find_point(body_cell, body.dofs, first_not_covered - seen.begin()),
                        body.name);
    n_quadrature_points = seen.size();
    inhomogeneity       = assembler.inhomogeneity;
    Utilities::MPI::sum(inhomogeneity, communicator, inhomogeneity);
    compress(assembler.entries, body.dofs.n_dofs(), body.name);
  }

  template <int dim>
  void InteractionOperator<dim>::compress(const std::vector<LooseEntry> &loose_entries,
                                          const unsigned int n_rows, const std::string &name)
  {
    // Sort by rows (counting sort), then add up equal columns of each row.
    std::vector<std::size_t> start(n_rows + 1, 0), order(loose_entries.size());
    for (const LooseEntry &entry : loose_entries)
      ++start[entry.row + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<std::size_t> next(start.begin(), start.end() - 1);
    for (std::size_t k = 0; k < loose_entries.size(); ++k)
      order[next[loose_entries[k].row]++] = k;

    // A chain of hanging nodes can lead to unknowns that this rank does not know.
    const bool all_known =
        std::all_of(loose_entries.begin(), loose_entries.end(), [&](const LooseEntry &entry) {
          return partitioner->in_local_range(entry.column) ||
                 partitioner->is_ghost_entry(entry.column);
        });
    AssertThrow(Utilities::MPI::min<int>(all_known, partitioner->get_mpi_communicator()) == 1,
                ExcMessage("Refinement/Body margin: the kernel of body " + name +
                           " reaches cells that depend on two coarser levels. Increase the "
                           "margin."));

    const unsigned int n_local = partitioner->locally_owned_size() + partitioner->n_ghost_indices();
    std::vector<std::size_t> place(n_local, 0); // 1 + position of a column in its row
    row_start.assign(1, 0);
    for (unsigned int row = 0; row < n_rows; ++row)
    {
      for (std::size_t k = start[row]; k < start[row + 1]; ++k)
      {
        const types::global_dof_index column = loose_entries[order[k]].column;
        const unsigned int            local  = partitioner->global_to_local(column);
        if (place[local] <= row_start.back())
        {
          columns.push_back(column);
          local_columns.push_back(local);
          entries.push_back(0);
          place[local] = entries.size();
        }
        entries[place[local] - 1] += loose_entries[order[k]].value;
      }
      row_start.push_back(entries.size());
    }
  }

  template <int dim>
  Vector<double> InteractionOperator<dim>::interpolate(const FieldVector &velocity,
                                                       const bool         homogeneous) const
  {
    Vector<double> result(inhomogeneity.size());
    for (unsigned int row = 0; row + 1 < row_start.size(); ++row)
      for (std::size_t k = row_start[row]; k < row_start[row + 1]; ++k)
        result[row] += entries[k] * velocity.local_element(local_columns[k]);
    Utilities::MPI::sum(result, partitioner->get_mpi_communicator(), result);
    if (!homogeneous)
      result += inhomogeneity;
    return result;
  }

  template <int dim>
  void InteractionOperator<dim>::spread(const Vector<double> &force_density,
                                        FieldVector          &result) const
  {
    result.zero_out_ghost_values();
    for (unsigned int row = 0; row + 1 < row_start.size(); ++row)
      for (std::size_t k = row_start[row]; k < row_start[row + 1]; ++k)
        result.local_element(local_columns[k]) += entries[k] * force_density[row];
    result.compress(VectorOperation::add);
  }

  template class InteractionOperator<2>;
  template class InteractionOperator<3>;
} // namespace caudal
