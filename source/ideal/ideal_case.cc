// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/number_table.h>
#include <caudal/ideal/bending_body.h>
#include <caudal/ideal/ideal_case.h>
#include <caudal/ideal/mesh_body.h>
#include <caudal/ideal/swim_summary.h>

#include <algorithm>

namespace caudal
{
  using namespace ideal;

  namespace
  {
    std::unique_ptr<StraightBody> make_straight_body(const IdealParameters &parameters,
                                                     const Surface         &surface)
    {
      if (surface.is_from_file())
        return std::make_unique<MeshBody>(surface);
      return parameters.body.shape.make_straight_body(parameters.get_body_path() + "/Shape");
    }
  } // namespace

  IdealCase::IdealCase(const IdealParameters &parameters)
      : parameters(parameters)
      , surface(parameters.surface, parameters.body.shape.type.get().get_file())
      , straight_body(make_straight_body(parameters, surface))
      , gait(parameters.body.gait.create(straight_body->get_length()))
      , deformation(std::make_unique<BendingBody>(surface, *straight_body, *gait))
  {
    check_table_times(parameters.get_body_path(), "Gait", 0., gait->get_end(),
                      parameters.time.end_time);
    const double bend = compute_largest_bend(256);
    AssertThrow(bend < 1.,
                ExcMessage("Gait: the body would intersect itself, since its width relative to "
                           "the room that the bend leaves (half-width times curvature, or two "
                           "half-widths over their distance) reaches " +
                           std::to_string(bend) +
                           " and has to stay below 1. Reduce the gait's Amplitude, Curvature "
                           "or Bias, or the half-widths in section Shape."));
  }

  double IdealCase::compute_largest_bend(const unsigned int n_samples) const
  {
    const double end  = gait->is_periodic() ? 2. * numbers::PI : parameters.time.end_time;
    double       bend = 0.;
    for (unsigned int k = 0; k < n_samples; ++k)
      bend = std::max(bend, deformation->compute_bend(gait->evaluate(end * k / n_samples).c));
    return bend;
  }

  Torques IdealCase::get_torques() const
  {
    if (!parameters.integration.torques || is_rigid())
      return Torques::none;
    return is_from_rest() ? Torques::from_rest : Torques::any;
  }

  double IdealCase::compute_volume() const
  {
    return deformation->compute_body_mass(gait->evaluate(0.).c)(3, 3);
  }

  void IdealCase::print_summary(std::ostream &out) const
  {
    const double n         = surface.n_nodes();
    const bool   is_halved = has_glide_symmetry(*gait) && deformation->is_symmetric();
    out << "Swimmer in an ideal fluid\n"
        << "  surface   " << surface.n_cells() << " curved quadrilaterals, " << n
        << " panels (unknowns of the potential), matrix of " << n * n * 8 / 1048576. << " MiB\n"
        << "  body      length " << deformation->get_length() << " m, volume " << compute_volume()
        << " m^3, mass " << compute_mass() << " kg, " << deformation->n_modes()
        << " modes of deformation\n"
        << "  bend      width over the room that the bend leaves up to " << compute_largest_bend(64)
        << " (limit 1)\n"
        << "  method    ";
    if (uses_table())
      out << "table of " << parameters.integration.n_phases << " phases"
          << (is_halved ? ", half of them mirrored" : "");
    else
      out << "brute force, a new surface at each time";
    out << "\n" << get_ideal_fluid_statement();
    if (parameters.integration.method == "table" && !gait->is_periodic())
      out << "Note: the gait has no period, so that there can't be a table; a new surface is\n"
             "computed at each time.\n";
    if (get_torques() == Torques::any)
      out << "Note: torques and powers take several times as long as all the rest, as the body\n"
             "does not start from rest or Resistance is active; Integration/Torques = false saves\n"
             "them.\n";
    if (!is_rigid() && is_reciprocal(*gait))
      out << "Warning: the stroke is reciprocal (its second half is the first one played\n"
             "backwards), and from rest such a stroke can't swim: each shape is passed in both\n"
             "directions, which cancels the motion exactly (Purcell's argument). Give "
             "Gait/Wave\nnumber a value that is not zero.\n";
  }
} // namespace caudal
