#include <caudal/solid/elasticity.h>

#include <cmath>
#include <limits>

namespace caudal
{
  namespace
  {
    /** The deformation gradient at quadrature point @p point of a cell with nodal positions @p x.
     */
    template <int dim>
    Tensor<2, dim> compute_deformation_gradient(const std::vector<Point<dim>>     &x,
                                                const std::vector<Tensor<1, dim>> &gradients)
    {
      Tensor<2, dim> F;
      for (unsigned int a = 0; a < x.size(); ++a)
        F += outer_product(x[a], gradients[a]);
      return F;
    }

    template <int dim>
    std::vector<Point<dim>> get_nodes(const typename DoFHandler<dim>::active_cell_iterator &cell,
                                      const std::vector<types::global_dof_index>           &dofs,
                                      const Vector<double> &positions)
    {
      std::vector<Point<dim>> nodes(dofs.size() / dim);
      for (unsigned int i = 0; i < dofs.size(); ++i)
      {
        const auto [component, a] = cell->get_fe().system_to_component_index(i);
        nodes[a][component]       = positions[dofs[i]];
      }
      return nodes;
    }

    /** What a cell contributes to an ElasticSystem. */
    template <int dim>
    class CellSystem
    {
    public:
      explicit CellSystem(const FiniteElement<dim> &element)
          : n(element.n_dofs_per_cell())
          , component(n)
          , node(n)
          , elastic(n)
          , active(n)
          , volume_gradient(n)
          , stiffness(n, n)
      {
        for (unsigned int i = 0; i < n; ++i)
          std::tie(component[i], node[i]) = element.system_to_component_index(i);
      }

      void clear()
      {
        elastic          = 0;
        active           = 0;
        volume_gradient  = 0;
        stiffness        = 0;
        volume           = 0;
        reference_volume = 0;
      }

      void add_forces(const Tensor<2, dim> &P, const Tensor<2, dim> &active_P,
                      const Tensor<1, dim> &force, const std::vector<double> &shape_values,
                      const std::vector<Tensor<1, dim>> &gradients, const double weight)
      {
        for (unsigned int i = 0; i < n; ++i)
        {
          elastic[i] -= weight * (P[component[i]] * gradients[node[i]]);
          active[i] += weight * (force[component[i]] * shape_values[node[i]] -
                                 active_P[component[i]] * gradients[node[i]]);
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

      void add_stiffness(const Tensor<4, dim> &tangent, const Tensor<2, dim> &active_stress,
                         const std::vector<Tensor<1, dim>> &gradients, const double weight)
      {
        for (unsigned int j = 0; j < n; ++j)
        {
          // dP for a displacement of node j: column k of the tangent times grad N_j.
          Tensor<2, dim> dP;
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int J = 0; J < dim; ++J)
              dP[i][J] = tangent[i][J][component[j]] * gradients[node[j]];
          dP[component[j]] += gradients[node[j]] * active_stress;
          for (unsigned int i = 0; i < n; ++i)
            stiffness(i, j) += weight * (dP[component[i]] * gradients[node[i]]);
        }
      }

      /**
       * Force and stiffness of the energy kappa/2 V (ln(v/V))^2 of the volume v of
       * the cell, V in the reference configuration. The stiffness is that of the
       * linearised ln(v/V), which is positive semi-definite.
       */
      void add_volume_stabilisation(const double kappa, const bool with_stiffness)
      {
        const double J = volume / reference_volume;
        elastic.add(-kappa * std::log(J) / J, volume_gradient);
        if (!with_stiffness)
          return;
        const double factor = kappa / (J * volume);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            stiffness(i, j) += factor * volume_gradient[i] * volume_gradient[j];
      }

      void distribute(const std::vector<types::global_dof_index> &dofs, const bool with_stiffness,
                      ElasticSystem &system) const
      {
        system.elastic_force.add(dofs, elastic);
        system.active_force.add(dofs, active);
        if (with_stiffness)
          system.stiffness.add(dofs, stiffness);
      }

    private:
      const unsigned int        n;
      std::vector<unsigned int> component, node;
      Vector<double>            elastic, active, volume_gradient;
      FullMatrix<double>        stiffness;
      double                    volume = 0, reference_volume = 0;
    };

    /** kappa of the energy of the cells' volumes [Pa] in a region. */
    template <int dim>
    double get_volume_stabilisation(const SolidBody<dim> &body, const types::material_id region)
    {
      return body.get_parameters().region_parameters[region]->cell_volume_stabilisation;
    }
  } // namespace

  void ElasticSystem::reinit(const SparsityPattern &pattern)
  {
    elastic_force.reinit(pattern.n_rows());
    active_force.reinit(pattern.n_rows());
    stiffness.reinit(pattern);
  }

  template <int dim>
  void assemble_elastic_system(const SolidBody<dim> &body, const Vector<double> &positions,
                               const ActiveLoad<dim> &load, const bool with_stiffness,
                               ElasticSystem &system)
  {
    const auto                          &data    = body.get_quadrature_data();
    const FiniteElement<dim>            &element = body.get_dof_handler().get_fe();
    std::vector<types::global_dof_index> dofs(element.n_dofs_per_cell());
    CellSystem<dim>                      cell_system(element);

    system.elastic_force = 0;
    system.active_force  = 0;
    if (with_stiffness)
      system.stiffness = 0;
    for (const auto &cell : body.get_dof_handler().active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      const auto               nodes    = get_nodes<dim>(cell, dofs, positions);
      const types::material_id region   = cell->material_id();
      const auto              &material = body.get_material(region);
      const double             kappa    = get_volume_stabilisation(body, region);
      cell_system.clear();
      for (unsigned int q = 0; q < data.n_q; ++q)
      {
        const unsigned int   point     = cell->active_cell_index() * data.n_q + q;
        const auto          &gradients = data.shape_gradients[point];
        const double         weight    = data.weights[point];
        const Tensor<2, dim> F         = compute_deformation_gradient(nodes, gradients);
        AssertThrow(determinant(F) > 0, ExcInvertedElement(determinant(F)));

        Tensor<2, dim> active_stress;
        Tensor<1, dim> force;
        if (load.stress)
          active_stress = load.stress(data.points[point], region);
        if (load.force_density)
          force = load.force_density(data.points[point], region);
        cell_system.add_forces(material.first_piola_kirchhoff_stress(F, data.points[point]),
                               F * active_stress, force, data.shape_values[q], gradients, weight);
        if (kappa > 0)
          cell_system.add_volume(F, gradients, weight);
        if (with_stiffness)
          cell_system.add_stiffness(material.tangent(F, data.points[point]), active_stress,
                                    gradients, weight);
      }
      if (kappa > 0)
        cell_system.add_volume_stabilisation(kappa, with_stiffness);
      cell_system.distribute(dofs, with_stiffness, system);
    }
  }

  template <int dim>
  DeformationSummary summarise_deformation(const SolidBody<dim> &body,
                                           const Vector<double> &positions)
  {
    const auto                          &data = body.get_quadrature_data();
    std::vector<types::global_dof_index> dofs(body.get_dof_handler().get_fe().n_dofs_per_cell());
    DeformationSummary                   summary{std::numeric_limits<double>::max(),
                               std::numeric_limits<double>::lowest(), 0, 0};
    double                               volume = 0;
    for (const auto &cell : body.get_dof_handler().active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      const auto nodes       = get_nodes<dim>(cell, dofs, positions);
      double     cell_volume = 0, reference_volume = 0;
      for (unsigned int q = 0; q < data.n_q; ++q)
      {
        const unsigned int   point = cell->active_cell_index() * data.n_q + q;
        const Tensor<2, dim> F = compute_deformation_gradient(nodes, data.shape_gradients[point]);
        const double         J = determinant(F);
        summary.smallest_jacobian = std::min(summary.smallest_jacobian, J);
        summary.largest_jacobian  = std::max(summary.largest_jacobian, J);
        cell_volume += data.weights[point] * J;
        reference_volume += data.weights[point];
        AssertThrow(J > 0, ExcInvertedElement(J));
        summary.elastic_energy +=
            data.weights[point] *
            body.get_material(cell->material_id()).strain_energy(F, data.points[point]);
      }
      volume += cell_volume;
      const double log_J = std::log(cell_volume / reference_volume);
      summary.elastic_energy += 0.5 * get_volume_stabilisation(body, cell->material_id()) *
                                reference_volume * log_J * log_J;
    }
    summary.volume_change = volume / body.get_reference_volume() - 1;
    return summary;
  }

  template <int dim>
  CellDeformation compute_cell_deformation(const SolidBody<dim> &body,
                                           const Vector<double> &positions)
  {
    const auto                          &data    = body.get_quadrature_data();
    const unsigned int                   n_cells = body.get_triangulation().n_active_cells();
    std::vector<types::global_dof_index> dofs(body.get_dof_handler().get_fe().n_dofs_per_cell());
    CellDeformation                      result;
    result.jacobian.reinit(n_cells);
    result.region.reinit(n_cells);
    const std::string axes = "xyz";
    for (const auto &cell : body.get_dof_handler().active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      const auto     nodes = get_nodes<dim>(cell, dofs, positions);
      double         J = 0, volume = 0, reference_volume = 0;
      Tensor<2, dim> stress;
      for (unsigned int q = 0; q < data.n_q; ++q)
      {
        const unsigned int   point = cell->active_cell_index() * data.n_q + q;
        const Tensor<2, dim> F = compute_deformation_gradient(nodes, data.shape_gradients[point]);
        J += determinant(F) / data.n_q;
        volume += data.weights[point] * determinant(F);
        reference_volume += data.weights[point];
        stress += body.get_material(cell->material_id())
                      .first_piola_kirchhoff_stress(F, data.points[point]) *
                  transpose(F) / determinant(F) / data.n_q;
      }
      const double pressure = -get_volume_stabilisation(body, cell->material_id()) *
                              reference_volume / volume * std::log(volume / reference_volume);
      for (unsigned int d = 0; d < dim; ++d)
        stress[d][d] -= pressure;
      result.jacobian[cell->active_cell_index()] = J;
      result.region[cell->active_cell_index()]   = cell->material_id();
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
        {
          Vector<float> &component =
              result.cauchy_stress[std::string("stress_") + axes[i] + axes[j]];
          if (component.size() == 0)
            component.reinit(n_cells);
          component[cell->active_cell_index()] = stress[i][j];
        }
    }
    return result;
  }

#define INSTANTIATE(dim)                                                                           \
  template void assemble_elastic_system(const SolidBody<dim> &, const Vector<double> &,            \
                                        const ActiveLoad<dim> &, bool, ElasticSystem &);           \
  template DeformationSummary summarise_deformation(const SolidBody<dim> &,                        \
                                                    const Vector<double> &);                       \
  template CellDeformation compute_cell_deformation(const SolidBody<dim> &, const Vector<double> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
