// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/expression.h>
#include <caudal/solid/elasticity.h>
#include <caudal/solid/load.h>
#include <caudal/solid/material_tools.h>
#include <caudal/solid/rigid_motion.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/numerics/vector_tools_rhs.h>

#include <algorithm>
#include <cmath>

namespace caudal
{
  namespace
  {
    /** Forces b of a body's cell and their derivatives -db/dX, by sums over quadrature points. */
    template <int dim>
    class CellForces
    {
    public:
      using QuadraturePoint = typename SolidBody<dim>::QuadraturePoint;

      explicit CellForces(const FiniteElement<dim> &element)
          : n(element.n_dofs_per_cell())
          , component(n)
          , node(n)
          , force(n)
          , volume_gradient(n)
          , stiffness(n, n)
          , volume_curvature(n, n)
      {
        for (unsigned int i = 0; i < n; ++i)
          std::tie(component[i], node[i]) = element.system_to_component_index(i);
      }

      void clear()
      {
        force            = 0;
        volume_gradient  = 0;
        stiffness        = 0;
        volume_curvature = 0;
        volume           = 0;
        reference_volume = 0;
      }

      /** A force @p density per reference volume. */
      void add_force(const Tensor<1, dim> &density, const QuadraturePoint &point)
      {
        for (unsigned int i = 0; i < n; ++i)
          force[i] += point.weight * density[component[i]] * point.values[node[i]];
      }

      /** The first Piola-Kirchhoff stress @p P. */
      void add_stress(const Tensor<2, dim> &P, const QuadraturePoint &point)
      {
        for (unsigned int i = 0; i < n; ++i)
          force[i] -= point.weight * (P[component[i]] * point.gradients[node[i]]);
      }

      /** The @p tangent dP/dF of the stress. */
      void add_tangent(const Tensor<4, dim> &tangent, const QuadraturePoint &point)
      {
        add_second_derivatives(tangent, point, stiffness);
      }

      void add_volume(const Tensor<2, dim> &F, const QuadraturePoint &point)
      {
        const Tensor<2, dim> dJ = cofactor(F);
        for (unsigned int i = 0; i < n; ++i)
          volume_gradient[i] += point.weight * (dJ[component[i]] * point.gradients[node[i]]);
        volume += point.weight * determinant(F);
        reference_volume += point.weight;
      }

      /** The second derivative of J, J (G_iJ G_kL - G_iL G_kJ) with G = F^-T. */
      void add_volume_curvature(const Tensor<2, dim> &F, const QuadraturePoint &point)
      {
        const double         J = determinant(F);
        const Tensor<2, dim> G = inverse_transpose(F);
        add_second_derivatives(make_tangent<dim>([&](auto i, auto J_, auto k, auto L) {
                                 return J * (G[i][J_] * G[k][L] - G[i][L] * G[k][J_]);
                               }),
                               point, volume_curvature);
      }

      /**
       * Force and stiffness of the energy kappa/2 V (ln(v/V))^2 of the volume v of the cell, V in
       * the reference configuration. The curvature of v, if it was summed up, is left out of the
       * stiffness in compression, where it is negative.
       */
      void add_volume_stabilisation(const double kappa)
      {
        const double J = volume / reference_volume, log_J = std::log(J);
        force.add(-kappa * log_J / J, volume_gradient);
        stiffness.add(kappa * std::max(0., log_J) / J, volume_curvature);
        const double factor = kappa * (1. - log_J) / (J * volume);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            stiffness(i, j) += factor * volume_gradient[i] * volume_gradient[j];
      }

      /** Adds the sums to those of the body. */
      void distribute(const typename DoFHandler<dim>::active_cell_iterator &cell,
                      Vector<double> &body_force, BodyResponse *response) const
      {
        cell->distribute_local_to_global(force, body_force);
        if (response != nullptr)
          cell->distribute_local_to_global(stiffness, response->stiffness);
      }

    private:
      const unsigned int        n;
      std::vector<unsigned int> component, node;
      Vector<double>            force, volume_gradient;
      FullMatrix<double>        stiffness, volume_curvature;
      double                    volume = 0, reference_volume = 0;

      /** Tests the second @p derivative with respect to F by two displacements. */
      void add_second_derivatives(const Tensor<4, dim> &derivative, const QuadraturePoint &point,
                                  FullMatrix<double> &matrix) const
      {
        for (unsigned int j = 0; j < n; ++j)
        {
          // dP for a displacement of node j: column k of the tangent times grad N_j.
          Tensor<2, dim> dP;
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int J = 0; J < dim; ++J)
              dP[i][J] = derivative[i][J][component[j]] * point.gradients[node[j]];
          for (unsigned int i = 0; i < n; ++i)
            matrix(i, j) += point.weight * (dP[component[i]] * point.gradients[node[i]]);
        }
      }
    };

    template <int dim>
    class ElasticLoad : public Load<dim>
    {
    public:
      explicit ElasticLoad(const SolidBody<dim> &body)
          : Load<dim>(body, LoadAccount::elastic)
      {}

      void add(const BodyMotion &motion, Vector<double> &force,
               BodyResponse *response) const override
      {
        const SolidBody<dim> &body = this->body;
        // Without the curvature of their volumes bodies under a dead load don't come to rest
        // (prm/benchmarks/pulled_rectangle.prm). Others have volume errors of both signs, with
        // which it makes large steps tear elements (tests/viscous/flag.prm, flagship.prm).
        const bool      is_loaded = !body.get_parameters().traction.empty();
        CellForces<dim> sums(body.get_dof_handler().get_fe());
        for (const auto &cell : body.get_dof_handler().active_cell_iterators())
        {
          const auto   nodes    = get_cell_nodes<dim>(cell, motion.positions);
          const auto  &material = body.get_material(cell->material_id());
          const double kappa    = body.get_cell_volume_stabilisation(cell->material_id());
          sums.clear();
          for (const auto &point : body.get_quadrature_points(cell->active_cell_index()))
          {
            const Tensor<2, dim> F = compute_deformation_gradient(nodes, point.gradients);
            AssertThrow(determinant(F) > 0, ExcInvertedElement(determinant(F)));
            sums.add_stress(material.first_piola_kirchhoff_stress(F, point.place), point);
            if (response != nullptr)
              sums.add_tangent(material.tangent(F, point.place), point);
            if (kappa > 0)
              sums.add_volume(F, point);
            if (kappa > 0 && response != nullptr && is_loaded)
              sums.add_volume_curvature(F, point);
          }
          if (kappa > 0)
            sums.add_volume_stabilisation(kappa);
          sums.distribute(cell, force, response);
        }
      }
    };

    template <int dim>
    class FeedbackLoad : public Load<dim>
    {
    public:
      explicit FeedbackLoad(const SolidBody<dim> &body)
          : Load<dim>(body, LoadAccount::feedback)
      {}

      void add(const BodyMotion &motion, Vector<double> &force,
               BodyResponse *response) const override
      {
        const SolidBody<dim> &body = this->body;
        Vector<double> displacement(body.compute_held_positions(motion.time)), slip(body.n_dofs());
        displacement -= motion.positions;
        if (body.has_moving_places())
        {
          const double increment = 1e-6, before = std::max(0., motion.time - increment);
          const double scale = 1. / (motion.time + increment - before);
          slip.add(scale, body.compute_held_positions(motion.time + increment), -scale,
                   body.compute_held_positions(before));
        }
        slip -= motion.velocity;
        body.get_feedback_stiffness().vmult_add(force, displacement);
        body.get_feedback_damping().vmult_add(force, slip);
        if (response != nullptr)
        {
          response->stiffness.add(1, body.get_feedback_stiffness());
          response->damping.add(1, body.get_feedback_damping());
        }
      }
    };

    template <int dim>
    class ExcessWeight : public Load<dim>
    {
    public:
      ExcessWeight(const SolidBody<dim> &body, const Vector<double> &weight)
          : Load<dim>(body, LoadAccount::gravity)
          , weight(weight)
      {}

      void add(const BodyMotion &, Vector<double> &force, BodyResponse *) const override
      {
        force += weight;
      }

    private:
      const Vector<double> &weight;
    };

    template <int dim>
    class MuscleLoad : public Load<dim>
    {
    public:
      MuscleLoad(const SolidBody<dim> &body, const Muscle<dim> &muscle)
          : Load<dim>(body, LoadAccount::muscle)
          , muscle(muscle)
      {}

      void add(const BodyMotion &motion, Vector<double> &force,
               BodyResponse *response) const override
      {
        if (motion.contraction.step == 0)
          return; // before the first step it has not decided anything
        const SolidBody<dim> &body = this->body;
        CellForces<dim>       sums(body.get_dof_handler().get_fe());
        for (const auto &cell : body.get_dof_handler().active_cell_iterators())
        {
          const auto nodes = get_cell_nodes<dim>(cell, motion.positions);
          sums.clear();
          for (const auto &point : body.get_quadrature_points(cell->active_cell_index()))
          {
            const MaterialPoint<dim> place{point.place, cell->material_id()};
            if (muscle.has_force())
              sums.add_force(body.rotate_to_domain(
                                 muscle.force_density(motion.contraction, place, motion.time)),
                             point);
            if (!muscle.has_active_stress())
              continue;
            const Tensor<2, dim> S = muscle.active_stress(motion.contraction, place, motion.time);
            sums.add_stress(compute_deformation_gradient(nodes, point.gradients) * S, point);
            if (response != nullptr)
              sums.add_tangent(make_tangent<dim>([&](auto i, auto J, auto k, auto L) {
                                 return i == k ? S[L][J] : 0.;
                               }),
                               point);
          }
          sums.distribute(cell, force, response);
        }
      }

    private:
      const Muscle<dim> &muscle;
    };

    template <int dim>
    class SurfaceLoad : public Load<dim>
    {
    public:
      explicit SurfaceLoad(const SolidBody<dim> &body)
          : Load<dim>(body, LoadAccount::muscle)
          , traction(
                std::make_unique<Expression<dim>>(body.get_parameters().get_path() + "/Traction",
                                                  body.get_parameters().traction, dim))
      {}

      void add(const BodyMotion &motion, Vector<double> &force, BodyResponse *) const override
      {
        traction->set_time(motion.time);
        const DoFHandler<dim> &dofs = this->body.get_dof_handler();
        Vector<double>         load(dofs.n_dofs());
        VectorTools::create_boundary_right_hand_side(
            dofs, QGauss<dim - 1>(dofs.get_fe().degree + 1), *traction, load);
        force += load;
      }

    private:
      const std::unique_ptr<Expression<dim>> traction;
    };

    // Errors of the shape are worked off within so many steps.
    constexpr double n_relaxation_steps = 10;

    template <int dim>
    class GaitLoad : public Load<dim>
    {
    public:
      GaitLoad(const SolidBody<dim> &body, const PrescribedMotion<dim> &gait, const double damping)
          : Load<dim>(body, LoadAccount::gait)
          , gait(gait)
          , damping(damping)
      {}

      void add(const BodyMotion &motion, Vector<double> &force,
               BodyResponse *response) const override
      {
        Vector<double> slip = compute_velocity(motion);
        slip -= motion.velocity;
        slip *= damping;
        this->body.get_mass_matrix().vmult_add(force, slip);
        if (response != nullptr)
          response->damping.add(damping, this->body.get_mass_matrix());
      }

    private:
      const PrescribedMotion<dim> &gait;
      const double                 damping;

      Vector<double> compute_velocity(const BodyMotion &motion) const
      {
        const SolidBody<dim> &body        = this->body;
        const auto           &nodes       = body.get_nodes();
        const auto            deformation = gait.compute(motion.time);
        const auto            fit         = lay_over(body, deformation.positions, motion.positions);
        Vector<double>        result(body.n_dofs());
        for (unsigned int n = 0; n < nodes.size(); ++n)
        {
          const Tensor<1, dim> place = fit.apply(deformation.positions[n]);
          set_value(result, nodes[n],
                    fit.rotation * deformation.velocities[n] +
                        (place - get_value(motion.positions, nodes[n])) /
                            (n_relaxation_steps * motion.step));
        }
        return result;
      }
    };
  } // namespace

  template <int dim>
  RigidMotion<dim> lay_over(const SolidBody<dim> &body, const std::vector<Point<dim>> &shape,
                            const Vector<double> &positions)
  {
    const auto    &nodes = body.get_nodes();
    Vector<double> field(body.n_dofs());
    for (unsigned int n = 0; n < nodes.size(); ++n)
      set_value(field, nodes[n], shape[n]);
    return fit_rigid_motion(body, nodes, field, positions);
  }

  template <int dim>
  std::unique_ptr<Load<dim>> make_elastic_load(const SolidBody<dim> &body)
  {
    return std::make_unique<ElasticLoad<dim>>(body);
  }

  template <int dim>
  std::unique_ptr<Load<dim>> make_feedback_load(const SolidBody<dim> &body)
  {
    return std::make_unique<FeedbackLoad<dim>>(body);
  }

  template <int dim>
  std::unique_ptr<Load<dim>> make_excess_weight(const SolidBody<dim> &body,
                                                const Vector<double> &weight)
  {
    return std::make_unique<ExcessWeight<dim>>(body, weight);
  }

  template <int dim>
  std::unique_ptr<Load<dim>> make_muscle_load(const SolidBody<dim> &body, const Muscle<dim> &muscle)
  {
    return std::make_unique<MuscleLoad<dim>>(body, muscle);
  }

  template <int dim>
  std::unique_ptr<Load<dim>> make_surface_load(const SolidBody<dim> &body)
  {
    return std::make_unique<SurfaceLoad<dim>>(body);
  }

  template <int dim>
  std::unique_ptr<Load<dim>> make_gait_load(const SolidBody<dim>        &body,
                                            const PrescribedMotion<dim> &gait, const double damping)
  {
    return std::make_unique<GaitLoad<dim>>(body, gait, damping);
  }

  template <int dim>
  PrescribedMotion<dim> prescribe_nodes(const SolidBody<dim> &body, const Gait &gait)
  {
    std::vector<Point<dim>> places;
    for (const auto &node : body.get_nodes())
      places.push_back(body.get_reference_point(node[0]));
    const auto                  ends = compute_lateral_ends(body.get_triangulation(), places);
    std::vector<BodyPoint<dim>> points;
    for (std::size_t p = 0; p < places.size(); ++p)
      points.push_back({places[p], ends[p].first, ends[p].second});
    return PrescribedMotion<dim>(gait, points);
  }

  template <int dim>
  Vector<double> compute_first_positions(const SolidBody<dim>        &body,
                                         const PrescribedMotion<dim> &gait)
  {
    const auto     shape = gait.compute(0.).positions;
    const auto     fit   = lay_over(body, shape, body.get_initial_positions());
    const auto    &nodes = body.get_nodes();
    Vector<double> positions(body.n_dofs());
    for (unsigned int n = 0; n < nodes.size(); ++n)
      set_value(positions, nodes[n], fit.apply(shape[n]));
    return positions;
  }

#define INSTANTIATE(dim)                                                                           \
  template RigidMotion<dim> lay_over(const SolidBody<dim> &, const std::vector<Point<dim>> &,      \
                                     const Vector<double> &);                                      \
  template std::unique_ptr<Load<dim>> make_elastic_load(const SolidBody<dim> &);                   \
  template std::unique_ptr<Load<dim>> make_feedback_load(const SolidBody<dim> &);                  \
  template std::unique_ptr<Load<dim>> make_excess_weight(const SolidBody<dim> &,                   \
                                                         const Vector<double> &);                  \
  template std::unique_ptr<Load<dim>> make_muscle_load(const SolidBody<dim> &,                     \
                                                       const Muscle<dim> &);                       \
  template std::unique_ptr<Load<dim>> make_surface_load(const SolidBody<dim> &);                   \
  template std::unique_ptr<Load<dim>> make_gait_load(const SolidBody<dim> &,                       \
                                                     const PrescribedMotion<dim> &, double);       \
  template PrescribedMotion<dim>      prescribe_nodes(const SolidBody<dim> &, const Gait &);       \
  template Vector<double>             compute_first_positions(const SolidBody<dim> &,              \
                                                              const PrescribedMotion<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace caudal
