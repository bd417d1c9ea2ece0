#include <caudal/base/checks.h>
#include <caudal/ideal/resistance.h>

#include <deal.II/base/quadrature_lib.h>

#include <memory>

namespace caudal::ideal
{
  namespace
  {
    /** An element of the surface: place, area N, velocity and velocities of the modes. */
    struct Element
    {
      Tensor<1, 3>              X, N, u;
      std::vector<Tensor<1, 3>> modes;
    };

    std::vector<Element> compute_elements(const SwimmingShape &shape, const ReferenceRule &rule,
                                          const MotionInstant &instant)
    {
      const GaitState      gait   = shape.gait.evaluate(instant.argument);
      const SurfaceMotion  motion = shape.deformation.place(gait.c);
      std::vector<Element> elements;
      for (unsigned int cell = 0; cell < shape.surface.n_cells(); ++cell)
      {
        const auto         &nodes = shape.surface.get_nodes(cell);
        CellArray<Point<3>> places;
        for (unsigned int k = 0; k < nodes.size(); ++k)
          places[k] = motion.positions[nodes[k]];
        const PlacedRule at(rule, places);
        for (unsigned int q = 0; q < rule.size(); ++q)
        {
          Element element{Tensor<1, 3>(at.points[q]), at.areas[q], {}, {}};
          element.u = get_linear(instant.velocity) +
                      cross_product_3d(get_angular(instant.velocity), element.X);
          element.modes.resize(gait.c.size());
          for (unsigned int i = 0; i < gait.c.size(); ++i)
          {
            for (unsigned int k = 0; k < nodes.size(); ++k)
              element.modes[i] += rule.values[q][k] * motion.modes[i][nodes[k]];
            element.u += instant.rate * gait.rates[i] * element.modes[i];
          }
          elements.push_back(element);
        }
      }
      return elements;
    }

    /** C_f, given or by Blasius's law. */
    double compute_friction(const ResistanceParameters &parameters, const double length,
                            const std::vector<Element> &elements)
    {
      if (parameters.friction > 0.)
        return parameters.friction;
      double area = 0., squares = 0.;
      for (const Element &element : elements)
      {
        area += element.N.norm();
        squares += element.N.norm() * element.u.norm_square();
      }
      const double reynolds = std::sqrt(squares / area) * length / parameters.viscosity;
      return reynolds > 0. ? 1.328 / std::sqrt(reynolds) : 0.;
    }
  } // namespace

  void ResistanceParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Resistance");
    prm.add_parameter("Active", active,
                      "Whether friction and form drag act on the surface, by the formulas of a "
                      "plate: a crude substitute for viscosity, without a wake.");
    prm.add_parameter("Friction coefficient", friction,
                      "C_f, relative to (1/2) rho u_t^2 dS [1]; 0: 1.328 Re^(-1/2).");
    prm.add_parameter("Drag coefficient", drag,
                      "C_D, relative to (1/2) rho u_n^2 dS of motion normal to the surface [1].");
    prm.add_parameter("Kinematic viscosity", viscosity, "For Re [m^2/s].");
    prm.leave_subsection();
  }

  void ResistanceParameters::check() const
  {
    const std::string remedy = "Give a number that is not negative.";
    check_not_negative("Resistance/Friction coefficient", friction, remedy);
    check_not_negative("Resistance/Drag coefficient", drag, remedy);
    check_positive("Resistance/Kinematic viscosity", viscosity, "Give a positive one.");
  }

  ExternalForce create_resistance(const ResistanceParameters &parameters,
                                  const SwimmingShape        &shape)
  {
    if (!parameters.active)
      return {};
    const auto rule = std::make_shared<ReferenceRule>(QGauss<2>(2), shape.surface.get_fe());
    return [parameters, &shape, rule](const MotionInstant &instant) {
      const std::vector<Element> elements = compute_elements(shape, *rule, instant);
      const double               friction =
          compute_friction(parameters, shape.deformation.get_length(), elements);
      Tensor<1, 3> force, torque;
      Load         load;
      load.on_modes.resize(shape.deformation.n_modes(), 0.);
      for (const Element &element : elements)
      {
        const double       area   = element.N.norm();
        const Tensor<1, 3> normal = element.N / area;
        const double       u_n    = element.u * normal;
        const Tensor<1, 3> u_t    = element.u - u_n * normal;
        const Tensor<1, 3> df =
            -0.5 * shape.densities.fluid * area *
            (friction * u_t.norm() * u_t + parameters.drag * std::abs(u_n) * u_n * normal);
        force += df;
        torque += cross_product_3d(element.X, df);
        for (std::size_t i = 0; i < element.modes.size(); ++i)
          load.on_modes[i] += df * element.modes[i];
      }
      load.screw = make_screw(torque, force);
      return load;
    };
  }
} // namespace caudal::ideal
