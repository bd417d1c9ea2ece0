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
    // In FSI3 with steps of 5 ms, all whose figures are right.
    constexpr double largest_cfl = 7;

    // Bytes for a cell of the fluid in compressed .vtu files and in checkpoints, of prm/fish.prm.
    constexpr double bytes_of_fields = 95, bytes_of_checkpoint = 550;
    constexpr double mebibyte = 1024. * 1024.;

    // How the cost of a step grows with the number of cells.
    constexpr double growth = 1.2;

    // A boundary layer is 5 L/Re^(1/2) thick at the end of a plate (Blasius 1908).
    constexpr double layer_thickness = 5;

    // Grad-div terms larger than U L/10 by this factor slow down a fish by a tenth or more.
    constexpr double largest_grad_div = 5;

    // Smaller changes of outflows are errors of interpolation.
    constexpr double least_outflow_change = 1e-6;

    // Bodies that are lighter or heavier than the fluid by such factors are likely a wrong unit.
    constexpr double largest_density_ratio = 50;

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
      : parameters(operators.parameters)
      , scales(operators.scales)
      , grad_div(operators.space.get_grad_div())
      , outflow_change(check_boundary_flux(operators.space, operators.parameters.time.end_time))
      , n_cells(n_cells)
      , cell_size(get_finest_cell(parameters.domain))
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
      const double stabilised = modulus + region.cell_volume_stabilisation;
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
      out << body.path << ": its nodes are " << print_rounded(body.resolution.spacing_ratio)
          << " of the fluid's finest cells apart; thickness of";
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
      if (body.swims())
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
  void CaseCheck<dim>::print_costs(std::ostream &out, const TrialCost &trial) const
  {
    const double n_steps   = std::ceil(parameters.time.end_time / parameters.time.step);
    const double n_largest = parameters.refinement.largest_number_of_cells;
    const bool   grows     = parameters.refinement.vorticity_threshold > 0 && n_largest > n_cells;
    if (trial.n_steps > 1)
    {
      out << "Trial: " << trial.n_steps << " steps, " << print_rounded(trial.seconds)
          << " s of wall time each and " << print_rounded(trial.memory) << " MiB. " << n_steps
          << " steps on these cells take about " << format_duration(n_steps * trial.seconds);
      if (grows)
        out << ", "
            << format_duration(n_steps * trial.seconds * std::pow(n_largest / n_cells, growth))
            << " on " << n_largest << ", the most that the wake may ask for";
      out << ".\n";
    }
    const double cells     = grows ? n_largest : n_cells;
    const double n_outputs = parameters.output.field_interval > 0
                                 ? parameters.time.end_time / parameters.output.field_interval
                                 : n_steps;
    out << "Disk: up to " << print_rounded((n_outputs + 1) * cells * bytes_of_fields / mebibyte)
        << " MiB for fields at " << std::floor(n_outputs + 1) << " times, "
        << print_rounded(parameters.checkpoint.n_slots * cells * bytes_of_checkpoint / mebibyte)
        << " MiB for checkpoints.\n";
  }

  template <int dim>
  std::vector<std::string> CaseCheck<dim>::find_warnings() const
  {
    std::vector<std::string> warnings;
    for (const BodyOnGrid &body : bodies)
      warnings.insert(warnings.end(), body.remarks.begin(), body.remarks.end());
    add_thickness_warnings(warnings);
    add_domain_warnings(warnings);
    add_wake_warnings(warnings);
    add_flow_warnings(warnings);
    add_body_warnings(warnings);
    return warnings;
  }

  template <int dim>
  void CaseCheck<dim>::add_thickness_warnings(std::vector<std::string> &warnings) const
  {
    for (const BodyOnGrid &body : bodies)
    {
      if (body.swims() && body.resolution.typical.n_cells < thinnest_meaningful)
        warnings.push_back(body.path +
                           ": RESULTS MEAN NOTHING: most of the body is thinner than "
                           "half a cell of the fluid (Coupling/Accept unresolved bodies).");
      else if (body.swims() && body.resolution.typical.n_cells < 1)
        warnings.push_back(body.path + ": most of the body is thinner than a cell of the fluid, " +
                           print_rounded(body.resolution.typical.thickness) +
                           " m: forces and speeds can be wrong by a factor of four. Use a finer "
                           "grid (Domain/Levels).");
      for (unsigned int r = 0; r < body.get_regions().size(); ++r)
      {
        const CountedThickness<dim> &thinnest = body.resolution.thinnest[r];
        const std::string region = body.path + ": region " + body.get_regions()[r] + " is " +
                                   print_rounded(thinnest.thickness) + " m thick at its thinnest, ";
        if (thinnest.thickness < kernel_width)
          warnings.push_back(
              region + "less than the width " + print_rounded(kernel_width) +
              " m of the kernel: it acts as if it were thicker. Use a narrower kernel "
              "(Coupling/Kernel = dirac) or a finer grid (Domain/Levels).");
        else if (thinnest.n_cells < least_thickness)
          warnings.push_back(
              region + "less than " + print_rounded(least_thickness) +
              " cells of the fluid: the flow round it is not resolved there. Use a "
              "finer grid (Domain/Levels), or compare with one to see what it costs.");
      }
      if (body.resolution.spacing_ratio > coarsest_ratio)
        warnings.push_back(
            body.path + "/Shape/Elements: the body's nodes are " +
            print_rounded(body.resolution.spacing_ratio) +
            " of the fluid's finest cells apart: fluid may leak through it. Give more.");
      if (body.resolution.spacing_ratio < finest_ratio)
        warnings.push_back(
            body.path + "/Shape/Elements: the body's nodes are " +
            print_rounded(body.resolution.spacing_ratio) +
            " of the fluid's finest cells apart: more motions than the fluid has make "
            "the body thicker, and the solver may fail. Give fewer.");
    }
  }

  template <int dim>
  void CaseCheck<dim>::add_domain_warnings(std::vector<std::string> &warnings) const
  {
    for (const BodyOnGrid &body : bodies)
    {
      if (!body.swims())
        continue;
      if (body.nearest_side < body.body.get_length())
        warnings.push_back(body.path + "/Shape/Position: a side of the domain is " +
                           print_rounded(body.nearest_side) + " m away, less than a body length (" +
                           print_rounded(body.body.get_length()) +
                           " m): the body feels it. Move the body or change Domain/Size.");
      const double speed    = estimate_swimming_speed(body.body);
      const double distance = speed * parameters.time.end_time;
      if (distance > body.room_ahead)
        warnings.push_back("Time/End time: at " + print_rounded(speed) + " m/s " + body.path +
                           " swims " + print_rounded(distance) + " m, and there are " +
                           print_rounded(body.room_ahead) +
                           " m ahead of it. Make the domain longer (Domain/Size) or end earlier.");
      if (body.body.get_beat_frequency() * parameters.time.step > 0.02)
        warnings.push_back("Time/Step: " + print_rounded(parameters.time.step) +
                           " s are less than 50 steps a beat of " + body.path +
                           ". Give a smaller step.");
    }
  }

  template <int dim>
  void CaseCheck<dim>::add_wake_warnings(std::vector<std::string> &warnings) const
  {
    const RefinementParameters &refinement = parameters.refinement;
    if (!has_swimmers())
      return;
    if (refinement.vorticity_threshold == 0)
      warnings.push_back("Refinement/Vorticity threshold is 0: the grid does not follow the wake. "
                         "Give a threshold, such as a tenth of the speed.");
    else if (n_cells > 0.95 * refinement.largest_number_of_cells)
      warnings.push_back(
          "Refinement/Largest number of cells: there are " +
          std::to_string(static_cast<unsigned int>(n_cells)) +
          " at the start already, so that none are left for the wake. Give more than " +
          std::to_string(refinement.largest_number_of_cells) + ".");
  }

  template <int dim>
  bool CaseCheck<dim>::has_swimmers() const
  {
    return std::any_of(bodies.begin(), bodies.end(),
                       [](const BodyOnGrid &body) { return body.swims(); });
  }

  template <int dim>
  double CaseCheck<dim>::get_boundary_layer() const
  {
    return layer_thickness *
           std::sqrt(parameters.fluid.kinematic_viscosity * scales.length / scales.speed);
  }

  template <int dim>
  void CaseCheck<dim>::add_flow_warnings(std::vector<std::string> &warnings) const
  {
    if (outflow_change > least_outflow_change)
      warnings.push_back(
          "Fluid/Boundary conditions: what the prescribed velocities let in and what they "
          "let out differ by up to " +
          print_rounded(100 * outflow_change) + " %. The outflow is scaled so that they agree.");
    if (scales.speed == 0)
      return;
    if (!bodies.empty() && get_boundary_layer() < cell_size)
      warnings.push_back(
          "Domain/Levels: the boundary layer, about " + print_rounded(get_boundary_layer()) +
          " m thick" + (scales.is_guess ? " at one length a second" : "") +
          ", is thinner than a cell: friction and separation will be those of the grid, "
          "not of Fluid/Kinematic viscosity. Use finer cells or a larger viscosity.");
    const double usual = scales.get_grad_div();
    if (has_swimmers() && grad_div > largest_grad_div * usual)
      warnings.push_back("Fluid/Grad-div stabilisation: " + print_rounded(grad_div) +
                         " m^2/s are far more than a tenth of speed times length, " +
                         print_rounded(usual) +
                         ": they slow the body down. Give automatic, or that.");
    const double spacings = scales.speed * parameters.time.step / (0.5 * cell_size);
    if (spacings > largest_cfl)
      warnings.push_back("Time/Step: at " + print_rounded(scales.speed) + " m/s the flow passes " +
                         print_rounded(spacings) + " spacings of the grid in a step, and " +
                         print_rounded(largest_cfl) + " are the most that was tried. Give " +
                         print_rounded(parameters.time.step * largest_cfl / spacings) +
                         " s or less.");
  }

  template <int dim>
  void CaseCheck<dim>::add_body_warnings(std::vector<std::string> &warnings) const
  {
    for (const BodyOnGrid &body : bodies)
    {
      const SolidBody<dim> &solid = body.body.get_solid();
      const double          ratio = solid.get_parameters().density / parameters.fluid.density;
      if (ratio > 0 && (ratio > largest_density_ratio || ratio < 1 / largest_density_ratio))
        warnings.push_back(body.path + "/Density: it is " + print_rounded(ratio) +
                           " of the fluid's. If that is not meant, give it in kg/m^3.");
      if (body.material_speed > 0 && body.material_speed < scales.speed)
        warnings.push_back(body.path + ": elastic waves run through it at " +
                           print_rounded(body.material_speed) + " m/s, slower than the flow of " +
                           print_rounded(scales.speed) +
                           " m/s, to which it gives way like a fluid. If that is not meant, give "
                           "its moduli in Pa.");
      const unsigned int mirror = find_mirror(solid);
      if (mirror < dim && body.is_free() && !body.swims() && solid.get_excess_density() != 0 &&
          solid.get_parameters().traction.empty())
      {
        std::string push;
        for (unsigned int d = 0; d < dim; ++d)
          push += (d > 0 ? "; " : "") + std::string(d == mirror ? "if(t < 0.1, 1e-3, 0)" : "0");
        warnings.push_back(
            body.path +
            " is free and lies symmetrically in the domain: so its wake stays, and "
            "a body that would swerve does not, and is too fast. Give it a small push "
            "by the entry Traction, such as <" +
            push + "> Pa.");
      }
      if (body.body.has_gait() && body.body.has_muscle())
        warnings.push_back(body.path +
                           "/Muscle/Type: the body follows its gait whatever the muscle does. Set "
                           "it to none, or Gait/Type.");
    }
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
