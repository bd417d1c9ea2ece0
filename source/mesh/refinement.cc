#include <caudal/mesh/refinement.h>

#include <caudal/base/expression.h>

#include <cmath>

namespace caudal
{
  void RefinementParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Refinement");
    prm.add_parameter("Interval", interval, "Number of steps between adaptations of the grid [1].");
    prm.add_parameter(
        "Body margin", body_margin,
        "Cells of the finest level around the bodies beyond the support of the kernel [1].");
    prm.add_parameter("Vorticity threshold", vorticity_threshold,
                      "Refine where h |vorticity| is larger, h the cell's edge; coarsen below an "
                      "eighth of it [m/s]. 0 switches it off.");
    prm.add_parameter("Vorticity levels", vorticity_levels,
                      "The number of levels that the vorticity may ask for, counted like "
                      "Domain/Levels; 0: all [1].");
    prm.add_parameter("Largest number of cells", largest_number_of_cells,
                      "The vorticity asks for no more cells than this [1].");
    prm.add_parameter(
        "Level expression", level_expression,
        "Function of x, y (and z): the level, from 0, that the grid has there at least [1].");
    prm.leave_subsection();
  }

  void RefinementParameters::check(const unsigned int levels) const
  {
    AssertThrow(interval >= 1, ExcMessage("Refinement/Interval: 0 steps. Give 1 or more."));
    AssertThrow(body_margin >= 0 && body_margin <= 100,
                ExcMessage("Refinement/Body margin: " + std::to_string(body_margin) +
                           " cells. Give 0 to 100."));
    AssertThrow(
        std::isfinite(vorticity_threshold) && vorticity_threshold >= 0,
        ExcMessage("Refinement/Vorticity threshold: " + std::to_string(vorticity_threshold) +
                   " m/s. Give 0 (off) or a positive number."));
    AssertThrow(vorticity_levels <= levels,
                ExcMessage("Refinement/Vorticity levels: " + std::to_string(vorticity_levels) +
                           ". Give at most Domain/Levels = " + std::to_string(levels) +
                           ", or 0 for all levels."));
  }

  namespace
  {
    /** The indicator above which about @p n_affordable cells are refined. */
    double compute_affordable_threshold(const std::vector<float> &indicators,
                                        const double threshold, const double n_affordable,
                                        MPI_Comm communicator)
    {
      const auto count = [&](const double limit) {
        return Utilities::MPI::sum(
            static_cast<double>(std::count_if(indicators.begin(), indicators.end(),
                                              [&](const float i) { return i > limit; })),
            communicator);
      };
      if (count(threshold) <= n_affordable)
        return threshold;
      double lower = threshold, upper = threshold;
      do
        upper *= 2;
      while (count(upper) > n_affordable);
      for (unsigned int bisection = 0; bisection < 20; ++bisection)
      {
        const double middle                            = std::sqrt(lower * upper);
        (count(middle) > n_affordable ? lower : upper) = middle;
      }
      return upper;
    }
  } // namespace

  template <int dim>
  bool flag_cells(parallel::distributed::Triangulation<dim> &triangulation,
                  const CellLattice<dim> &lattice, const CellSet<dim> &body_cells,
                  const Vector<float> &indicator, const RefinementParameters &parameters)
  {
    const std::string path             = "Refinement/Level expression";
    const auto        level_function   = make_expression<dim>(path, parameters.level_expression, 1);
    const int         finest           = lattice.get_finest_level();
    const int         finest_vorticity = parameters.vorticity_levels == 0
                                             ? finest
                                             : static_cast<int>(parameters.vorticity_levels) - 1;
    const bool        use_vorticity    = parameters.vorticity_threshold > 0 && indicator.size() > 0;

    std::vector<float> candidates;
    if (use_vorticity)
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && cell->level() < finest_vorticity)
          candidates.push_back(indicator[cell->active_cell_index()]);
    const double n_affordable = std::max(
        0., (parameters.largest_number_of_cells - 1. * triangulation.n_global_active_cells()) /
                (GeometryInfo<dim>::max_children_per_cell - 1));
    const double threshold =
        use_vorticity ? compute_affordable_threshold(candidates, parameters.vorticity_threshold,
                                                     n_affordable, triangulation.get_communicator())
                      : 0;

    bool any_flag = false;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        const int    level        = cell->level();
        const double wanted_level = level_function->value(cell->center());
        check_finite(path, parameters.level_expression, *level_function, cell->center());
        const double vorticity = use_vorticity ? indicator[cell->active_cell_index()] : 0;
        const bool   needs_refinement =
            level < finest &&
            (body_cells.contains(cell->center(), level) || level < wanted_level ||
             (use_vorticity && level < finest_vorticity && vorticity > threshold));
        const bool may_coarsen =
            level > 0 && level > wanted_level && !body_cells.contains(cell->center(), level) &&
            (vorticity <= parameters.vorticity_threshold / 8 || level > finest_vorticity);

        if (needs_refinement)
          cell->set_refine_flag();
        else if (may_coarsen)
          cell->set_coarsen_flag();
        any_flag = any_flag || needs_refinement || may_coarsen;
      }
    return Utilities::MPI::max(static_cast<int>(any_flag), triangulation.get_communicator()) > 0;
  }

  template bool flag_cells(parallel::distributed::Triangulation<2> &, const CellLattice<2> &,
                           const CellSet<2> &, const Vector<float> &, const RefinementParameters &);
  template bool flag_cells(parallel::distributed::Triangulation<3> &, const CellLattice<3> &,
                           const CellSet<3> &, const Vector<float> &, const RefinementParameters &);
} // namespace caudal
