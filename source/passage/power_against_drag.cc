// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/ideal/exterior_flow.h>
#include <caudal/mesh/shape.h>
#include <caudal/passage/power_curve.h>
#include <caudal/passage/print.h>

#include <cmath>
#include <memory>

namespace caudal::passage
{
  namespace
  {
    /** A body of unit length: what its drag and its acceleration depend on. */
    struct BodyFigures
    {
      double volume;     // over l^3 [1]
      double added_mass; // along the body, over the mass of the water that it displaces [1]
      double area;       // of the skin, over l^2 [1]
    };

    double compute_area(const ideal::Surface &surface, const std::vector<Point<3>> &places)
    {
      // The nine nodes of a cell are the corners of four quadrilaterals, of two triangles each;
      // deal.II numbers corners first, then edges left, right, bottom, top, then the middle.
      const unsigned int parts[4][4] = {{0, 6, 8, 4}, {6, 1, 5, 8}, {4, 8, 7, 2}, {8, 5, 3, 7}};
      double             area        = 0.;
      for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
        for (const auto &part : parts)
        {
          const auto &nodes = surface.get_nodes(cell);
          const auto  at    = [&](const unsigned int k) { return places[nodes[part[k]]]; };
          for (const unsigned int k : {1u, 2u})
            area += 0.5 * cross_product_3d(at(k) - at(0), at(k + 1) - at(0)).norm();
        }
      return area;
    }

    /**
     * The power against the drag of a rigid body of the fish's shape, and its kinetic energy:
     *   P = rho/2 C (S) U^3 / efficiency, C = (1 + k) 0.455/(log10 Re)^2.58
     * with the friction of a turbulent flat plate (Schlichting), S the area of the skin; mass and
     * added mass of the fish are accelerated, the latter by boundary elements on its surface.
     */
    class PowerAgainstDrag : public PowerCurve
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.enter_subsection("Shape");
        shape->add_entries(prm);
        prm.leave_subsection();
        prm.add_parameter("Drag factor", drag_factor,
                          "The swimming fish's drag over that of a flat plate of its skin [1]: 1.2 "
                          "for form drag of a stiff body, 3 to 5 are told of undulating ones.");
        prm.add_parameter("Efficiency", efficiency, "Useful over muscle power [1].");
        prm.add_parameter("Density", density, "Density of water and fish [kg/m^3].");
        prm.add_parameter("Kinematic viscosity", viscosity, "Of the water [m^2/s].");
      }

      void check(const std::string &path) const override
      {
        shape->check(path + "/Shape");
        check_positive(path + "/Drag factor", drag_factor);
        check_value(0. < efficiency && efficiency <= 1., path + "/Efficiency", efficiency,
                    "Give a number up to 1.");
        check_positive(path + "/Density", density, "Give a positive density [kg/m^3].");
        check_positive(path + "/Kinematic viscosity", viscosity, "Give a positive number [m^2/s].");
      }

      Power make_power(const double length) const override
      {
        const BodyFigures &body   = get_figures();
        const double       area   = body.area * length * length;
        const double       factor = 0.5 * density * drag_factor * area / efficiency;
        const double       rate   = length / viscosity;
        const double       mass   = density * body.volume * std::pow(length, 3);
        return {[=](const double speed) {
                  // The formula ends where the flow is laminar all over.
                  const double reynolds = std::max(rate * speed, 1e4);
                  const double friction = 0.455 / std::pow(std::log10(reynolds), 2.58);
                  return factor * friction * speed * speed * speed;
                },
                mass * (1. + body.added_mass) / efficiency};
      }

      std::string describe() const override
      {
        const BodyFigures &body = get_figures();
        return "muscle power against the drag of the fish's shape (" + print_number(drag_factor) +
               " times a turbulent flat plate of its skin, " + print_number(body.area) +
               " l^2, efficiency " + print_number(efficiency) +
               ") and for the acceleration of its mass (" + print_number(body.volume) +
               " rho l^3) and added mass (" + print_number(body.added_mass) +
               " of that, by boundary elements): an estimate, not a measurement";
      }

    private:
      const BodyFigures &get_figures() const
      {
        if (figures.volume == 0.)
        {
          const auto           body   = shape->make_straight_body("Energy/Drag/Shape");
          const double         length = body->get_length();
          const ideal::Surface surface({4, 3});
          ideal::SurfaceMotion motion;
          for (const Point<3> &reference : surface.get_reference_points())
            motion.positions.push_back(Point<3>(body->place(reference) / length));
          figures.area = compute_area(surface, motion.positions);
          ideal::BoundaryElements  boundary_elements(surface, MPI_COMM_SELF);
          const auto               flow   = boundary_elements.solve(motion);
          const ideal::Potentials &result = flow.get_potentials();
          figures.volume                  = result.volume;
          figures.added_mass              = result.added_mass(3, 3) / result.volume;
        }
        return figures;
      }

      // Shared by copies, as choices can't be copied; nobody changes it.
      std::shared_ptr<ShapeParameters<3>> shape =
          std::make_shared<ShapeParameters<3>>("stations", 0.1);
      double              drag_factor = 1.2, efficiency = 0.7, density = 1000., viscosity = 1e-6;
      mutable BodyFigures figures{0., 0., 0.}; // once they were computed
    };

    const Registration<PowerCurve, PowerAgainstDrag>
        registration("drag", "from the drag and the added mass of the fish's shape");
  } // namespace
} // namespace caudal::passage
