#include <caudal/base/expression.h>
#include <caudal/base/factory.h>
#include <caudal/fish/body_function.h>
#include <caudal/fish/force_table.h>
#include <caudal/fish/muscle.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace caudal
{
  namespace
  {
    using RegionIds = std::map<std::string, types::material_id>;

    /** The part of the body in which a muscle acts, by the names of its regions. */
    class ActivePart
    {
    public:
      ActivePart(const std::vector<std::string> &names, const RegionIds &region_ids)
      {
        std::string known;
        for (const auto &region : region_ids)
          known += (known.empty() ? "" : ", ") + region.first;
        for (const std::string &name : names)
        {
          const auto region = region_ids.find(name);
          AssertThrow(region != region_ids.end(),
                      ExcMessage("Muscle/Regions: the body has no region called <" + name +
                                 ">. Its regions are: " + known + "."));
          ids.insert(region->second);
        }
      }

      bool contains(const types::material_id region) const
      {
        return ids.empty() || ids.count(region) > 0;
      }

    private:
      std::set<types::material_id> ids;
    };

    /** The common part of the muscles that pull sideways: f = f(s,t) g(s,y) e_y. */
    template <int dim>
    class LateralForce : public Muscle<dim>
    {
    public:
      LateralForce(const MuscleParameters &p, const double length, const RegionIds &region_ids)
          : length(length)
          , ramp(p.ramp)
          , part(p.regions, region_ids)
          , distribution("Muscle/Force distribution", "s,y", p.force_distribution)
      {}

      Tensor<1, dim> force_density(const MaterialPoint<dim> &point,
                                   const double              time) const override
      {
        Tensor<1, dim> force;
        if (part.contains(point.region))
        {
          const double s = point.s[0] / length;
          force[1]       = amplitude(s, time) * distribution.value(s, point.s[1] / length);
        }
        return force;
      }

      bool has_force() const override
      {
        return true;
      }

    protected:
      /** f(s,t) [N/m^3] at the arc length @p s [body lengths]. */
      virtual double amplitude(const double s, const double time) const = 0;

      const double      length;
      const StartUpRamp ramp;

    private:
      const ActivePart   part;
      const BodyFunction distribution;
    };

    /**
     * A force that jumps inside a step is averaged over one step length centred
     * at the time asked for. Schemes that evaluate it in the middle of the step
     * or at its end then see the impulse of the jump at second order, wherever in
     * the step it falls. The time of the crossing is extrapolated linearly from
     * the beginning of the step; one that was missed counts from there.
     *
     * The sign can switch once a step, and again only after the point has been
     * driven across to the other side.
     */
    template <int dim>
    class BangBang : public LateralForce<dim>
    {
    public:
      BangBang(const MuscleParameters &p, const double length, const RegionIds &region_ids)
          : LateralForce<dim>(p, length, region_ids)
          , maximum(p.bang_bang.maximum_force_density)
          , switching_position(p.bang_bang.switching_position)
          , switching_duration(p.bang_bang.switching_duration)
          , direction(p.bang_bang.initial_direction)
          , switching_time(-switching_duration)
      {}

      void prepare_step(const SwimmerState &state) override
      {
        Muscle<dim>::prepare_step(state);
        const double distance = switching_position - direction * state.lateral_position;
        const double velocity = direction * state.lateral_velocity;
        if (distance <= 0.)
          next_switching_time = state.time;
        else if (velocity > 0.)
          next_switching_time = state.time + distance / velocity;
        else
          next_switching_time = never;
      }

      void accept_step() override
      {
        if (next_switching_time <= this->step_begin + this->step)
        {
          direction      = -direction;
          switching_time = next_switching_time;
        }
        next_switching_time = never;
      }

      double activation() const override
      {
        return activation_at(this->step_begin + 0.5 * this->step);
      }

      std::vector<double> get_state() const override
      {
        return {static_cast<double>(direction), switching_time};
      }

      void set_state(const std::vector<double> &state) override
      {
        AssertThrow(state.size() == 2,
                    ExcMessage("The checkpoint does not hold the state of a bang-bang muscle. "
                               "Resume with the parameters that wrote it."));
        direction      = static_cast<int>(state[0]);
        switching_time = state[1];
      }

    protected:
      double amplitude(const double, const double time) const override
      {
        return maximum * activation_at(time);
      }

    private:
      double activation_at(const double time) const
      {
        const double begin = time - 0.5 * this->step;
        const double end   = time + 0.5 * this->step;
        return this->ramp.value(time) *
               (this->command.gain * mean_sign(begin, end) + this->command.bias);
      }

      double mean_sign(const double begin, const double end) const
      {
        const double a  = std::min(begin, next_switching_time);
        const double b  = std::min(end, next_switching_time);
        double integral = sign_integral(b - switching_time) - sign_integral(a - switching_time);
        if (end > next_switching_time)
          integral -= sign_integral(end - next_switching_time) -
                      sign_integral(std::max(0., begin - next_switching_time));
        return direction * integral / (end - begin);
      }

      /** Integral from 0 to @p x of a sign that turns smoothly from -1 to 1 from 0 on. */
      double sign_integral(const double x) const
      {
        if (x <= 0.)
          return -x;
        if (x >= switching_duration)
          return x - switching_duration;
        return -switching_duration / numbers::PI * std::sin(numbers::PI * x / switching_duration);
      }

      static constexpr double never = std::numeric_limits<double>::max();

      const double maximum;
      const double switching_position;
      const double switching_duration;

      int    direction;
      double switching_time;
      double next_switching_time = never;
    };

    template <int dim>
    class Table : public LateralForce<dim>
    {
    public:
      Table(const MuscleParameters &p, const double length, const RegionIds &region_ids)
          : LateralForce<dim>(p, length, region_ids)
          , table(p.table.file, p.table.periodic)
          , maximum(table.get_maximum())
          , monitored_point(p.monitored_point)
      {}

      double activation() const override
      {
        const double middle = this->step_begin + 0.5 * this->step;
        return maximum > 0. ? amplitude(monitored_point, middle) / maximum : 0.;
      }

    protected:
      double amplitude(const double s, const double time) const override
      {
        return this->ramp.value(time) *
               (this->command.gain * table.value(time, s) + this->command.bias * maximum);
      }

    private:
      const ForceTable table;
      const double     maximum;
      const double     monitored_point;
    };

    template <int dim>
    class TravellingWave : public Muscle<dim>
    {
    public:
      TravellingWave(const MuscleParameters &p, const double length, const RegionIds &region_ids)
          : wave(p.travelling_wave)
          , length(length)
          , ramp(p.ramp)
          , part(p.regions, region_ids)
          , envelope("Muscle/Travelling wave/Envelope", "s,t", wave.envelope)
      {}

      Tensor<2, dim> active_stress(const MaterialPoint<dim> &point,
                                   const double              time) const override
      {
        Tensor<2, dim> stress;
        if (part.contains(point.region))
        {
          const double s    = point.s[0] / length;
          const double side = point.s[1] / (length * wave.reference_half_thickness);
          stress[0][0] =
              wave.maximum_active_stress * envelope.value(s, time) * side * activation_at(s, time);
        }
        return stress;
      }

      bool has_active_stress() const override
      {
        return true;
      }

      double activation() const override
      {
        return activation_at(0., this->step_begin + 0.5 * this->step);
      }

    private:
      double activation_at(const double s, const double time) const
      {
        const double phase =
            2. * numbers::PI * (wave.frequency * time - wave.wave_number * s) + wave.phase;
        return ramp.value(time) * (this->command.gain * std::sin(phase) + this->command.bias);
      }

      const TravellingWaveParameters wave;
      const double                   length;
      const StartUpRamp              ramp;
      const ActivePart               part;
      const BodyFunction             envelope;
    };

    template <int dim>
    class Fibres : public Muscle<dim>
    {
    public:
      Fibres(const MuscleParameters &p, const double, const RegionIds &region_ids)
          : parameters(p.fibres)
          , ramp(p.ramp)
          , part(p.regions, region_ids)
          , tension(make_expression<dim>(tension_path, parameters.tension, 1))
          , direction(make_expression<dim>(direction_path, parameters.direction, dim))
      {}

      Tensor<2, dim> active_stress(const MaterialPoint<dim> &point,
                                   const double              time) const override
      {
        if (!part.contains(point.region))
          return Tensor<2, dim>();
        tension->set_time(time);
        direction->set_time(time);
        check_finite(tension_path, parameters.tension, *tension, point.s);
        check_finite(direction_path, parameters.direction, *direction, point.s);
        Tensor<1, dim> a;
        for (unsigned int d = 0; d < dim; ++d)
          a[d] = direction->value(point.s, d);
        if (a.norm() == 0.)
        {
          std::ostringstream place;
          place << point.s;
          throw ExcMessage(std::string(direction_path) + ": <" + parameters.direction +
                           "> vanishes at (" + place.str() +
                           "). Give a direction for each point of the body.");
        }
        return outer_product(a, a) *
               (tension->value(point.s) * activation_at(time) / a.norm_square());
      }

      bool has_active_stress() const override
      {
        return true;
      }

      double activation() const override
      {
        return activation_at(this->step_begin + 0.5 * this->step);
      }

    private:
      double activation_at(const double time) const
      {
        return ramp.value(time) * (this->command.gain + this->command.bias);
      }

      static constexpr auto tension_path   = "Muscle/Fibres/Tension";
      static constexpr auto direction_path = "Muscle/Fibres/Direction";

      const FibreParameters                  parameters;
      const StartUpRamp                      ramp;
      const ActivePart                       part;
      const std::unique_ptr<Expression<dim>> tension, direction;
    };

    template <int dim>
    using MuscleFactory =
        Factory<Muscle<dim>, const MuscleParameters &, const double, const RegionIds &>;

    template <class Derived>
    auto make = [](const MuscleParameters &parameters, const double length, const RegionIds &ids) {
      return std::make_unique<Derived>(parameters, length, ids);
    };

    template <int dim>
    const MuscleFactory<dim> &get_factory()
    {
      static const MuscleFactory<dim> factory(
          "muscle", {{"none", [](const MuscleParameters &, const double,
                                 const RegionIds &) { return std::make_unique<Muscle<dim>>(); }},
                     {"bang-bang", make<BangBang<dim>>},
                     {"travelling wave", make<TravellingWave<dim>>},
                     {"fibres", make<Fibres<dim>>},
                     {"table", make<Table<dim>>}});
      return factory;
    }
  } // namespace

  template <int dim>
  void Muscle<dim>::prepare_step(const SwimmerState &state)
  {
    step_begin = state.time;
    step       = state.step;
  }

  template <int dim>
  void Muscle<dim>::accept_step()
  {}

  template <int dim>
  Tensor<1, dim> Muscle<dim>::force_density(const MaterialPoint<dim> &, const double) const
  {
    return Tensor<1, dim>();
  }

  template <int dim>
  Tensor<2, dim> Muscle<dim>::active_stress(const MaterialPoint<dim> &, const double) const
  {
    return Tensor<2, dim>();
  }

  template <int dim>
  bool Muscle<dim>::has_force() const
  {
    return false;
  }

  template <int dim>
  bool Muscle<dim>::has_active_stress() const
  {
    return false;
  }

  template <int dim>
  double Muscle<dim>::activation() const
  {
    return 0.;
  }

  template <int dim>
  std::vector<double> Muscle<dim>::get_state() const
  {
    return {};
  }

  template <int dim>
  void Muscle<dim>::set_state(const std::vector<double> &state)
  {
    AssertThrow(state.empty(),
                ExcMessage("The checkpoint holds the state of another muscle. Resume with the "
                           "parameters that wrote it."));
  }

  template <int dim>
  std::unique_ptr<Muscle<dim>> create_muscle(const MuscleParameters &parameters,
                                             const double length, const RegionIds &region_ids)
  {
    return get_factory<dim>().create(parameters.type, parameters, length, region_ids);
  }

  std::string get_muscle_names()
  {
    return get_factory<2>().get_names();
  }

  template class Muscle<2>;
  template class Muscle<3>;
  template std::unique_ptr<Muscle<2>> create_muscle(const MuscleParameters &, const double,
                                                    const RegionIds &);
  template std::unique_ptr<Muscle<3>> create_muscle(const MuscleParameters &, const double,
                                                    const RegionIds &);
} // namespace caudal
