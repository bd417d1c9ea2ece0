// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/memory.h>
#include <caudal/base/print.h>
#include <caudal/io/progress.h>
#include <caudal/viscous/cost_estimate.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  namespace
  {
    constexpr double mebibyte     = 1024. * 1024.;
    constexpr double base_of_rank = 150 * mebibyte, bytes_of_cell = 6e4, bytes_near = 3e4;
    constexpr double seconds_of_cell = 7e-4, seconds_near = 1e-4;
    constexpr double least_near = 1500; // unknowns for which it takes a rank more

    constexpr double longest_sensible_run = 14 * 86400.; // [s]

    /** Unknowns of bodies and of the pressures in them, which are factorised together. */
    template <int dim>
    double count_near_unknowns(const Operators<dim> &operators)
    {
      const auto edges =
          operators.parameters.domain.get_cell_size(operators.parameters.domain.get_finest_level());
      double cell = 1, n = 0;
      for (unsigned int d = 0; d < dim; ++d)
        cell *= edges[d];
      for (const auto &body : operators.bodies)
        n += body->get_solid().n_dofs() +
             (dim + 1) * body->get_solid().get_reference_volume() / cell;
      return n;
    }
  } // namespace

  template <int dim>
  StepCost estimate_iterative_step(const Operators<dim> &operators)
  {
    const double n_ranks  = Utilities::MPI::n_mpi_processes(operators.communicator);
    const double n_cells  = operators.triangulation.n_global_active_cells();
    const double n_near   = count_near_unknowns(operators);
    const double n_slices = std::clamp(n_near / least_near, 1., n_ranks);
    StepCost     cost;
    cost.seconds = seconds_of_cell * n_cells / n_ranks + seconds_near * n_near / n_slices;
    cost.memory =
        (base_of_rank * n_ranks + bytes_of_cell * n_cells + bytes_near * n_near) / mebibyte;
    return cost;
  }

  template <int dim>
  std::vector<std::string> find_cost_warnings(const Operators<dim> &operators)
  {
    std::vector<std::string> warnings;
    if (!operators.solver.is_iterative())
      return warnings;
    const double   n_cells = operators.triangulation.n_global_active_cells();
    const double   n_ranks = Utilities::MPI::n_mpi_processes(operators.communicator);
    const StepCost cost    = estimate_iterative_step(operators);
    const double   free    = get_free_memory(n_ranks) * n_ranks / mebibyte;
    const auto    &time    = operators.parameters.time;
    const double   seconds = std::ceil(time.end_time / time.step) * cost.seconds;
    // Half of the spacing is four to eight times the cells, in steps half as long.
    if (cost.memory > free)
      warnings.push_back("Domain/Levels: " + print_rounded(n_cells) + " cells take about " +
                         print_rounded(cost.memory / 1024) + " GiB, and " +
                         print_rounded(free / 1024) + " GiB are free: about " +
                         print_rounded(n_cells * free / cost.memory) +
                         " cells fit. Give a level less, or a smaller Refinement/Body margin.");
    if (seconds > longest_sensible_run)
      warnings.push_back("Domain/Levels: the run takes about " + format_duration(seconds) +
                         " on these ranks, " + print_rounded(cost.seconds) +
                         " s a step. A level less and twice Time/Step take an eighth to a "
                         "sixteenth of it; more ranks share the work of the cells.");
    return warnings;
  }

#define INSTANTIATE(dim)                                                                           \
  template StepCost                 estimate_iterative_step(const Operators<dim> &);               \
  template std::vector<std::string> find_cost_warnings(const Operators<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
