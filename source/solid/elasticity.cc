#include <caudal/solid/elasticity.h>

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

    /**
     * The part of the volumetric damping that acts at each quadrature point
     * rather than on the cell's volume: enough against cells whose ends swell
     * and shrink in turn, too little to make them resist bending.
     */
    constexpr double pointwise_fraction = 0.02;

    /** matrix += factor v v^T */
    void add_outer_product(const double factor, const Vector<double> &v, FullMatrix<double> &matrix)
    {
      for (unsigned int i = 0; i < v.size(); ++i)
        for (unsigned int j = 0; j < v.size(); ++j)
          matrix(i, j) += factor * v[i] * v[j];
    }
  } // namespace

  void ElasticSystem::reinit(const SparsityPattern &pattern)
  {
    elastic_force.reinit(pattern.n_rows());
    active_force.reinit(pattern.n_rows());
    stiffness.reinit(pattern);
    volumetric_damping.reinit(pattern);
  }

  template <int dim>
  void assemble_elastic_system(const SolidBody<dim> &body, const Vector<double> &positions,
                               const ActiveLoad<dim> &load, const bool with_matrices,
                               ElasticSystem &system)
  {
    const auto                          &data    = body.get_quadrature_data();
    const FiniteElement<dim>            &element = body.get_dof_handler().get_fe();
    const unsigned int                   n       = element.n_dofs_per_cell();
    std::vector<types::global_dof_index> dofs(n);
    Vector<double>            elastic(n), active(n), volume_gradient(n), point_gradient(n);
    FullMatrix<double>        stiffness(n, n), cell_damping(n, n);
    std::vector<unsigned int> component(n), node(n);
    for (unsigned int i = 0; i < n; ++i)
      std::tie(component[i], node[i]) = element.system_to_component_index(i);

    system.elastic_force = 0;
    system.active_force  = 0;
    if (with_matrices)
    {
      system.stiffness          = 0;
      system.volumetric_damping = 0;
    }
    for (const auto &cell : body.get_dof_handler().active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      const auto  nodes    = get_nodes<dim>(cell, dofs, positions);
      const auto &material = body.get_stress_model(cell->material_id());
      elastic              = 0;
      active               = 0;
      stiffness            = 0;
      volume_gradient      = 0;
      cell_damping         = 0;
      double       volume  = 0;
      const double damping =
          body.get_parameters().region_parameters[cell->material_id()]->volumetric_damping;
      for (unsigned int q = 0; q < data.n_q; ++q)
      {
        const unsigned int   point     = cell->active_cell_index() * data.n_q + q;
        const auto          &gradients = data.shape_gradients[point];
        const double         weight    = data.weights[point];
        const Tensor<2, dim> F         = compute_deformation_gradient(nodes, gradients);
        AssertThrow(determinant(F) > 0, ExcInvertedElement(determinant(F)));

        const Tensor<2, dim> P = material.first_piola_kirchhoff_stress(F);
        Tensor<2, dim>       active_stress;
        Tensor<1, dim>       force;
        if (load.stress)
          active_stress = load.stress(data.points[point], cell->material_id());
        if (load.force_density)
          force = load.force_density(data.points[point], cell->material_id());
        const Tensor<2, dim> active_P = F * active_stress;
        for (unsigned int i = 0; i < n; ++i)
        {
          elastic[i] -= weight * (P[component[i]] * gradients[node[i]]);
          active[i] += weight * (force[component[i]] * data.shape_values[q][node[i]] -
                                 active_P[component[i]] * gradients[node[i]]);
        }
        if (!with_matrices)
          continue;

        const double         J        = determinant(F);
        const Tensor<2, dim> cofactor = J * transpose(invert(F));
        for (unsigned int i = 0; i < n; ++i)
          point_gradient[i] = cofactor[component[i]] * gradients[node[i]];
        volume += weight * J;
        volume_gradient.add(weight, point_gradient);
        add_outer_product(pointwise_fraction * damping * weight / J, point_gradient, cell_damping);
        const Tensor<4, dim> tangent = material.tangent(F);
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
      system.elastic_force.add(dofs, elastic);
      system.active_force.add(dofs, active);
      if (with_matrices)
      {
        system.stiffness.add(dofs, stiffness);
        add_outer_product(damping / volume, volume_gradient, cell_damping);
        system.volumetric_damping.add(dofs, cell_damping);
      }
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
      const auto nodes = get_nodes<dim>(cell, dofs, positions);
      for (unsigned int q = 0; q < data.n_q; ++q)
      {
        const unsigned int   point = cell->active_cell_index() * data.n_q + q;
        const Tensor<2, dim> F = compute_deformation_gradient(nodes, data.shape_gradients[point]);
        const double         J = determinant(F);
        summary.smallest_jacobian = std::min(summary.smallest_jacobian, J);
        summary.largest_jacobian  = std::max(summary.largest_jacobian, J);
        volume += data.weights[point] * J;
        AssertThrow(J > 0, ExcInvertedElement(J));
        summary.elastic_energy +=
            data.weights[point] * body.get_stress_model(cell->material_id()).strain_energy(F);
      }
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
      double         J     = 0;
      Tensor<2, dim> stress;
      for (unsigned int q = 0; q < data.n_q; ++q)
      {
        const Tensor<2, dim> F = compute_deformation_gradient(
            nodes, data.shape_gradients[cell->active_cell_index() * data.n_q + q]);
        J += determinant(F) / data.n_q;
        stress += body.get_stress_model(cell->material_id()).first_piola_kirchhoff_stress(F) *
                  transpose(F) / determinant(F) / data.n_q;
      }
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
