// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/solid/elasticity.h>
#include <caudal/solid/load.h>

namespace caudal
{
  namespace
  {
    template <int dim>
    class MuscleLoad : public Load<dim>
    {
    public:
      MuscleLoad(const SolidBody<dim> &body, const Muscle<dim> &muscle)
          : body(body)
          , muscle(muscle)
      {}

      LoadAccount get_account() const override
      {
        return LoadAccount::muscle;
      }

      void add(const BodyMotion &motion, Vector<double> &force,
               BodyResponse *response) const override
      {
        if (motion.contraction.step == 0)
          return; // before the first step it has not decided anything
        const auto                          &data    = body.get_quadrature_data();
        const FiniteElement<dim>            &element = body.get_dof_handler().get_fe();
        const unsigned int                   n       = element.n_dofs_per_cell();
        std::vector<types::global_dof_index> dofs(n);
        Vector<double>                       cell_force(n);
        FullMatrix<double>                   cell_stiffness(n, n);
        for (const auto &cell : body.get_dof_handler().active_cell_iterators())
        {
          const auto nodes = get_cell_nodes<dim>(cell, motion.positions);
          cell_force       = 0;
          cell_stiffness   = 0;
          for (unsigned int q = 0; q < data.n_q; ++q)
          {
            const unsigned int       index     = cell->active_cell_index() * data.n_q + q;
            const auto              &gradients = data.shape_gradients[index];
            const double             weight    = data.weights[index];
            const MaterialPoint<dim> point{data.points[index], cell->material_id()};
            Tensor<1, dim>           density; // in the domain's frame
            Tensor<2, dim>           stress;
            if (muscle.has_force())
              density = body.rotate_to_domain(
                  muscle.force_density(motion.contraction, point, motion.time));
            if (muscle.has_active_stress())
              stress = muscle.active_stress(motion.contraction, point, motion.time);
            const Tensor<2, dim> P = compute_deformation_gradient(nodes, gradients) * stress;
            for (unsigned int i = 0; i < n; ++i)
            {
              const auto [component, a] = element.system_to_component_index(i);
              cell_force[i] += weight * (density[component] * data.shape_values[q][a] -
                                         P[component] * gradients[a]);
            }
            if (response != nullptr && muscle.has_active_stress())
              add_stiffness(element, stress, gradients, weight, cell_stiffness);
          }
          cell->get_dof_indices(dofs);
          force.add(dofs, cell_force);
          if (response != nullptr && muscle.has_active_stress())
            response->stiffness.add(dofs, cell_stiffness);
        }
      }

    private:
      const SolidBody<dim> &body;
      const Muscle<dim>    &muscle;

      /** Stiffness of P_a = F S_a: (grad N_j S_a).grad N_i for equal components. */
      static void add_stiffness(const FiniteElement<dim> &element, const Tensor<2, dim> &stress,
                                const std::vector<Tensor<1, dim>> &gradients, const double weight,
                                FullMatrix<double> &stiffness)
      {
        for (unsigned int i = 0; i < stiffness.m(); ++i)
          for (unsigned int j = 0; j < stiffness.n(); ++j)
          {
            const auto [component_i, a] = element.system_to_component_index(i);
            const auto [component_j, b] = element.system_to_component_index(j);
            if (component_i == component_j)
              stiffness(i, j) += weight * (gradients[b] * stress * gradients[a]);
          }
      }
    };
  } // namespace

  template <int dim>
  std::unique_ptr<Load<dim>> make_muscle_load(const SolidBody<dim> &body, const Muscle<dim> &muscle)
  {
    return std::make_unique<MuscleLoad<dim>>(body, muscle);
  }

  template std::unique_ptr<Load<2>> make_muscle_load(const SolidBody<2> &, const Muscle<2> &);
  template std::unique_ptr<Load<3>> make_muscle_load(const SolidBody<3> &, const Muscle<3> &);
} // namespace caudal
