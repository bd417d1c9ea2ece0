// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/lateral_force.h>

namespace caudal
{
  template <int dim>
  void LateralForce<dim>::set_up(const SharedMuscleParameters &shared, const double length,
                                 const std::map<std::string, types::material_id> &region_ids)
  {
    Muscle<dim>::set_up(shared, length, region_ids);
    distribution = std::make_shared<BodyFunction>("Muscle/Force distribution", "s,y",
                                                  shared.force_distribution);
  }

  template <int dim>
  bool LateralForce<dim>::has_force() const
  {
    return true;
  }

  template <int dim>
  Tensor<1, dim> LateralForce<dim>::force_density(const Contraction        &contraction,
                                                  const MaterialPoint<dim> &point,
                                                  const double              time) const
  {
    Tensor<1, dim> force;
    if (this->acts_in(point.region))
    {
      const double s = point.s[0] / this->length;
      force[1] =
          amplitude(contraction, s, time) * distribution->value(s, point.s[1] / this->length);
    }
    return force;
  }

  template class LateralForce<2>;
  template class LateralForce<3>;
} // namespace caudal
