// SPDX-License-Identifier: LGPL-2.1-or-later
// The loads on a body: no elastic forces in a rigid motion, balanced ones in any deformation, and
// the tangents of elastic and muscle forces against differences.

#include <caudal/solid/elasticity.h>
#include <caudal/solid/load.h>
#include <caudal/solid/rigid_motion.h>

#include "../round_off.h"

#include <iomanip>
#include <iostream>

using namespace caudal;

namespace
{
  /** A force density, an active stress, or both. */
  template <int dim>
  class TestMuscle : public Muscle<dim>
  {
  public:
    TestMuscle(const bool pulls, const bool contracts)
        : pulls(pulls)
        , contracts(contracts)
    {}

    bool has_force() const override
    {
      return pulls;
    }

    bool has_active_stress() const override
    {
      return contracts;
    }

    Tensor<1, dim> force_density(const Contraction &, const MaterialPoint<dim> &point,
                                 double) const override
    {
      return Tensor<1, dim>(point.s * point.s[0]);
    }

    Tensor<2, dim> active_stress(const Contraction &, const MaterialPoint<dim> &point,
                                 double) const override
    {
      Tensor<2, dim> stress;
      stress[0][0] = 0.5 + point.s[1];
      stress[0][1] = stress[1][0] = 0.2 * point.region;
      return stress;
    }

  private:
    const bool pulls, contracts;
  };

  /** The force of a load at the positions @p x at t = 2 s. */
  template <int dim>
  Vector<double> compute_force(const Load<dim> &load, const Vector<double> &x,
                               BodyResponse *response = nullptr)
  {
    Contraction contraction;
    contraction.step = 1;
    const Vector<double> velocity(x.size());
    Vector<double>       force(x.size());
    load.add({x, velocity, 2, 1, contraction}, force, response);
    return force;
  }

  /** The largest entry of K - K^T. */
  double get_asymmetry(const SparseMatrix<double> &matrix)
  {
    double asymmetry = 0;
    for (const auto &entry : matrix)
      asymmetry =
          std::max(asymmetry, std::abs(entry.value() - matrix(entry.column(), entry.row())));
    return asymmetry;
  }

  template <int dim>
  struct Setup
  {
    Setup()
        : parameters("test", {"front", "back"})
    {
      parameters.grid.shape.type.set_name("beam");
      parameters.grid.shape.lengths.thickness = 0.3;
      parameters.grid.shape.lengths.width     = 0.4;
      parameters.grid.elements                = dim == 2 ? "2, 2" : "2, 2, 2";
      parameters.grid.region_boundaries       = {0.5};
      parameters.grid.rotation                = 30;
      parameters.polynomial_degree            = 2;
      MaterialParameters<dim> &front          = parameters.region_parameters[0]->material;
      front.moduli.youngs_modulus             = 3;
      MaterialParameters<dim> &back           = parameters.region_parameters[1]->material;
      back.material.set_name("St. Venant-Kirchhoff");
      back.moduli.shear_modulus = 2;
      body         = std::make_unique<SolidBody<dim>>(parameters, Surroundings{1., 0.1});
      elastic_load = make_elastic_load(*body);
    }

    Vector<double> map(const std::function<Tensor<1, dim>(const Tensor<1, dim> &)> &mapping) const
    {
      Vector<double> x(body->n_dofs());
      for (const auto &node : body->get_nodes())
      {
        const Tensor<1, dim> old = get_value(body->get_initial_positions(), node);
        set_value(x, node, mapping(old));
      }
      return x;
    }

    /** The sum of the forces on all nodes, and their moments about the origin. */
    std::pair<double, double> get_resultant(const Vector<double> &force,
                                            const Vector<double> &x) const
    {
      Tensor<1, dim> total;
      Tensor<2, dim> moment;
      for (const auto &node : body->get_nodes())
        for (unsigned int d = 0; d < dim; ++d)
        {
          total[d] += force[node[d]];
          for (unsigned int e = 0; e < dim; ++e)
            moment[d][e] += x[node[d]] * force[node[e]] - x[node[e]] * force[node[d]];
        }
      return {total.norm(), moment.norm()};
    }

    SolidParameters<dim>            parameters;
    std::unique_ptr<SolidBody<dim>> body;
    std::unique_ptr<Load<dim>>      elastic_load;
  };

  template <int dim>
  Tensor<2, dim> make_rotation()
  {
    Tensor<2, dim> rotation = unit_symmetric_tensor<dim>();
    rotation[0][0] = rotation[1][1] = std::cos(2.);
    rotation[0][1]                  = -std::sin(2.);
    rotation[1][0]                  = std::sin(2.);
    return rotation;
  }

  template <int dim>
  void test_rigid_motion(Setup<dim> &setup)
  {
    const SolidBody<dim> &body     = *setup.body;
    const Tensor<2, dim>  rotation = make_rotation<dim>();
    const Vector<double>  x        = setup.map(
        [&](const Tensor<1, dim> &old) { return rotation * old + 3 * Point<dim>::unit_vector(0); });
    const auto summary = summarise_deformation(body, x);
    std::cout << "  rigid motion: elastic force "
              << in_units(1e-13, compute_force(*setup.elastic_load, x).linfty_norm()) << ", energy "
              << in_units(1e-14, summary.elastic_energy) << ", J " << summary.smallest_jacobian
              << " to " << summary.largest_jacobian << '\n';
    const auto fit = fit_rigid_motion(body, body.get_nodes(), body.get_initial_positions(), x);
    std::cout << "  error of the fitted rotation "
              << in_units(1e-13, (fit.rotation - rotation).norm()) << '\n';
  }

  template <int dim>
  void test_deformation(Setup<dim> &setup)
  {
    const SolidBody<dim> &body = *setup.body;
    const Vector<double>  x    = setup.map([](const Tensor<1, dim> &old) {
      Tensor<1, dim> place = 1.1 * old;
      for (unsigned int d = 0; d < dim; ++d)
        place[d] += 0.1 * std::sin(3 * old[(d + 1) % dim]);
      return place;
    });
    BodyResponse          response(body.get_sparsity_pattern());
    const auto            force                = compute_force(*setup.elastic_load, x, &response);
    const auto [elastic_force, elastic_moment] = setup.get_resultant(force, x);
    std::cout << "  elastic forces up to " << force.linfty_norm() << ", resultant "
              << in_units(1e-13, elastic_force) << ", moment " << in_units(1e-13, elastic_moment)
              << ", asymmetry of their derivatives "
              << in_units(1e-12, get_asymmetry(response.stiffness)) << '\n';

    // Active stress alone has no resultant; force density has that of int f.
    const TestMuscle<dim> contracting(false, true), pulling(true, false), both(true, true);
    const auto [active_force, active_moment] =
        setup.get_resultant(compute_force(*make_muscle_load(body, contracting), x), x);
    const double total_force =
        setup.get_resultant(compute_force(*make_muscle_load(body, pulling), x), x).first;
    std::cout << "  active stress: resultant " << in_units(1e-13, active_force) << ", moment "
              << in_units(1e-13, active_moment) << "; resultant of the force density "
              << total_force << '\n';

    const auto load = make_muscle_load(body, both);
    compute_force(*load, x, &response);
    Vector<double> direction(body.n_dofs()), tangent(body.n_dofs()), differences(body.n_dofs());
    for (unsigned int i = 0; i < direction.size(); ++i)
      direction[i] = std::sin(1 + i);
    response.stiffness.vmult(tangent, direction);
    const double step = 3e-6;
    for (const int sign : {1, -1})
    {
      Vector<double> y(x);
      y.add(sign * step, direction);
      differences.add(-sign / (2 * step), compute_force(*setup.elastic_load, y), -sign / (2 * step),
                      compute_force(*load, y));
    }
    differences -= tangent;
    std::cout << "  tangent " << tangent.l2_norm() << ", off the differences by "
              << in_units(1e-7, differences.l2_norm() / tangent.l2_norm()) << '\n';
  }

  /** On the far end of the beam, which is turned: resultant and moment stay in the domain's frame.
   */
  template <int dim>
  void test_surface_load()
  {
    Setup<dim> setup;
    setup.parameters.traction = dim == 2 ? "if(x>0.999, 5*t, 0); 0" : "if(x>0.999, 5*t, 0); 0; 0";
    const SolidBody<dim> body(setup.parameters, Surroundings{1., 0.1});
    const Vector<double> force =
        compute_force(*make_surface_load(body), body.get_initial_positions());
    const double area              = dim == 2 ? 0.3 : 0.3 * 0.4;
    const auto [resultant, moment] = setup.get_resultant(force, body.get_initial_positions());
    // The middle of the end is at height sin(30 degrees); both orders of the product count.
    std::cout << "  surface load: force " << resultant / (10 * area) << ", moment "
              << moment / (std::sqrt(2.) * 10 * area) << '\n';
  }

  /** Springs and dampers on the far end of the beam, which is moved away from them. */
  template <int dim>
  void test_surface_springs()
  {
    Setup<dim> setup;
    setup.parameters.surface_spring = "if(x>0.999, 3, 0)";
    setup.parameters.surface_damper = "if(x>0.999, 5, 0)";
    const SolidBody<dim> body(setup.parameters, Surroundings{1., 0.1});
    const auto           load = make_feedback_load(body);
    Tensor<1, dim>       shift;
    shift[0]          = 0.2;
    shift[1]          = -0.1;
    const double area = dim == 2 ? 0.3 : 0.3 * 0.4;
    const auto   force =
        compute_force(*load, setup.map([&](const Tensor<1, dim> &old) { return old + shift; }));
    BodyResponse response(body.get_sparsity_pattern());
    compute_force(*load, body.get_initial_positions(), &response);
    Vector<double> uniform(body.n_dofs());
    for (const auto &node : body.get_nodes())
      set_value(uniform, node, shift);
    std::cout << "  surface springs: force "
              << setup.get_resultant(force, body.get_initial_positions()).first /
                     (3 * area * shift.norm())
              << ", energy "
              << response.stiffness.matrix_norm_square(uniform) / (3 * area * shift.norm_square())
              << ", damping "
              << response.damping.matrix_norm_square(uniform) / (5 * area * shift.norm_square())
              << '\n';
  }

  /** The stabilisation of the cells' volumes: its force, energy and stiffness alone. */
  template <int dim>
  void test_volume_stabilisation()
  {
    Setup<dim> setup;
    setup.parameters.traction = dim == 2 ? "0; 0" : "0; 0; 0";
    for (auto &region : setup.parameters.region_parameters)
    {
      region->cell_volume_stabilisation = "7";
      region->material.material.set_name("none");
      region->material.volumetric_stabilisation = 0;
    }
    const SolidBody<dim> body(setup.parameters, Surroundings{1., 0.1});
    const auto           load    = make_elastic_load(body);
    const auto           stretch = [&](const double factor) {
      return setup.map([&](const Tensor<1, dim> &old) {
        Tensor<1, dim> place = old;
        place[0] *= factor;
        place[1] += 0.1 * std::sin(3 * old[0]);
        return place;
      });
    };
    const double         J = 1.2, step = 1e-5;
    const Vector<double> x             = stretch(J);
    const Vector<double> elastic_force = compute_force(*load, x);
    const auto           summary       = summarise_deformation(body, x);
    const auto [force, moment]         = setup.get_resultant(elastic_force, x);
    Vector<double> direction           = stretch(J + step);
    direction -= stretch(J - step);
    const double slope = summarise_deformation(body, stretch(J + step)).elastic_energy -
                         summarise_deformation(body, stretch(J - step)).elastic_energy;
    std::cout << "  volumes of cells: energy over kappa/2 V (ln J)^2 "
              << summary.elastic_energy /
                     (3.5 * body.get_reference_volume() * std::pow(std::log(J), 2))
              << ", resultant " << in_units(1e-13, force) << ", moment " << in_units(1e-13, moment)
              << ", force off its slope by "
              << in_units(1e-9, (elastic_force * direction) / slope + 1) << '\n';

    // Their stiffness, which is whole in tension, in a body with a dead load.
    Vector<double> any(body.n_dofs());
    for (unsigned int i = 0; i < any.size(); ++i)
      any[i] = std::sin(1 + i * i);
    for (const double factor : {1.1, 1.2})
    {
      Vector<double> tangent(body.n_dofs()), differences(body.n_dofs());
      BodyResponse   response(body.get_sparsity_pattern());
      compute_force(*load, stretch(factor), &response);
      response.stiffness.vmult(tangent, any);
      for (const int sign : {1, -1})
      {
        Vector<double> y(stretch(factor));
        y.add(sign * step, any);
        differences.add(-sign / (2 * step), compute_force(*load, y));
      }
      differences -= tangent;
      std::cout << "  their stiffness at J = " << factor << ": " << tangent.l2_norm()
                << ", off the differences by "
                << in_units(1e-7, differences.l2_norm() / tangent.l2_norm()) << '\n';
    }
  }

  template <int dim>
  void test()
  {
    std::cout << dim << "D\n";
    Setup<dim> setup;
    test_rigid_motion(setup);
    test_deformation(setup);
    test_surface_load<dim>();
    test_surface_springs<dim>();
    test_volume_stabilisation<dim>();
    try
    {
      const Vector<double> x = setup.map([](const Tensor<1, dim> &old) {
        Tensor<1, dim> place = old;
        place[1] *= -1;
        return place;
      });
      compute_force(*setup.elastic_load, x);
    }
    catch (const ExcInvertedElement &)
    {
      std::cout << "  a mirrored body: an exception\n";
    }
  }
} // namespace

int main()
{
  std::cout << std::fixed << std::setprecision(6);
  test<2>();
  test<3>();
}
