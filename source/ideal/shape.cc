#include <caudal/base/factory.h>
#include <caudal/ideal/number_table.h>
#include <caudal/ideal/profile.h>
#include <caudal/ideal/shape.h>
#include <caudal/ideal/surface_quadrature.h>

#include <deal.II/base/quadrature_lib.h>

namespace caudal::ideal
{
  namespace
  {
    const std::string stations_entry = "Shape/Stations";

    /** Half-axes at a place along the spine [m]. */
    struct Station
    {
      double s, a, b;
    };

    /** What the station table says; its s is relative to the length and becomes m. */
    std::vector<Station> read_stations(const ShapeParameters &parameters)
    {
      const bool        from_file = !parameters.stations_file.empty();
      const std::string entry     = from_file ? "Shape/Stations file" : stations_entry;
      AssertThrow(from_file != !parameters.stations.empty(),
                  ExcMessage(stations_entry + ": give the stations either here or in "
                                              "Shape/Stations file."));
      const auto rows = from_file ? read_number_table(entry, parameters.stations_file, 3)
                                  : parse_number_table(entry, parameters.stations, 3);
      AssertThrow(rows.size() >= 3,
                  ExcMessage(entry + ": there are " + std::to_string(rows.size()) +
                             " stations. Give at least three."));
      std::vector<Station> stations;
      for (const auto &row : rows)
      {
        const auto complain = [&](const std::string &text) {
          return ExcMessage(entry + ": station " + std::to_string(stations.size() + 1) + " " +
                            text);
        };
        AssertThrow(row[0] > 0. && row[0] < 1.,
                    complain("is at s/L = " + Patterns::Tools::to_string(row[0]) +
                             ". Give positions between 0 and 1: the ends are round."));
        AssertThrow(stations.empty() || row[0] * parameters.length > stations.back().s,
                    complain("at s/L = " + Patterns::Tools::to_string(row[0]) +
                             " does not lie behind the one before it. Sort the stations from "
                             "head to tail."));
        AssertThrow(row[1] > 0. && row[2] > 0.,
                    complain("has the half-axes " + Patterns::Tools::to_string(row[1]) + " and " +
                             Patterns::Tools::to_string(row[2]) + " m. Give positive ones."));
        stations.push_back({row[0] * parameters.length, row[1], row[2]});
      }
      return stations;
    }

    /** A body of elliptic sections with the half-axes g_a E and g_b E. */
    class EllipticBody : public Shape
    {
    public:
      explicit EllipticBody(const double length)
          : length(length)
      {}

      double get_length() const override
      {
        return length;
      }

      Point<3> place(const Point<3> &reference) const override
      {
        const double s      = 0.5 * length * (1. + reference[0]);
        const auto [ga, gb] = scales(s);
        return Point<3>(s, ga * reference[1], gb * reference[2]);
      }

      double half_width(const double s) const override
      {
        return scales(s).first * end_factor(s);
      }

      std::vector<Section> compute_sections() const override
      {
        const unsigned int   n_slices = 56;
        const QGauss<1>      gauss(3);
        std::vector<Section> sections;
        for (unsigned int i = 0; i < n_slices; ++i)
          for (unsigned int q = 0; q < gauss.size(); ++q)
          {
            Section section;
            section.s           = length * (i + gauss.point(q)[0]) / n_slices;
            const auto [ga, gb] = scales(section.s);
            const double a = ga * end_factor(section.s), b = gb * end_factor(section.s);
            const double volume   = numbers::PI * a * b * length / n_slices * gauss.weight(q);
            section.moments[0][0] = volume;
            section.moments[1][1] = volume * a * a / 4.;
            section.moments[2][2] = volume * b * b / 4.;
            sections.push_back(section);
          }
        return sections;
      }

      bool is_symmetric() const override
      {
        return true;
      }

    protected:
      /** g_a and g_b at s [m]. */
      virtual std::pair<double, double> scales(double s) const = 0;

      double end_factor(const double s) const
      {
        return 2. * std::sqrt(std::max(0., s * (length - s))) / length;
      }

      const double length;
    };

    class StationBody : public EllipticBody
    {
    public:
      StationBody(const ShapeParameters &parameters, const Surface &)
          : EllipticBody(parameters.length)
          , stations(read_stations(parameters))
          , log_ga(make_profile(&Station::a, parameters.interpolation == "limited"))
          , log_gb(make_profile(&Station::b, parameters.interpolation == "limited"))
      {}

    protected:
      std::pair<double, double> scales(const double s) const override
      {
        return {std::exp(log_ga.value(s)), std::exp(log_gb.value(s))};
      }

    private:
      Profile make_profile(double Station::*axis, const bool limited) const
      {
        std::vector<double> s, values;
        for (const Station &station : stations)
        {
          s.push_back(station.s);
          values.push_back(std::log(station.*axis / end_factor(station.s)));
        }
        return Profile(s, values, limited);
      }

      const std::vector<Station> stations;
      const Profile              log_ga, log_gb;
    };

    class Ellipsoid : public EllipticBody
    {
    public:
      Ellipsoid(const ShapeParameters &parameters, const Surface &)
          : EllipticBody(2. * parameters.axes[0])
          , axes(parameters.axes)
      {}

    protected:
      std::pair<double, double> scales(const double) const override
      {
        return {axes[1], axes[2]};
      }

    private:
      const std::vector<double> axes;
    };

    /** The body inside a surface mesh. */
    class MeshBody : public Shape
    {
    public:
      MeshBody(const ShapeParameters &, const Surface &surface)
          : surface(surface)
          , nose(std::numeric_limits<double>::max())
          , tail(-nose)
      {
        for (const Point<3> &point : surface.get_reference_points())
        {
          nose = std::min(nose, point[0]);
          tail = std::max(tail, point[0]);
        }
      }

      double get_length() const override
      {
        return tail - nose;
      }

      Point<3> place(const Point<3> &reference) const override
      {
        return Point<3>(reference[0] - nose, reference[1], reference[2]);
      }

      /** The largest |y| within a twentieth of the length. */
      double half_width(const double s) const override
      {
        double width = 0.;
        for (const Point<3> &point : surface.get_reference_points())
          if (std::abs(point[0] - nose - s) < 0.05 * get_length())
            width = std::max(width, std::abs(point[1]));
        return width;
      }

      /** int f dV = int F n_y dS with dF/dy = f, here f = 1, y, z, y^2, yz, z^2. */
      std::vector<Section> compute_sections() const override
      {
        const ReferenceRule  rule(QGauss<2>(3), surface.get_fe());
        std::vector<Section> sections;
        for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
        {
          std::vector<Point<3>> positions;
          for (const auto node : surface.get_nodes(cell))
            positions.push_back(place(surface.get_reference_points()[node]));
          const CellRule at(rule, positions);
          for (unsigned int q = 0; q < rule.n_points; ++q)
          {
            const Point<3> X = at.get_point(q);
            const double   y = X[1], z = X[2], N = at.get_area(q)[1];
            Section        section;
            section.s             = X[0];
            section.moments[0][0] = N * y;
            section.moments[0][1] = N * y * y / 2.;
            section.moments[0][2] = N * y * z;
            section.moments[1][1] = N * y * y * y / 3.;
            section.moments[1][2] = N * y * y * z / 2.;
            section.moments[2][2] = N * y * z * z;
            sections.push_back(section);
          }
        }
        return sections;
      }

      bool is_symmetric() const override
      {
        return false; // not known
      }

    private:
      const Surface &surface;
      double         nose, tail; // x [m]
    };

    using ShapeFactory = Factory<Shape, const ShapeParameters &, const Surface &>;

    template <class Derived>
    auto make = [](const ShapeParameters &parameters, const Surface &surface) {
      return std::make_unique<Derived>(parameters, surface);
    };

    const ShapeFactory &get_factory()
    {
      static const ShapeFactory factory("shape", {{"stations", make<StationBody>},
                                                  {"ellipsoid", make<Ellipsoid>},
                                                  {"file", make<MeshBody>}});
      return factory;
    }
  } // namespace

  void ShapeParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Shape");
    prm.add_parameter("Type", type,
                      "'stations': elliptic sections at stations along the spine; 'ellipsoid'; "
                      "'file': the mesh in Surface/File.",
                      Patterns::Selection(get_factory().get_names()));
    prm.add_parameter("Length", length, "Length L of the spine [m], for stations.");
    prm.add_parameter("Stations", stations,
                      "Rows `s/L, a, b` separated by ';': position along the spine from the nose "
                      "(0 < s/L < 1 [1]), half-width and half-height [m].",
                      Patterns::Anything());
    prm.add_parameter("Stations file", stations_file,
                      "A text file with these rows, instead of them; a row of names may come "
                      "first.",
                      Patterns::Anything());
    prm.add_parameter("Interpolation", interpolation,
                      "Between the stations, of the logarithms of the half-axes over those of a "
                      "round body: 'spline', the natural cubic spline, which may overshoot; "
                      "'limited', the same without bulges or necks that no station has.",
                      Patterns::Selection("limited|spline"));
    prm.add_parameter("Axes", axes,
                      "Half-axes of the ellipsoid along the spine, lateral and dorsal [m].",
                      Patterns::List(Patterns::Double(), 3, 3));
    prm.leave_subsection();
  }

  void ShapeParameters::check() const
  {
    AssertThrow(length > 0. && std::isfinite(length),
                ExcMessage("Shape/Length: the value is " + Patterns::Tools::to_string(length) +
                           ". Give a positive length [m]."));
    for (const double axis : axes)
      AssertThrow(axis > 0. && std::isfinite(axis),
                  ExcMessage("Shape/Axes: a half-axis is " + Patterns::Tools::to_string(axis) +
                             ". Give three positive lengths [m]."));
    if (type == "stations")
      read_stations(*this);
  }

  std::unique_ptr<Shape> create_shape(const ShapeParameters &parameters, const Surface &surface)
  {
    AssertThrow((parameters.type == "file") == surface.is_from_file(),
                ExcMessage("Shape/Type: a surface mesh needs both Shape/Type = file and its name "
                           "in Surface/File. Give both or neither."));
    return get_factory().create(parameters.type, parameters, surface);
  }
} // namespace caudal::ideal
