// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/ideal/surface_output.h>

#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_fe_field.h>
#include <deal.II/numerics/data_out.h>

namespace caudal::ideal
{
  namespace
  {
    /** The flow on the surface, at its nodes; vectors in the frame of the positions. */
    struct SurfaceFields
    {
      Vector<double>            pressure; ///< p - p_infinity [Pa]
      std::vector<Tensor<1, 3>> velocity; ///< of the fluid, grad phi [m/s]
    };

    /**
     * The pressure by Bernoulli's equation with the rate of change that a node sees as it moves,
     *   p = -rho (delta phi/delta t - u.grad phi + |grad phi|^2/2),
     * grad phi being composed of its tangential part, by differentiation along the surface and
     * averaged over the cells that meet in a node, and of the given normal part u.n.
     */
    SurfaceFields compute_surface_fields(const Mapping<2, 3> &mapping, const Surface &surface,
                                         const std::vector<Tensor<1, 3>> &node_velocities,
                                         const Vector<double>            &potential,
                                         const Vector<double> &potential_rate, const double density)
    {
      const unsigned int        n = surface.n_nodes();
      SurfaceFields             fields{Vector<double>(n), std::vector<Tensor<1, 3>>(n)};
      std::vector<unsigned int> n_cells(n, 0);
      FEValues<2, 3>            at_nodes(mapping, surface.get_fe(),
                                         Quadrature<2>(surface.get_fe().get_unit_support_points()),
                                         update_gradients | update_normal_vectors);
      std::vector<Tensor<1, 3>> gradients(at_nodes.n_quadrature_points);
      for (const auto &cell : surface.get_dof_handler().active_cell_iterators())
      {
        at_nodes.reinit(cell);
        at_nodes.get_function_gradients(potential, gradients);
        for (const unsigned int q : at_nodes.quadrature_point_indices())
        {
          const auto          node   = surface.get_nodes(cell->active_cell_index())[q];
          const Tensor<1, 3> &normal = at_nodes.normal_vector(q);
          fields.velocity[node] += gradients[q] + (node_velocities[node] * normal) * normal;
          ++n_cells[node];
        }
      }
      for (unsigned int node = 0; node < n; ++node)
      {
        Tensor<1, 3> &gradient = fields.velocity[node];
        gradient /= n_cells[node];
        fields.pressure(node) =
            -density * (potential_rate(node) - node_velocities[node] * gradient +
                        0.5 * gradient.norm_square());
      }
      return fields;
    }

    /** Values at the nodes as those of the unknowns of a field of vectors. */
    template <class VectorType>
    Vector<double> make_field(const DoFHandler<2, 3> &handler, const Surface &surface,
                              const std::vector<VectorType> &values)
    {
      Vector<double>                       field(handler.n_dofs());
      const auto                          &fe = handler.get_fe();
      std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
      for (const auto &cell : handler.active_cell_iterators())
      {
        cell->get_dof_indices(indices);
        const auto &nodes = surface.get_nodes(cell->active_cell_index());
        for (unsigned int i = 0; i < indices.size(); ++i)
        {
          const auto [component, k] = fe.system_to_component_index(i);
          field(indices[i])         = values[nodes[k]][component];
        }
      }
      return field;
    }
  } // namespace

  SurfaceOutput::SurfaceOutput(const SwimmingShape &shape, StrokeModel &model, FieldOutput &fields,
                               const std::string &name, const unsigned int n_subdivisions)
      : shape(shape)
      , model(model)
      , fields(fields)
      , name(name)
      , n_subdivisions(n_subdivisions)
      , vectors(shape.surface.get_dof_handler().get_triangulation())
  {
    vectors.distribute_dofs(FESystem<2, 3>(shape.surface.get_fe(), 3));
  }

  /**
   * The potential of the whole flow at the nodes at a time near that of the sample, to which
   * the impulses go on at the rate @p impulse_rate.
   */
  Vector<double> SurfaceOutput::compute_potential(const MotionSample &sample,
                                                  const Screw &impulse_rate, const double time,
                                                  const double rate) const
  {
    const Screw               impulse  = sample.body.impulse + (time - sample.time) * impulse_rate;
    const double              argument = rate * time;
    const FullMatrix<double>  modes    = model.compute_potentials(argument);
    const std::vector<double> rates    = shape.gait.evaluate(argument).rates;
    const Screw    velocity = model.compute_motion(argument).compute_velocity(impulse, rate);
    Vector<double> motions(modes.n()), potential(modes.m());
    for (unsigned int k = 0; k < 6; ++k)
      motions(k) = velocity[k];
    for (unsigned int i = 0; i < rates.size(); ++i)
      motions(6 + i) = rate * rates[i];
    modes.vmult(potential, motions);
    return potential;
  }

  /** The potential's derivative by time at the moving nodes, by a difference. */
  Vector<double> SurfaceOutput::compute_potential_rate(const MotionSample  &sample,
                                                       const MotionProblem &problem) const
  {
    const double rate      = problem.rate;
    const double increment = 1e-4 / rate;
    const Screw  impulse_rate =
        compute_impulse_rate(sample.body.impulse, sample.velocity,
                             problem.force({rate * sample.time, rate, sample.velocity}).screw);
    Vector<double> difference =
        compute_potential(sample, impulse_rate, sample.time + increment, rate);
    difference -= compute_potential(sample, impulse_rate, sample.time - increment, rate);
    difference /= 2. * increment;
    return difference;
  }

  void SurfaceOutput::write(const MotionSample &sample, const MotionProblem &problem,
                            const unsigned int counter)
  {
    const double        rate   = problem.rate;
    const GaitState     gait   = shape.gait.evaluate(rate * sample.time);
    const SurfaceMotion motion = shape.deformation.place(gait.c);

    // Places and velocities in the inertial frame
    std::vector<Point<3>>     places;
    std::vector<Tensor<1, 3>> velocities =
        motion.compute_velocities(sample.velocity, gait.rates, rate);
    for (unsigned int node = 0; node < shape.surface.n_nodes(); ++node)
    {
      const Tensor<1, 3> X(motion.positions[node]);
      places.emplace_back(sample.body.position + sample.body.rotate(X));
      velocities[node] = sample.body.rotate(velocities[node]);
    }
    const Vector<double> potential   = compute_potential(sample, Screw(), sample.time, rate);
    const Vector<double> place_field = make_field(vectors, shape.surface, places);
    const MappingFEField<2, 3, Vector<double>> mapping(vectors, place_field);
    const SurfaceFields                        flow =
        compute_surface_fields(mapping, shape.surface, velocities, potential,
                               compute_potential_rate(sample, problem), shape.densities.fluid);

    DataOut<2, 3> data_out;
    const auto   &scalars = shape.surface.get_dof_handler();
    const std::vector<DataComponentInterpretation::DataComponentInterpretation> is_vector(
        3, DataComponentInterpretation::component_is_part_of_vector);
    data_out.add_data_vector(scalars, potential, "potential");
    data_out.add_data_vector(scalars, flow.pressure, "pressure");
    data_out.add_data_vector(vectors, make_field(vectors, shape.surface, flow.velocity),
                             std::vector<std::string>(3, "velocity"), is_vector);
    data_out.build_patches(mapping, std::max(2u, n_subdivisions),
                           DataOut<2, 3>::curved_inner_cells);
    fields.write(data_out, name, sample.time, counter, MPI_COMM_SELF);
  }
} // namespace caudal::ideal
