// SPDX-License-Identifier: LGPL-2.1-or-later
// The interaction operator across hanging nodes and beside a boundary: the
// adjointness of interpolation and spreading, the power identity, and the exact
// interpolation of linear fields, with and without a weight of the body's surface. The numbers
// must not depend on the ranks.

#include <caudal/base/compatibility.h>
#include <caudal/coupling/interaction_operator.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/numerics/matrix_tools.h>
#include <deal.II/numerics/vector_tools.h>

#include "../round_off.h"

#include <iomanip>
#include <iostream>
#include <random>

using namespace caudal;

namespace
{
  template <int dim>
  class LinearField : public Function<dim>
  {
  public:
    LinearField()
        : Function<dim>(dim)
    {}

    double value(const Point<dim> &p, const unsigned int component) const override
    {
      return 0.7 - 0.3 * component + p[0] * (1 + component) - 2 * p[1] + 0.5 * p[dim - 1];
    }
  };

  /** A body of 4 x 4 (x 4) cells in the unit box, bent, with its lower corner at @p corner. */
  template <int dim>
  struct Body
  {
    explicit Body(const double corner)
        : element(FE_Q<dim>(1), dim)
        , dof_handler(triangulation)
    {
      GridGenerator::subdivided_hyper_cube(triangulation, 4, corner, corner + 0.3);
      dof_handler.distribute_dofs(element);
      std::vector<Point<dim>> points(dof_handler.n_dofs());
      DoFTools::map_dofs_to_support_points(MappingQ1<dim>(), dof_handler, points);
      positions.reinit(dof_handler.n_dofs());
      std::vector<types::global_dof_index> dofs(element.n_dofs_per_cell());
      for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
        {
          const unsigned int d = element.system_to_component_index(i).first;
          positions[dofs[i]] =
              points[dofs[i]][d] + 0.02 * std::sin(9 * points[dofs[i]][(d + 1) % dim]);
        }
      }
      DynamicSparsityPattern dynamic(dof_handler.n_dofs());
      DoFTools::make_sparsity_pattern(dof_handler, dynamic);
      pattern.copy_from(dynamic);
      mass.reinit(pattern);
      MatrixCreator::create_mass_matrix(dof_handler, QGauss<dim>(2), mass);
    }

    /** Adds @p surface_weight times the integral over the surface times the height of the cells. */
    void add_surface(const double surface_weight)
    {
      const double      height = 0.3 / 4;
      FEFaceValues<dim> values(element, QGauss<dim - 1>(2), update_values | update_JxW_values);
      std::vector<types::global_dof_index> dofs(element.n_dofs_per_cell());
      for (const auto &cell : dof_handler.active_cell_iterators())
        for (const unsigned int face : cell->face_indices())
          if (cell->at_boundary(face))
          {
            values.reinit(cell, face);
            cell->get_dof_indices(dofs);
            for (const unsigned int q : values.quadrature_point_indices())
              for (const unsigned int i : values.dof_indices())
                for (const unsigned int j : values.dof_indices())
                  if (element.system_to_component_index(i).first ==
                      element.system_to_component_index(j).first)
                    mass.add(dofs[i], dofs[j],
                             surface_weight * height * values.JxW(q) * values.shape_value(i, q) *
                                 values.shape_value(j, q));
          }
    }

    std::vector<BoundingBox<dim>> get_boxes() const
    {
      std::vector<BoundingBox<dim>> boxes;
      Vector<double>                x(element.n_dofs_per_cell());
      for (const auto &cell : dof_handler.active_cell_iterators())
      {
        std::vector<Point<dim>> vertices(x.size() / dim);
        cell->get_dof_values(positions, x);
        for (unsigned int i = 0; i < x.size(); ++i)
          vertices[element.system_to_component_index(i).second]
                  [element.system_to_component_index(i).first] = x[i];
        boxes.emplace_back(vertices);
      }
      return boxes;
    }

    Triangulation<dim>   triangulation;
    const FESystem<dim>  element;
    DoFHandler<dim>      dof_handler;
    Vector<double>       positions;
    SparsityPattern      pattern;
    SparseMatrix<double> mass;
  };

  /** The fluid's side: a grid just as fine as the kernel needs it. */
  template <int dim>
  struct Fluid
  {
    Fluid(const Body<dim> &body, const double support)
        : lattice(make_parameters())
        , triangulation(MPI_COMM_WORLD)
        , element(FE_Q<dim>(2), dim)
        , dof_handler(triangulation)
    {
      make_domain(triangulation, make_parameters());
      CellSet<dim> wanted(lattice);
      wanted.add(body.get_boxes(), support, lattice.get_finest_level());
      for (unsigned int level = 0; level < lattice.get_finest_level(); ++level)
      {
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned() && wanted.contains(cell->center(), level))
            cell->set_refine_flag();
        triangulation.execute_coarsening_and_refinement();
      }
      dof_handler.distribute_dofs(element);
      cells =
          std::make_unique<ActiveCells<dim>>(lattice, triangulation, lattice.get_finest_level());

      const IndexSet relevant = DoFTools::extract_locally_relevant_dofs(dof_handler);
      constraints.copy_from(
          compatibility::make_constraints(dof_handler.locally_owned_dofs(), relevant));
      DoFTools::make_hanging_node_constraints(dof_handler, constraints);
      VectorTools::interpolate_boundary_values(dof_handler, 0, LinearField<dim>(), constraints);
      constraints.close();
      velocity.reinit(dof_handler.locally_owned_dofs(), relevant, MPI_COMM_WORLD);
    }

    static DomainParameters<dim> make_parameters()
    {
      DomainParameters<dim> parameters;
      parameters.cells.assign(dim, 4);
      parameters.levels = 3;
      return parameters;
    }

    void set_velocity(const Function<dim> &function)
    {
      VectorTools::interpolate(dof_handler, function, velocity);
      constraints.distribute(velocity);
      velocity.update_ghost_values();
    }

    const CellLattice<dim>                    lattice;
    parallel::distributed::Triangulation<dim> triangulation;
    const FESystem<dim>                       element;
    DoFHandler<dim>                           dof_handler;
    std::unique_ptr<ActiveCells<dim>>         cells;
    AffineConstraints<double>                 constraints;
    FieldVector                               velocity;
  };

  template <int dim>
  void test(const std::string &kernel, const double corner, const double surface_weight)
  {
    const bool         is_root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    CouplingParameters parameters;
    parameters.kernel.set_name(kernel);
    const Coupling coupling(parameters);
    Body<dim>      body(corner);
    body.add_surface(surface_weight);
    Fluid<dim>         fluid(body, coupling.get_support());
    const unsigned int n = body.dof_handler.n_dofs();

    const auto compute_interaction = [&](const Vector<double> &positions) {
      return InteractionOperator<dim>(
          coupling,
          {*fluid.cells, fluid.dof_handler, fluid.constraints, fluid.velocity.get_partitioner()},
          {body.dof_handler, positions, surface_weight, {}, "test"});
    };
    const InteractionOperator<dim> interaction = compute_interaction(body.positions);
    if (is_root)
      std::cout << std::fixed << std::setprecision(6) << dim << "D, " << kernel << ", corner at "
                << corner << ", surface weight " << surface_weight << ": "
                << fluid.triangulation.n_global_active_cells() << " cells, "
                << interaction.n_points() << " points\n";

    // Phi.(G u) and (G^T Phi).u for random vectors, which are not the same on
    // different numbers of ranks, and for a smooth field, whose power is.
    std::mt19937 generator(1 + Utilities::MPI::this_mpi_process(MPI_COMM_WORLD));
    std::uniform_real_distribution<double> random(-1, 1);
    Vector<double>                         force_density(n);
    for (unsigned int i = 0; i < n; ++i)
      force_density[i] = 1000 * std::sin(1 + i);
    FieldVector force(fluid.velocity);
    for (const bool smooth : {false, true})
    {
      if (smooth)
        fluid.set_velocity(LinearField<dim>());
      else
      {
        for (double &value : fluid.velocity)
          value = random(generator);
        fluid.constraints.distribute(fluid.velocity);
        fluid.velocity.update_ghost_values();
      }
      const Vector<double> interpolated =
          interaction.interpolate(fluid.velocity, /*homogeneous=*/true);
      force = 0;
      interaction.spread(force_density, force);
      const double of_body = force_density * interpolated, of_fluid = force * fluid.velocity;
      if (is_root)
        std::cout << "  power of body and fluid equal but for "
                  << in_units(1e-12, of_fluid / of_body - 1) << '\n';
      if (is_root && smooth)
        std::cout << "  power " << of_fluid << '\n';
    }

    // C^-1 G reproduces linear fields, C the mass with the surface's share.
    Vector<double>         interpolated = interaction.interpolate(fluid.velocity);
    Vector<double>         nodal(n), expected(n);
    const LinearField<dim> field;
    for (const auto &cell : body.dof_handler.active_cell_iterators())
    {
      Vector<double> x(body.element.n_dofs_per_cell()), u(x.size());
      cell->get_dof_values(body.positions, x);
      for (unsigned int i = 0; i < x.size(); ++i)
      {
        const auto [component, a] = body.element.system_to_component_index(i);
        Point<dim> place;
        for (unsigned int d = 0; d < dim; ++d)
          place[d] = x[body.element.component_to_system_index(d, a)];
        u[i] = field.value(place, component);
      }
      cell->set_dof_values(u, nodal);
    }
    body.mass.vmult(expected, nodal);
    interpolated -= expected;
    if (is_root)
      std::cout << "  relative error of an interpolated linear field "
                << in_units(1e-9, interpolated.linfty_norm() / expected.linfty_norm()) << '\n';

    // The total of a force of (1, 0, 0) per volume is the body's volume, with 2 dim surface layers
    // of a quarter of it, if no part of it acts on the boundary.
    force_density = 0;
    for (const auto &cell : body.dof_handler.active_cell_iterators())
    {
      Vector<double> unit(body.element.n_dofs_per_cell());
      for (unsigned int i = 0; i < unit.size(); ++i)
        unit[i] = body.element.system_to_component_index(i).first == 0;
      cell->set_dof_values(unit, force_density);
    }
    force = 0;
    interaction.spread(force_density, force);
    const double total = force.mean_value() * force.size();
    if (is_root)
      std::cout << "  total force / volume "
                << total / ((1 + dim * surface_weight / 2) * std::pow(0.3, dim)) << '\n';

    // A body that leaves the fine cells.
    Vector<double> moved(body.positions);
    moved.add(0.2);
    try
    {
      compute_interaction(moved);
    }
    catch (const ExceptionBase &exception)
    {
      if (is_root)
        std::cout << "  moved away: an exception\n";
    }
  }
} // namespace

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const char *kernel : {"dirac", "four-point", "composite B-spline 32"})
  {
    test<2>(kernel, 0.4, 0.);
    test<2>(kernel, 0.09, 0.35);
  }
  test<3>("four-point", 0.4, 0.);
  test<3>("dirac", 0.09, 0.35);
}
