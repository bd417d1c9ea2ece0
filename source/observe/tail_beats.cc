// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/tail_beats.h>

#include <caudal/base/collective.h>
#include <caudal/observe/control_volume.h>
#include <caudal/observe/energies.h>

namespace caudal
{
  namespace
  {
    const DimensionalRegistration<Observer, TailBeats>
        registration("tail beats", "speed, power, forces and efficiencies of each tail beat");

    /** Mass per volume of the body [kg/m^3]. */
    template <int dim>
    double get_density(const Observation<dim> &observation, const SolidBody<dim> &solid)
    {
      return observation.space.get_parameters().density + solid.get_excess_density();
    }

    template <int dim>
    SwimmerConstants get_constants(const Observation<dim> &observation, const Body<dim> &body)
    {
      const auto      &fluid = observation.space.get_parameters();
      SwimmerConstants swimmer;
      swimmer.name   = body.get_name();
      swimmer.length = body.get_length();
      swimmer.mass =
          get_density(observation, body.get_solid()) * body.get_solid().get_reference_volume();
      swimmer.viscosity     = fluid.kinematic_viscosity;
      swimmer.fluid_density = fluid.density;
      swimmer.is_per_span   = dim == 2;
      for (const auto &face : body.get_solid().get_triangulation().active_face_iterators())
        if (face->at_boundary())
          swimmer.wetted_area += face->measure();
      return swimmer;
    }
  } // namespace

  template <int dim>
  void TailBeats<dim>::start(const Observation<dim>     &observation,
                             const ObserverContext<dim> &context)
  {
    const bool is_root      = Utilities::MPI::this_mpi_process(context.communicator) == 0;
    const bool has_one_body = observation.bodies.size() == 1;
    for (const auto &observed : observation.bodies)
    {
      const Body<dim>  &body    = observed.body;
      const std::string file    = has_one_body ? "swim.txt" : "swim_" + body.get_name() + ".txt";
      SwimmerConstants  swimmer = get_constants(observation, body);
      // The control volume gives the force on all bodies together.
      swimmer.has_control_volume =
          has_one_body && context.others.template get<ControlVolume<dim>>().is_active();
      reports.emplace_back();
      if (!body.swims())
        continue;
      for (const std::string ending : {".json", ".csv"})
        context.folder.add(file.substr(0, file.rfind('.')) + ending);
      const std::string path = context.folder.add(file);
      reports.back().emplace(swimmer, context.log, is_root ? path : "");
    }
    body_impulses.resize(reports.size());
  }

  template <int dim>
  SwimSample TailBeats<dim>::take_sample(const Observation<dim>     &observation,
                                         const ObserverContext<dim> &context,
                                         const unsigned int          b) const
  {
    const Body<dim>      &body    = observation.bodies[b].body;
    const BodyState      &state   = observation.bodies[b].state;
    const SolidBody<dim> &solid   = body.get_solid();
    const Tensor<1, dim>  forward = -solid.get_initial_axis(0);
    const double          volume  = solid.get_reference_volume();
    const double          speed   = body.get_mean_velocity(state) * forward;
    SwimSample            sample;
    sample.time          = observation.time;
    sample.tail_position = body.get_lateral_position(state);
    sample.forward_position =
        (solid.compute_mean(state.positions) - solid.compute_mean(solid.get_initial_positions())) *
        forward;
    const Tensor<1, dim> side   = solid.get_initial_axis(1);
    const Tensor<1, dim> tail   = body.get_monitored_position(state);
    const Tensor<1, dim> centre = solid.compute_mean(state.positions);
    sample.tail                 = Point<2>(tail * forward, tail * side);
    sample.centre               = Point<2>(centre * forward, centre * side);
    sample.muscle_work          = state.muscle_work;
    sample.forward_momentum     = get_density(observation, solid) * volume * speed;
    // The body force includes the inertia of the excess mass.
    sample.body_impulse = body_impulses[b] + solid.get_excess_density() * volume * speed;
    sample.fluid_impulse =
        context.others.template get<ControlVolume<dim>>().get_impulse() * forward;
    sample.ledger = context.others.template get<Energies<dim>>().get_ledger();
    return sample;
  }

  template <int dim>
  void TailBeats<dim>::observe_step(const Observation<dim>     &observation,
                                    const ObserverContext<dim> &context)
  {
    // Rank 0 alone writes to the tables; if it can't, all ranks must know.
    run_on_all(context.communicator, [&]() {
      for (unsigned int b = 0; b < reports.size(); ++b)
        if (reports[b])
        {
          const auto &[body, state, report] = observation.bodies[b];
          const Tensor<1, dim> forward      = -body.get_solid().get_initial_axis(0);
          body_impulses[b] += observation.step * (body.get_resultant(state) * forward);
          reports[b]->add(take_sample(observation, context, b));
        }
    });
  }

  template <int dim>
  void TailBeats<dim>::finish(const Observation<dim> &, const ObserverContext<dim> &)
  {
    for (auto &report : reports)
      if (report)
        report->finish();
  }

  template <int dim>
  void TailBeats<dim>::exchange_state(StateArchive &archive)
  {
    archive &body_impulses;
    for (auto &report : reports)
      if (report)
        archive &*report;
  }

  template <int dim>
  void TailBeats<dim>::resume(const Observation<dim> &, const ObserverContext<dim> &context)
  {
    run_on_all(context.communicator, [&]() {
      for (const auto &report : reports)
        if (report)
          report->resume();
    });
  }

  template <int dim>
  double TailBeats<dim>::get_last_period() const
  {
    for (const auto &report : reports)
      if (report && !report->get_beats().empty())
        return report->get_beats().back().period;
    return 0.;
  }

  template class TailBeats<2>;
  template class TailBeats<3>;
} // namespace caudal
