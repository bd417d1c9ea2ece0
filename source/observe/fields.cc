// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/fields.h>

#include <deal.II/fe/mapping_q.h>
#include <deal.II/fe/mapping_q_eulerian.h>
#include <deal.II/numerics/data_out.h>

#include <algorithm>
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

    /** A scalar of the velocity's gradient. */
    template <int dim>
    class DerivedScalar : public DataPostprocessorScalar<dim>
    {
    public:
      DerivedScalar(const std::string &name, const FlowQuantity<dim> &quantity)
          : DataPostprocessorScalar<dim>(name, update_gradients)
          , quantity(quantity)
      {}

      void evaluate_vector_field(const DataPostprocessorInputs::Vector<dim> &input,
                                 std::vector<Vector<double>> &quantities) const override
      {
        for (unsigned int q = 0; q < quantities.size(); ++q)
        {
          Tensor<2, dim> gradient;
          for (unsigned int d = 0; d < dim; ++d)
            gradient[d] = input.solution_gradients[q][d];
          quantities[q][0] = quantity.evaluate(gradient);
        }
      }

    private:
      const FlowQuantity<dim> &quantity;
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
      using Cell = typename Triangulation<dim>::cell_iterator;

#if DEAL_II_VERSION_GTE(9, 8, 0)
      void compute_mapping_support_points(
          const Cell &cell, boost::container::small_vector<Point<dim>, 200> &points) const override
      {
        MappingQ<dim>::compute_mapping_support_points(cell, points);
        for (Point<dim> &point : points)
          point += translation;
      }
#else
      std::vector<Point<dim>> compute_mapping_support_points(const Cell &cell) const override
      {
        auto points = MappingQ<dim>::compute_mapping_support_points(cell);
        for (Point<dim> &point : points)
          point += translation;
        return points;
      }
#endif

    private:
      const Tensor<1, dim> translation;
    };

    /** Per reference volume, at the time of the other fields; at the start there is none. */
    template <int dim>
    Vector<double> compute_muscle_force_density(const Observation<dim>     &observation,
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

    const DimensionalRegistration<Observer, Fields> registration("fields",
                                                                 "fields of fluid and bodies");
  } // namespace

  template <int dim>
  Vector<double> compute_displacement(const BodyObservation<dim> &observed)
  {
    Vector<double> displacement(observed.state.positions);
    displacement -= observed.body.get_solid().get_initial_positions();
    return displacement;
  }

  template <int dim>
  Vector<double> compute_move(const BodyObservation<dim> &observed)
  {
    const SolidBody<dim> &solid = observed.body.get_solid();
    Vector<double>        move(observed.state.positions);
    for (const auto &node : solid.get_nodes())
      for (unsigned int d = 0; d < dim; ++d)
        move[node[d]] -= solid.get_reference_point(node[0])[d];
    return move;
  }

  template <int dim>
  void Fields<dim>::add_parameters(ParameterHandler &prm)
  {
    std::string text = "Scalars of the velocity's gradient that are written with the fluid's "
                       "velocity, pressure and vorticity, separated by ','.";
    for (const auto &[name, member] : Registry<FlowQuantity<dim>>::get_members())
      text += " '" + name + "': " + member.documentation + ".";
    prm.enter_subsection("Output");
    prm.add_parameter("Additional fields", additional, text);
    for (const auto &[name, quantity] : quantities)
      declare_plugin(prm, get_plugin_section(name), *quantity);
    prm.leave_subsection();
  }

  template <int dim>
  void Fields<dim>::check(const std::string & /*path*/) const
  {
    for (const std::string &name : additional)
      AssertThrow(Registry<FlowQuantity<dim>>::get_members().count(name) > 0,
                  ExcMessage("Output/Additional fields: there is nothing called <" + name +
                             ">. The known ones are: " +
                             Registry<FlowQuantity<dim>>::get_names(", ") + "."));
    for (const auto &[name, quantity] : quantities)
      if (is_wanted(name))
        quantity->check("Output/" + get_plugin_section(name));
  }

  template <int dim>
  bool Fields<dim>::is_wanted(const std::string &name) const
  {
    return std::find(additional.begin(), additional.end(), name) != additional.end();
  }

  template <int dim>
  typename Fields<dim>::Derived Fields<dim>::make_derived_fields() const
  {
    Derived derived;
    derived.push_back(std::make_unique<Vorticity<dim>>());
    for (const auto &[name, quantity] : quantities)
      if (is_wanted(name))
        derived.push_back(std::make_unique<DerivedScalar<dim>>(name, *quantity));
    return derived;
  }

  template <int dim>
  void Fields<dim>::write_fields(const Observation<dim>     &observation,
                                 const ObserverContext<dim> &context)
  {
    write_fluid(observation, context.output.n_subdivisions);
    for (const auto &body : observation.bodies)
      write_body(observation, body);
  }

  template <int dim>
  void Fields<dim>::write_fluid(const Observation<dim> &observation,
                                const unsigned int      n_subdivisions)
  {
    const FluidSpace<dim> &space         = observation.space;
    const auto            &triangulation = space.get_triangulation();
    const Derived          derived       = make_derived_fields();
    DataOut<dim>           data_out;
    data_out.attach_triangulation(triangulation);
    add_vector(data_out, space.velocity_dofs, observation.fluid.velocity, "velocity");
    data_out.add_data_vector(space.pressure_dofs, observation.fluid.pressure, "pressure");
    for (const auto &field : derived)
      data_out.add_data_vector(space.velocity_dofs, observation.fluid.velocity, *field);
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
    this->add(data_out, "fluid", observation, space.get_communicator());
  }

  template <int dim>
  void Fields<dim>::write_body(const Observation<dim>     &observation,
                               const BodyObservation<dim> &observed)
  {
    const SolidBody<dim>  &solid = observed.body.get_solid();
    const BodyState       &state = observed.state;
    const DoFHandler<dim> &dofs  = solid.get_dof_handler();

    const Vector<double> displacement = compute_displacement(observed);
    const Vector<double> move         = compute_move(observed);
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
    this->add(data_out, observed.body.get_name(), observation, MPI_COMM_SELF);
  }

#define INSTANTIATE(dim)                                                                           \
  template class Fields<dim>;                                                                      \
  template Vector<double> compute_displacement(const BodyObservation<dim> &);                      \
  template Vector<double> compute_move(const BodyObservation<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
