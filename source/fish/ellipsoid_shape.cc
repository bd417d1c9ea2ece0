// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/elliptic_body.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    /** An ellipsoid with the nose at s = 0: g_a and g_b are constant. */
    class EllipsoidBody : public EllipticBody
    {
    public:
      explicit EllipsoidBody(const std::vector<double> &axes)
          : EllipticBody(2. * axes[0])
          , axes(axes)
      {}

    private:
      std::pair<double, double> get_scales(const double) const override
      {
        return {axes[1], axes[2]};
      }

      const std::vector<double> axes;
    };

    template <int dim>
    class EllipsoidShape : public EllipticShape<dim>
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Axes", axes, "Half-axes along the spine, lateral and dorsal [m].",
                          Patterns::List(Patterns::Double(), 3, 3));
      }

      void check(const std::string &path) const override
      {
        for (const double axis : axes)
          AssertThrow(axis > 0. && std::isfinite(axis),
                      ExcMessage(path + "/Axes: a half-axis is " +
                                 Patterns::Tools::to_string(axis) +
                                 ". Give three positive lengths [m]."));
      }

      std::unique_ptr<StraightBody> make_straight_body(const ShapeLengths &) const override
      {
        return std::make_unique<EllipsoidBody>(axes);
      }

    private:
      std::vector<double> axes = {0.05, 0.01, 0.01};
    };

    const DimensionalRegistration<Shape, EllipsoidShape>
        registration("ellipsoid", "an ellipsoid (2D: its middle section) behind its nose");
  } // namespace
} // namespace caudal
