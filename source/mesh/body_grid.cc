// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/patterns.h>

#include <caudal/base/parameter_text.h>
#include <caudal/mesh/body_grid.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace caudal
{
  template <int dim>
  void BodyGridParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Shape");
    shape.add_entries(prm);
    prm.add_parameter(
        "Elements", elements,
        "automatic: elements 1.25 of the fluid's finest cells high at the surface (of degree 2: "
        "2), one across where the body is thinner than 1.6 of that. Or the number of elements "
        "along and across the body (3D: along, across, in the third direction); round and across "
        "the wall of ring; of the flag alone. The round nose of naca and eel and the round ends of "
        "stations add a few. Of disc, ellipse and ellipsoid only the product counts: they get "
        "about that many elements.",
        Patterns::Anything());
    prm.add_parameter(
        "Position", position,
        "Where the origin of the shape is put at the start [m]: nose of naca, eel, stations and "
        "ellipsoid, middle of the root edge of beam, centre of disc, cylinder, ellipse, ring and "
        "rectangle, origin of the vertices or of the mesh from a file.");
    prm.add_parameter("Rotation", rotation,
                      "Angle from the x axis to the axis of the shape, about its origin "
                      "(3D: about z), counter-clockwise [degrees].",
                      Patterns::Double());
    prm.add_parameter("Region boundaries", region_boundaries,
                      "Places, as increasing fractions of the length, that separate the regions of "
                      "the body, from the front (low x) to the back; none: one region. Not for the "
                      "types file and cylinder with flag.",
                      Patterns::List(Patterns::Double(0., 1.), 0));
    prm.leave_subsection();
  }

  template <int dim>
  std::vector<RenamedEntry> BodyGridParameters<dim>::get_renamed_entries()
  {
    const std::string section = "Body */Shape/";
    return {{section + "NACA digits", section + "Naca/Digits"},
            {section + "Wall thickness", section + "Ring/Wall thickness"},
            {section + "Vertices", section + "Quadrilateral/Vertices"},
            {section + "File", section + "File/Name"}};
  }

  template <int dim>
  void BodyGridParameters<dim>::check(const std::string &path) const
  {
    const std::string section = path + "/Shape", entries = section + "/";
    const Shape<dim> &type = shape.type.get();
    AssertThrow(
        type.has_grid(),
        ExcMessage(entries + "Type: the shape <" + shape.type.get_name() + "> is available in " +
                   std::to_string(5 - dim) + "D only. Choose one of " +
                   list_shapes<dim>([](const Shape<dim> &s) { return s.has_grid(); }) + "."));

    const GridDivisions divisions = get_divisions(0., path);
    for (unsigned int i = 0; i < region_boundaries.size(); ++i)
      AssertThrow(region_boundaries[i] > (i == 0 ? 0. : region_boundaries[i - 1]) &&
                      region_boundaries[i] < 1.,
                  ExcMessage(entries +
                             "Region boundaries: " + Patterns::Tools::to_string(region_boundaries) +
                             " does not increase between 0 and 1. Give increasing fractions of "
                             "the length, without its ends."));
    AssertThrow(type.get_region_entry() != "" || divisions.is_automatic() ||
                    divisions.elements[0] > region_boundaries.size(),
                ExcMessage(entries + "Elements: " + std::to_string(divisions.elements[0]) +
                           " along the body are fewer than its " +
                           std::to_string(region_boundaries.size() + 1) +
                           " regions. Give one for each at least."));
    shape.check(section);
    type.check_divisions(shape.lengths, divisions, section);
  }

  template <int dim>
  GridDivisions BodyGridParameters<dim>::get_divisions(const double       spacing,
                                                       const std::string &path) const
  {
    GridDivisions divisions{{}, spacing, region_boundaries};
    if (has_automatic_elements())
      return divisions;
    const std::string numbers = write_out_whole_numbers(elements);
    AssertThrow(Patterns::List(Patterns::Integer(1), dim, dim).match(numbers),
                ExcMessage(path + "/Shape/Elements: the value is <" + elements + ">. Give " +
                           std::to_string(dim) + " numbers separated by commas, or automatic."));
    divisions.elements = Patterns::Tools::Convert<std::vector<unsigned int>>::to_value(numbers);
    return divisions;
  }

  namespace
  {
    /** The material id of each region, by the names that the grid has for them. */
    std::map<types::material_id, unsigned int> match_names(const GroupNames               &names,
                                                           const std::vector<std::string> &regions,
                                                           const std::string              &entry)
    {
      std::map<types::material_id, unsigned int> numbers;
      std::string                                known;
      for (const auto &[id, name] : names)
      {
        known += (known.empty() ? "" : ", ") + name;
        const auto region = std::find(regions.begin(), regions.end(), name);
        if (region != regions.end())
          numbers[id] = region - regions.begin();
      }
      AssertThrow(
          numbers.size() == regions.size() && numbers.size() == names.size(),
          ExcMessage(
              entry + ": the groups of the mesh are called " + known +
              ", and the body's regions otherwise. Give Regions with these names, that of the "
              "head first."));
      return numbers;
    }

    /** Renumbers the material ids to the numbers of the regions: by names, else in order. */
    template <int dim>
    void number_regions(Triangulation<dim> &tria, const std::vector<std::string> &regions,
                        const GroupNames &names, const std::string &entry)
    {
      const unsigned int           n_regions = regions.size();
      std::set<types::material_id> ids;
      for (const auto &cell : tria.active_cell_iterators())
        ids.insert(cell->material_id());
      AssertThrow(ids.size() == n_regions,
                  ExcMessage(entry + ": the grid has cells of the regions " +
                             Patterns::Tools::to_string(ids) +
                             " (material ids), but the body has " + std::to_string(n_regions) +
                             " regions. Make the two agree."));
      std::map<types::material_id, unsigned int> numbers;
      for (const types::material_id id : ids)
        numbers.emplace(id, numbers.size());
      if (n_regions > 1 && !names.empty())
      {
        numbers = match_names(names, regions, entry);
        for (const types::material_id id : ids)
          AssertThrow(numbers.count(id) > 0,
                      ExcMessage(entry + ": the group " + std::to_string(id) +
                                 " of cells has no name, and others have. Name all groups of "
                                 "cells, or none."));
      }
      for (const auto &cell : tria.active_cell_iterators())
        cell->set_material_id(numbers.at(cell->material_id()));
    }
  } // namespace

  template <int dim>
  void make_body_grid(Triangulation<dim> &tria, const BodyGridParameters<dim> &parameters,
                      const double spacing, const std::vector<std::string> &regions,
                      const std::string &path)
  {
    const unsigned int n_regions = regions.size();
    parameters.check(path);
    const Shape<dim>  &shape        = parameters.shape.type.get();
    const std::string  entries      = path + "/Shape/";
    const bool         divided      = shape.get_region_entry() != "";
    const unsigned int n_boundaries = parameters.region_boundaries.size();
    AssertThrow(
        n_boundaries == (divided ? 0 : n_regions - 1),
        ExcMessage(
            entries + "Region boundaries: there are " + std::to_string(n_boundaries) +
            ", but the body has " + std::to_string(n_regions) + " regions. Give " +
            (divided ? "none, as a " + parameters.shape.type.get_name() + " has regions of its own."
                     : "one fewer than regions.")));

    shape.make_grid(parameters.shape.lengths, parameters.get_divisions(spacing, path),
                    path + "/Shape", tria);
    tria.reset_all_manifolds();
    tria.set_all_manifold_ids(numbers::flat_manifold_id);

    number_regions(tria, regions, shape.get_group_names(),
                   entries + (divided ? shape.get_region_entry() : "Region boundaries"));
    AssertThrow(compute_min_scaled_jacobian(tria) > 0.,
                ExcMessage(entries + shape.get_grid_entry() +
                           ": the grid has inverted or non-convex cells (scaled Jacobian " +
                           std::to_string(compute_min_scaled_jacobian(tria)) +
                           "). Give a better one."));
  }

  template <int dim>
  Point<dim> place_in_domain(const BodyGridParameters<dim> &parameters,
                             const Point<dim>              &reference_point)
  {
    const double angle = parameters.rotation * numbers::PI / 180.;
    const double c = std::cos(angle), s = std::sin(angle);

    Point<dim> rotated = reference_point;
    rotated[0]         = c * reference_point[0] - s * reference_point[1];
    rotated[1]         = s * reference_point[0] + c * reference_point[1];
    return parameters.position + rotated;
  }

  template struct BodyGridParameters<2>;
  template struct BodyGridParameters<3>;

  template void make_body_grid(Triangulation<2> &, const BodyGridParameters<2> &, double,
                               const std::vector<std::string> &, const std::string &);
  template void make_body_grid(Triangulation<3> &, const BodyGridParameters<3> &, double,
                               const std::vector<std::string> &, const std::string &);

  template Point<2> place_in_domain(const BodyGridParameters<2> &, const Point<2> &);
  template Point<3> place_in_domain(const BodyGridParameters<3> &, const Point<3> &);
} // namespace caudal
