// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/fish/number_table.h>
#include <caudal/solid/body.h>
#include <caudal/solid/rigid_motion.h>

#include <deal.II/base/patterns.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>

namespace caudal
{
  template <int dim>
  BodyParameters<dim>::BodyParameters(const std::string              &name,
                                      const std::vector<std::string> &regions)
      : solid(name, regions)
  {}

  template <int dim>
  void BodyParameters<dim>::add_parameters(ParameterHandler &prm)
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
  void BodyParameters<dim>::check(const bool is_explicit) const
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
  Body<dim>::Body(const BodyParameters<dim> &parameters, const Surroundings &fluid,
                  const Tensor<1, dim> &gravity)
      : parameters(parameters)
      , solid(parameters.solid, fluid)
      , extent(compute_extent(solid.get_triangulation()))
      , controller(parameters.controller.type.create())
  {
    std::map<std::string, types::material_id> region_ids;
    for (unsigned int r = 0; r < parameters.solid.regions.size(); ++r)
      region_ids[parameters.solid.regions[r]] = r;
    muscle = parameters.muscle.create(extent.length, region_ids);
    gait   = parameters.gait.create(extent.length);
    check_nose();
    if (undulates())
      lateral_point =
          solid.add_point(Point<dim>(parameters.muscle.shared.monitored_point * extent.length *
                                     Point<dim>::unit_vector(0)),
                          solid.get_parameters().get_path() + "/Muscle/Monitored point");

    loads.push_back(make_elastic_load(solid));
    loads.push_back(make_feedback_load(solid));
    if (gravity.norm() > 0. && solid.get_excess_density() != 0.)
    {
      excess_weight = compute_excess_weight(solid, gravity);
      loads.push_back(make_excess_weight(solid, excess_weight));
    }
    if (has_muscle())
      loads.push_back(make_muscle_load(solid, *muscle));
    if (!parameters.solid.traction.empty())
      loads.push_back(make_surface_load(solid));
    if (has_gait())
    {
      prescribed = std::make_unique<PrescribedMotion<dim>>(prescribe_nodes(solid, *gait));
      loads.push_back(make_gait_load(solid, *prescribed, parameters.gait_damping));
    }
  }

  template <int dim>
  bool Body<dim>::swims() const
  {
    return has_gait() || has_muscle();
  }

  template <int dim>
  void Body<dim>::check_nose() const
  {
    const double nose = GridTools::compute_bounding_box(solid.get_triangulation()).lower_bound(0);
    AssertThrow(
        !counts_from_nose() || std::abs(nose) < 1e-3 * extent.length,
        ExcMessage(solid.get_parameters().get_path() +
                   "/Shape: muscle and gait count s from x = 0 of the body's frame, but the "
                   "shape begins at x = " +
                   std::to_string(nose) +
                   " m there. Give a shape whose nose is at 0 (naca, eel), or move that of "
                   "the file."));
  }

  template <int dim>
  void Body<dim>::check_until(const double end_time) const
  {
    const std::string path = solid.get_parameters().get_path();
    if (has_gait())
      check_table_times(path, "Gait", 0., gait->get_end(), end_time);
    const auto [begin, end] = muscle->get_time_range();
    check_table_times(path, "Muscle", begin, end, end_time);
  }

  template <int dim>
  BodyState Body<dim>::make_initial_state() const
  {
    BodyState state;
    state.positions = solid.get_initial_positions();
    if (has_gait())
      state.positions = compute_first_positions(solid, *prescribed);
    state.old_positions = state.positions;
    for (Vector<double> *field : {&state.velocity, &state.old_velocity, &state.force_density})
      field->reinit(solid.n_dofs());
    state.contraction.after = muscle->get_initial_memory();
    return state;
  }

  template <int dim>
  void Body<dim>::check_state(const BodyState &state, const Vector<double> &initial_positions) const
  {
    AssertThrow(initial_positions == solid.get_initial_positions(),
                ExcMessage("Body " + get_name() +
                           "/Shape: the checkpoint holds a body with another grid. Resume with "
                           "the shape (and the mesh file) that wrote it."));
    muscle->check_memory(state.contraction.after);
  }

  namespace
  {
    /** Whether a load is what holds fixed nodes, or is borne by their support. */
    bool acts_on_fixed_nodes(const LoadAccount account)
    {
      return account == LoadAccount::feedback || account == LoadAccount::gait;
    }
  } // namespace

  template <int dim>
  Vector<double> Body<dim>::compute_force(const LoadAccount account, const BodyMotion &motion) const
  {
    Vector<double> force(solid.n_dofs());
    for (const auto &load : loads)
      if (load->account == account)
        load->add(motion, force, nullptr);
    if (!acts_on_fixed_nodes(account))
      solid.clear_fixed_nodes(force);
    return force;
  }

  template <int dim>
  ForcesByAccount Body<dim>::compute_forces(const BodyMotion &motion, BodyResponse *response) const
  {
    ForcesByAccount forces;
    const auto      add = [&](const bool on_fixed_nodes) {
      for (const auto &load : loads)
        if (acts_on_fixed_nodes(load->account) == on_fixed_nodes)
        {
          Vector<double> &force = forces[load->account];
          if (force.size() == 0)
            force.reinit(solid.n_dofs());
          load->add(motion, force, response);
        }
    };
    add(false);
    // What acts on fixed nodes is borne by their support, and not by the fluid through the damping.
    for (auto &force : forces)
      solid.clear_fixed_nodes(force.second);
    if (response != nullptr)
      for (SparseMatrix<double> *matrix : {&response->stiffness, &response->damping})
        solid.clear_fixed_nodes(*matrix);
    add(true);
    return forces;
  }

  template <int dim>
  Vector<double> Body<dim>::compute_gait_force(const Vector<double>  &force_density,
                                               const ForcesByAccount &forces,
                                               const Vector<double>  &acceleration) const
  {
    Vector<double> result(solid.n_dofs()), inertia(acceleration);
    solid.get_coupling_mass().vmult(result, force_density);
    for (const LoadAccount account :
         {LoadAccount::elastic, LoadAccount::feedback, LoadAccount::gravity})
      result -= forces.at(account);
    inertia *= solid.get_excess_density();
    solid.get_mass_matrix().vmult_add(result, inertia);
    return result;
  }

  template <int dim>
  Vector<double> Body<dim>::compute_forces_on_fluid(const BodyState &state) const
  {
    Vector<double> forces(solid.n_dofs());
    solid.get_coupling_mass().vmult(forces, state.force_density);
    return forces;
  }

  template <int dim>
  Tensor<1, dim> Body<dim>::get_resultant(const BodyState &state) const
  {
    return sum_up(solid, compute_forces_on_fluid(state));
  }

  template <int dim>
  double Body<dim>::get_potential_energy(const BodyState &state) const
  {
    if (excess_weight.size() == 0)
      return 0;
    Vector<double> rise(state.positions);
    rise -= solid.get_initial_positions();
    return -(excess_weight * rise);
  }

  template <int dim>
  Tensor<1, dim> Body<dim>::evaluate_monitored(const Vector<double> &field) const
  {
    return undulates() ? solid.evaluate(field, lateral_point) : solid.compute_mean(field);
  }

  template <int dim>
  double Body<dim>::get_lateral_position(const BodyState &state) const
  {
    if (!swims())
      return 0;
    const Tensor<1, dim> axis     = solid.get_initial_axis(1);
    const Tensor<1, dim> position = evaluate_monitored(state.positions);
    const Tensor<1, dim> initial  = evaluate_monitored(solid.get_initial_positions());
    if (parameters.lateral_frame == "domain")
      return (position - initial) * axis;
    const auto head = fit_head(state);
    return (transpose(head.rotation) * (position - head.center) -
            (initial - head.reference_center)) *
           axis;
  }

  template <int dim>
  RigidMotion<dim> Body<dim>::fit_head(const BodyState &state) const
  {
    return fit_rigid_motion(solid, solid.get_head_nodes(), solid.get_initial_positions(),
                            state.positions);
  }

  template <int dim>
  Tensor<1, dim> Body<dim>::get_forward_direction(const BodyState &state) const
  {
    const Tensor<1, dim> direction = -solid.get_initial_axis(0);
    return parameters.lateral_frame == "domain" ? direction : fit_head(state).rotation * direction;
  }

  template <int dim>
  SwimmerState Body<dim>::get_swimmer_state(const BodyState &state, const double time,
                                            const double step) const
  {
    const auto motion = fit_head(state);
    const auto velocity =
        fit_rigid_velocity(solid, solid.get_head_nodes(), state.positions, state.velocity);
    const Tensor<1, dim> point          = evaluate_monitored(state.positions);
    Tensor<1, dim>       axis           = solid.get_initial_axis(1);
    Tensor<1, dim>       point_velocity = evaluate_monitored(state.velocity);
    if (parameters.lateral_frame == "head")
    {
      axis = motion.rotation * axis;
      point_velocity -= velocity.mean + velocity.spin * (point - velocity.center);
    }

    SwimmerState swimmer;
    swimmer.time             = time;
    swimmer.step             = step;
    swimmer.lateral_position = get_lateral_position(state);
    swimmer.lateral_velocity = point_velocity * axis;
    swimmer.heading          = std::atan2(motion.rotation[1][0], motion.rotation[0][0]);
    swimmer.yaw_rate         = velocity.spin[1][0];
    swimmer.speed            = get_mean_velocity(state) * get_forward_direction(state);
    return swimmer;
  }

  template <int dim>
  Contraction Body<dim>::command_muscle(const BodyState &state, const double time,
                                        const double step) const
  {
    if (!swims())
      return state.contraction;
    const SwimmerState swimmer = get_swimmer_state(state, time, step);
    return muscle->contract(state.contraction.after, swimmer, controller->compute_command(swimmer));
  }

  template class Body<2>;
  template class Body<3>;
  template struct BodyParameters<2>;
  template struct BodyParameters<3>;
} // namespace caudal
