// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/viscous/coupled_equations.h>

#include <algorithm>

namespace caudal
{
  namespace
  {
    // Any body has a few anchors, see get_group_begins().
    constexpr unsigned int fewest_anchors = 4;

    /** All ranks' values of a vector, on each rank. */
    Vector<double> collect(const FieldVector &source)
    {
      Vector<double> values(source.size());
      std::copy(source.begin(), source.end(),
                values.begin() + source.get_partitioner()->local_range().first);
      Utilities::MPI::sum(values, source.get_mpi_communicator(), values);
      return values;
    }

    Vector<double> extract(const Vector<double> &values, const unsigned int begin,
                           const Places &places)
    {
      Vector<double> part(places.size);
      for (unsigned int i = 0; i < places.size; ++i)
        part[i] = values[begin + places[i]];
      return part;
    }

    /** values += factor part */
    void add(const Vector<double> &part, const unsigned int begin, const Places &places,
             const double factor, Vector<double> &values)
    {
      AssertDimension(part.size(), places.size);
      for (unsigned int i = 0; i < places.size; ++i)
        values[begin + places[i]] += factor * part[i];
    }
  } // namespace

  template <int dim>
  CoupledEquations<dim>::CoupledEquations(const FluidSpace<dim>                 &space,
                                          const MomentumOperator<dim>           &momentum,
                                          const std::vector<BodyEquations<dim>> &bodies,
                                          const MomentumWeights                 &weights)
      : communicator(space.get_communicator())
      , n_velocities(space.velocity_dofs.n_dofs())
      , momentum(momentum)
      , bodies(bodies)
      , scale(weights.inertia)
      , begins(1, 0)
  {
    for (const auto &body : bodies)
      begins.push_back(begins.back() + body.n_unknowns());
    owned_body_unknowns = Utilities::create_evenly_distributed_partitioning(
        Utilities::MPI::this_mpi_process(communicator),
        Utilities::MPI::n_mpi_processes(communicator), begins.back());
  }

  template <int dim>
  BlockFieldVector
  CoupledEquations<dim>::make_right_hand_side(const CoupledUnknowns &residual) const
  {
    BlockFieldVector rhs(bodies.empty() ? 2 : 3);
    rhs.block(0) = residual.velocity;
    rhs.block(1) = residual.pressure;
    rhs.block(1) *= scale;
    if (!bodies.empty())
    {
      Vector<double> values(begins.back());
      for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        add(residual.bodies[b].force_density, begins[b], bodies[b].velocity, 1, values);
        add(residual.bodies[b].velocity, begins[b], bodies[b].force_density, scale, values);
        add(residual.bodies[b].frame_velocity, begins[b], bodies[b].frame, scale, values);
      }
      rhs.block(2).reinit(owned_body_unknowns, communicator);
      for (const auto i : owned_body_unknowns)
        rhs.block(2)(i) = values[i];
    }
    rhs.collect_sizes();
    return rhs;
  }

  template <int dim>
  CoupledUnknowns CoupledEquations<dim>::extract_correction(const BlockFieldVector &solution) const
  {
    CoupledUnknowns correction;
    correction.velocity = solution.block(0);
    correction.pressure = solution.block(1);
    correction.pressure *= -1;
    if (bodies.empty())
      return correction;
    const Vector<double> values = collect(solution.block(2));
    for (unsigned int b = 0; b < bodies.size(); ++b)
      correction.bodies.push_back({extract(values, begins[b], bodies[b].velocity),
                                   extract(values, begins[b], bodies[b].force_density),
                                   extract(values, begins[b], bodies[b].frame)});
    return correction;
  }

  template <int dim>
  void CoupledEquations<dim>::vmult(BlockFieldVector &result, const BlockFieldVector &source) const
  {
    // It also updates the ghost entries that the interpolation needs.
    momentum.get_matrix().vmult(result.block(0), source.block(0));
    momentum.get_divergence_matrix().Tvmult_add(result.block(0), source.block(1));
    momentum.get_divergence_matrix().vmult(result.block(1), source.block(0));
    result.block(1) *= scale;
    if (bodies.empty())
      return;

    const Vector<double> in = collect(source.block(2));
    Vector<double>       out(in.size());
    const auto [begin, end] = source.block(2).get_partitioner()->local_range();
    for (unsigned int b = 0; b < bodies.size(); ++b)
    {
      const auto &[rows, columns, entries] = bodies[b].matrix;
      for (std::size_t k = 0; k < entries.size(); ++k)
        if (const unsigned int row = begins[b] + rows[k]; begin <= row && row < end)
          out[row] += entries[k] * in[begins[b] + columns[k]];
      add(bodies[b].interaction.interpolate(source.block(0), /*homogeneous=*/true), begins[b],
          bodies[b].force_density, -scale, out);
    }
    spread(in, -1, result.block(0));
    std::copy(out.begin() + begin, out.begin() + end, result.block(2).begin());
  }

  template <int dim>
  void CoupledEquations<dim>::add_forces(const FieldVector &unknowns, const double factor,
                                         FieldVector &forces) const
  {
    spread(collect(unknowns), factor, forces);
  }

  template <int dim>
  void CoupledEquations<dim>::spread(const Vector<double> &values, const double factor,
                                     FieldVector &forces) const
  {
    FieldVector sum;
    sum.reinit(forces);
    for (unsigned int b = 0; b < bodies.size(); ++b)
      bodies[b].interaction.spread(extract(values, begins[b], bodies[b].force_density), sum);
    forces.add(factor, sum);
  }

  template <int dim>
  MatrixParts CoupledEquations<dim>::collect_matrix() const
  {
    MatrixParts matrix;
    momentum.get_matrix().append_to(matrix);
    for (unsigned int b = 0; b < bodies.size(); ++b)
    {
      const int     begin = n_velocities + begins[b];
      const Places &force = bodies[b].force_density;
      bodies[b].interaction.for_each_entry(
          [&](const unsigned int row, const types::global_dof_index column, const double value) {
            matrix.entries.add(begin + force[row], column, -scale * value);
            matrix.entries.add(column, begin + force[row], -value);
          });
      // All ranks have the other entries of a body; rank 0 contributes them.
      const auto &[rows, columns, entries] = bodies[b].matrix;
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        for (std::size_t k = 0; k < entries.size(); ++k)
          matrix.entries.add(begin + rows[k], begin + columns[k], entries[k]);
    }
    return matrix;
  }

  template <int dim>
  Triplets CoupledEquations<dim>::collect_interactions() const
  {
    Triplets entries;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      bodies[b].interaction.for_each_entry(
          [&](const unsigned int row, const types::global_dof_index column, const double value) {
            entries.add(begins[b] + bodies[b].force_density[row], column, value);
          });
    return entries;
  }

  template <int dim>
  Triplets CoupledEquations<dim>::collect_body_matrix() const
  {
    Triplets entries;
    for (unsigned int b = 0; b < bodies.size(); ++b)
    {
      const Triplets &matrix = bodies[b].matrix;
      for (std::size_t k = 0; k < matrix.values.size(); ++k)
        entries.add(begins[b] + matrix.rows[k], begins[b] + matrix.columns[k], matrix.values[k]);
    }
    return entries;
  }

  template <int dim>
  std::vector<int> CoupledEquations<dim>::get_group_begins(const unsigned int most_per_anchor) const
  {
    std::vector<int> groups;
    for (unsigned int i = 0; i < n_velocities; i += dim)
      groups.push_back(i);
    for (unsigned int b = 0; b < bodies.size(); ++b)
    {
      const int          begin   = n_velocities + begins[b];
      const unsigned int n_nodes = bodies[b].velocity.size / dim;
      const unsigned int spacing = std::clamp(n_nodes / fewest_anchors, 1u, most_per_anchor);
      for (unsigned int node = 0; node < n_nodes; ++node)
      {
        groups.push_back(begin + bodies[b].velocity[node * dim]);
        if (node % spacing != 0)
          groups.push_back(begin + bodies[b].force_density[node * dim]);
      }
      if (bodies[b].frame.size > 0)
        groups.push_back(begin + bodies[b].frame[0]);
    }
    groups.push_back(n_velocities + begins.back());
    return groups;
  }

  template <int dim>
  std::vector<BodyPlaces> CoupledEquations<dim>::get_body_places() const
  {
    std::vector<BodyPlaces> all;
    for (unsigned int b = 0; b < bodies.size(); ++b)
    {
      BodyPlaces places{dim, {}, {}, {}, {}};
      for (unsigned int i = 0; i < bodies[b].velocity.size; ++i)
      {
        places.force.push_back(begins[b] + bodies[b].force_density[i]);
        places.velocity.push_back(begins[b] + bodies[b].velocity[i]);
      }
      for (unsigned int i = 0; i < bodies[b].frame.size; ++i)
        places.frame.push_back(begins[b] + bodies[b].frame[i]);
      places.positions.assign(bodies[b].positions.begin(), bodies[b].positions.end());
      all.push_back(std::move(places));
    }
    return all;
  }

  template class CoupledEquations<2>;
  template class CoupledEquations<3>;
} // namespace caudal
