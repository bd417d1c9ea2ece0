// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/fish/body_function.h>
#include <caudal/fish/muscle.h>

namespace caudal
{
  template <int dim>
  void Muscle<dim>::set_up(const SharedMuscleParameters &shared, const double body_length,
                           const std::map<std::string, types::material_id> &region_ids)
  {
    length = body_length;
    ramp   = shared.ramp;
    std::string known;
    for (const auto &region : region_ids)
      known += (known.empty() ? "" : ", ") + region.first;
    for (const std::string &name : shared.regions)
    {
      const auto region = region_ids.find(name);
      AssertThrow(region != region_ids.end(),
                  ExcMessage("Muscle/Regions: the body has no region called <" + name +
                             ">. Its regions are: " + known + "."));
      active_regions.insert(region->second);
    }
  }

  template <int dim>
  void Muscle<dim>::check_memory(const MuscleMemory &memory) const
  {
    AssertThrow(memory.size() == get_initial_memory().size(),
                ExcMessage("The checkpoint holds the state of another muscle. Resume with the "
                           "parameters that wrote it."));
  }

  template <int dim>
  void MuscleParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Muscle");
    type.add_parameters(prm);
    prm.add_parameter("Regions", shared.regions,
                      "Regions of the body in which the muscle acts, separated by commas; empty "
                      "is the whole body.");
    prm.add_parameter("Monitored point", shared.monitored_point,
                      "Arc length over body length of the point on the midline whose lateral "
                      "motion the muscle watches (0 nose, 1 tail).");
    prm.add_parameter("Start-up ramp", shared.ramp.duration,
                      "Time [s] in which the activation grows from zero, as (1 - cos)/2.");
    prm.add_parameter("Force distribution", shared.force_distribution,
                      "Share of the force density [-] of the bang-bang muscle and the table: a "
                      "function of the arc length s and the lateral distance y from the "
                      "midline, both over the body length.");
    prm.leave_subsection();
  }

  template <int dim>
  void MuscleParameters<dim>::check(const std::string &path) const
  {
    const std::string section = path + "/Muscle";
    check_between(section + "/Monitored point", shared.monitored_point, 0., 1.,
                  "Give an arc length between 0 (nose) and 1 (tail).");
    check_not_negative(section + "/Start-up ramp", shared.ramp.duration,
                       "Give a duration that is not negative [s].");
    BodyFunction(section + "/Force distribution", "s,y", shared.force_distribution).check_along();
    type.check(section);
  }

  namespace
  {
    const DimensionalRegistration<Muscle, Muscle> none("none", "the body is passive");
  }

  template class Muscle<2>;
  template class Muscle<3>;
  template struct MuscleParameters<2>;
  template struct MuscleParameters<3>;
} // namespace caudal
