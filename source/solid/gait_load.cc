// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/solid/load.h>
#include <caudal/solid/rigid_motion.h>

namespace caudal
{
  namespace
  {
    // Errors of the shape are worked off within so many steps.
    constexpr double n_relaxation_steps = 10;

    template <int dim>
    class GaitLoad : public Load<dim>
    {
    public:
      GaitLoad(const SolidBody<dim> &body, const Gait &gait, const double damping)
          : body(body)
          , prescribed(gait, get_points(body))
          , damping(damping)
      {}

      LoadAccount get_account() const override
      {
        return LoadAccount::gait;
      }

      void add(const BodyMotion &motion, Vector<double> &force,
               BodyResponse *response) const override
      {
        Vector<double> slip = compute_velocity(motion);
        slip -= motion.velocity;
        slip *= damping;
        body.get_mass_matrix().vmult_add(force, slip);
        if (response != nullptr)
          response->damping.add(damping, body.get_mass_matrix());
      }

    private:
      const SolidBody<dim>       &body;
      const PrescribedMotion<dim> prescribed; // of the nodes
      const double                damping;

      static std::vector<Point<dim>> get_points(const SolidBody<dim> &body)
      {
        std::vector<Point<dim>> points;
        for (const auto &node : body.get_nodes())
          points.push_back(body.get_reference_point(node[0]));
        return points;
      }

      Vector<double> compute_velocity(const BodyMotion &motion) const
      {
        const auto    &nodes       = body.get_nodes();
        const auto     deformation = prescribed.compute(motion.time);
        Vector<double> shape(body.n_dofs()), result(body.n_dofs());
        for (unsigned int n = 0; n < nodes.size(); ++n)
          set_value(shape, nodes[n], deformation.positions[n]);
        const auto fit = fit_rigid_motion(body, nodes, shape, motion.positions);
        for (unsigned int n = 0; n < nodes.size(); ++n)
        {
          const Tensor<1, dim> place =
              fit.center + fit.rotation * (deformation.positions[n] - fit.reference_center);
          set_value(result, nodes[n],
                    fit.rotation * deformation.velocities[n] +
                        (place - get_value(motion.positions, nodes[n])) /
                            (n_relaxation_steps * motion.step));
        }
        return result;
      }
    };
  } // namespace

  template <int dim>
  std::unique_ptr<Load<dim>> make_gait_load(const SolidBody<dim> &body, const Gait &gait,
                                            const double damping)
  {
    return std::make_unique<GaitLoad<dim>>(body, gait, damping);
  }

  template std::unique_ptr<Load<2>> make_gait_load(const SolidBody<2> &, const Gait &, double);
  template std::unique_ptr<Load<3>> make_gait_load(const SolidBody<3> &, const Gait &, double);
} // namespace caudal
