// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/ideal/resistance.h>

#include <deal.II/base/quadrature_lib.h>

#include <memory>

namespace caudal::ideal
{
  namespace
  {
    struct SurfaceElement
    {
      unsigned int cell, q;
      Tensor<1, 3> N; ///< area times normal [m^2]
      Tensor<1, 3> u; ///< velocity [m/s]
    };

    std::vector<SurfaceElement> compute_elements(const Surface &surface, const ReferenceRule &rule,
                                                 const std::vector<Point<3>>     &places,
                                                 const std::vector<Tensor<1, 3>> &velocities)
    {
      std::vector<SurfaceElement> elements;
      for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
      {
        const auto            &nodes = surface.get_nodes(cell);
        const PlacedRule       at(rule, extract_cell(places, nodes));
        ReferenceRule::Vectors u;
        rule.interpolate(ReferenceRule::value, extract_cell(velocities, nodes), u);
        for (unsigned int q = 0; q < rule.size(); ++q)
          elements.push_back({cell, q, at.get_area(q), Point<3>(u[0][q], u[1][q], u[2][q])});
      }
      return elements;
    }

    /** C_f, given or by Blasius's law for the root mean square of the velocity. */
    double compute_friction(const ResistanceParameters &parameters, const double length,
                            const std::vector<SurfaceElement> &elements)
    {
      if (parameters.friction > 0.)
        return parameters.friction;
      double area = 0., squares = 0.;
      for (const SurfaceElement &element : elements)
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
                      "Whether friction and a cross-flow force act on the surface, by the "
                      "formulas of a plate: a crude substitute for viscosity, without a wake.");
    prm.add_parameter("Friction coefficient", friction,
                      "C_f of the force (1/2) rho C_f u_t^2 dS against the motion along the "
                      "surface [1]. 0: that of a laminar boundary layer, 1.328 Re^(-1/2) (Blasius "
                      "1908), good up to Re = 5e5; from there on 0.074 Re^(-1/5) (Prandtl 1927) "
                      "is usual, which has to be given.");
    prm.add_parameter("Cross-flow coefficient", drag,
                      "C_D of the force (1/2) rho C_D u_n^2 dS against the motion normal to the "
                      "surface, on each side of the body [1]; 0: none. 1 gives a plate across the "
                      "flow the drag coefficient 2, a long cylinder 1.33 and a sphere 1, about "
                      "what is measured (Hoerner, Fluid-Dynamic Drag, 1965). It is not the drag of "
                      "a swimming fish: the undulating sides push it forward as well, so that a "
                      "larger one can make it faster.");
    prm.add_parameter("Kinematic viscosity", viscosity, "For Re [m^2/s].");
    prm.leave_subsection();
  }

  void ResistanceParameters::check() const
  {
    const std::string remedy = "Give a number that is not negative.";
    check_not_negative("Resistance/Friction coefficient", friction, remedy);
    check_not_negative("Resistance/Cross-flow coefficient", drag, remedy);
    check_positive("Resistance/Kinematic viscosity", viscosity, "Give a positive one.");
  }

  ExternalForce create_resistance(const ResistanceParameters &parameters,
                                  const SwimmingShape        &shape)
  {
    if (!parameters.active)
      return [](const MotionInstant &) { return Load(); };
    const auto rule = std::make_shared<ReferenceRule>(QGauss<2>(2), shape.surface.get_fe());
    return [parameters, &shape, rule](const MotionInstant &instant) {
      const GaitState     gait   = shape.gait.evaluate(instant.argument);
      const SurfaceMotion motion = shape.deformation.place(gait.c);
      const auto          elements =
          compute_elements(shape.surface, *rule, motion.positions,
                           motion.compute_velocities(instant.velocity, gait.rates, instant.rate));
      const double friction =
          compute_friction(parameters, shape.deformation.get_length(), elements);
      Load load;
      load.on_modes.resize(motion.modes.size(), 0.);
      for (const SurfaceElement &element : elements)
      {
        const double       area   = element.N.norm();
        const Tensor<1, 3> normal = element.N / area;
        const double       u_n    = element.u * normal;
        const Tensor<1, 3> u_t    = element.u - u_n * normal;
        const Tensor<1, 3> df =
            -0.5 * shape.densities.fluid * area *
            (friction * u_t.norm() * u_t + parameters.drag * std::abs(u_n) * u_n * normal);
        const auto &nodes = shape.surface.get_nodes(element.cell);
        for (unsigned int k = 0; k < nodes.size(); ++k)
        {
          const Tensor<1, 3> at_node = rule->get_value(k, element.q) * df;
          const Tensor<1, 3> X(motion.positions[nodes[k]]);
          load.screw += make_screw(cross_product_3d(X, at_node), at_node);
          for (unsigned int i = 0; i < motion.modes.size(); ++i)
            load.on_modes[i] += at_node * motion.modes[i][nodes[k]];
        }
      }
      return load;
    };
  }
} // namespace caudal::ideal
