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
      GaitLoad(const SolidBody<dim> &body, const Gait<dim> &gait, const double damping)
          : body(body)
          , gait(gait)
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
      const SolidBody<dim> &body;
      const Gait<dim>      &gait;
      const double          damping;

      Vector<double> compute_velocity(const BodyMotion &motion) const
      {
        const auto     deformation = gait.at(motion.time);
        Vector<double> shape(body.n_dofs()), result(body.n_dofs());
        for (const auto &node : body.get_nodes())
          set_value(shape, node, deformation.position(body.get_reference_point(node[0])));
        const auto fit = fit_rigid_motion(body, body.get_nodes(), shape, motion.positions);
        for (const auto &node : body.get_nodes())
        {
          const Tensor<1, dim> place =
              fit.center + fit.rotation * (get_value(shape, node) - fit.reference_center);
          const Tensor<1, dim> rate =
              fit.rotation * deformation.velocity(body.get_reference_point(node[0]));
          set_value(result, node,
                    rate + (place - get_value(motion.positions, node)) /
                               (n_relaxation_steps * motion.step));
        }
        return result;
      }
    };
  } // namespace

  template <int dim>
  std::unique_ptr<Load<dim>> make_gait_load(const SolidBody<dim> &body, const Gait<dim> &gait,
                                            const double damping)
  {
    return std::make_unique<GaitLoad<dim>>(body, gait, damping);
  }

  template std::unique_ptr<Load<2>> make_gait_load(const SolidBody<2> &, const Gait<2> &, double);
  template std::unique_ptr<Load<3>> make_gait_load(const SolidBody<3> &, const Gait<3> &, double);
} // namespace caudal
