#include <caudal/base/factory.h>
#include <caudal/ideal/bending_body.h>
#include <caudal/ideal/cubic_spline.h>
#include <caudal/ideal/gait.h>
#include <caudal/ideal/number_table.h>
#include <caudal/ideal/pulsating_sphere.h>

#include <algorithm>
#include <limits>

namespace caudal::ideal
{
  namespace
  {
    const double degree = numbers::PI / 180.;

    /** A gait with the frequencies of the .prm. */
    class PeriodicGait : public Gait
    {
    public:
      explicit PeriodicGait(const GaitParameters &parameters)
          : parameters(parameters)
      {}

      std::vector<double> get_frequencies() const override
      {
        return parameters.frequencies;
      }

    protected:
      const GaitParameters parameters;
    };

    /** A wave of joint angles. */
    class JointWave : public PeriodicGait
    {
    public:
      using PeriodicGait::PeriodicGait;

      GaitState evaluate(const double psi) const override
      {
        GaitState state;
        for (unsigned int i = 1; i <= n_joints; ++i)
        {
          const double s = get_joint(1., i);
          const auto [angle, by_psi] =
              get_angle(s, psi - 2. * numbers::PI * parameters.wave_number * s);
          state.c.push_back(angle + parameters.bias * degree);
          state.rates.push_back(by_psi);
        }
        return state;
      }

      std::unique_ptr<Deformation> create_deformation(const Surface &surface,
                                                      const Shape   &shape) const override
      {
        return std::make_unique<BendingBody>(surface, shape, create_joints(shape.get_length()));
      }

    protected:
      /** The angle of the joint at s/L and its derivative by u. */
      virtual std::pair<double, double> get_angle(double s, double u) const = 0;
    };

    class ArctangentWave : public JointWave
    {
    public:
      using JointWave::JointWave;

    protected:
      std::pair<double, double> get_angle(const double, const double u) const override
      {
        return {std::atan(std::sin(u)), std::cos(u) / (1. + std::sin(u) * std::sin(u))};
      }
    };

    class SineWave : public JointWave
    {
    public:
      using JointWave::JointWave;

    protected:
      std::pair<double, double> get_angle(const double s, const double u) const override
      {
        const double amplitude =
            parameters.amplitude * degree * (1. - parameters.growth + parameters.growth * s);
        return {amplitude * std::sin(u), amplitude * std::cos(u)};
      }
    };

    class CurvatureWaveGait : public PeriodicGait
    {
    public:
      using PeriodicGait::PeriodicGait;

      GaitState evaluate(const double psi) const override
      {
        return {{std::sin(psi), -std::cos(psi)}, {std::cos(psi), std::sin(psi)}};
      }

      std::unique_ptr<Deformation> create_deformation(const Surface &surface,
                                                      const Shape   &shape) const override
      {
        return std::make_unique<BendingBody>(
            surface, shape,
            create_curvature_wave(shape.get_length(), parameters.curvature, parameters.growth,
                                  parameters.wave_number));
      }
    };

    class DeformingSphere : public PeriodicGait
    {
    public:
      using PeriodicGait::PeriodicGait;

      GaitState evaluate(const double psi) const override
      {
        return {{std::cos(psi), std::sin(psi)}, {-std::sin(psi), std::cos(psi)}};
      }

      std::unique_ptr<Deformation> create_deformation(const Surface &surface,
                                                      const Shape   &shape) const override
      {
        const double   radius = shape.get_length() / 2.;
        const Point<3> side   = shape.place(Point<3>(0., std::sqrt(0.5), std::sqrt(0.5)));
        AssertThrow(std::abs(side[1] - radius * std::sqrt(0.5)) < 1e-9 * radius &&
                        std::abs(side[2] - radius * std::sqrt(0.5)) < 1e-9 * radius &&
                        !surface.is_from_file(),
                    ExcMessage("Shape/Axes: the gait `deforming sphere` needs the shape of a "
                               "sphere. Give Shape/Type = ellipsoid with three equal axes."));
        return std::make_unique<PulsatingSphere>(surface, radius, parameters.sphere_amplitude,
                                                 parameters.sphere_order);
      }
    };

    /** A body without joints. */
    class RigidGait : public PeriodicGait
    {
    public:
      using PeriodicGait::PeriodicGait;

      GaitState evaluate(const double) const override
      {
        return {};
      }

      std::unique_ptr<Deformation> create_deformation(const Surface &surface,
                                                      const Shape   &shape) const override
      {
        return std::make_unique<BendingBody>(surface, shape, create_no_modes());
      }
    };

    /** The control file: rows of a time [s] and six joint angles [degrees]. */
    class TableGait : public Gait
    {
    public:
      explicit TableGait(const GaitParameters &parameters)
          : periodic(parameters.table_is_periodic)
          , bias(parameters.bias * degree)
      {
        const auto rows = read_number_table(entry, parameters.table, 1 + n_joints);
        check(rows, parameters.table);
        std::vector<double> times;
        for (const auto &row : rows)
          times.push_back(row[0]);
        start = times.front();
        end   = times.back();
        for (unsigned int i = 1; i <= n_joints; ++i)
        {
          std::vector<double> angles;
          for (const auto &row : rows)
            angles.push_back(row[i] * degree);
          splines.emplace_back(times, angles, periodic);
        }
      }

      GaitState evaluate(const double argument) const override
      {
        const double scale = periodic ? (end - start) / (2. * numbers::PI) : 1.;
        GaitState    state;
        for (const CubicSpline &spline : splines)
        {
          const auto [angle, rate] = spline.evaluate(start + scale * argument);
          state.c.push_back(angle + bias);
          state.rates.push_back(rate * scale);
        }
        return state;
      }

      bool is_periodic() const override
      {
        return periodic;
      }

      std::vector<double> get_frequencies() const override
      {
        return {1. / (end - start)};
      }

      double get_end() const override
      {
        return periodic ? Gait::get_end() : end - start;
      }

      std::unique_ptr<Deformation> create_deformation(const Surface &surface,
                                                      const Shape   &shape) const override
      {
        return std::make_unique<BendingBody>(surface, shape, create_joints(shape.get_length()));
      }

    private:
      void check(const std::vector<std::vector<double>> &rows, const std::string &file) const
      {
        const std::string table = entry + ": " + file + ": ";
        AssertThrow(rows.size() >= 4,
                    ExcMessage(table + "there are " + std::to_string(rows.size()) +
                               " rows of numbers. Give at least four."));
        std::vector<double> steps;
        for (std::size_t i = 1; i < rows.size(); ++i)
        {
          steps.push_back(rows[i][0] - rows[i - 1][0]);
          AssertThrow(steps.back() > 0.,
                      ExcMessage(table + "the time " + Patterns::Tools::to_string(rows[i][0]) +
                                 " s is not later than that of the row before. Sort the rows by "
                                 "time."));
        }
        std::vector<double> sorted = steps;
        std::sort(sorted.begin(), sorted.end());
        const double median = sorted[sorted.size() / 2];
        for (std::size_t i = 0; i < steps.size(); ++i)
          AssertThrow(steps[i] <= 10. * median,
                      ExcMessage(table + "there is a gap after the time " +
                                 Patterns::Tools::to_string(rows[i][0]) +
                                 " s, more than ten times as long as the usual step of " +
                                 Patterns::Tools::to_string(median) + " s. Add the missing rows."));
        if (periodic)
          for (unsigned int i = 1; i <= n_joints; ++i)
            AssertThrow(std::abs(rows.front()[i] - rows.back()[i]) < 1e-6,
                        ExcMessage(table + "the table is periodic, and its last row differs from "
                                           "its first. End it with the first row's angles, at "
                                           "the time where the period ends."));
      }

      static const std::string entry;

      const bool               periodic;
      const double             bias;
      double                   start, end; // [s]
      std::vector<CubicSpline> splines;    // by joint
    };
    const std::string TableGait::entry = "Gait/Table/File";

    using GaitFactory = Factory<Gait, const GaitParameters &>;

    template <class Derived>
    auto make =
        [](const GaitParameters &parameters) { return std::make_unique<Derived>(parameters); };

    const GaitFactory &get_factory()
    {
      static const GaitFactory factory("gait", {{"none", make<RigidGait>},
                                                {"arctangent", make<ArctangentWave>},
                                                {"sine", make<SineWave>},
                                                {"curvature", make<CurvatureWaveGait>},
                                                {"table", make<TableGait>},
                                                {"deforming sphere", make<DeformingSphere>}});
      return factory;
    }

    // Of the phases at which the symmetries of a gait are looked for.
    const unsigned int n_samples = 120;
    const double       tolerance = 1e-9;

    std::vector<std::vector<double>> sample(const Gait &gait)
    {
      std::vector<std::vector<double>> samples;
      for (unsigned int k = 0; k < n_samples; ++k)
        samples.push_back(gait.evaluate(2. * numbers::PI * k / n_samples).c);
      return samples;
    }

    /** The largest of |a_i - factor b_i|. */
    double compute_distance(const std::vector<double> &a, const std::vector<double> &b,
                            const double factor)
    {
      double largest = 0.;
      for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(a[i] - factor * b[i]));
      return largest;
    }
  } // namespace

  double Gait::get_end() const
  {
    return std::numeric_limits<double>::max();
  }

  void GaitParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Gait");
    prm.add_parameter("Type", type,
                      "Waves of joint angles: 'arctangent' (the paper's), 'sine', 'table'; "
                      "'curvature', a wave of curvature; 'deforming sphere'; 'none', rigid.",
                      Patterns::Selection(get_factory().get_names()));
    prm.add_parameter("Frequency", frequencies,
                      "Strokes a second f [Hz]; several, separated by commas, are simulated one "
                      "after the other from one table of phases. A table has its own.");
    prm.add_parameter("Wave number", wave_number,
                      "k, the waves on the body [1]; with 0 the stroke is reciprocal.");
    prm.add_parameter("Bias", bias,
                      "Constant angle gamma added to each joint [degrees], which steers; the "
                      "paper prints 5, and its fish would swim in circles with it.");
    prm.add_parameter("Amplitude", amplitude, "A, of the joints in `sine` [degrees].");
    prm.add_parameter("Growth", growth,
                      "g [1]: the amplitude (sine, curvature) is in proportion to (1 - g) + g "
                      "s/L.");
    prm.add_parameter("Curvature", curvature, "K L, of `curvature` [1].");
    prm.enter_subsection("Table");
    prm.add_parameter("File", table,
                      "The control file: rows of a time [s] and the angles of the six joints "
                      "[degrees].",
                      Patterns::Anything());
    prm.add_parameter("Periodic", table_is_periodic,
                      "Whether the table is one period, which its last row closes; otherwise a "
                      "new surface is computed in each step.");
    prm.leave_subsection();
    prm.enter_subsection("Deforming sphere");
    prm.add_parameter("Amplitude", sphere_amplitude,
                      "eps in R = a (1 + eps (cos psi P_n + sin psi P_(n+1))) [1].");
    prm.add_parameter("Order", sphere_order, "n [1].", Patterns::Integer(2, 12));
    prm.leave_subsection();
    prm.leave_subsection();
  }

  void GaitParameters::check() const
  {
    const auto finite = [](const std::string &entry, const double value) {
      AssertThrow(std::isfinite(value),
                  ExcMessage("Gait/" + entry + ": the value is " +
                             Patterns::Tools::to_string(value) + ". Give a finite number."));
    };
    finite("Wave number", wave_number);
    finite("Bias", bias);
    finite("Amplitude", amplitude);
    finite("Growth", growth);
    finite("Curvature", curvature);
    finite("Deforming sphere/Amplitude", sphere_amplitude);
    AssertThrow(!frequencies.empty(),
                ExcMessage("Gait/Frequency: the list is empty. Give one frequency or more [Hz]."));
    for (const double frequency : frequencies)
      AssertThrow(std::isfinite(frequency) && frequency > 0.,
                  ExcMessage("Gait/Frequency: the value is " +
                             Patterns::Tools::to_string(frequency) +
                             ". Give a positive frequency [Hz]; a body at rest or without joints "
                             "has Gait/Type = none."));
    std::vector<double> sorted(frequencies);
    std::sort(sorted.begin(), sorted.end());
    AssertThrow(std::adjacent_find(sorted.begin(), sorted.end(),
                                   [](double a, double b) { return b - a < 1e-5 * b; }) ==
                    sorted.end(),
                ExcMessage("Gait/Frequency: two values are the same; their results would be "
                           "written to the same files. Leave one out."));
    if (type == "table")
      create_gait(*this);
  }

  std::unique_ptr<Gait> create_gait(const GaitParameters &parameters)
  {
    return get_factory().create(parameters.type, parameters);
  }

  bool is_reciprocal(const Gait &gait)
  {
    if (!gait.is_periodic())
      return false;
    const auto c = sample(gait);
    // Played backwards from one phase and forwards from another one it is the same.
    for (unsigned int shift = 0; shift < n_samples; ++shift)
    {
      double distance = 0.;
      for (unsigned int k = 0; k < n_samples && distance < tolerance; ++k)
        distance =
            std::max(distance, compute_distance(c[k], c[(shift + n_samples - k) % n_samples], 1.));
      if (distance < tolerance)
        return true;
    }
    return false;
  }

  bool has_glide_symmetry(const Gait &gait)
  {
    if (!gait.is_periodic())
      return false;
    const auto c        = sample(gait);
    double     distance = 0.;
    for (unsigned int k = 0; k < n_samples; ++k)
      distance =
          std::max(distance, compute_distance(c[k], c[(k + n_samples / 2) % n_samples], -1.));
    return distance < tolerance;
  }
} // namespace caudal::ideal
