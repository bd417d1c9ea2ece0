// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/expression.h>
#include <caudal/fish/muscle.h>

#include <memory>
#include <sstream>

namespace caudal
{
  namespace
  {
    const char *const tension_path   = "Muscle/Fibres/Tension";
    const char *const direction_path = "Muscle/Fibres/Direction";

    /**
     * Fibres under a tension that the .prm gives, S_a = T a a^T, P_a = T F a a^T,
     * with T and the direction a, which is normalised, functions of the place in
     * the reference shape. With a constant T it is a passive, anisotropic
     * material, such as the wall of the ring of Boffi, Gastaldi, Heltai & Peskin
     * (2008, doi:10.1016/j.cma.2007.09.015).
     */
    template <int dim>
    class FibreMuscle : public Muscle<dim>
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter(
            "Tension", tension_text,
            "Active stress T along the fibres, of the second Piola-Kirchhoff tensor [Pa]: a "
            "function of the place x, y (and z) in the body's own frame [m] and of the time t "
            "[s].");
        prm.add_parameter(
            "Direction", direction_text,
            "Direction of the fibres in the reference configuration, of any length: functions of "
            "x, y (and z) and t, one for each dimension, separated by ';'; '-y; x' is "
            "circumferential.");
      }

      void set_up(const SharedMuscleParameters &shared, const double length,
                  const std::map<std::string, types::material_id> &region_ids) override
      {
        Muscle<dim>::set_up(shared, length, region_ids);
        tension   = std::make_shared<Expression<dim>>(tension_path, tension_text, 1);
        direction = std::make_shared<Expression<dim>>(direction_path, direction_text, dim);
      }

      bool has_active_stress() const override
      {
        return true;
      }

      bool can_steer() const override
      {
        return false;
      }

      bool counts_from_nose() const override
      {
        return false;
      }

      Tensor<2, dim> active_stress(const Contraction &contraction, const MaterialPoint<dim> &point,
                                   const double time) const override
      {
        if (!this->acts_in(point.region))
          return Tensor<2, dim>();
        tension->set_time(time);
        direction->set_time(time);
        Tensor<1, dim> a;
        for (unsigned int d = 0; d < dim; ++d)
          a[d] = direction->value(point.s, d);
        if (a.norm() == 0.)
        {
          std::ostringstream place;
          place << point.s;
          AssertThrow(false, ExcMessage(std::string(direction_path) + ": <" + direction_text +
                                        "> vanishes at (" + place.str() +
                                        "). Give a direction for each point of the body."));
        }
        return outer_product(a, a) *
               (tension->value(point.s) * activation_at(contraction, time) / a.norm_square());
      }

      double activation(const Contraction &contraction) const override
      {
        return activation_at(contraction, contraction.get_middle());
      }

    private:
      double activation_at(const Contraction &contraction, const double time) const
      {
        return this->ramp.value(time) * (contraction.command.gain + contraction.command.bias);
      }

      std::string tension_text   = "1e5";
      std::string direction_text = "1; 0";

      std::shared_ptr<Expression<dim>> tension, direction;
    };

    const DimensionalRegistration<Muscle, FibreMuscle>
        registration("fibres", "an active stress along given lines");
  } // namespace
} // namespace caudal
