// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_lateral_force_h
#define caudal_fish_lateral_force_h

#include <caudal/fish/body_function.h>
#include <caudal/fish/muscle.h>

#include <memory>

namespace caudal
{
  /** The muscles that pull sideways: f_a = f(s,t) g(s,y) e_y, g the entry `Force distribution`. */
  template <int dim>
  class LateralForce : public Muscle<dim>
  {
  public:
    void set_up(const SharedMuscleParameters &shared, const double length,
                const std::map<std::string, types::material_id> &region_ids) override
    {
      Muscle<dim>::set_up(shared, length, region_ids);
      distribution = std::make_shared<BodyFunction>("Muscle/Force distribution", "s,y",
                                                    shared.force_distribution);
    }

    bool has_force() const override
    {
      return true;
    }

    Tensor<1, dim> force_density(const Contraction &contraction, const MaterialPoint<dim> &point,
                                 const double time) const override
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

  protected:
    /** f(s,t) [N/m^3] at the arc length @p s [body lengths]. */
    virtual double amplitude(const Contraction &contraction, double s, double time) const = 0;

  private:
    std::shared_ptr<const BodyFunction> distribution;
  };
} // namespace caudal

#endif
