#include <caudal/viscous/body_unknowns.h>
#include <caudal/viscous/coupled_equations.h>

#include <algorithm>

namespace caudal
{
  namespace
  {
    // Any body has a few anchors, see get_group_begins().
    constexpr unsigned int fewest_anchors = 4;

    /** Calls operation(number, places) for each body; the unknowns of the first begin at @p begin.
     */
    template <int dim, class Operation>
    void for_each_body(const std::vector<BodyEquations<dim>> &bodies, int begin,
                       const Operation &operation)
    {
      for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        operation(b, BodyPlaces<dim>(bodies[b], begin));
        begin += bodies[b].n_unknowns();
      }
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
  {}

  template <int dim>
  unsigned int CoupledEquations<dim>::n_body_unknowns() const
  {
    unsigned int n = 0;
    for (const auto &body : bodies)
      n += body.n_unknowns();
    return n;
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
      BodyVector values(communicator, n_body_unknowns());
      for_each_body(bodies, 0, [&](const unsigned int b, const BodyPlaces<dim> &places) {
        Vector<double> kinematic(residual.bodies[b].velocity),
            frame(residual.bodies[b].frame_velocity);
        kinematic *= scale;
        frame *= scale;
        values.insert(residual.bodies[b].force_density, places.velocity);
        values.insert(kinematic, places.force_density);
        values.insert(frame, places.frame);
      });
      rhs.block(2) = values.make_owned();
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
    BodyVector values(communicator, n_body_unknowns());
    values.receive(solution.block(2));
    for_each_body(bodies, 0, [&](const unsigned int, const BodyPlaces<dim> &places) {
      correction.bodies.push_back({values.extract(places.velocity),
                                   values.extract(places.force_density),
                                   values.extract(places.frame)});
    });
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

    BodyVector in(communicator, n_body_unknowns()), out(in);
    in.receive(source.block(2));
    FieldVector forces;
    forces.reinit(result.block(0));
    for_each_body(bodies, 0, [&](const unsigned int b, const BodyPlaces<dim> &places) {
      const BodyEquations<dim> &body          = bodies[b];
      const Vector<double>      velocity      = in.extract(places.velocity);
      const Vector<double>      force_density = in.extract(places.force_density);
      const Vector<double>      frame         = in.extract(places.frame);
      body.interaction.spread(force_density, forces);

      Vector<double> kinematic(velocity.size()), balance(velocity.size()),
          frame_balance(frame.size());
      body.mass.vmult(kinematic, velocity);
      kinematic -= body.interaction.interpolate(source.block(0), /*homogeneous=*/true);
      kinematic *= scale;
      body.response.vmult(balance, velocity);
      body.mass.vmult_add(balance, force_density);
      for (unsigned int k = 0; k < frame.size(); ++k)
      {
        balance.add(-body.gait_damping * frame[k], body.rigid_moments[k]);
        frame_balance[k] = body.rigid_moments[k] * velocity;
        for (unsigned int l = 0; l < frame.size(); ++l)
          frame_balance[k] -= body.rigid_inertia(k, l) * frame[l];
        frame_balance[k] *= scale;
      }
      out.insert(balance, places.velocity);
      out.insert(kinematic, places.force_density);
      out.insert(frame_balance, places.frame);
    });
    result.block(0) -= forces;
    out.send(result.block(2));
  }

  template <int dim>
  MatrixParts CoupledEquations<dim>::collect_matrix() const
  {
    MatrixParts matrix;
    Triplets   &entries = matrix.entries;
    momentum.get_matrix().append_to(matrix);
    for_each_body(bodies, n_velocities, [&](const unsigned int b, const BodyPlaces<dim> &places) {
      const BodyEquations<dim> &body     = bodies[b];
      const Places             &velocity = places.velocity, &force_density = places.force_density,
                   &frame   = places.frame;
      const Places &balance = velocity, &kinematic = force_density; // rows
      body.interaction.for_each_entry(
          [&](const unsigned int row, const types::global_dof_index column, const double value) {
            entries.add(kinematic[row], column, -scale * value);
            entries.add(column, force_density[row], -value);
          });
      // All ranks have the other matrices of a body; rank 0 contributes them.
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        for (const auto &entry : body.mass)
        {
          entries.add(kinematic[entry.row()], velocity[entry.column()], scale * entry.value());
          entries.add(balance[entry.row()], force_density[entry.column()], entry.value());
        }
        for (const auto &entry : body.response)
          entries.add(balance[entry.row()], velocity[entry.column()], entry.value());
        for (unsigned int k = 0; k < body.n_frame_dofs(); ++k)
        {
          for (unsigned int i = 0; i < body.n_dofs(); ++i)
          {
            entries.add(balance[i], frame[k], -body.gait_damping * body.rigid_moments[k][i]);
            entries.add(frame[k], velocity[i], scale * body.rigid_moments[k][i]);
          }
          for (unsigned int l = 0; l < body.n_frame_dofs(); ++l)
            entries.add(frame[k], frame[l], -scale * body.rigid_inertia(k, l));
        }
      }
    });
    return matrix;
  }

  template <int dim>
  std::vector<int> CoupledEquations<dim>::get_group_begins(const unsigned int most_per_anchor) const
  {
    std::vector<int> begins;
    for (unsigned int i = 0; i < n_velocities; i += dim)
      begins.push_back(i);
    for_each_body(bodies, n_velocities, [&](const unsigned int b, const BodyPlaces<dim> &places) {
      const unsigned int n_nodes = bodies[b].n_dofs() / dim;
      const unsigned int spacing = std::clamp(n_nodes / fewest_anchors, 1u, most_per_anchor);
      for (unsigned int node = 0; node < n_nodes; ++node)
      {
        begins.push_back(places.velocity[node * dim]);
        if (node % spacing != 0)
          begins.push_back(places.force_density[node * dim]);
      }
      if (bodies[b].n_frame_dofs() > 0)
        begins.push_back(places.frame.begin);
    });
    begins.push_back(n_velocities + n_body_unknowns());
    return begins;
  }

  template class CoupledEquations<2>;
  template class CoupledEquations<3>;
} // namespace caudal
