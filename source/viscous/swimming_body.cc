#include <caudal/base/checks.h>
#include <caudal/viscous/swimming_body.h>

#include <caudal/solid/rigid_motion.h>

#include <deal.II/grid/grid_tools.h>

#include <cmath>

namespace caudal
{
  template <int dim>
  SwimmingBodyParameters<dim>::SwimmingBodyParameters(const std::string              &name,
                                                      const std::vector<std::string> &regions)
      : solid(name, regions)
  {}

  template <int dim>
  void SwimmingBodyParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.declare_entry(
        "Regions", "body", Patterns::Anything(),
        "Names of the body's regions from head to tail, separated by commas; each has "
        "a section `Region <name>`.");
    solid.add_parameters(prm);
    prm.add_parameter(
        "Lateral frame", lateral_frame,
        "What the muscle's monitored point is measured against: domain: the axis at "
        "the start; head: the present axis of the first region. The swim report tells of the "
        "motion along the axis at the start.",
        Patterns::Selection("domain|head"));
    muscle.add_parameters(prm);
    gait.add_parameters(prm);
    prm.add_parameter("Gait damping", gait_damping,
                      "Coefficient eta of the feedback force eta (V_gait - U) that makes the body "
                      "follow its gait; it has no resultant force or moment [N s/m^4].");
    controller.add_parameters(prm);
  }

  template <int dim>
  void SwimmingBodyParameters<dim>::check(const bool is_explicit) const
  {
    solid.check();
    const std::string path = solid.get_path();
    muscle.check(path);
    gait.check(path);
    controller.check(path);
    check_positive(path + "/Gait damping", gait_damping);
    AssertThrow(controller.type.get_name() == "none" || muscle.type.get_name() != "none",
                ExcMessage(path + "/Controller/Type: the controller <" +
                           controller.type.get_name() +
                           "> acts on the muscle, and there is none. Give Muscle/Type, or no "
                           "controller."));
    AssertThrow(!controller.type.get().steers() || muscle.type.get().can_steer(),
                ExcMessage(path + "/Controller/Type: fibres pull on both sides alike and can't "
                                  "steer. Give another muscle, or no controller of the heading."));
    if (is_explicit)
    {
      AssertThrow(!gait.type.get().is_prescribed(),
                  ExcMessage(path + "/Gait/Type: a gait needs Time/Scheme = semi-implicit."));
      AssertThrow(solid.density == 0,
                  ExcMessage(path +
                             "/Density: a density other than the fluid's needs Time/Scheme "
                             "= semi-implicit. Set it to 0 (the fluid's) or change the scheme."));
    }
  }

  template <int dim>
  SwimmingBody<dim>::SwimmingBody(const SwimmingBodyParameters<dim> &parameters,
                                  const CouplingParameters &coupling, const double fluid_density,
                                  MPI_Comm communicator)
      : solid(parameters.solid, fluid_density)
      , interaction(coupling, communicator)
      , parameters(parameters)
      , length(compute_extent(solid.get_triangulation()).length)
      , controller(parameters.controller.type.create())
      , surface_load(solid)
  {
    std::map<std::string, types::material_id> region_ids;
    for (unsigned int r = 0; r < parameters.solid.regions.size(); ++r)
      region_ids[parameters.solid.regions[r]] = r;
    muscle        = parameters.muscle.create(length, region_ids);
    muscle_memory = muscle->get_initial_memory();
    gait          = parameters.gait.create(length);
    std::vector<Point<dim>> nodes;
    for (const auto &node : solid.get_nodes())
      nodes.push_back(solid.get_reference_point(node[0]));
    gait_motion = std::make_unique<PrescribedMotion<dim>>(*gait, nodes);
    check_nose();

    elastic_system.reinit(solid.get_sparsity_pattern());
    response.reinit(solid.get_sparsity_pattern());
    equations.mass     = &solid.get_mass_matrix();
    equations.response = &response;
    new_positions      = solid.positions;
    new_velocity       = solid.velocity;
    new_force_density  = solid.force_density;
    new_feedback_force = solid.force_density;
    deformation        = summarise_deformation(solid, solid.positions);

    if (swims())
      lateral_point =
          solid.add_point(Point<dim>(parameters.muscle.shared.monitored_point * length *
                                     Point<dim>::unit_vector(0)),
                          solid.get_parameters().get_path() + "/Muscle/Monitored point");
  }

  template <int dim>
  void SwimmingBody<dim>::check_nose() const
  {
    const auto   box  = GridTools::compute_bounding_box(solid.get_triangulation());
    const double nose = box.lower_bound(0);
    AssertThrow(
        !counts_from_nose() || std::abs(nose) < 1e-3 * length,
        ExcMessage(solid.get_parameters().get_path() +
                   "/Shape: muscle and gait count s from x = 0 of the body's frame, but the "
                   "shape begins at x = " +
                   std::to_string(nose) +
                   " m there. Give a shape whose nose is at 0 (naca, eel), or move that of "
                   "the file."));
  }

  template <int dim>
  double SwimmingBody<dim>::get_lateral_position() const
  {
    if (!swims())
      return 0;
    const Tensor<1, dim> axis     = solid.get_initial_axis(1);
    const Tensor<1, dim> position = solid.evaluate(solid.positions, lateral_point);
    const Tensor<1, dim> initial  = solid.evaluate(solid.initial_positions, lateral_point);
    if (parameters.lateral_frame == "domain")
      return (position - initial) * axis;
    const auto head =
        fit_rigid_motion(solid, solid.get_head_nodes(), solid.initial_positions, solid.positions);
    return (transpose(head.rotation) * (position - head.center) -
            (initial - head.reference_center)) *
           axis;
  }

  template <int dim>
  Tensor<1, dim> SwimmingBody<dim>::get_forward_direction() const
  {
    const Tensor<1, dim> direction = -solid.get_initial_axis(0);
    if (parameters.lateral_frame == "domain")
      return direction;
    return fit_rigid_motion(solid, solid.get_head_nodes(), solid.initial_positions, solid.positions)
               .rotation *
           direction;
  }

  template <int dim>
  SwimmerState SwimmingBody<dim>::get_swimmer_state(const double time, const double step) const
  {
    const auto motion =
        fit_rigid_motion(solid, solid.get_head_nodes(), solid.initial_positions, solid.positions);
    const auto velocity =
        fit_rigid_velocity(solid, solid.get_head_nodes(), solid.positions, solid.velocity);
    const Tensor<1, dim> point          = solid.evaluate(solid.positions, lateral_point);
    Tensor<1, dim>       axis           = solid.get_initial_axis(1);
    Tensor<1, dim>       point_velocity = solid.evaluate(solid.velocity, lateral_point);
    if (parameters.lateral_frame == "head")
    {
      axis = motion.rotation * axis;
      point_velocity -= velocity.mean + velocity.spin * (point - velocity.center);
    }

    SwimmerState state;
    state.time             = time;
    state.step             = step;
    state.lateral_position = get_lateral_position();
    state.lateral_velocity = point_velocity * axis;
    state.heading          = std::atan2(motion.rotation[1][0], motion.rotation[0][0]);
    state.yaw_rate         = velocity.spin[1][0];
    state.speed            = get_mean_velocity() * get_forward_direction();
    return state;
  }

  template <int dim>
  void SwimmingBody<dim>::prepare_step(const double time, const double step)
  {
    if (!swims())
      return;
    const SwimmerState state = get_swimmer_state(time, step);
    contraction = muscle->contract(muscle_memory, state, controller->compute_command(state));
  }

  template <int dim>
  ActiveLoad<dim> SwimmingBody<dim>::get_active_load(const double time) const
  {
    ActiveLoad<dim> load;
    if (muscle->has_force())
      load.force_density = [this, time](const Point<dim> &s, const types::material_id region) {
        return solid.rotate_to_domain(
            muscle->force_density(contraction, MaterialPoint<dim>{s, region}, time));
      };
    if (muscle->has_active_stress())
      load.stress = [this, time](const Point<dim> &s, const types::material_id region) {
        return muscle->active_stress(contraction, MaterialPoint<dim>{s, region}, time);
      };
    return load;
  }

  template <int dim>
  void SwimmingBody<dim>::assemble_forces(const Vector<double> &x, const double time,
                                          const bool with_stiffness)
  {
    assemble_elastic_system(solid, x, get_active_load(time), with_stiffness, elastic_system);
    surface_load.add_to(elastic_system.active_force, time);
  }

  template <int dim>
  Vector<double> SwimmingBody<dim>::compute_feedback_force(const Vector<double> &x,
                                                           const Vector<double> &v) const
  {
    Vector<double> force(solid.n_dofs()), displacement(solid.initial_positions), damping(v);
    displacement -= x;
    damping *= -1;
    solid.get_feedback_stiffness().vmult(force, displacement);
    solid.get_feedback_damping().vmult_add(force, damping);
    return force;
  }

  template <int dim>
  Vector<double> SwimmingBody<dim>::compute_gait_velocity(const Vector<double> &x,
                                                          const double          time,
                                                          const double relaxation_time) const
  {
    Vector<double> shape(solid.n_dofs()), rate(solid.n_dofs()), result(solid.n_dofs());
    const auto     motion = gait_motion->compute(time);
    for (unsigned int n = 0; n < solid.get_nodes().size(); ++n)
      for (unsigned int d = 0; d < dim; ++d)
      {
        shape[solid.get_nodes()[n][d]] = motion.positions[n][d];
        rate[solid.get_nodes()[n][d]]  = motion.velocities[n][d];
      }
    const auto fit = fit_rigid_motion(solid, solid.get_nodes(), shape, x);
    for (const auto &node : solid.get_nodes())
    {
      Tensor<1, dim> position, velocity;
      for (unsigned int d = 0; d < dim; ++d)
      {
        position[d] = shape[node[d]];
        velocity[d] = rate[node[d]];
      }
      position = fit.center + fit.rotation * (position - fit.reference_center);
      velocity = fit.rotation * velocity;
      for (unsigned int d = 0; d < dim; ++d)
        result[node[d]] = velocity[d] + (position[d] - x[node[d]]) / relaxation_time;
    }
    return result;
  }

  template <int dim>
  void SwimmingBody<dim>::set_up_rigid_motions(const Vector<double> &x)
  {
    const std::vector<Vector<double>> modes = make_rigid_velocities(solid, x);
    equations.rigid_moments.assign(modes.size(), Vector<double>(solid.n_dofs()));
    equations.rigid_inertia.reinit(modes.size(), modes.size());
    equations.gait_damping = parameters.gait_damping;
    for (unsigned int k = 0; k < modes.size(); ++k)
      solid.get_mass_matrix().vmult(equations.rigid_moments[k], modes[k]);
    for (unsigned int k = 0; k < modes.size(); ++k)
      for (unsigned int l = 0; l < modes.size(); ++l)
        equations.rigid_inertia(k, l) = equations.rigid_moments[k] * modes[l];
  }

  template <int dim>
  void SwimmingBody<dim>::accept_step(const double step)
  {
    Vector<double> displacement(new_positions);
    displacement -= solid.positions;
    // What drives the body: the muscle, and with a gait the rest of its forces.
    Vector<double> driving_force(elastic_system.active_force);
    if (has_gait())
    {
      Vector<double> mean_density(solid.force_density);
      mean_density += new_force_density;
      mean_density *= 0.5;
      solid.get_mass_matrix().vmult(driving_force, mean_density);
      driving_force -= elastic_system.elastic_force;
      driving_force -= new_feedback_force;
      // The force density has the inertia of the excess mass in it, with the opposite sign.
      Vector<double> acceleration(new_velocity);
      acceleration -= solid.velocity;
      acceleration *= solid.get_excess_density() / step;
      solid.get_mass_matrix().vmult_add(driving_force, acceleration);
    }
    const double work = driving_force * displacement;
    muscle_work += work;
    muscle_power = work / step;
    // Fluid moves through fixed nodes rather than with them.
    for (unsigned int i = 0; i < solid.n_dofs(); ++i)
      if (solid.is_fixed(i))
        displacement[i] = 0.5 * step * (solid.velocity[i] + new_velocity[i]);
    feedback_work += new_feedback_force * displacement;

    solid.old_positions = solid.positions;
    solid.old_velocity  = solid.velocity;
    solid.positions     = new_positions;
    solid.velocity      = new_velocity;
    solid.force_density = new_force_density;
    muscle_memory       = contraction.after;
  }

  template <int dim>
  void SwimmingBody<dim>::restore(const Vector<double>      &initial_positions,
                                  const std::vector<double> &muscle_state)
  {
    AssertThrow(initial_positions == solid.initial_positions,
                ExcMessage("Body " + get_name() +
                           "/Shape: the checkpoint holds a body with another grid. Resume with "
                           "the shape (and the mesh file) that wrote it."));
    muscle->check_memory(muscle_state);
    muscle_memory     = muscle_state;
    new_positions     = solid.positions;
    new_velocity      = solid.velocity;
    new_force_density = solid.force_density;
    deformation       = summarise_deformation(solid, solid.positions);
  }

  template class SwimmingBody<2>;
  template class SwimmingBody<3>;
  template struct SwimmingBodyParameters<2>;
  template struct SwimmingBodyParameters<3>;
} // namespace caudal
