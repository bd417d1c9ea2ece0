// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/fish/body_function.h>
#include <caudal/fish/muscle.h>

#include <cmath>
#include <memory>

namespace caudal
{
  namespace
  {
    /**
     * A wave of contraction that runs from head to tail, on both sides in
     * opposition: S_a = T e_x e_x with
     *   T = T_max A(s) y/(L b) (gain sin(2 pi (f t - k s) + phase) + bias).
     * s is the arc length and b a reference half thickness, both over the body
     * length L. Like the stress of a bent beam, T is linear across the body: it
     * bends a symmetric section and does not shorten it.
     */
    template <int dim>
    class TravellingWaveMuscle : public Muscle<dim>
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Maximum active stress", maximum,
                          "Second Piola-Kirchhoff stress along the body at the reference half "
                          "thickness, where the envelope is 1 [Pa].");
        prm.add_parameter("Envelope", envelope_text,
                          "Amplitude of the wave [-], a function of the arc length s over the "
                          "body length (0 nose, 1 tail) and the time t [s].");
        prm.add_parameter("Wave number", wave_number,
                          "Waves on the body; they run to the tail [-].");
        prm.add_parameter("Frequency", frequency, "Tail-beat frequency [Hz].");
        prm.add_parameter("Phase", phase, "Phase of the wave at the nose at t = 0 [rad].");
        prm.add_parameter("Reference half thickness", half_thickness,
                          "Distance from the midline, over the body length, at which the stress "
                          "has its full value; it is linear across the body [-].");
      }

      void check(const std::string &path) const override
      {
        check_positive(path + "/Frequency", frequency, "Give a positive frequency [Hz].");
        check_positive(path + "/Reference half thickness", half_thickness,
                       "Give a positive share of the body length.");
        BodyFunction(path + "/Envelope", "s,t", envelope_text).check_along();
      }

      void set_up(const SharedMuscleParameters &shared, const double length,
                  const std::map<std::string, types::material_id> &region_ids) override
      {
        Muscle<dim>::set_up(shared, length, region_ids);
        envelope =
            std::make_shared<BodyFunction>("Muscle/Travelling wave/Envelope", "s,t", envelope_text);
      }

      bool has_active_stress() const override
      {
        return true;
      }

      double get_beat_frequency() const override
      {
        return frequency;
      }

      Tensor<2, dim> active_stress(const Contraction &contraction, const MaterialPoint<dim> &point,
                                   const double time) const override
      {
        Tensor<2, dim> stress;
        if (this->acts_in(point.region))
        {
          const double s    = point.s[0] / this->length;
          const double side = point.s[1] / (this->length * half_thickness);
          stress[0][0] =
              maximum * envelope->value(s, time) * side * activation_at(contraction, s, time);
        }
        return stress;
      }

      double activation(const Contraction &contraction) const override
      {
        return activation_at(contraction, 0., contraction.get_middle());
      }

    private:
      double activation_at(const Contraction &contraction, const double s, const double time) const
      {
        const double angle = 2. * numbers::PI * (frequency * time - wave_number * s) + phase;
        return this->ramp.value(time) *
               (contraction.command.gain * std::sin(angle) + contraction.command.bias);
      }

      double      maximum        = 1e5;
      std::string envelope_text  = "s";
      double      wave_number    = 1.;
      double      frequency      = 1.;
      double      phase          = 0.;
      double      half_thickness = 0.06;

      std::shared_ptr<const BodyFunction> envelope;
    };

    const DimensionalRegistration<Muscle, TravellingWaveMuscle>
        registration("travelling wave", "an active stress that runs to the tail as a wave");
  } // namespace
} // namespace caudal
