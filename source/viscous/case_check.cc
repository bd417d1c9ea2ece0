// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/io/progress.h>
#include <caudal/mesh/body_grid.h>
#include <caudal/viscous/case_check.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>

namespace caudal
{
  namespace
  {
    // What was measured with Turek and Hron's flag (prm/benchmarks/README.md): three cells of the
    // fluid across it are enough, with two its lift is a fifth too large; body nodes much closer
    // than the fluid's cells make a body thicker, much wider ones leak.
    constexpr double least_thickness = 3;
    constexpr double finest_ratio = 0.6, coarsest_ratio = 1.7;
    // In FSI3 with steps of 5 ms, all whose figures are right.
    constexpr double largest_cfl = 7;

    // Bytes for a cell of the fluid in compressed .vtu files and in checkpoints, of prm/fish.prm.
    constexpr double bytes_of_fields = 95, bytes_of_checkpoint = 550;
    constexpr double mebibyte = 1024. * 1024.;

    // How the cost of a step grows with the number of cells.
    constexpr double growth = 1.2;

    // A fish at a Strouhal number of 0.3 with a tail that sweeps a fifth of its length swims
    // 0.2/0.3 lengths a beat (Triantafyllou et al. 1993, doi:10.1006/jfls.1993.1012).
    constexpr double lengths_per_beat = 0.2 / 0.3;

    std::string print(const double value)
    {
      std::ostringstream text;
      text << std::setprecision(3) << value;
      return text.str();
    }
  } // namespace

  template <int dim>
  CaseCheck<dim>::CaseCheck(const Operators<dim> &operators, const unsigned int n_cells)
      : parameters(operators.parameters)
      , n_cells(n_cells)
      , cell_size(2 * parameters.domain.get_finest_spacing().norm() / std::sqrt(dim))
      , kernel_width(2 * cell_size * operators.coupling.get_support())
  {
    for (const auto &body : operators.bodies)
      bodies.push_back(describe_body(*body));
  }

  template <int dim>
  typename CaseCheck<dim>::BodyOnGrid CaseCheck<dim>::describe_body(const Body<dim> &body) const
  {
    const SolidBody<dim>       &solid   = body.get_solid();
    const SolidParameters<dim> &entries = solid.get_parameters();
    const double                density = parameters.fluid.density + solid.get_excess_density();
    const double volume = solid.get_reference_volume() / solid.get_triangulation().n_active_cells();

    BodyOnGrid result{body, entries.get_path(),
                      compute_extent(solid.get_triangulation()).region_thickness};
    result.spacing_ratio = std::pow(volume, 1. / dim) / entries.polynomial_degree / cell_size;
    for (unsigned int r = 0; r < entries.regions.size(); ++r)
    {
      const RegionParameters<dim> &region  = *entries.region_parameters[r];
      const double                 modulus = region.cell_volume_stabilisation +
                             region.material.get_wave_modulus(entries.get_region_path(r));
      result.wave_speed = std::max(result.wave_speed, std::sqrt(modulus / density));
      result.spring_frequency =
          std::max(result.spring_frequency, std::sqrt(region.feedback_stiffness / density));
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
      out << body.path << ": its nodes are " << print(body.spacing_ratio)
          << " of the fluid's finest cells apart; thickness of";
      for (unsigned int r = 0; r < body.get_regions().size(); ++r)
      {
        out << (r > 0 ? ", " : " ") << body.get_regions()[r] << ' ' << print(body.thickness[r])
            << " m = " << print(body.thickness[r] / cell_size) << " cells";
        if (kernel_width > 0)
          out << " = " << print(body.thickness[r] / kernel_width) << " kernel widths";
      }
      out << ".\n";
      if (body.swims())
        out << body.path << ": " << print(body.room_ahead) << " m of room ahead, enough for "
            << print(body.room_ahead / parameters.time.end_time) << " m/s until the end.\n";
    }
    out << "Steps: ";
    if (std::isfinite(get_explicit_limit()))
      out << "the explicit scheme takes about " << print(get_explicit_limit()) << " s; ";
    out << "with the semi-implicit one and " << print(parameters.time.step)
        << " s the flow may reach " << print(largest_cfl * 0.5 * cell_size / parameters.time.step)
        << " m/s, " << largest_cfl << " spacings a step, the most that was tried.\n";
  }

  template <int dim>
  void CaseCheck<dim>::print_costs(std::ostream &out, const TrialCost &trial) const
  {
    const double n_steps   = std::ceil(parameters.time.end_time / parameters.time.step);
    const double n_largest = parameters.refinement.largest_number_of_cells;
    const bool   grows     = parameters.refinement.vorticity_threshold > 0 && n_largest > n_cells;
    if (trial.n_steps > 1)
    {
      out << "Trial: " << trial.n_steps << " steps, " << print(trial.seconds)
          << " s of wall time each and " << print(trial.memory) << " MiB. " << n_steps
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
    out << "Disk: up to " << print((n_outputs + 1) * cells * bytes_of_fields / mebibyte)
        << " MiB for fields at " << std::floor(n_outputs + 1) << " times, "
        << print(parameters.checkpoint.n_slots * cells * bytes_of_checkpoint / mebibyte)
        << " MiB for checkpoints.\n";
  }

  template <int dim>
  std::vector<std::string> CaseCheck<dim>::find_warnings() const
  {
    std::vector<std::string> warnings;
    add_thickness_warnings(warnings);
    add_domain_warnings(warnings);
    add_wake_warnings(warnings);
    return warnings;
  }

  template <int dim>
  void CaseCheck<dim>::add_thickness_warnings(std::vector<std::string> &warnings) const
  {
    for (const BodyOnGrid &body : bodies)
    {
      for (unsigned int r = 0; r < body.get_regions().size(); ++r)
      {
        const std::string region = body.path + ": region " + body.get_regions()[r] + " is " +
                                   print(body.thickness[r]) + " m thick at its thinnest, ";
        if (body.thickness[r] < kernel_width)
          warnings.push_back(
              region + "less than the width " + print(kernel_width) +
              " m of the kernel: it acts as if it were thicker. Use a narrower kernel "
              "(Coupling/Kernel = dirac) or a finer grid (Domain/Levels).");
        else if (body.thickness[r] < least_thickness * cell_size)
          warnings.push_back(
              region + "less than " + print(least_thickness) +
              " cells of the fluid: the flow round it is not resolved there. Use a "
              "finer grid (Domain/Levels), or compare with one to see what it costs.");
      }
      if (body.spacing_ratio > coarsest_ratio)
        warnings.push_back(
            body.path + "/Shape/Elements: the body's nodes are " + print(body.spacing_ratio) +
            " of the fluid's finest cells apart: fluid may leak through it. Give more.");
      if (body.spacing_ratio < finest_ratio)
        warnings.push_back(
            body.path + "/Shape/Elements: the body's nodes are " + print(body.spacing_ratio) +
            " of the fluid's finest cells apart: more motions than the fluid has make "
            "the body thicker. Give fewer.");
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
                           print(body.nearest_side) + " m away, less than a body length (" +
                           print(body.body.get_length()) +
                           " m): the body feels it. Move the body or change Domain/Size.");
      const double distance = lengths_per_beat * body.body.get_length() *
                              body.body.get_beat_frequency() * parameters.time.end_time;
      if (distance > body.room_ahead)
        warnings.push_back("Time/End time: at " + print(lengths_per_beat) + " lengths a beat " +
                           body.path + " swims " + print(distance) + " m, and there are " +
                           print(body.room_ahead) +
                           " m ahead of it. Make the domain longer (Domain/Size) or end earlier.");
      if (body.body.get_beat_frequency() * parameters.time.step > 0.02)
        warnings.push_back("Time/Step: " + print(parameters.time.step) +
                           " s are less than 50 steps a beat of " + body.path +
                           ". Give a smaller step.");
    }
  }

  template <int dim>
  void CaseCheck<dim>::add_wake_warnings(std::vector<std::string> &warnings) const
  {
    const RefinementParameters &refinement = parameters.refinement;
    if (std::none_of(bodies.begin(), bodies.end(),
                     [](const BodyOnGrid &body) { return body.swims(); }))
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

  template class CaseCheck<2>;
  template class CaseCheck<3>;
} // namespace caudal
