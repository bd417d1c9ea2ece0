// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/solid/load.h>

namespace caudal
{
  namespace
  {
    template <int dim>
    class FeedbackLoad : public Load<dim>
    {
    public:
      explicit FeedbackLoad(const SolidBody<dim> &body)
          : body(body)
      {}

      LoadAccount get_account() const override
      {
        return LoadAccount::feedback;
      }

      void add(const BodyMotion &motion, Vector<double> &force,
               BodyResponse *response) const override
      {
        Vector<double> displacement(body.get_initial_positions()), opposite_velocity(body.n_dofs());
        displacement -= motion.positions;
        opposite_velocity -= motion.velocity;
        body.get_feedback_stiffness().vmult_add(force, displacement);
        body.get_feedback_damping().vmult_add(force, opposite_velocity);
        if (response != nullptr)
        {
          response->stiffness.add(1, body.get_feedback_stiffness());
          response->damping.add(1, body.get_feedback_damping());
        }
      }

    private:
      const SolidBody<dim> &body;
    };
  } // namespace

  template <int dim>
  std::unique_ptr<Load<dim>> make_feedback_load(const SolidBody<dim> &body)
  {
    return std::make_unique<FeedbackLoad<dim>>(body);
  }

  template std::unique_ptr<Load<2>> make_feedback_load(const SolidBody<2> &);
  template std::unique_ptr<Load<3>> make_feedback_load(const SolidBody<3> &);
} // namespace caudal
