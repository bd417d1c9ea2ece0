// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/print.h>
#include <caudal/viscous/case_check.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  namespace
  {
    // A boundary layer is 5 L/Re^(1/2) thick at the end of a plate (Blasius 1908).
    constexpr double layer_thickness = 5;

    // Grad-div terms larger than U L/10 by this factor slow down a fish by a tenth or more.
    constexpr double largest_grad_div = 5;

    // In CFD3 (prm/benchmarks) 0.04 U^2 dt lead to another flow, 0.2 to the right one.
    constexpr double least_grad_div = 0.1;

    // Smaller changes of outflows are errors of interpolation.
    constexpr double least_outflow_change = 1e-6;

    // Bodies that are lighter or heavier than the fluid by such factors are likely a wrong unit.
    constexpr double largest_density_ratio = 50;

    /** Whether nothing passes a side whose normal is along @p axis, but flow along it is free. */
    template <int dim>
    bool slips(const BoundaryCondition<dim> &side, const unsigned int axis)
    {
      const ComponentMask prescribed = side.get_prescribed_components(axis);
      return prescribed[axis] && prescribed.n_selected_components() < dim;
    }
  } // namespace

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
    for (const std::string &warning : find_cost_warnings(operators))
      warnings.push_back(warning);
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
      add_layer_warnings(body, warnings);
    }
  }

  template <int dim>
  void CaseCheck<dim>::add_layer_warnings(const BodyOnGrid         &body,
                                          std::vector<std::string> &warnings) const
  {
    const double least_share = 0.1; // of the surface: a tail may end in less
    const auto   warn = [&](const double share, const std::string &relation, const double limit,
                          const LayerHeight<dim> &worst, const std::string &consequence) {
      if (share > least_share)
        warnings.push_back(body.path + "/Shape/Elements: on " + print_rounded(100 * share) +
                             " % of the surface the first layer of elements is " + relation + ' ' +
                             print_rounded(limit) + " of the fluid's finest cells high, " +
                             print_rounded(worst.n_cells) + " at (" + print_place(worst.place) +
                             "): " + consequence + ", or automatic.");
    };
    warn(body.resolution.share_too_low, "less than", body.resolution.least_height,
         body.resolution.lowest,
         "more motions than the fluid has make the body thicker, and the solver may fail. Give "
         "fewer");
    warn(body.resolution.share_too_high, "more than", body.resolution.most_height,
         body.resolution.highest, "the wall acts further inside than it is. Give more");

    const SolidParameters<dim> &entries = body.body.get_solid().get_parameters();
    const double                unit = parameters.fluid.get_viscosity() / (cell_size * cell_size);
    const auto warn_of_damping       = [&](const std::string &entry, const double damping) {
      if (damping > 0 && damping < least_damping * unit)
        warnings.push_back(entry + ": " + print_rounded(damping) + " N s/m^4 are " +
                                 print_rounded(damping / unit) +
                                 " mu/h^2, h the fluid's finest cells, "
                                       "and the fluid moves through what is held by less than " +
                                 print_rounded(least_damping) + " of them. Give " +
                                 print_rounded(least_damping * unit) + " or more.");
    };
    for (unsigned int r = 0; r < entries.regions.size(); ++r)
      if (entries.region_parameters[r]->is_fixed())
        warn_of_damping(entries.get_region_path(r) + "/Feedback damping",
                        entries.region_parameters[r]->feedback_damping);
    if (body.body.has_gait())
      warn_of_damping(body.path + "/Gait damping", body.body.get_gait_damping());
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
      const double speed    = estimate_swimming_speed(body.body) - body.adverse_current;
      const double distance = speed * parameters.time.end_time;
      if (!parameters.domain.has_moving_frame() && distance > body.room_ahead)
        warnings.push_back(
            "Time/End time: at " + print_rounded(speed) + " m/s" +
            (body.adverse_current != 0 ? " over the ground " : " ") + body.path + " swims " +
            print_rounded(distance) + " m, and there are " + print_rounded(body.room_ahead) +
            " m ahead of it. Make the domain longer (Domain/Size), end earlier, or let it "
            "follow (Domain/Frame).");
      if (body.body.get_beat_frequency() * parameters.time.step > 0.02)
        warnings.push_back("Time/Step: " + print_rounded(parameters.time.step) +
                           " s are less than 50 steps a beat of " + body.path +
                           ". Give a smaller step.");
    }
    const auto &domain = parameters.domain;
    std::string open_sides;
    for (unsigned int side = 0; side < 2 * dim; ++side)
      if (domain.has_moving_frame() && !domain.is_periodic(side / 2) &&
          slips(parameters.fluid.sides[side].get(), side / 2))
        open_sides += (open_sides.empty() ? "" : ", ") + get_side_names(dim)[side];
    if (!open_sides.empty())
      warnings.push_back(
          "Fluid/Boundary conditions: where the grid moves (Domain/Frame) into fluid "
          "through a side (" +
          open_sides +
          "), free slip leaves open how fast that fluid goes along the side: the "
          "flow there may grow without a limit. Take wall where the fluid ahead is "
          "at rest.");
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
    for (const auto &side : parameters.fluid.sides)
      if (parameters.fluid.gravity.norm() > 0. && side.get().resists_backflow())
        warnings.push_back("Fluid/Gravity: the fluid falls out of a side without traction, " +
                           side.get_path("Fluid/Boundary conditions") +
                           ". Give that side the pressure of the fluid outside (pressure).");
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
    const double least = least_grad_div * scales.speed * scales.speed * parameters.time.step;
    if (!bodies.empty() && !has_swimmers() && grad_div < least)
      warnings.push_back(
          "Fluid/Grad-div stabilisation: " + print_rounded(grad_div) +
          " m^2/s are less than a tenth of speed^2 times step, " + print_rounded(least) +
          ": with so little the flow round a body that is held was seen to turn into "
          "another one, with half as much drag again. Give more, or a smaller "
          "Time/Step.");
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

#define INSTANTIATE(dim)                                                                           \
  template std::vector<std::string> CaseCheck<dim>::find_warnings() const;                         \
  template bool                     CaseCheck<dim>::has_swimmers() const;                          \
  template double                   CaseCheck<dim>::get_boundary_layer() const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
