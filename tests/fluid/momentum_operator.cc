// SPDX-License-Identifier: LGPL-2.1-or-later
// The operators of the momentum and continuity equations against their weak forms, which FEValues
// integrates here term by term: residual, matrix, divergence, stabilisation. Grid with hanging
// nodes, walls, inflow, an outflow with backflow.

#include <caudal/fluid/fluid_state.h>
#include <caudal/fluid/momentum_operator.h>

#include "../round_off.h"

#include <deal.II/base/function_parser.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/numerics/vector_tools.h>

#include <iomanip>
#include <iostream>

namespace
{
  using namespace caudal;

  const FEValuesExtractors::Vector velocities(0);

  /** Smooth fields that no symmetry makes special. */
  const std::vector<std::string> fields[] = {
      {"sin(2*x+y)+0.3", "cos(3*x-y)", "x*y+z"},
      {"0.5-y+x^2", "sin(4*y)*x", "cos(2*z)-x"},
      {"(y-0.4)*3", "x-0.5*y",
       "sin(z+x)"}, // enters at some places of the outflow, leaves at others
      {"cos(x)*y", "0.2+x*x", "y-z^2"}};

  /** The part of a function of a cell that the linear functions don't represent, at all points. */
  template <int dim>
  std::vector<Tensor<1, dim>> subtract_projection(const FEValues<dim>               &linear,
                                                  const std::vector<Tensor<1, dim>> &function)
  {
    const unsigned int          n = linear.dofs_per_cell;
    FullMatrix<double>          mass(n, n);
    std::vector<Vector<double>> moments(dim, Vector<double>(n));
    std::vector<Tensor<1, dim>> rest(function);
    const std::vector<double>  &weights = linear.get_JxW_values();
    for (unsigned int q = 0; q < weights.size(); ++q)
      for (unsigned int k = 0; k < n; ++k)
      {
        for (unsigned int l = 0; l < n; ++l)
          mass(k, l) += weights[q] * linear.shape_value(k, q) * linear.shape_value(l, q);
        for (unsigned int d = 0; d < dim; ++d)
          moments[d][k] += weights[q] * linear.shape_value(k, q) * function[q][d];
      }
    mass.gauss_jordan();
    Vector<double> coefficients(n);
    for (unsigned int d = 0; d < dim; ++d)
    {
      mass.vmult(coefficients, moments[d]);
      for (unsigned int q = 0; q < weights.size(); ++q)
        for (unsigned int k = 0; k < n; ++k)
          rest[q][d] -= coefficients[k] * linear.shape_value(k, q);
    }
    return rest;
  }

  template <int dim>
  double integrate(const std::vector<double> &weights, const std::vector<Tensor<1, dim>> &a,
                   const std::vector<Tensor<1, dim>> &b)
  {
    double sum = 0;
    for (unsigned int q = 0; q < weights.size(); ++q)
      sum += weights[q] * (a[q] * b[q]);
    return sum;
  }

  /** The weak forms on one cell after another, by FEValues. */
  template <int dim>
  class WeakForms
  {
  public:
    explicit WeakForms(const FluidSpace<dim> &space)
        : space(space)
        , flow(space.velocity_element, QGauss<dim>(3),
               update_values | update_gradients | update_JxW_values | update_quadrature_points)
        , linear(space.pressure_element, QGauss<dim>(3), update_values | update_JxW_values)
        , nodes(space.velocity_element,
                Quadrature<dim>(space.velocity_element.get_unit_support_points()), update_values)
        , face(space.velocity_element, QGauss<dim - 1>(3),
               update_values | update_JxW_values | update_normal_vectors)
    {}

    /** result += the loads of the forms that @p add adds for each test function of each cell. */
    template <typename Add>
    void add_for_cells(FieldVector &result, const Add &add)
    {
      std::vector<types::global_dof_index> dofs(space.velocity_element.n_dofs_per_cell());
      Vector<double>                       loads(dofs.size());
      for (const auto &cell : space.velocity_dofs.active_cell_iterators())
        if (cell->is_locally_owned())
        {
          reinit(cell);
          loads = 0;
          add(loads);
          cell->get_dof_indices(dofs);
          space.get_homogeneous_constraints().distribute_local_to_global(loads, dofs, result);
        }
      result.compress(VectorOperation::add);
    }

    void reinit(const typename DoFHandler<dim>::active_cell_iterator &cell)
    {
      this->cell = cell;
      flow.reinit(cell);
      nodes.reinit(cell);
      linear.reinit(typename DoFHandler<dim>::active_cell_iterator(*cell, &space.pressure_dofs));
    }

    /** a (u, v) + mu (grad u, grad v) + ... for all v, times @p factor */
    void add_constant_terms(const MomentumWeights &weights, const FieldVector &u,
                            const double factor, Vector<double> &loads)
    {
      std::vector<Tensor<1, dim>> values(flow.n_quadrature_points);
      std::vector<Tensor<2, dim>> gradients(values.size());
      flow[velocities].get_function_values(u, values);
      flow[velocities].get_function_gradients(u, gradients);
      const std::vector<double> &w = flow.get_JxW_values();

      // The divergence in the first component; what its linear part leaves is taken from it.
      std::vector<Tensor<1, dim>> divergences(values.size());
      for (unsigned int q = 0; q < values.size(); ++q)
        divergences[q][0] = trace(gradients[q]);
      const auto rest = subtract_projection(linear, divergences);
      for (unsigned int i = 0; i < loads.size(); ++i)
        for (unsigned int q = 0; q < values.size(); ++q)
        {
          const double divergence = flow[velocities].divergence(i, q);
          loads[i] +=
              factor * w[q] *
              (weights.inertia * (values[q] * flow[velocities].value(i, q)) +
               weights.viscosity * scalar_product(gradients[q], flow[velocities].gradient(i, q)) +
               weights.grad_div * divergences[q][0] * divergence +
               weights.augmentation * (divergences[q][0] - rest[q][0]) * divergence);
        }
    }

    /** Convection of @p u by @p transport with its stabilisation and the terms of the outflow. */
    void add_convection(const FieldVector &u, const FieldVector &transport, const double rate,
                        const double factor, Vector<double> &loads)
    {
      const double                rho = space.get_parameters().density;
      std::vector<Tensor<1, dim>> t(flow.n_quadrature_points), values(t), along(t);
      std::vector<Tensor<2, dim>> gradients(t.size());
      flow[velocities].get_function_values(transport, t);
      flow[velocities].get_function_values(u, values);
      flow[velocities].get_function_gradients(u, gradients);
      for (unsigned int q = 0; q < t.size(); ++q)
        along[q] = gradients[q] * t[q];
      const auto                 rest = subtract_projection(linear, along);
      const double               tau  = get_stabilisation_weight(transport, rate);
      const std::vector<double> &w    = flow.get_JxW_values();
      for (unsigned int i = 0; i < loads.size(); ++i)
      {
        std::vector<Tensor<1, dim>> test(t.size()), test_along(t.size());
        for (unsigned int q = 0; q < t.size(); ++q)
        {
          test[q]       = flow[velocities].value(i, q);
          test_along[q] = flow[velocities].gradient(i, q) * t[q];
        }
        loads[i] += factor * (0.5 * rho * integrate(w, along, test) -
                              0.5 * rho * integrate(w, values, test_along) +
                              tau * integrate(w, rest, subtract_projection(linear, test_along)));
      }
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == 1) // the outflow
          add_outflow(f, u, transport, factor * 0.5 * rho, loads);
    }

    /** (p, div v) + (f, v) */
    void add_pressure_and_force(const FieldVector &pressure, const Function<dim> &force,
                                Vector<double> &loads)
    {
      std::vector<double> p(flow.n_quadrature_points);
      linear.get_function_values(pressure, p);
      for (unsigned int i = 0; i < loads.size(); ++i)
      {
        const unsigned int d = space.velocity_element.system_to_component_index(i).first;
        for (unsigned int q = 0; q < p.size(); ++q)
          loads[i] +=
              flow.JxW(q) * (p[q] * flow[velocities].divergence(i, q) +
                             force.value(flow.quadrature_point(q), d) * flow.shape_value(i, q));
      }
    }

    /** (psi, div u) for the linear functions of the cell. */
    Vector<double> get_divergence(const FieldVector &u)
    {
      std::vector<double> divergences(flow.n_quadrature_points);
      flow[velocities].get_function_divergences(u, divergences);
      Vector<double> moments(linear.dofs_per_cell);
      for (unsigned int k = 0; k < moments.size(); ++k)
        for (unsigned int q = 0; q < divergences.size(); ++q)
          moments[k] += flow.JxW(q) * linear.shape_value(k, q) * divergences[q];
      return moments;
    }

    /** tau |k(u.grad u)|^2 of the cell */
    double compute_dissipation(const FieldVector &u, const double rate)
    {
      std::vector<Tensor<1, dim>> values(flow.n_quadrature_points), along(values);
      std::vector<Tensor<2, dim>> gradients(values.size());
      flow[velocities].get_function_values(u, values);
      flow[velocities].get_function_gradients(u, gradients);
      for (unsigned int q = 0; q < values.size(); ++q)
        along[q] = gradients[q] * values[q];
      const auto rest = subtract_projection(linear, along);
      return get_stabilisation_weight(u, rate) * integrate(flow.get_JxW_values(), rest, rest);
    }

  private:
    const FluidSpace<dim>                         &space;
    FEValues<dim>                                  flow, linear, nodes;
    FEFaceValues<dim>                              face;
    typename DoFHandler<dim>::active_cell_iterator cell;

    double get_stabilisation_weight(const FieldVector &transport, const double rate)
    {
      std::vector<Tensor<1, dim>> at_nodes(nodes.n_quadrature_points);
      nodes[velocities].get_function_values(transport, at_nodes);
      double fastest = 0;
      for (const Tensor<1, dim> &w : at_nodes)
        fastest = std::max(fastest, w.norm());
      const double h = cell->diameter() / std::sqrt(dim);
      return space.get_parameters().density * space.get_parameters().convection_stabilisation *
             std::min(h / fastest, 1 / rate);
    }

    /** Only where the flow leaves: the stabilisation of backflow. */
    void add_outflow(const unsigned int f, const FieldVector &u, const FieldVector &transport,
                     const double factor, Vector<double> &loads)
    {
      face.reinit(cell, f);
      std::vector<Tensor<1, dim>> t(face.n_quadrature_points), values(t);
      face[velocities].get_function_values(transport, t);
      face[velocities].get_function_values(u, values);
      for (unsigned int i = 0; i < loads.size(); ++i)
        for (unsigned int q = 0; q < t.size(); ++q)
          loads[i] += factor * face.JxW(q) * std::max(t[q] * face.normal_vector(q), 0.) *
                      (values[q] * face[velocities].value(i, q));
    }
  };

  template <int dim>
  FluidParameters<dim> read_parameters()
  {
    FluidParameters<dim> parameters;
    ParameterHandler     prm;
    parameters.add_parameters(prm);
    prm.parse_input_from_string("subsection Fluid\n"
                                "  set Density                  = 2\n"
                                "  set Kinematic viscosity      = 0.3\n"
                                "  set Convection stabilisation = 0.2\n"
                                "  set Body force = " +
                                std::string(dim == 2 ? "t*x*y; 1-x^2" : "t*x*y; 1-x^2; z*y") +
                                "\n"
                                "  subsection Boundary conditions\n"
                                "    set left  = inflow\n"
                                "    set right = outflow\n"
                                "    set top   = free slip\n"
                                "  end\n"
                                "end\n");
    return parameters;
  }

  /** The nodal values of one of the fields. */
  template <int dim>
  FieldVector make_field(const FluidSpace<dim> &space, const unsigned int field)
  {
    FunctionParser<dim> function(dim);
    std::string         text;
    for (unsigned int d = 0; d < dim; ++d)
      text += (d == 0 ? "" : ";") + fields[field][d];
    if (dim == 2)
      std::replace(text.begin(), text.end(), 'z', '1');
    function.initialize(FunctionParser<dim>::default_variable_names(), text, {});
    FieldVector result = space.make_velocity_vector();
    VectorTools::interpolate(space.velocity_dofs, function, result);
    space.get_homogeneous_constraints().distribute(result);
    result.update_ghost_values();
    return result;
  }

  void print(const std::string &name, const double value, const double by_fe_values,
             const double difference)
  {
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << "  " << name << ": " << std::fixed << std::setprecision(7) << value
                << ", by FEValues " << by_fe_values << ", largest difference "
                << in_units(1e-10, difference) << '\n';
  }

  void compare(const std::string &name, const FieldVector &value, const FieldVector &by_fe_values)
  {
    FieldVector difference(value);
    difference -= by_fe_values;
    print(name, value.l2_norm(), by_fe_values.l2_norm(), difference.linfty_norm());
  }

  template <int dim>
  void test()
  {
    DomainParameters<dim> domain;
    for (unsigned int d = 0; d < dim; ++d)
      domain.size[d] = 1 + 0.2 * d;
    domain.cells                                         = std::vector<unsigned int>(dim, 2);
    domain.levels                                        = 3;
    const FluidParameters<dim>                parameters = read_parameters<dim>();
    parallel::distributed::Triangulation<dim> triangulation(MPI_COMM_WORLD);
    make_domain(triangulation, domain);
    for (unsigned int level = 1; level < domain.levels; ++level)
    {
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && cell->center()[0] > 0.6 && cell->center()[1] < 0.6)
          cell->set_refine_flag();
      triangulation.execute_coarsening_and_refinement();
    }
    FluidSpace<dim> space(triangulation, domain, parameters, /*grad_div=*/1);
    space.reinit();
    MomentumOperator<dim> momentum(space);
    momentum.reinit();
    WeakForms<dim> forms(space);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << dim << "D\n";

    const FieldVector u = make_field(space, 0), old = make_field(space, 1),
                      transport = make_field(space, 2), x = make_field(space, 3);
    FieldVector pressure = space.make_pressure_vector();
    for (const auto &cell : space.pressure_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        std::vector<types::global_dof_index> dofs(space.pressure_element.n_dofs_per_cell());
        cell->get_dof_indices(dofs);
        for (unsigned int k = 0; k < dofs.size(); ++k)
          pressure[dofs[k]] = std::sin(3 * cell->center()[0] + cell->center()[1] + k);
      }
    pressure.update_ghost_values();

    // With all of its terms, as a step of BDF2 has them
    MomentumStep step;
    step.weights               = {30, 0.6, 0.7, 40};
    step.transport             = &transport;
    step.inertia_history       = &old;
    step.old_velocity          = &u;
    step.old_weights           = {0, 0.2, 0.3, 0};
    step.old_convection        = {{&old, 1.5}, {&u, -0.5}};
    step.instant.time          = 2;
    const FieldVector residual = momentum.assemble(step, u, pressure);

    FunctionParser<dim> force(dim);
    force.initialize(FunctionParser<dim>::default_variable_names() + ",t", parameters.body_force,
                     {}, true);
    force.set_time(step.instant.time);
    const double rate     = step.weights.inertia / parameters.density;
    FieldVector  expected = space.make_velocity_vector();
    forms.add_for_cells(expected, [&](Vector<double> &loads) {
      forms.add_constant_terms(step.weights, u, -1, loads);
      forms.add_convection(u, transport, rate, -1, loads);
      forms.add_constant_terms({1, 0, 0, 0}, old, -1, loads);
      forms.add_constant_terms(step.old_weights, u, -1, loads);
      forms.add_convection(old, old, rate, -1.5, loads);
      forms.add_convection(u, u, rate, 0.5, loads);
      forms.add_pressure_and_force(pressure, force, loads);
    });
    compare("residual", residual, expected);

    FieldVector product = space.make_velocity_vector();
    FieldVector source(x);
    momentum.get_matrix().vmult(product, source);
    space.get_homogeneous_constraints().set_zero(product);
    expected = 0;
    forms.add_for_cells(expected, [&](Vector<double> &loads) {
      forms.add_constant_terms(step.weights, x, 1, loads);
      forms.add_convection(x, transport, rate, 1, loads);
    });
    compare("matrix times a velocity", product, expected);

    FieldVector expected_divergence = space.make_pressure_vector();
    double      dissipation         = 0;
    for (const auto &cell : space.velocity_dofs.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        forms.reinit(cell);
        typename DoFHandler<dim>::active_cell_iterator(*cell, &space.pressure_dofs)
            ->set_dof_values(forms.get_divergence(x), expected_divergence);
        dissipation += forms.compute_dissipation(u, rate);
      }
    compare("divergence", momentum.compute_divergence(x), expected_divergence);
    dissipation        = Utilities::MPI::sum(dissipation, MPI_COMM_WORLD);
    const double value = compute_stabilisation_dissipation(space, u, rate);
    print("dissipation of the stabilisation", 100 * value, 100 * dissipation,
          std::abs(value - dissipation));
  }
} // namespace

int main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
