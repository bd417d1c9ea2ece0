// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/linear/conjugate_residuals.h>
#include <caudal/viscous/block_preconditioner.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>

namespace caudal
{
  namespace
  {
    /**
     * Conjugate residuals for the velocities end at this part of the residual or after so many:
     * more save no iterations of the whole.
     */
    constexpr double       velocity_tolerance       = 0.1;
    constexpr unsigned int most_velocity_iterations = 4;

    class Jacobi
    {
    public:
      explicit Jacobi(const FieldVector &diagonal)
          : inverse(diagonal)
      {
        for (double &entry : inverse)
          entry = 1 / entry;
      }

      void vmult(FieldVector &result, const FieldVector &source) const
      {
        result = source;
        result.scale(inverse);
      }

    private:
      FieldVector inverse;
    };

    /**
     * The pressures 1, x, y and z, as far as a cell's functions reach: S hardly sees the constant,
     * and multigrid that has the linear ones on all levels takes little more than half of the
     * iterations that it takes with what is constant in each cell.
     */
    template <int dim>
    std::vector<FieldVector> make_smooth_pressures(const FluidSpace<dim>       &space,
                                                   const MomentumOperator<dim> &momentum)
    {
      const auto                          &element = space.pressure_element;
      const unsigned int                   n       = element.n_dofs_per_cell();
      FEValues<dim>                        fe_values(element, QGauss<dim>(element.degree + 1),
                                                     update_values | update_JxW_values | update_quadrature_points);
      std::vector<FieldVector>             pressures(n, space.make_pressure_vector());
      std::vector<types::global_dof_index> dofs(n);
      for (const auto &cell : space.pressure_dofs.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          fe_values.reinit(cell);
          cell->get_dof_indices(dofs);
          for (const unsigned int q : fe_values.quadrature_point_indices())
            for (unsigned int k = 0; k < n; ++k)
            {
              const double value = k == 0 ? 1 : fe_values.quadrature_point(q)[k - 1];
              for (unsigned int i = 0; i < n; ++i)
                pressures[k](dofs[i]) += value * fe_values.shape_value(i, q) * fe_values.JxW(q);
            }
        }
      for (FieldVector &pressure : pressures)
        momentum.apply_inverse_pressure_mass(pressure);
      return pressures;
    }
  } // namespace

  template <int dim>
  class BlockPreconditioner<dim>::VelocityBlock
  {
  public:
    VelocityBlock(const CellwiseMatrix &matrix, const FieldVector &diagonal)
        : matrix(matrix)
        , jacobi(diagonal)
    {}

    void vmult(FieldVector &result, const FieldVector &source) const
    {
      solve_by_conjugate_residuals(matrix, result, source, jacobi,
                                   velocity_tolerance * source.l2_norm(), most_velocity_iterations);
    }

  private:
    const CellwiseMatrix &matrix;
    const Jacobi          jacobi;
  };

  template <int dim>
  BlockPreconditioner<dim>::BlockPreconditioner(const FluidSpace<dim>       &space,
                                                const MomentumOperator<dim> &momentum)
      : space(space)
      , momentum(momentum)
      , schur_complement(space.get_communicator())
  {}

  template <int dim>
  BlockPreconditioner<dim>::~BlockPreconditioner() = default;

  template <int dim>
  void BlockPreconditioner<dim>::reinit()
  {
    velocity_block.reset();
    schur_complement.reinit(space.make_velocity_vector(), make_smooth_pressures(space, momentum),
                            momentum.get_divergence_matrix().to_triplets());
  }

  template <int dim>
  void BlockPreconditioner<dim>::set_up(const CoupledEquations<dim> &new_equations,
                                        const MomentumWeights       &new_weights)
  {
    equations = &new_equations;
    // Between changes of grid and step the pressures' part is the same.
    const bool is_known = velocity_block && new_weights == weights;
    velocity_block.reset(); // should it fail
    if (!is_known)
      schur_complement.set_diagonal(momentum.compute_smooth_diagonal(new_weights.grad_div),
                                    new_weights.inertia);
    weights = new_weights;
    schur_complement.couple(equations->collect_interactions(), equations->collect_body_matrix(),
                            equations->get_owned_body_unknowns(), equations->get_body_places());
    velocity_block =
        std::make_unique<VelocityBlock>(momentum.get_matrix(), momentum.compute_diagonal());
  }

  template <int dim>
  void BlockPreconditioner<dim>::vmult(BlockFieldVector       &result,
                                       const BlockFieldVector &source) const
  {
    FieldVector  none;
    const bool   has_bodies = source.n_blocks() == 3;
    FieldVector &pressure   = result.block(1);
    schur_complement.solve(pressure, has_bodies ? result.block(2) : none, source.block(1),
                           has_bodies ? source.block(2) : none);
    FieldVector local(source.block(1));
    momentum.apply_inverse_pressure_mass(local);
    pressure.add(-(weights.grad_div + weights.viscosity) / weights.inertia, local);

    FieldVector forces;
    forces.reinit(source.block(0));
    momentum.get_divergence_matrix().Tvmult_add(forces, pressure);
    forces.sadd(-1, 1, source.block(0));
    if (has_bodies)
      equations->add_forces(result.block(2), 1, forces);
    velocity_block->vmult(result.block(0), forces);
  }

  template <int dim>
  double BlockPreconditioner<dim>::compute_stiffness_ratio() const
  {
    FieldVector                          inertia = space.make_velocity_vector();
    Vector<double>                       entries(space.velocity_element.n_dofs_per_cell());
    std::vector<types::global_dof_index> dofs(entries.size());
    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        const FullMatrix<double> &mass = space.get_cell_matrices(cell->level()).get_mass();
        for (unsigned int i = 0; i < entries.size(); ++i)
        {
          const unsigned int s = space.velocity_element.system_to_component_index(i).second;
          entries[i]           = weights.inertia * mass(s, s);
        }
        cell->get_dof_indices(dofs);
        space.get_homogeneous_constraints().distribute_local_to_global(entries, dofs, inertia);
      }
    inertia.compress(VectorOperation::add);

    const FieldVector   all = momentum.compute_diagonal();
    std::vector<double> ratios;
    for (const auto i : all.locally_owned_elements())
      if (inertia(i) > 0)
        ratios.push_back(all(i) / inertia(i));
    const auto middle = ratios.begin() + ratios.size() / 2;
    std::nth_element(ratios.begin(), middle, ratios.end());
    return Utilities::MPI::max(ratios.empty() ? 0. : *middle, space.get_communicator());
  }

  template <int dim>
  void BlockPreconditioner<dim>::remove_mean_pressure(FieldVector &pressure) const
  {
    if (!schur_complement.is_singular())
      return;
    // The first function of each cell is constant, and orthogonal to the others.
    const unsigned int n_per_cell = space.pressure_element.n_dofs_per_cell();
    FieldVector        inverse_volume;
    inverse_volume.reinit(pressure);
    for (unsigned int i = 0; i < pressure.locally_owned_size(); i += n_per_cell)
      inverse_volume.local_element(i) = 1;
    momentum.apply_inverse_pressure_mass(inverse_volume);
    double integral = 0, volume = 0;
    for (unsigned int i = 0; i < pressure.locally_owned_size(); i += n_per_cell)
    {
      integral += pressure.local_element(i) / inverse_volume.local_element(i);
      volume += 1 / inverse_volume.local_element(i);
    }
    const double mean = Utilities::MPI::sum(integral, space.get_communicator()) /
                        Utilities::MPI::sum(volume, space.get_communicator());
    for (unsigned int i = 0; i < pressure.locally_owned_size(); i += n_per_cell)
      pressure.local_element(i) -= mean;
  }

  template class BlockPreconditioner<2>;
  template class BlockPreconditioner<3>;
} // namespace caudal
