// SPDX-License-Identifier: LGPL-2.1-or-later
// What a factorisation costs, by model problems of the kind and size of prm/fish.prm and
// prm/fish_paper.prm: the momentum of a step with an augmented Lagrangian, Q2 elements on a grid
// refined at a NACA 0012 profile, and velocities and force densities of a body of that shape.
// scripts/benchmark solver builds and runs it. Beside it UMFPACK with pivots from all rows.

#include <caudal/linear/multifrontal.h>

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/timer.h>
#include <deal.II/base/utilities.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_dgp.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/grid_tools_cache.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>

using namespace caudal;
using namespace dealii;

namespace
{
  const MPI_Comm communicator = MPI_COMM_WORLD;

  struct Size
  {
    std::string               name;
    std::vector<unsigned int> cells;
    unsigned int              n_levels;
    std::vector<unsigned int> body_elements;
  };

  const std::vector<Size> sizes = {{"fish", {40, 6}, 6, {52, 4}},
                                   {"fish_paper", {280, 42}, 4, {348, 6}}};

  constexpr double density = 1000, step = 2e-3, inertia = 1.5 * density / step;

  double half_thickness(const double s)
  {
    return 0.6 *
           (0.2969 * std::sqrt(s) + s * (-0.1260 + s * (-0.3516 + s * (0.2843 - 0.1036 * s))));
  }

  /** Matrix of the model problem, the same on all ranks. */
  class Model
  {
  public:
    explicit Model(const Size &size)
        : fe(FE_Q<2>(2), 2)
        , body_fe(FE_Q<2>(1), 2)
        , dofs(fluid)
        , body_dofs(body)
    {
      make_grids(size);
      dofs.distribute_dofs(fe);
      body_dofs.distribute_dofs(body_fe);
      DoFTools::make_hanging_node_constraints(dofs, constraints);
      constraints.close();
      assemble_fluid();
      assemble_body();
      couple();
      make_groups();
    }

    unsigned int n_cells() const
    {
      return fluid.n_active_cells();
    }

    std::vector<int>    group_begins;
    std::vector<double> positions;
    MatrixParts         matrix;

  private:
    static constexpr double nose = 17.4, axis = 1.5;

    Triangulation<2>                 fluid, body;
    const FESystem<2>                fe, body_fe;
    DoFHandler<2>                    dofs, body_dofs;
    AffineConstraints<double>        constraints;
    std::vector<std::vector<int>>    unknowns;
    std::vector<std::vector<double>> values;

    /** Where a body's velocity and force density number @p i are. */
    int velocity(const int i) const
    {
      return dofs.n_dofs() + i / 2 * 4 + i % 2;
    }
    int force(const int i) const
    {
      return velocity(i) + 2;
    }

    void make_grids(const Size &size)
    {
      GridGenerator::subdivided_hyper_rectangle(fluid, size.cells, Point<2>(), Point<2>(20, 3));
      for (unsigned int level = 1; level < size.n_levels; ++level)
      {
        for (const auto &cell : fluid.active_cell_iterators())
        {
          const double margin = 3.5 * cell->minimum_vertex_distance();
          const double s      = cell->center()[0] - nose;
          if (s > -margin && s < 1 + margin &&
              std::abs(cell->center()[1] - axis) < half_thickness(std::clamp(s, 0., 1.)) + margin)
            cell->set_refine_flag();
        }
        fluid.execute_coarsening_and_refinement();
      }
      GridGenerator::subdivided_hyper_rectangle(body, size.body_elements, Point<2>(0.002, -1),
                                                Point<2>(1, 1));
      GridTools::transform(
          [](const Point<2> &p) {
            return Point<2>(nose + p[0], axis + half_thickness(p[0]) * p[1]);
          },
          body);
    }

    void assemble_fluid()
    {
      constexpr double   speed = 1, viscosity = 1e-3, grad_div = 100;
      constexpr double   augmentation = 1e4 * density * 9 / step;
      const QGauss<2>    quadrature(3);
      const FE_DGP<2>    pressure_fe(1);
      FEValues<2>        u(fe, quadrature, update_values | update_gradients | update_JxW_values);
      FEValues<2>        p(pressure_fe, quadrature, update_values);
      const unsigned int n = fe.n_dofs_per_cell(), n_p = 3;
      FullMatrix<double> cell_matrix(n, n), divergence(n_p, n), mass(n_p, n_p);
      std::vector<types::global_dof_index> indices(n);
      positions.resize(dofs.n_dofs());
      for (const auto &cell : dofs.active_cell_iterators())
      {
        u.reinit(cell);
        p.reinit(static_cast<Triangulation<2>::cell_iterator>(cell));
        cell_matrix = 0;
        divergence  = 0;
        mass        = 0;
        for (const unsigned int q : u.quadrature_point_indices())
        {
          const double w = u.JxW(q);
          for (unsigned int i = 0; i < n; ++i)
          {
            const unsigned int  a    = fe.system_to_component_index(i).first;
            const Tensor<1, 2> &grad = u.shape_grad(i, q);
            for (unsigned int j = 0; j < n; ++j)
            {
              const unsigned int  b      = fe.system_to_component_index(j).first;
              const Tensor<1, 2> &grad_j = u.shape_grad(j, q);
              cell_matrix(i, j) += w * grad_div * grad[a] * grad_j[b];
              if (a == b)
                cell_matrix(i, j) += w * (viscosity * (grad * grad_j) +
                                          u.shape_value(i, q) * (inertia * u.shape_value(j, q) +
                                                                 density * speed * grad_j[0]));
            }
            for (unsigned int k = 0; k < n_p; ++k)
              divergence(k, i) += w * p.shape_value(k, q) * grad[a];
          }
          for (unsigned int k = 0; k < n_p; ++k)
            for (unsigned int l = 0; l < n_p; ++l)
              mass(k, l) += w * p.shape_value(k, q) * p.shape_value(l, q);
        }
        mass.gauss_jordan();
        mass *= augmentation;
        cell_matrix.triple_product(mass, divergence, divergence, true, false);
        cell->get_dof_indices(indices);
        for (const auto index : indices)
          positions[index] = cell->center()[0];
        add_cell(cell_matrix, indices);
      }
      for (std::size_t e = 0; e < unknowns.size(); ++e)
        matrix.elements.push_back(
            {static_cast<int>(unknowns[e].size()), unknowns[e].data(), values[e].data()});
    }

    /** What an unknown stands for: others times weights. */
    std::vector<std::pair<types::global_dof_index, double>>
    resolve(const types::global_dof_index index) const
    {
      const auto *line = constraints.get_constraint_entries(index);
      if (line == nullptr)
        return {{index, 1.}};
      return *line;
    }

    void add_cell(const FullMatrix<double>                   &cell_matrix,
                  const std::vector<types::global_dof_index> &indices)
    {
      std::map<int, int> places;
      for (unsigned int i = 0; i < indices.size(); ++i)
      {
        if (constraints.is_constrained(indices[i]))
          matrix.entries.add(indices[i], indices[i], cell_matrix(i, i));
        for (const auto &[unknown, weight] : resolve(indices[i]))
          places.emplace(unknown, places.size());
      }
      const std::size_t n = places.size();
      unknowns.emplace_back(n);
      values.emplace_back(n * n);
      for (const auto &[unknown, place] : places)
        unknowns.back()[place] = unknown;
      for (unsigned int i = 0; i < indices.size(); ++i)
        for (unsigned int j = 0; j < indices.size(); ++j)
          for (const auto &[row, row_weight] : resolve(indices[i]))
            for (const auto &[column, column_weight] : resolve(indices[j]))
              values.back()[places[row] * n + places[column]] +=
                  row_weight * column_weight * cell_matrix(i, j);
    }

    void assemble_body()
    {
      constexpr double                     modulus = 1e6;
      FEValues<2>                          fe_values(body_fe, QGauss<2>(2),
                                                     update_values | update_gradients | update_JxW_values);
      std::vector<types::global_dof_index> indices(body_fe.n_dofs_per_cell());
      for (const auto &cell : body_dofs.active_cell_iterators())
      {
        fe_values.reinit(cell);
        cell->get_dof_indices(indices);
        for (unsigned int i = 0; i < indices.size(); ++i)
          for (unsigned int j = i % 2; j < indices.size(); j += 2)
          {
            double mass = 0, stiffness = 0;
            for (const unsigned int q : fe_values.quadrature_point_indices())
            {
              mass += fe_values.shape_value(i, q) * fe_values.shape_value(j, q) * fe_values.JxW(q);
              stiffness +=
                  fe_values.shape_grad(i, q) * fe_values.shape_grad(j, q) * fe_values.JxW(q);
            }
            matrix.entries.add(force(indices[i]), velocity(indices[j]), inertia * mass);
            matrix.entries.add(velocity(indices[i]), force(indices[j]), mass);
            matrix.entries.add(velocity(indices[i]), velocity(indices[j]),
                               step * modulus * stiffness);
          }
      }
    }

    /** The body moves with the fluid, and its force density acts on that. */
    void couple()
    {
      const QIterated<2>                   quadrature(QGauss<1>(2), 2);
      FEValues<2>                          fe_values(body_fe, quadrature,
                                                     update_values | update_JxW_values | update_quadrature_points);
      std::vector<types::global_dof_index> indices(body_fe.n_dofs_per_cell());
      std::vector<Point<2>>                points;
      std::vector<std::map<int, double>>   weights; // of the nodes at each point
      for (const auto &cell : body_dofs.active_cell_iterators())
      {
        fe_values.reinit(cell);
        cell->get_dof_indices(indices);
        for (const unsigned int q : fe_values.quadrature_point_indices())
        {
          points.push_back(fe_values.quadrature_point(q));
          weights.emplace_back();
          for (unsigned int i = 0; i < indices.size(); i += 2)
            weights.back()[indices[i]] = fe_values.shape_value(i, q) * fe_values.JxW(q);
        }
      }
      std::map<std::pair<int, int>, double> interaction;
      const GridTools::Cache<2>             cache(fluid);
      const auto [cells, unit_points, numbers] = GridTools::compute_point_locations(cache, points);
      indices.resize(fe.n_dofs_per_cell());
      for (unsigned int c = 0; c < cells.size(); ++c)
      {
        DoFHandler<2>::active_cell_iterator(&fluid, cells[c]->level(), cells[c]->index(), &dofs)
            ->get_dof_indices(indices);
        for (unsigned int q = 0; q < numbers[c].size(); ++q)
          for (const auto &[node, weight] : weights[numbers[c][q]])
            for (unsigned int j = 0; j < indices.size(); ++j)
              for (const auto &[unknown, share] : resolve(indices[j]))
                interaction[{node + fe.system_to_component_index(j).first, unknown}] +=
                    share * weight * fe.shape_value(j, unit_points[c][q]);
      }
      for (const auto &[place, value] : interaction)
      {
        matrix.entries.add(force(place.first), place.second, -inertia * value);
        matrix.entries.add(place.second, force(place.first), -value);
      }
    }

    void make_groups()
    {
      const int n = body_dofs.n_dofs();
      for (unsigned int i = 0; i < dofs.n_dofs(); i += 2)
        group_begins.push_back(i);
      for (int i = 0; i < n; i += 2)
      {
        group_begins.push_back(velocity(i));
        if (i / 2 % 64 != 0)
          group_begins.push_back(force(i));
      }
      group_begins.push_back(velocity(n));
    }
  };

  /** Where a rank's part of so many things begins. */
  std::size_t begin_part(const std::size_t n_things, const unsigned int rank)
  {
    const std::size_t n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    return rank == n_ranks ? n_things : n_things / 2 * rank / n_ranks * 2;
  }

  /** This rank's part of what all ranks have. */
  template <typename T>
  std::vector<T> take_part(const std::vector<T> &all)
  {
    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
    return {all.begin() + begin_part(all.size(), rank),
            all.begin() + begin_part(all.size(), rank + 1)};
  }

  double get_memory()
  {
    Utilities::System::MemoryStats stats;
    Utilities::System::get_memory_stats(stats);
    return Utilities::MPI::sum(stats.VmRSS / 1024., communicator);
  }

  /** CPU time of the rank that takes longest, the shortest of several tries. */
  template <typename Action>
  double measure(const unsigned int n_tries, const Action &action)
  {
    double shortest = std::numeric_limits<double>::max();
    for (unsigned int k = 0; k < n_tries; ++k)
    {
      Timer timer;
      action();
      timer.stop();
      shortest = std::min(shortest, Utilities::MPI::max(timer.last_cpu_time(), communicator));
    }
    return shortest;
  }

  /** Largest part of a row's terms by which it is missed. */
  double get_residual(const Triplets &entries, const std::vector<double> &solution,
                      const std::vector<double> &rhs)
  {
    std::vector<double> residual(rhs), terms(rhs.size());
    for (std::size_t k = 0; k < entries.values.size(); ++k)
    {
      const double term = entries.values[k] * solution[entries.columns[k]];
      residual[entries.rows[k]] -= term;
      terms[entries.rows[k]] += std::abs(term);
    }
    double largest = 0;
    for (std::size_t i = 0; i < rhs.size(); ++i)
      largest = std::max(largest, std::abs(residual[i]) / terms[i]);
    return largest;
  }

  void run(const Size &size, const bool with_umfpack, ConditionalOStream &out)
  {
    const Model model(size);
    const int   n = model.group_begins.back(), n_placed = model.positions.size();
    MatrixParts parts;
    parts.elements = take_part(model.matrix.elements);
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      parts.entries = model.matrix.entries;

    // Unknowns of the fluid are divided among the ranks, rank 0 has those of the body.
    const auto own = take_part(model.positions);
    IndexSet   placed(n_placed), others(n - n_placed);
    const auto begin = begin_part(n_placed, Utilities::MPI::this_mpi_process(communicator));
    placed.add_range(begin, begin + own.size());
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      others.add_range(0, n - n_placed);
    LinearAlgebra::distributed::BlockVector<double> rhs(2);
    rhs.block(0).reinit(placed, communicator);
    rhs.block(1).reinit(others, communicator);
    rhs.collect_sizes();
    rhs = 1;

    out << size.name << ": " << model.n_cells() << " cells, " << n << " unknowns, "
        << Utilities::MPI::n_mpi_processes(communicator) << " ranks\n";
    const auto report = [&](const std::string &name, const double ordered, const double reused,
                            const MultifrontalSolver &solver, const double memory) {
      auto         solution = rhs;
      const double time     = measure(3, [&]() {
        solution = rhs;
        solver.solve(solution);
      });
      out << "  " << std::left << std::setw(13) << name << std::right << std::fixed
          << std::setprecision(4) << std::setw(9) << ordered << " s, again " << std::setw(7)
          << reused << " s, solution " << std::setw(7) << time << " s, " << std::defaultfloat
          << std::setprecision(3) << solver.get_factor_entries() << " entries, " << memory
          << " MiB";
      if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      {
        std::vector<double> all(solution.block(0).begin(), solution.block(0).end());
        all.insert(all.end(), solution.block(1).begin(), solution.block(1).end());
        out << ", residual "
            << get_residual(model.matrix.to_triplets(), all, std::vector<double>(n, 1.));
      }
      out << std::endl;
    };
    const double memory = get_memory();
    {
      const auto         set_up = [&](auto &solver) { solver.set_positions(own); };
      MultifrontalSolver solver(communicator);
      set_up(solver);
      const double ordered = measure(5, [&]() {
        MultifrontalSolver anew(communicator);
        set_up(anew);
        AssertThrow(anew.factorize(model.group_begins, parts), ExcMessage("Poor pivots."));
      });
      const double reused  = measure(6, [&]() { solver.factorize(model.group_begins, parts); });
      report("multifrontal", ordered, reused, solver, get_memory() - memory);
    }
    if (with_umfpack)
    {
      const double       before = get_memory();
      MultifrontalSolver solver(communicator);
      const double       time = measure(1, [&]() { solver.factorize_with_pivoting(n, parts); });
      report("UMFPACK", time, time, solver, get_memory() - before);
    }
  }
} // namespace

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ConditionalOStream out(std::cout, Utilities::MPI::this_mpi_process(communicator) == 0);
  const bool         with_umfpack = argc < 2 || std::string(argv[1]) != "--fast";
  for (const Size &size : sizes)
    run(size, with_umfpack, out);
}
