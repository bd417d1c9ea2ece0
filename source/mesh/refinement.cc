// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/base/compatibility.h>
#include <caudal/mesh/refinement.h>

#include <caudal/base/collective.h>
#include <caudal/base/expression.h>

#include <cmath>

namespace caudal
{
  void RefinementParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Refinement");
    prm.add_parameter("Interval", interval, "Number of steps between adaptations of the grid [1].",
                      Patterns::Integer(1));
    prm.add_parameter(
        "Body margin", body_margin,
        "Cells of the finest level around the bodies beyond the support of the kernel [1].");
    prm.add_parameter(
        "Interior levels", interior_levels,
        "The number of levels, counted like Domain/Levels, that the grid has at least "
        "inside of bodies, three cells and more below their surfaces; 0: all. Rigid "
        "bodies need no fine cells there. Needs the kernel dirac [1].",
        Patterns::Integer(0));
    prm.add_parameter("Vorticity threshold", vorticity_threshold,
                      "Refine where h |vorticity| is larger, h the cell's edge; coarsen below an "
                      "eighth of it [m/s]. 0 switches it off.");
    prm.add_parameter("Vorticity levels", vorticity_levels,
                      "The number of levels that the vorticity may ask for, counted like "
                      "Domain/Levels; 0: all [1].",
                      Patterns::Integer(0));
    prm.add_parameter(
        "Largest number of cells", largest_number_of_cells,
        "The vorticity asks for no more cells than this; where the bodies have brought "
        "more, the calmest are coarsened [1].",
        Patterns::Integer(1));
    prm.add_parameter(
        "Level expression", level_expression,
        "Function of x, y (z) and t: the level, from 0, that the grid has there at least [1]. The "
        "grid follows its course in time t [s] by a level at each adaptation.");
    prm.leave_subsection();
  }

  void RefinementParameters::check(const unsigned int levels) const
  {
    check_positive("Refinement/Interval", interval, "Give 1 step or more.");
    check_between("Refinement/Body margin", body_margin, 0, 100, "Give 0 to 100 cells.");
    check_value(interior_levels <= levels, "Refinement/Interior levels", interior_levels,
                "Give at most Domain/Levels = " + std::to_string(levels) +
                    ", or 0 for all levels.");
    check_not_negative("Refinement/Vorticity threshold", vorticity_threshold,
                       "Give 0 (off) or a positive number [m/s].");
    check_value(vorticity_levels <= levels, "Refinement/Vorticity levels", vorticity_levels,
                "Give at most Domain/Levels = " + std::to_string(levels) +
                    ", or 0 for all levels.");
  }

  namespace
  {
    /** The smallest limit from @p threshold on that at most about @p n_most indicators exceed. */
    double raise_threshold(const std::vector<float> &indicators, const double threshold,
                           const double n_most, MPI_Comm communicator)
    {
      const auto count = [&](const double limit) {
        return Utilities::MPI::sum(
            static_cast<double>(std::count_if(indicators.begin(), indicators.end(),
                                              [&](const float i) { return i > limit; })),
            communicator);
      };
      if (count(threshold) <= n_most)
        return threshold;
      double lower = threshold, upper = threshold;
      do
        upper *= 2;
      while (count(upper) > n_most);
      for (unsigned int bisection = 0; bisection < 20; ++bisection)
      {
        const double middle                      = std::sqrt(lower * upper);
        (count(middle) > n_most ? lower : upper) = middle;
      }
      return upper;
    }

    /** What the grid is adapted to, cell by cell. */
    template <int dim>
    class AdaptationCriteria
    {
    public:
      using Cell = typename parallel::distributed::Triangulation<dim>::active_cell_iterator;

      AdaptationCriteria(const parallel::distributed::Triangulation<dim> &triangulation,
                         const CellLattice<dim> &lattice, const CellSet<dim> &body_cells,
                         const Vector<float> &indicator, const RefinementParameters &parameters,
                         const double time)
          : body_cells(body_cells)
          , indicator(indicator)
          , parameters(parameters)
          , finest(lattice.get_finest_level())
          , finest_vorticity(parameters.vorticity_levels == 0
                                 ? finest
                                 : static_cast<int>(parameters.vorticity_levels) - 1)
          , uses_vorticity(parameters.vorticity_threshold > 0 && indicator.size() > 0)
          , wanted_levels(triangulation.n_active_cells())
      {
        set_wanted_levels(triangulation, time);
        if (uses_vorticity)
          set_thresholds(triangulation);
      }

      bool needs_refinement(const Cell &cell) const
      {
        const int level = cell->level();
        return level < finest && (body_cells.contains_finer(cell->center(), level) ||
                                  level < wanted_levels[cell->active_cell_index()] ||
                                  (uses_vorticity && level < finest_vorticity &&
                                   indicator[cell->active_cell_index()] > refinement_threshold));
      }

      bool may_coarsen(const Cell &cell) const
      {
        return is_free(cell) && (!uses_vorticity || cell->level() > finest_vorticity ||
                                 get_family_indicator(cell) <= coarsening_threshold);
      }

    private:
      const CellSet<dim>         &body_cells;
      const Vector<float>        &indicator;
      const RefinementParameters &parameters;
      const int                   finest, finest_vorticity;
      const bool                  uses_vorticity;
      std::vector<double>         wanted_levels; // of the owned active cells
      double                      refinement_threshold = 0, coarsening_threshold = 0;

      void set_wanted_levels(const parallel::distributed::Triangulation<dim> &triangulation,
                             const double                                     time)
      {
        Expression<dim> level_function("Refinement/Level expression", parameters.level_expression,
                                       1);
        level_function.set_time(time);
        run_on_all(compatibility::get_communicator(triangulation), [&]() {
          for (const auto &cell : triangulation.active_cell_iterators())
            if (cell->is_locally_owned())
              wanted_levels[cell->active_cell_index()] = level_function.value(cell->center());
        });
      }

      /** Whether neither a body nor the level expression holds the cell. */
      bool is_free(const Cell &cell) const
      {
        const int level = cell->level();
        return level > 0 && level > wanted_levels[cell->active_cell_index()] &&
               !body_cells.contains(cell->center(), level);
      }

      /** The largest indicator of the cells that would become one; siblings are on one rank. */
      float get_family_indicator(const Cell &cell) const
      {
        float result = indicator[cell->active_cell_index()];
        for (const auto &sibling : cell->parent()->child_iterators())
          if (sibling->is_active() && sibling->is_locally_owned())
            result = std::max(result, indicator[sibling->active_cell_index()]);
        return result;
      }

      /** Keeps the number of cells near its limit, in both directions. */
      void set_thresholds(const parallel::distributed::Triangulation<dim> &triangulation)
      {
        std::vector<float> coarse, fine;
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned())
          {
            if (cell->level() < finest_vorticity)
              coarse.push_back(indicator[cell->active_cell_index()]);
            if (cell->level() <= finest_vorticity && is_free(cell))
              fine.push_back(get_family_indicator(cell));
          }
        constexpr double n_children   = GeometryInfo<dim>::max_children_per_cell;
        const MPI_Comm   communicator = compatibility::get_communicator(triangulation);
        const double     n_spare =
            1. * parameters.largest_number_of_cells - triangulation.n_global_active_cells();
        refinement_threshold =
            raise_threshold(coarse, parameters.vorticity_threshold,
                            std::max(0., n_spare / (n_children - 1)), communicator);
        const double n_fine   = Utilities::MPI::sum(static_cast<double>(fine.size()), communicator);
        const double n_excess = std::max(0., -n_spare) * n_children / (n_children - 1);
        coarsening_threshold  = raise_threshold(fine, parameters.vorticity_threshold / 8,
                                                std::max(0., n_fine - n_excess), communicator);
      }
    };
  } // namespace

  template <int dim>
  bool flag_cells(parallel::distributed::Triangulation<dim> &triangulation,
                  const CellLattice<dim> &lattice, const CellSet<dim> &body_cells,
                  const Vector<float> &indicator, const RefinementParameters &parameters,
                  const double time)
  {
    const AdaptationCriteria<dim> criteria(triangulation, lattice, body_cells, indicator,
                                           parameters, time);
    bool                          any_flag = false;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        const bool needs_refinement = criteria.needs_refinement(cell);
        const bool may_coarsen      = !needs_refinement && criteria.may_coarsen(cell);
        if (needs_refinement)
          cell->set_refine_flag();
        else if (may_coarsen)
          cell->set_coarsen_flag();
        any_flag = any_flag || needs_refinement || may_coarsen;
      }
    return Utilities::MPI::max(static_cast<int>(any_flag),
                               compatibility::get_communicator(triangulation)) > 0;
  }

  template bool flag_cells(parallel::distributed::Triangulation<2> &, const CellLattice<2> &,
                           const CellSet<2> &, const Vector<float> &, const RefinementParameters &,
                           double);
  template bool flag_cells(parallel::distributed::Triangulation<3> &, const CellLattice<3> &,
                           const CellSet<3> &, const Vector<float> &, const RefinementParameters &,
                           double);
} // namespace caudal
