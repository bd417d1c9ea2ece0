// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/solid/elasticity.h>
#include <caudal/solid/load.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    /** Force and stiffness of one cell. */
    template <int dim>
    class CellElasticity
    {
    public:
      explicit CellElasticity(const FiniteElement<dim> &element)
          : n(element.n_dofs_per_cell())
          , component(n)
          , node(n)
          , force(n)
          , volume_gradient(n)
          , stiffness(n, n)
      {
        for (unsigned int i = 0; i < n; ++i)
          std::tie(component[i], node[i]) = element.system_to_component_index(i);
      }

      void clear()
      {
        force            = 0;
        volume_gradient  = 0;
        stiffness        = 0;
        volume           = 0;
        reference_volume = 0;
      }

      void add_stress(const Tensor<2, dim> &P, const std::vector<Tensor<1, dim>> &gradients,
                      const double weight)
      {
        for (unsigned int i = 0; i < n; ++i)
          force[i] -= weight * (P[component[i]] * gradients[node[i]]);
      }

      void add_tangent(const Tensor<4, dim> &tangent, const std::vector<Tensor<1, dim>> &gradients,
                       const double weight)
      {
        for (unsigned int j = 0; j < n; ++j)
        {
          // dP for a displacement of node j: column k of the tangent times grad N_j.
          Tensor<2, dim> dP;
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int J = 0; J < dim; ++J)
              dP[i][J] = tangent[i][J][component[j]] * gradients[node[j]];
          for (unsigned int i = 0; i < n; ++i)
            stiffness(i, j) += weight * (dP[component[i]] * gradients[node[i]]);
        }
      }

      void add_volume(const Tensor<2, dim> &F, const std::vector<Tensor<1, dim>> &gradients,
                      const double weight)
      {
        const double         J        = determinant(F);
        const Tensor<2, dim> cofactor = J * transpose(invert(F));
        for (unsigned int i = 0; i < n; ++i)
          volume_gradient[i] += weight * (cofactor[component[i]] * gradients[node[i]]);
        volume += weight * J;
        reference_volume += weight;
      }

      /**
       * Force and stiffness of the energy kappa/2 V (ln(v/V))^2 of the volume v of the cell, V in
       * the reference configuration. The stiffness is that of the linearised ln(v/V), which is
       * positive semi-definite.
       */
      void add_volume_stabilisation(const double kappa)
      {
        const double J = volume / reference_volume;
        force.add(-kappa * std::log(J) / J, volume_gradient);
        const double factor = kappa / (J * volume);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            stiffness(i, j) += factor * volume_gradient[i] * volume_gradient[j];
      }

      const Vector<double> &get_force() const
      {
        return force;
      }
      const FullMatrix<double> &get_stiffness() const
      {
        return stiffness;
      }

    private:
      const unsigned int        n;
      std::vector<unsigned int> component, node;
      Vector<double>            force, volume_gradient;
      FullMatrix<double>        stiffness;
      double                    volume = 0, reference_volume = 0;
    };

    template <int dim>
    class ElasticLoad : public Load<dim>
    {
    public:
      explicit ElasticLoad(const SolidBody<dim> &body)
          : body(body)
      {}

      LoadAccount get_account() const override
      {
        return LoadAccount::elastic;
      }

      void add(const BodyMotion &motion, Vector<double> &force,
               BodyResponse *response) const override
      {
        const auto                          &data    = body.get_quadrature_data();
        const FiniteElement<dim>            &element = body.get_dof_handler().get_fe();
        std::vector<types::global_dof_index> dofs(element.n_dofs_per_cell());
        CellElasticity<dim>                  sums(element);
        for (const auto &cell : body.get_dof_handler().active_cell_iterators())
        {
          const auto   nodes    = get_cell_nodes<dim>(cell, motion.positions);
          const auto  &material = body.get_material(cell->material_id());
          const double kappa    = body.get_cell_volume_stabilisation(cell->material_id());
          sums.clear();
          for (unsigned int q = 0; q < data.n_q; ++q)
          {
            const unsigned int   point     = cell->active_cell_index() * data.n_q + q;
            const auto          &gradients = data.shape_gradients[point];
            const double         weight    = data.weights[point];
            const Tensor<2, dim> F         = compute_deformation_gradient(nodes, gradients);
            AssertThrow(determinant(F) > 0, ExcInvertedElement(determinant(F)));
            sums.add_stress(material.first_piola_kirchhoff_stress(F, data.points[point]), gradients,
                            weight);
            if (response != nullptr)
              sums.add_tangent(material.tangent(F, data.points[point]), gradients, weight);
            if (kappa > 0)
              sums.add_volume(F, gradients, weight);
          }
          if (kappa > 0)
            sums.add_volume_stabilisation(kappa);
          cell->get_dof_indices(dofs);
          force.add(dofs, sums.get_force());
          if (response != nullptr)
            response->stiffness.add(dofs, sums.get_stiffness());
        }
      }

    private:
      const SolidBody<dim> &body;
    };
  } // namespace

  template <int dim>
  std::unique_ptr<Load<dim>> make_elastic_load(const SolidBody<dim> &body)
  {
    return std::make_unique<ElasticLoad<dim>>(body);
  }

  template std::unique_ptr<Load<2>> make_elastic_load(const SolidBody<2> &);
  template std::unique_ptr<Load<3>> make_elastic_load(const SolidBody<3> &);
} // namespace caudal
