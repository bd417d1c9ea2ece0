// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/io/progress.h>
#include <caudal/solid/elastic_body.h>
#include <caudal/solid/elasticity.h>

#include <deal.II/lac/sparse_direct.h>

#include <cmath>
#include <iostream>

namespace caudal
{
  namespace
  {
    const unsigned int largest_number_of_iterations = 30;

    // Newton's last correction beside the body's length; the error is far smaller.
    const double tolerance = 1e-9;
  } // namespace

  template <int dim>
  ElasticBody<dim>::ElasticBody(const ElasticParameters<dim> &parameters,
                                const MPI_Comm                communicator)
      : parameters(parameters)
      , solid(*parameters.solid, Surroundings())
      , elasticity(make_elastic_load(solid))
      , response(solid.get_sparsity_pattern())
      , weight(solid.n_dofs())
      , positions(solid.get_initial_positions())
      , velocity(solid.n_dofs())
      , acceleration(solid.n_dofs())
      , matrix(solid.get_sparsity_pattern())
  {
    AssertThrow(Utilities::MPI::n_mpi_processes(communicator) == 1,
                ExcMessage("Model: the elastic model runs on one rank. Start it without mpirun."));
    weight = compute_excess_weight(solid, parameters.gravity);
  }

  template <int dim>
  void ElasticBody<dim>::start()
  {
    if (parameters.is_static)
      return;
    acceleration = weight;
    solid.apply_inverse_mass(acceleration);
    acceleration /= solid.get_excess_density();
    for (unsigned int i = 0; i < solid.n_dofs(); ++i)
      if (solid.is_fixed(i))
        acceleration[i] = 0;
  }

  template <int dim>
  void ElasticBody<dim>::check(std::ostream &out, bool /*fast*/) const
  {
    print_summary(out);
    out << "No problems found.\n";
  }

  template <int dim>
  void ElasticBody<dim>::print_summary(std::ostream &out) const
  {
    out << "Body " << solid.get_name() << ": " << solid.get_triangulation().n_active_cells()
        << " cells, " << solid.n_dofs() << " unknowns, mass "
        << solid.get_excess_density() * solid.get_reference_volume() << (dim == 2 ? " kg/m" : " kg")
        << '\n';
  }

  /** weight + elastic forces - inertia (X - X_predicted), zero where the body is held. */
  template <int dim>
  Vector<double> ElasticBody<dim>::compute_residual(const double inertia, const double load,
                                                    const Vector<double> &predicted)
  {
    Vector<double> residual(solid.n_dofs()), move(positions), force(solid.n_dofs());
    response.stiffness = 0;
    elasticity->add({positions, velocity, 0, 0, Contraction()}, residual, &response);
    move -= predicted;
    solid.get_mass_matrix().vmult(force, move);
    residual.add(load, weight, -inertia, force);
    for (unsigned int i = 0; i < solid.n_dofs(); ++i)
      if (solid.is_fixed(i))
        residual[i] = 0;
    return residual;
  }

  /** X += (K + inertia M)^-1 residual; the residual becomes this correction. */
  template <int dim>
  void ElasticBody<dim>::apply_newton_update(const double inertia, Vector<double> &residual)
  {
    matrix.copy_from(response.stiffness);
    matrix.add(inertia, solid.get_mass_matrix());
    for (auto entry : matrix)
      if (solid.is_fixed(entry.row()) || solid.is_fixed(entry.column()))
        entry.value() = entry.row() == entry.column() ? 1. : 0.;
    SparseDirectUMFPACK solver;
    solver.initialize(matrix);
    solver.solve(residual);
    positions += residual;
  }

  template <int dim>
  unsigned int ElasticBody<dim>::solve(const double step, const double load)
  {
    // Average acceleration: X = X_0 + dt U_0 + dt^2/4 (A_0 + A), U = U_0 + dt/2 (A_0 + A).
    const bool     moves   = !parameters.is_static;
    const double   inertia = moves ? 4 / (step * step) * solid.get_excess_density() : 0;
    Vector<double> predicted(positions);
    if (moves)
      predicted.add(step, velocity, 0.25 * step * step, acceleration);

    const double length    = compute_extent(solid.get_triangulation()).length;
    unsigned int iteration = 0;
    double       correction;
    do
    {
      ++iteration;
      AssertThrow(iteration <= largest_number_of_iterations,
                  ExcMessage("Newton's method did not converge in " +
                             std::to_string(largest_number_of_iterations) +
                             " iterations. Reduce Time/Step."));
      Vector<double> residual = compute_residual(inertia, load, predicted);
      AssertThrow(std::isfinite(residual.l2_norm()),
                  ExcMessage("The forces in the body are not finite."));
      apply_newton_update(inertia, residual);
      correction = residual.linfty_norm();
    } while (!(correction <= tolerance * length));
    if (moves)
    {
      Vector<double> new_acceleration(positions);
      new_acceleration -= predicted;
      new_acceleration *= 4 / (step * step);
      velocity.add(0.5 * step, acceleration, 0.5 * step, new_acceleration);
      acceleration = new_acceleration;
    }
    return iteration;
  }

  template <int dim>
  void ElasticBody<dim>::write_statistics(const double time, const unsigned int iterations,
                                          Statistics &statistics) const
  {
    const std::string prefix = solid.get_name() + ": ";
    const auto        shape  = summarise_deformation(solid, positions);
    statistics.set("time", "s", time);
    statistics.set("iterations", "", iterations);
    for (unsigned int k = 0; k < solid.get_parameters().monitored_points.size(); ++k)
      for (unsigned int d = 0; d < dim; ++d)
        statistics.set(prefix + "xyz"[d] + " of point " + std::to_string(k + 1), "m",
                       solid.evaluate(positions, k)[d]);
    Vector<double> displacement(positions);
    displacement -= solid.get_initial_positions();
    statistics.set(prefix + "kinetic energy", get_extensive_unit<dim>("J"),
                   0.5 * solid.get_excess_density() *
                       solid.get_mass_matrix().matrix_norm_square(velocity));
    statistics.set(prefix + "elastic energy", get_extensive_unit<dim>("J"), shape.elastic_energy);
    statistics.set(prefix + "work of gravity", get_extensive_unit<dim>("J"), weight * displacement);
    statistics.set(prefix + "min J", "", shape.smallest_jacobian);
    statistics.set(prefix + "max J", "", shape.largest_jacobian);
    statistics.write_row();
  }

  template <int dim>
  Outcome ElasticBody<dim>::run(const OutputFolder &folder, Log &log,
                                const std::function<bool()> &stop_requested)
  {
    print_summary(log.get_stream());
    Statistics   statistics(folder.add_table("statistics.txt"));
    Progress     progress(is_terminal() ? std::cout : log.get_stream(), 0, parameters.end_time,
                      is_terminal());
    const double n_steps = std::ceil(parameters.end_time / parameters.step * (1 - 1e-9));
    const double step    = parameters.end_time / n_steps;
    unsigned int n       = 0;
    while (n < n_steps && !stop_requested())
    {
      ++n;
      const unsigned int iterations = solve(step, parameters.is_static ? n / n_steps : 1.);
      write_statistics(n * step, iterations, statistics);
      progress.update(n * step, n, std::to_string(iterations) + " iterations");
    }
    progress.finish();
    return n == n_steps ? Outcome::finished : Outcome::stopped;
  }

  template class ElasticBody<2>;
  template class ElasticBody<3>;
} // namespace caudal
