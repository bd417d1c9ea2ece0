// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/memory.h>
#include <caudal/base/print.h>
#include <caudal/viscous/size_check.h>

#include <functional>
#include <numeric>

namespace caudal
{
  namespace
  {
    // Bytes that a cell takes at least: of the fluid in the plane, half of what prm/fish_paper.prm
    // and Turek and Hron's benchmark take, in space half of what the iterative method does; of the
    // bodies, what grids, vectors and matrices take.
    constexpr double bytes_of_coarse_cell = 1000;
    template <int dim>
    constexpr double bytes_of_body_cell = dim == 2 ? 2000 : 20000;
    template <int dim>
    constexpr double bytes_of_cell = dim == 2 ? 12000 : 60000;
  } // namespace

  template <int dim>
  void check_sizes(const RunParameters<dim> &parameters, const MPI_Comm communicator)
  {
    const auto count = [](const std::vector<unsigned int> &numbers) {
      return std::accumulate(numbers.begin(), numbers.end(), 1., std::multiplies<double>());
    };
    const double n_ranks  = Utilities::MPI::n_mpi_processes(communicator);
    const double n_coarse = count(parameters.domain.cells);
    // Each rank has all of them.
    check_memory(communicator, n_coarse * bytes_of_coarse_cell * n_ranks,
                 "Domain/Cells: the coarse grid has " + print_rounded(n_coarse) + " cells",
                 "Give fewer, and more Domain/Levels where they are needed.");
    for (const auto &body : parameters.bodies)
    {
      const double n = count(body->solid.grid.get_divisions(0., body->solid.get_path()).elements);
      check_memory(communicator, n * bytes_of_body_cell<dim> * n_ranks,
                   body->solid.get_path() + "/Shape/Elements: there are " + print_rounded(n),
                   "Give fewer.");
    }
  }

  template <int dim>
  void check_fluid_size(const RunParameters<dim> &parameters, const Bodies<dim> &bodies,
                        const MPI_Comm communicator)
  {
    double     cell = 1, n_cells = 0;
    const auto edges = parameters.domain.get_cell_size(parameters.domain.get_finest_level());
    for (unsigned int d = 0; d < dim; ++d)
      cell *= edges[d];
    for (const auto &body : bodies)
      n_cells += body->get_solid().get_reference_volume() / cell;
    check_memory(communicator, n_cells * bytes_of_cell<dim>,
                 "Domain/Levels: " + std::to_string(parameters.domain.levels) + " ask for " +
                     print_rounded(n_cells) + " cells in the bodies",
                 "Give fewer levels or fewer Domain/Cells.");
  }

  template <int dim>
  void check_growth(const parallel::distributed::Triangulation<dim> &triangulation)
  {
    const MPI_Comm communicator = compatibility::get_communicator(triangulation);
    double         n_new        = 0;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && cell->refine_flag_set())
        n_new += GeometryInfo<dim>::max_children_per_cell - 1;
    n_new                = Utilities::MPI::sum(n_new, communicator);
    const double n_cells = triangulation.n_global_active_cells();
    check_memory(communicator, n_new * bytes_of_cell<dim>,
                 "Refinement: to " + print_rounded(n_cells) + " cells of the fluid " +
                     print_rounded(n_new) + " are to be added",
                 "Give a smaller Refinement/Level expression, fewer Domain/Levels, or a smaller "
                 "Largest number of cells.");
  }

#define INSTANTIATE(dim)                                                                           \
  template void check_sizes(const RunParameters<dim> &, MPI_Comm);                                 \
  template void check_fluid_size(const RunParameters<dim> &, const Bodies<dim> &, MPI_Comm);       \
  template void check_growth(const parallel::distributed::Triangulation<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
