// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/flow_evaluation.h>

#include <caudal/base/collective.h>

#include <deal.II/fe/mapping_q.h>
#include <deal.II/matrix_free/fe_point_evaluation.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  template <int dim>
  class FlowEvaluation<dim>::Velocity
  {
  public:
    explicit Velocity(const FiniteElement<dim> &element)
        : mapping(1)
        , evaluation(mapping, element, update_values | update_gradients)
    {}

  private:
    const MappingQ<dim> mapping;

  public:
    FEPointEvaluation<dim, dim> evaluation;
  };

  template <int dim>
  FlowEvaluation<dim>::FlowEvaluation(const FluidSpace<dim> &space, const FluidState<dim> &fluid)
      : space(space)
      , fluid(fluid)
      , velocity(std::make_unique<Velocity>(space.velocity_element))
  {}

  template <int dim>
  FlowEvaluation<dim>::~FlowEvaluation() = default;

  template <int dim>
  std::vector<FlowValue<dim>>
  FlowEvaluation<dim>::evaluate(const typename Triangulation<dim>::active_cell_iterator &cell,
                                const std::vector<Point<dim>> &unit_points)
  {
    using DoFCell = typename DoFHandler<dim>::active_cell_iterator;
    Vector<double> velocities(space.velocity_element.n_dofs_per_cell());
    Vector<double> pressures(space.pressure_element.n_dofs_per_cell());
    DoFCell(*cell, &space.velocity_dofs)->get_dof_values(fluid.velocity, velocities);
    DoFCell(*cell, &space.pressure_dofs)->get_dof_values(fluid.pressure, pressures);

    auto &evaluation = velocity->evaluation;
    evaluation.reinit(cell, unit_points);
    evaluation.evaluate(make_array_view(velocities),
                        EvaluationFlags::values | EvaluationFlags::gradients);
    std::vector<FlowValue<dim>> values(unit_points.size());
    for (unsigned int q = 0; q < unit_points.size(); ++q)
    {
      values[q].velocity = evaluation.get_value(q);
      values[q].gradient = evaluation.get_gradient(q);
      for (unsigned int i = 0; i < pressures.size(); ++i)
        values[q].pressure += pressures[i] * space.pressure_element.shape_value(i, unit_points[q]);
    }
    return values;
  }

  namespace
  {
    /** Where a point is in a level's lattice of cells. */
    template <int dim>
    struct Place
    {
      typename CellLattice<dim>::Coordinates cell;
      Point<dim>                             unit_point;
    };

    /** The place of a point; one beyond a side that is not periodic is put onto it. */
    template <int dim>
    Place<dim> find_place(const CellLattice<dim> &lattice, const Point<dim> &point,
                          const unsigned int level)
    {
      Place<dim> place;
      place.cell = lattice.get_coordinates(point, level);
      for (unsigned int d = 0; d < dim; ++d)
        if (!lattice.is_periodic(d))
          place.cell[d] = std::clamp(place.cell[d], 0, lattice.get_number_of_cells(d, level) - 1);
      const Point<dim> corner = lattice.get_lower_corner(place.cell, level);
      for (unsigned int d = 0; d < dim; ++d)
        place.unit_point[d] =
            std::clamp((point[d] - corner[d]) / lattice.get_cell_size(level)[d], 0., 1.);
      place.cell = lattice.wrap(place.cell, level);
      return place;
    }
  } // namespace

  template <int dim>
  std::vector<FlowValue<dim>> evaluate_flow(const Observation<dim>        &observation,
                                            const std::vector<Point<dim>> &points)
  {
    constexpr unsigned int  n_numbers = dim + dim * dim + 2; // the last one counts cells
    const CellLattice<dim> &lattice   = observation.lattice;
    const ActiveCells<dim>  cells(lattice, observation.space.get_triangulation(), 0);
    FlowEvaluation<dim>     evaluation(observation.space, observation.fluid);
    std::vector<double>     numbers(n_numbers * points.size());
    for (unsigned int k = 0; k < points.size(); ++k)
      for (unsigned int level = 0; level <= lattice.get_finest_level(); ++level)
      {
        const Place<dim> place = find_place(lattice, points[k], level);
        const auto      *cell  = cells.find(place.cell, level);
        if (cell == nullptr)
          continue;
        const FlowValue<dim> value  = evaluation.evaluate(*cell, {place.unit_point})[0];
        auto                 number = numbers.begin() + n_numbers * k;
        for (unsigned int i = 0; i < dim; ++i)
        {
          *number++ = value.velocity[i];
          for (unsigned int j = 0; j < dim; ++j)
            *number++ = value.gradient[i][j];
        }
        *number++ = value.pressure;
        *number += 1;
      }
    // One rank has found the cell, so that nothing is added up.
    Utilities::MPI::sum(numbers, observation.space.get_communicator(), numbers);
    std::vector<FlowValue<dim>> values(points.size());
    auto                        number = numbers.begin();
    for (FlowValue<dim> &value : values)
    {
      for (unsigned int i = 0; i < dim; ++i)
      {
        value.velocity[i] = *number++;
        for (unsigned int j = 0; j < dim; ++j)
          value.gradient[i][j] = *number++;
      }
      value.pressure = *number++;
      Assert(*number == 1, ExcInternalError());
      ++number;
    }
    AssertThrow(std::all_of(numbers.begin(), numbers.end(),
                            [](const double x) { return std::isfinite(x); }),
                ExcMessage("The flow is not finite at the surface of a body. Take smaller steps "
                           "(Time/Step)."));
    return values;
  }

  template class FlowEvaluation<2>;
  template class FlowEvaluation<3>;
  template std::vector<FlowValue<2>> evaluate_flow(const Observation<2> &,
                                                   const std::vector<Point<2>> &);
  template std::vector<FlowValue<3>> evaluate_flow(const Observation<3> &,
                                                   const std::vector<Point<3>> &);
} // namespace caudal
