#include <caudal/base/factory.h>
#include <caudal/fish/body_function.h>
#include <caudal/fish/gait.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace caudal
{
  namespace
  {
    /** Inclination theta(s,t) of the midline against the x axis [rad], and its rate [rad/s]. */
    struct Inclination
    {
      double value = 0.;
      double rate  = 0.;
    };

    /**
     * The midline in @p n_stations equal pieces: dm/ds = (cos theta, sin theta)
     * integrated from the nose on by the trapezoidal rule; between the stations
     * cubic Hermite interpolation of m, linear of theta. Velocities are the exact
     * time derivatives of this discrete shape.
     */
    template <int dim>
    class MidlineGait : public Gait<dim>
    {
    public:
      explicit MidlineGait(const double length)
          : length(length)
          , spacing(length / n_stations)
          , inclination(n_stations + 1)
          , place(n_stations + 1)
          , velocity_of_place(n_stations + 1)
      {}

      void set_time(const double time) override
      {
        compute_inclination(time, inclination);
        for (unsigned int i = 1; i <= n_stations; ++i)
        {
          place[i] = place[i - 1] + 0.5 * spacing * (tangent(i - 1) + tangent(i));
          velocity_of_place[i] =
              velocity_of_place[i - 1] + 0.5 * spacing * (tangent_rate(i - 1) + tangent_rate(i));
        }
      }

      Point<dim> position(const Point<dim> &s) const override
      {
        const Location     at    = locate(s[0]);
        const Tensor<1, 2> m     = interpolate(at, place, &MidlineGait::tangent);
        const double       angle = interpolate(at, &Inclination::value);
        Point<dim>         X     = s;
        X[0]                     = m[0] - s[1] * std::sin(angle) + at.beyond * std::cos(angle);
        X[1]                     = m[1] + s[1] * std::cos(angle) + at.beyond * std::sin(angle);
        return X;
      }

      Tensor<1, dim> velocity(const Point<dim> &s) const override
      {
        const Location     at    = locate(s[0]);
        const Tensor<1, 2> m     = interpolate(at, velocity_of_place, &MidlineGait::tangent_rate);
        const double       angle = interpolate(at, &Inclination::value);
        const double       rate  = interpolate(at, &Inclination::rate);
        Tensor<1, dim>     V;
        V[0] = m[0] - rate * (s[1] * std::cos(angle) + at.beyond * std::sin(angle));
        V[1] = m[1] - rate * (s[1] * std::sin(angle) - at.beyond * std::cos(angle));
        return V;
      }

    protected:
      /** Fills in theta and its rate at the stations s_i = i/n_stations L. */
      virtual void compute_inclination(const double              time,
                                       std::vector<Inclination> &inclination) const = 0;

      const double length;
      const double spacing;

      static constexpr unsigned int n_stations = 400;

    private:
      /** A piece of the midline, the place in it (0 to 1), and how far [m] beyond an end. */
      struct Location
      {
        unsigned int left;
        double       fraction;
        double       beyond;
      };

      Location locate(const double s) const
      {
        const double inside = std::clamp(s, 0., length);
        const auto   left   = std::min(static_cast<unsigned int>(inside / spacing), n_stations - 1);
        return {left, inside / spacing - left, s - inside};
      }

      Tensor<1, 2> tangent(const unsigned int i) const
      {
        const double theta = inclination[i].value;
        return Point<2>(std::cos(theta), std::sin(theta));
      }

      Tensor<1, 2> tangent_rate(const unsigned int i) const
      {
        const double theta = inclination[i].value;
        return inclination[i].rate * Point<2>(-std::sin(theta), std::cos(theta));
      }

      double interpolate(const Location &at, double Inclination::*member) const
      {
        return (1. - at.fraction) * (inclination[at.left].*member) +
               at.fraction * (inclination[at.left + 1].*member);
      }

      Tensor<1, 2> interpolate(const Location &at, const std::vector<Tensor<1, 2>> &values,
                               Tensor<1, 2> (MidlineGait::*slope)(unsigned int) const) const
      {
        const double x = at.fraction, y = 1. - x;
        return y * y * (1. + 2. * x) * values[at.left] +
               x * x * (1. + 2. * y) * values[at.left + 1] +
               spacing * x * y * (y * (this->*slope)(at.left) - x * (this->*slope)(at.left + 1));
      }

      std::vector<Inclination>  inclination;
      std::vector<Tensor<1, 2>> place;
      std::vector<Tensor<1, 2>> velocity_of_place;
    };

    /** sin theta = dy/ds of the lateral displacement y(s,t), since s is the arc length. */
    template <int dim>
    class TravellingWave : public MidlineGait<dim>
    {
    public:
      TravellingWave(const GaitParameters &p, const double length)
          : MidlineGait<dim>(length)
          , ramp(p.ramp)
          , slope(p.amplitude / (1. + p.offset))
          , offset(p.offset)
          , wave_number(2. * numbers::PI * p.wave_number)
          , frequency(2. * numbers::PI * p.frequency)
      {}

    protected:
      void compute_inclination(const double              time,
                               std::vector<Inclination> &inclination) const override
      {
        for (unsigned int i = 0; i <= this->n_stations; ++i)
        {
          const double s     = static_cast<double>(i) / this->n_stations;
          const double phase = wave_number * s - frequency * time;
          const double wave =
              slope * (std::sin(phase) + (s + offset) * wave_number * std::cos(phase));
          const double wave_rate =
              -frequency * slope * (std::cos(phase) - (s + offset) * wave_number * std::sin(phase));
          const double sine      = ramp.value(time) * wave;
          const double sine_rate = ramp.value(time) * wave_rate + ramp.rate(time) * wave;
          AssertThrow(std::abs(sine) < 1.,
                      ExcMessage("Gait: the slope of the midline reaches " + std::to_string(sine) +
                                 ", and a midline of constant length allows less than 1. Reduce "
                                 "the amplitude or the wave number."));
          inclination[i] = {std::asin(sine), sine_rate / std::sqrt(1. - sine * sine)};
        }
      }

    private:
      const StartUpRamp ramp;
      const double      slope, offset, wave_number, frequency;
    };

    /** theta is the integral of the curvature from the nose on. */
    template <int dim>
    class CurvatureGait : public MidlineGait<dim>
    {
    public:
      CurvatureGait(const GaitParameters &p, const double length)
          : MidlineGait<dim>(length)
          , ramp(p.ramp)
          , curvature("Gait/Curvature", "s,t", p.curvature)
      {}

    protected:
      void compute_inclination(const double              time,
                               std::vector<Inclination> &inclination) const override
      {
        Inclination before = bend(0., time);
        inclination[0]     = Inclination();
        for (unsigned int i = 1; i <= this->n_stations; ++i)
        {
          const Inclination here = bend(static_cast<double>(i) / this->n_stations, time);
          inclination[i].value =
              inclination[i - 1].value + 0.5 * this->spacing * (before.value + here.value);
          inclination[i].rate =
              inclination[i - 1].rate + 0.5 * this->spacing * (before.rate + here.rate);
          before = here;
        }
      }

    private:
      /** The curvature [1/m] and its rate, by a central difference. */
      Inclination bend(const double s, const double time) const
      {
        const double increment = 1e-6;
        const double value     = curvature.value(s, time);
        const double rate =
            (curvature.value(s, time + increment) - curvature.value(s, time - increment)) /
            (2. * increment);
        return {ramp.value(time) * value, ramp.value(time) * rate + ramp.rate(time) * value};
      }

      const StartUpRamp  ramp;
      const BodyFunction curvature;
    };

    template <int dim>
    using GaitFactory = Factory<Gait<dim>, const GaitParameters &, const double>;

    template <class Derived>
    auto make = [](const GaitParameters &parameters, const double length) {
      return std::make_unique<Derived>(parameters, length);
    };

    template <int dim>
    const GaitFactory<dim> &get_factory()
    {
      static const GaitFactory<dim> factory(
          "gait", {{"none", [](const GaitParameters &, const double) { return nullptr; }},
                   {"travelling wave", make<TravellingWave<dim>>},
                   {"curvature", make<CurvatureGait<dim>>}});
      return factory;
    }
  } // namespace

  void GaitParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Gait");
    prm.add_parameter("Type", type,
                      "'travelling wave' prescribes the lateral displacement of the midline, "
                      "'curvature' its curvature, 'none' nothing.",
                      Patterns::Selection(get_factory<2>().get_names()));
    prm.add_parameter("Start-up ramp", ramp.duration,
                      "Time [s] in which the motion grows from zero, as (1 - cos)/2.");
    prm.enter_subsection("Travelling wave");
    prm.add_parameter("Amplitude", amplitude,
                      "Lateral amplitude a of the tail, over the body length [-], in y = a L "
                      "(s/L + b)/(1 + b) sin(2 pi (k s/L - f t)).");
    prm.add_parameter("Offset", offset, "b, of which the nose's amplitude is a b/(1 + b) [-].");
    prm.add_parameter("Wave number", wave_number, "k, the waves on the body [-].");
    prm.add_parameter("Frequency", frequency, "f, the tail-beat frequency [Hz].");
    prm.leave_subsection();
    prm.add_parameter("Curvature", curvature,
                      "Curvature of the midline [1/m], a function of the arc length s over the "
                      "body length (0 nose, 1 tail) and the time t [s]; positive to the left "
                      "of the way from nose to tail.");
    prm.leave_subsection();
  }

  void GaitParameters::check(const std::string &path) const
  {
    const std::string section = path + "/Gait";
    const auto        bad     = [&section](const std::string &entry, const double value) {
      return section + "/" + entry + ": the value is " + Patterns::Tools::to_string(value) + ". ";
    };
    AssertThrow(ramp.duration >= 0., ExcMessage(bad("Start-up ramp", ramp.duration) +
                                                "Give a duration that is not negative [s]."));
    if (type == "travelling wave")
    {
      AssertThrow(offset > -1.,
                  ExcMessage(bad("Travelling wave/Offset", offset) + "Give more than -1."));
      AssertThrow(frequency > 0., ExcMessage(bad("Travelling wave/Frequency", frequency) +
                                             "Give a positive frequency [Hz]."));
    }
    if (type == "curvature")
    {
      const BodyFunction function(section + "/Curvature", "s,t", curvature);
      for (const double s : {0., 0.25, 0.5, 0.75, 1.})
        function.value(s, 0.);
    }
  }

  template <int dim>
  std::unique_ptr<Gait<dim>> create_gait(const GaitParameters &parameters, const double length)
  {
    return get_factory<dim>().create(parameters.type, parameters, length);
  }

  template class Gait<2>;
  template class Gait<3>;
  template std::unique_ptr<Gait<2>> create_gait(const GaitParameters &, const double);
  template std::unique_ptr<Gait<3>> create_gait(const GaitParameters &, const double);
} // namespace caudal
