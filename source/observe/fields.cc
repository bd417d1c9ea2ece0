// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/observer.h>

#include <deal.II/fe/mapping_q.h>
#include <deal.II/fe/mapping_q_eulerian.h>
#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <cmath>
#include <optional>
#include <type_traits>

namespace caudal
{
  namespace
  {
    /** The vorticity: a scalar in 2D, a vector in 3D [1/s]. */
    template <int dim>
    class Vorticity : public std::conditional_t<dim == 2, DataPostprocessorScalar<dim>,
                                                DataPostprocessorVector<dim>>
    {
    public:
      Vorticity()
          : std::conditional_t<dim == 2, DataPostprocessorScalar<dim>,
                               DataPostprocessorVector<dim>>("vorticity", update_gradients)
      {}

      void evaluate_vector_field(const DataPostprocessorInputs::Vector<dim> &input,
                                 std::vector<Vector<double>> &quantities) const override
      {
        for (unsigned int q = 0; q < quantities.size(); ++q)
          for (unsigned int d = 0; d < quantities[q].size(); ++d)
          {
            const unsigned int i = dim == 2 ? 0 : (d + 1) % dim, j = dim == 2 ? 1 : (d + 2) % dim;
            quantities[q][d] =
                input.solution_gradients[q][j][i] - input.solution_gradients[q][i][j];
          }
      }
    };

    /** The grid where it is in the laboratory's frame. */
    template <int dim>
    class TranslatedMapping : public MappingQ<dim>
    {
    public:
      explicit TranslatedMapping(const Tensor<1, dim> &translation)
          : MappingQ<dim>(1)
          , translation(translation)
      {}

      bool preserves_vertex_locations() const override
      {
        return false;
      }

      std::unique_ptr<Mapping<dim>> clone() const override
      {
        return std::make_unique<TranslatedMapping<dim>>(*this);
      }

    protected:
      std::vector<Point<dim>> compute_mapping_support_points(
          const typename Triangulation<dim>::cell_iterator &cell) const override
      {
        auto points = MappingQ<dim>::compute_mapping_support_points(cell);
        for (Point<dim> &point : points)
          point += translation;
        return points;
      }

    private:
      const Tensor<1, dim> translation;
    };

    /** Velocity, pressure and vorticity of the fluid, and of the bodies' motion and stresses. */
    template <int dim>
    class Fields : public Observer<dim>
    {
    public:
      Fields()
          : Observer<dim>(100)
      {}

      void start(const Observation<dim> &observation, const ObserverContext<dim> &context) override
      {
        format = context.output.format;
        if (context.is_resumed)
          return;
        output.emplace(context.folder, format, context.communicator);
        write(observation, context);
      }

      void observe_step(const Observation<dim>     &observation,
                        const ObserverContext<dim> &context) override
      {
        if (observation.is_last || is_due(observation.time, context.output.field_interval))
          write(observation, context);
      }

      void finish(const Observation<dim> &observation, const ObserverContext<dim> &context) override
      {
        write(observation, context);
      }

      void exchange_state(StateArchive &archive) override
      {
        if (output)
          series = output->get_series();
        archive &n_outputs &last_time &format &series;
      }

      void resume(const Observation<dim> &observation, const ObserverContext<dim> &context) override
      {
        if (format != context.output.format) // a new list begins
          series.clear();
        format = context.output.format;
        output.emplace(context.folder, format, context.communicator, series);
        for (const std::string &sentence : output->find_missing_files())
          context.log << "Warning: " << sentence << std::endl;
        // Their writing may have been what ended the run.
        if (is_due(observation.time, context.output.field_interval))
          write(observation, context);
      }

    private:
      std::optional<FieldOutput> output;
      FieldOutput::Series        series; // of the checkpoint
      std::string                format;
      unsigned int               n_outputs = 0;
      double                     last_time = -1; // [s]

      /** Whether a multiple of the interval was passed since the last, maybe additional, output. */
      bool is_due(const double time, const double interval) const
      {
        const auto count = [&](const double t) { return std::floor(t / interval * (1 + 1e-9)); };
        return interval == 0 || count(time) > count(last_time);
      }

      /** The present fields, unless they were written. */
      void write(const Observation<dim> &observation, const ObserverContext<dim> &context)
      {
        if (observation.time == last_time)
          return;
        write_fluid(observation, context.output.n_subdivisions);
        for (const auto &body : observation.bodies)
          write_body(observation, body);
        last_time = observation.time;
        ++n_outputs;
      }

      void write_fluid(const Observation<dim> &observation, const unsigned int n_subdivisions)
      {
        const FluidSpace<dim> &space         = observation.space;
        const auto            &triangulation = space.get_triangulation();
        const Vorticity<dim>   vorticity;
        DataOut<dim>           data_out;
        data_out.attach_triangulation(triangulation);
        add_vector(data_out, space.velocity_dofs, observation.fluid.velocity, "velocity");
        data_out.add_data_vector(space.pressure_dofs, observation.fluid.pressure, "pressure");
        data_out.add_data_vector(space.velocity_dofs, observation.fluid.velocity, vorticity);
        Vector<float> level(triangulation.n_active_cells()), rank(triangulation.n_active_cells());
        for (const auto &cell : triangulation.active_cell_iterators())
        {
          level[cell->active_cell_index()] = cell->level();
          rank[cell->active_cell_index()]  = cell->is_locally_owned() ? cell->subdomain_id() : -1;
        }
        data_out.add_data_vector(level, "level");
        data_out.add_data_vector(rank, "rank");
        if (observation.grid_moves)
          // Without the last argument deal.II draws cells inside of the domain where they were.
          data_out.build_patches(TranslatedMapping<dim>(restrict_to<dim>(observation.origin)),
                                 n_subdivisions, DataOut<dim>::curved_inner_cells);
        else
          data_out.build_patches(n_subdivisions);
        output->write(data_out, "fluid", observation.time, n_outputs, space.get_communicator());
      }

      void write_body(const Observation<dim> &observation, const BodyObservation<dim> &observed)
      {
        const SolidBody<dim>  &solid = observed.body.get_solid();
        const BodyState       &state = observed.state;
        const DoFHandler<dim> &dofs  = solid.get_dof_handler();

        // The grid lives in the body's own frame; the picture in the domain.
        Vector<double> displacement(state.positions), move(state.positions);
        displacement -= solid.get_initial_positions();
        for (const auto &node : solid.get_nodes())
          for (unsigned int d = 0; d < dim; ++d)
            move[node[d]] -= solid.get_reference_point(node[0])[d];
        const Vector<double> muscle_force = compute_muscle_force_density(observation, observed);
        const auto           cell_means   = compute_cell_means(solid, state.positions);

        DataOut<dim> data_out;
        data_out.attach_triangulation(solid.get_triangulation());
        add_vector(data_out, dofs, displacement, "displacement");
        add_vector(data_out, dofs, state.velocity, "velocity");
        add_vector(data_out, dofs, muscle_force, "muscle_force");
        for (const auto &[name, values] : cell_means)
          data_out.add_data_vector(values, name);
        const MappingQEulerian<dim> mapping(dofs.get_fe().degree, dofs, move);
        data_out.build_patches(mapping, dofs.get_fe().degree, DataOut<dim>::curved_inner_cells);
        output->write(data_out, observed.body.get_name(), observation.time, n_outputs,
                      MPI_COMM_SELF);
      }

      /** Per reference volume, at the time of the other fields; at the start there is none. */
      static Vector<double> compute_muscle_force_density(const Observation<dim>     &observation,
                                                         const BodyObservation<dim> &observed)
      {
        const auto &[body, state, report] = observed;
        if (observation.step_number == 0)
          return Vector<double>(body.get_solid().n_dofs());
        Vector<double> force = body.compute_force(
            LoadAccount::muscle, body.get_motion(state, observation.time, observation.step));
        body.get_solid().apply_inverse_mass(force);
        return force;
      }

      template <class VectorType>
      static void add_vector(DataOut<dim> &data_out, const DoFHandler<dim> &dofs,
                             const VectorType &values, const std::string &name)
      {
        data_out.add_data_vector(
            dofs, values, std::vector<std::string>(dim, name),
            std::vector<DataComponentInterpretation::DataComponentInterpretation>(
                dim, DataComponentInterpretation::component_is_part_of_vector));
      }
    };

    const DimensionalRegistration<Observer, Fields> registration("fields",
                                                                 "fields of fluid and bodies");
  } // namespace
} // namespace caudal
