// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/print.h>
#include <caudal/fluid/boundary_flux.h>
#include <caudal/io/progress.h>
#include <caudal/mesh/body_grid.h>
#include <caudal/viscous/case_check.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace caudal
{
  namespace
  {
    // Bytes for a cell of the fluid in compressed .vtu files and in checkpoints, of prm/fish.prm.
    constexpr double bytes_of_point = 24, bytes_of_checkpoint = 550;
    constexpr double mebibyte = 1024. * 1024.;

    // How the cost of a step grows with the number of cells.
    constexpr double growth = 1.2;

    /** The direction of the line along @p axis, to two digits: "0, 1". */
    template <int dim>
    std::string print_axis(Tensor<1, dim> axis)
    {
      unsigned int first = 0;
      while (first < dim - 1 && std::abs(axis[first]) < 5e-3)
        ++first;
      if (axis[first] < 0)
        axis *= -1;
      std::string text;
      for (unsigned int d = 0; d < dim; ++d)
        text += (d > 0 ? ", " : "") + print_rounded(std::round(100 * axis[d]) / 100 + 0.);
      return text;
    }
  } // namespace

  template <int dim>
  CaseCheck<dim>::CaseCheck(const Operators<dim> &operators, const unsigned int n_cells)
      : operators(operators)
      , parameters(operators.parameters)
      , scales(operators.scales)
      , grad_div(operators.space.get_grad_div())
      , outflow_change(check_boundary_flux(operators.space, operators.parameters.time.end_time))
      , n_cells(n_cells)
      , cell_size(parameters.domain.get_finest_cell())
      , kernel_width(2 * cell_size * operators.coupling.get_support())
  {
    for (const auto &body : operators.bodies)
      bodies.push_back(describe_body(*body));
    for (unsigned int side = 0; side < 2 * dim; ++side)
      if (operators.space.get_boundary_condition(side).has_velocity())
        is_crossed[side / 2] = true;
  }

  template <int dim>
  typename CaseCheck<dim>::BodyOnGrid CaseCheck<dim>::describe_body(const Body<dim> &body) const
  {
    const SolidBody<dim>       &solid   = body.get_solid();
    const SolidParameters<dim> &entries = solid.get_parameters();
    const double                density = parameters.fluid.density + solid.get_excess_density();

    BodyOnGrid result{body, entries.get_path(), measure_resolution(body, parameters.domain)};
    for (unsigned int r = 0; r < entries.regions.size(); ++r)
    {
      const RegionParameters<dim> &region  = *entries.region_parameters[r];
      const std::string            path    = entries.get_region_path(r);
      const double                 modulus = region.material.get_wave_modulus(path);
      // What keeps volumes makes waves fast and steps short, but no body stiff.
      const double stabilised = modulus + entries.get_cell_volume_stabilisation(r);
      const double bare       = modulus - region.material.volumetric_stabilisation;
      result.wave_speed       = std::max(result.wave_speed, std::sqrt(stabilised / density));
      result.material_speed   = std::max(result.material_speed, std::sqrt(bare / density));
      result.spring_frequency =
          std::max(result.spring_frequency, std::sqrt(region.feedback_stiffness / density));
      const std::string remark = region.material.get_immersed_remark(path);
      if (!remark.empty())
        result.remarks.push_back(path + ": " + remark);
    }
    measure_room(result);
    return result;
  }

  template <int dim>
  void CaseCheck<dim>::measure_room(BodyOnGrid &body) const
  {
    const SolidBody<dim> &solid   = body.body.get_solid();
    const Point<dim>      lower   = parameters.domain.lower_corner;
    const Point<dim>      upper   = lower + parameters.domain.size;
    const Tensor<1, dim>  forward = -solid.get_initial_axis(0);
    const Expression<dim> initial_velocity("Fluid/Initial velocity",
                                           parameters.fluid.initial_velocity, dim);
    Point<dim>            first_node;
    for (unsigned int d = 0; d < dim; ++d)
      first_node[d] = solid.get_initial_positions()[solid.get_nodes().front()[d]];
    for (unsigned int d = 0; d < dim; ++d)
      body.adverse_current -= forward[d] * initial_velocity.value(first_node, d);
    body.nearest_side = body.room_ahead = std::numeric_limits<double>::infinity();
    for (const auto &node : solid.get_nodes())
      for (unsigned int d = 0; d < dim; ++d)
      {
        const double x = solid.get_initial_positions()[node[d]], below = x - lower[d],
                     above = upper[d] - x;
        body.nearest_side  = std::min({body.nearest_side, below, above});
        if (std::abs(forward[d]) > 1e-6)
          body.room_ahead =
              std::min(body.room_ahead, (forward[d] > 0 ? above : below) / std::abs(forward[d]));
      }
  }

  template <int dim>
  double CaseCheck<dim>::get_explicit_limit() const
  {
    // The spacing over the speed of the elastic waves, and the springs' stability limit.
    double limit = std::numeric_limits<double>::infinity();
    for (const BodyOnGrid &body : bodies)
    {
      if (body.wave_speed > 0)
        limit = std::min(limit, 0.5 * cell_size / body.wave_speed);
      if (body.spring_frequency > 0)
        limit = std::min(limit, 2 / body.spring_frequency);
    }
    return limit;
  }

  template <int dim>
  void CaseCheck<dim>::print_resolution(std::ostream &out) const
  {
    for (const BodyOnGrid &body : bodies)
    {
      const auto &lowest = body.resolution.lowest, &highest = body.resolution.highest;
      out << body.path << ": its first layer of elements is " << print_rounded(lowest.n_cells)
          << " of the fluid's finest cells high at (" << print_place(lowest.place) << ") along ("
          << print_axis(lowest.direction) << "), " << print_rounded(highest.n_cells) << " at ("
          << print_place(highest.place) << ") along (" << print_axis(highest.direction)
          << "); thickness of";
      for (unsigned int r = 0; r < body.get_regions().size(); ++r)
      {
        const CountedThickness<dim> &thinnest = body.resolution.thinnest[r];
        out << (r > 0 ? ", " : " ") << body.get_regions()[r] << ' ';
        if (!std::isfinite(thinnest.thickness))
        {
          out << "(inside)";
          continue;
        }
        out << print_rounded(thinnest.thickness) << " m = " << print_rounded(thinnest.n_cells)
            << " cells";
        if (kernel_width > 0)
          out << " = " << print_rounded(thinnest.thickness / kernel_width) << " kernel widths";
        out << " along (" << print_axis(thinnest.direction) << ')';
      }
      out << ".\n";
      // Sides that move with the grid leave no such room.
      if (body.swims() && !parameters.domain.has_moving_frame())
        out << body.path << ": " << print_rounded(body.room_ahead)
            << " m of room ahead, enough for "
            << print_rounded(body.room_ahead / parameters.time.end_time) << " m/s until the end.\n";
    }
    print_flow(out);
    out << "Steps: ";
    if (std::isfinite(get_explicit_limit()))
      out << "the explicit scheme takes about " << print_rounded(get_explicit_limit()) << " s; ";
    out << "with the semi-implicit one and " << print_rounded(parameters.time.step)
        << " s the flow may reach "
        << print_rounded(largest_cfl * 0.5 * cell_size / parameters.time.step) << " m/s, "
        << largest_cfl << " spacings a step, the most that was tried.\n";
  }

  template <int dim>
  void CaseCheck<dim>::print_flow(std::ostream &out) const
  {
    if (scales.speed == 0)
      return;
    if (!scales.is_guess)
      out << "Flow: U = " << print_rounded(scales.speed)
          << " m/s (of inflows, initial velocity, swimmers) and L = "
          << print_rounded(scales.length) << " m give Re = ";
    else
      out << "Flow: the beat, and so the speed, is a result. At one length a second, "
          << print_rounded(scales.speed) << " m/s, Re = ";
    out << print_rounded(scales.speed * scales.length / parameters.fluid.kinematic_viscosity)
        << "; the boundary layer grows to about " << print_rounded(get_boundary_layer())
        << " m = " << print_rounded(get_boundary_layer() / cell_size)
        << " of the finest cells. Grad-div stabilisation " << print_rounded(grad_div)
        << " m^2/s.\n";
  }

  template <int dim>
  void CaseCheck<dim>::print_costs(std::ostream &out, const StepCost &step) const
  {
    const double n_steps   = std::ceil(parameters.time.end_time / parameters.time.step);
    const double n_largest = parameters.refinement.largest_number_of_cells;
    const bool   grows     = parameters.refinement.vorticity_threshold > 0 && n_largest > n_cells;
    if (step.seconds > 0)
    {
      if (step.n_steps > 0)
        out << "Trial: " << step.n_steps << " steps, " << print_rounded(step.seconds)
            << " s of wall time each and " << print_rounded(step.memory) << " MiB. ";
      else
        out << "Estimate, by the numbers of unknowns: about " << print_rounded(step.seconds)
            << " s of wall time a step and " << print_rounded(step.memory) << " MiB. ";
      out << n_steps << " steps on these cells take about "
          << format_duration(n_steps * step.seconds);
      if (grows)
        out << ", "
            << format_duration(n_steps * step.seconds * std::pow(n_largest / n_cells, growth))
            << " on " << n_largest << ", the most that the wake may ask for";
      out << ".\n";
    }
    const double cells     = grows ? n_largest : n_cells;
    const double n_outputs = parameters.output.field_interval > 0
                                 ? parameters.time.end_time / parameters.output.field_interval
                                 : n_steps;
    const double bytes_of_fields =
        bytes_of_point * std::pow(parameters.output.n_subdivisions + 1., dim);
    out << "Disk: up to " << print_rounded((n_outputs + 1) * cells * bytes_of_fields / mebibyte)
        << " MiB for fields at " << std::floor(n_outputs + 1) << " times, "
        << print_rounded(parameters.checkpoint.n_slots * cells * bytes_of_checkpoint / mebibyte)
        << " MiB for checkpoints.\n";
  }

  template <int dim>
  bool CaseCheck<dim>::BodyOnGrid::is_free() const
  {
    const SolidBody<dim> &solid = body.get_solid();
    for (unsigned int dof = 0; dof < solid.n_dofs(); ++dof)
      if (solid.is_fixed(dof))
        return false;
    return spring_frequency == 0;
  }

  /**
   * The normal's number of a plane in the middle of the domain at which the body is its own mirror
   * image, and which no prescribed velocity crosses; dim if there is none.
   */
  template <int dim>
  unsigned int CaseCheck<dim>::find_mirror(const SolidBody<dim> &solid) const
  {
    std::vector<Point<dim>> nodes;
    for (const auto &node : solid.get_nodes())
      nodes.push_back(get_value(solid.get_initial_positions(), node));
    const double tolerance = 1e-6 * cell_size;
    const auto   precedes  = [&](const Point<dim> &a, const Point<dim> &b) {
      for (unsigned int d = 0; d < dim; ++d)
        if (std::abs(a[d] - b[d]) > tolerance)
          return a[d] < b[d];
      return false;
    };
    const std::set<Point<dim>, decltype(precedes)> places(nodes.begin(), nodes.end(), precedes);
    for (unsigned int d = 0; d < dim; ++d)
    {
      if (is_crossed[d])
        continue;
      const double middle = parameters.domain.lower_corner[d] + 0.5 * parameters.domain.size[d];
      if (std::all_of(nodes.begin(), nodes.end(), [&](Point<dim> node) {
            node[d] = 2 * middle - node[d];
            return places.count(node) > 0;
          }))
        return d;
    }
    return dim;
  }

  template class CaseCheck<2>;
  template class CaseCheck<3>;
} // namespace caudal
