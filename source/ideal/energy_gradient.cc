// SPDX-License-Identifier: LGPL-2.1-or-later
// The derivative of the fluid's energy with respect to the shape, by the adjoint equations.

#include <caudal/ideal/exterior_flow.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <array>

namespace caudal::ideal
{
  namespace
  {
    /** Derivatives by the places y, elements N and fluxes w = u.N of the points of a rule. */
    struct PointGradient
    {
      ReferenceRule::Vectors by_y, by_N;
      ReferenceRule::Numbers by_w;
    };

    /**
     * Derivatives by the places of a cell's @p nodes and by their velocities, which are @p u at the
     * points: N = weight X_x x X_y, and w = u.N. Changes @p at_points.
     */
    CAUDAL_WIDE_VECTORS
    void hand_to_nodes(const PlacedRule &rule, const CellArray<Point<3>> &nodes,
                       const ReferenceRule::Vectors &u, PointGradient &at_points,
                       std::array<CellArray<double>, 3> &by_place,
                       std::array<CellArray<double>, 3> &by_velocity)
    {
      const ReferenceRule          &reference = rule.get_reference();
      const unsigned int            n         = rule.size();
      const ReferenceRule::Numbers &by_w      = at_points.by_w;
      const ReferenceRule::Vectors &by_y      = at_points.by_y;
      ReferenceRule::Vectors       &by_N      = at_points.by_N;
      ReferenceRule::Vectors        X_x, X_y;
      reference.interpolate(ReferenceRule::x_derivative, nodes, X_x);
      reference.interpolate(ReferenceRule::y_derivative, nodes, X_y);
      for (unsigned int d = 0; d < 3; ++d)
        for (unsigned int q = 0; q < n; ++q)
          by_N[d][q] = reference.get_weights()[q] * (by_N[d][q] + by_w[q] * u[d][q]);
      for (unsigned int d = 0; d < 3; ++d)
      {
        const unsigned int     e = (d + 1) % 3, f = (d + 2) % 3;
        const double *const    N = rule.get_areas(d);
        ReferenceRule::Numbers by_X_x, by_X_y, by_u;
#pragma omp simd
        for (unsigned int q = 0; q < n; ++q)
        {
          by_X_x[q] = X_y[e][q] * by_N[f][q] - X_y[f][q] * by_N[e][q];
          by_X_y[q] = by_N[e][q] * X_x[f][q] - by_N[f][q] * X_x[e][q];
          by_u[q]   = by_w[q] * N[q];
        }
        reference.add_sums(ReferenceRule::value, by_y[d], by_place[d]);
        reference.add_sums(ReferenceRule::x_derivative, by_X_x, by_place[d]);
        reference.add_sums(ReferenceRule::y_derivative, by_X_y, by_place[d]);
        reference.add_sums(ReferenceRule::value, by_u, by_velocity[d]);
      }
    }
  } // namespace

  std::vector<double>
  ExteriorFlow::compute_energy_gradient(const std::vector<double>                    &u,
                                        const std::vector<std::vector<Tensor<1, 3>>> &mode_rates)
  {
    Timer               timer;
    std::vector<double> gradient(motion.modes.size(), 0.);
    for (const double sign : {1., -1.})
    {
      // Flows of different symmetry have no energy in common, in symmetric shapes.
      const Vector<double> part = extract_part(Vector<double>(u.begin(), u.end()), sign);
      if (part.all_zero())
        continue;
      const NodalGradient by_nodes = differentiate_energy(part);
      const Tensor<1, 3>  omega({part(0), part(1), part(2)});
      for (unsigned int mode = 0; mode < gradient.size(); ++mode)
        for (unsigned int i = 0; i < surface.n_nodes(); ++i)
        {
          // How X and omega x X + v + sum_j c_j' dX/dc_j depend on c_i
          Tensor<1, 3> velocity = cross_product_3d(omega, motion.modes[mode][i]);
          if (sign > 0.)
            velocity += mode_rates[mode][i];
          gradient[mode] +=
              0.5 * (by_nodes.place[i] * motion.modes[mode][i] + by_nodes.velocity[i] * velocity);
        }
    }
    Utilities::MPI::sum(gradient, communicator, gradient);
    cost.gradient += timer.cpu_time();
    return gradient;
  }

  bool ExteriorFlow::interact(const Vector<double> &u, const Vector<double> &v) const
  {
    const auto interact_by = [&](const double sign) {
      return !extract_part(u, sign).all_zero() && !extract_part(v, sign).all_zero();
    };
    return interact_by(1.) || interact_by(-1.);
  }

  /** This rank's part, for motions @p u of one symmetry. */
  ExteriorFlow::NodalGradient ExteriorFlow::differentiate_energy(const Vector<double> &u)
  {
    const unsigned int n = surface.n_nodes();
    NodalFlow          flow{Vector<double>(n), std::vector<Tensor<1, 3>>(n)};
    Vector<double>     adjoint(n); // at first f, derivatives of int phi u.n dS by phi at the nodes
    potentials.values.vmult(flow.potential, u);
    fluxes.vmult(adjoint, u);
    matrix.solve(adjoint, /*transposed*/ true);
    for (unsigned int l = 0; l < u.size(); ++l)
      for (unsigned int i = 0; i < n; ++i)
        flow.velocity[i] += u(l) * velocities[l][i];
    // In symmetric flows the equations of both halves contribute the same.
    for (unsigned int i = 0; i < n; ++i)
      if (images[i] != i)
        adjoint(i) *= 2.;

    NodalGradient gradient;
    gradient.place.resize(n);
    gradient.velocity.resize(n);
    const std::vector<unsigned int> own_nodes = get_own_nodes();
    for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
    {
      std::vector<std::vector<unsigned int>> observers(1); // nodes by the rules they use
      for (const unsigned int node : own_nodes)
        for (const unsigned int rule : placed.find_rules(cell, node))
        {
          observers.resize(std::max<std::size_t>(observers.size(), rule + 1));
          observers[rule].push_back(node);
        }
      for (unsigned int rule = 0; rule < observers.size(); ++rule)
        differentiate_rule(cell, rule, observers[rule], flow, adjoint, gradient);
    }
    return gradient;
  }

  /**
   * Derivatives of the sum over nodes x of lambda_x times the residual of their equation,
   *   R_x = phi_x + int ((phi_y - phi_x) (y - x).N/(4 pi |y - x|^3) + u.N/(4 pi |y - x|)),
   * minus int phi u.N: what one rule adds for the nodes that use it, through the places y,
   * elements N and fluxes w = u.N of its points.
   */
  CAUDAL_WIDE_VECTORS
  void ExteriorFlow::differentiate_rule(const unsigned int cell, const unsigned int number,
                                        const std::vector<unsigned int> &observers,
                                        const NodalFlow &flow, const Vector<double> &adjoint,
                                        NodalGradient &gradient) const
  {
    const PlacedRule      &rule      = placed.get_rule(cell, number);
    const ReferenceRule   &reference = rule.get_reference();
    const auto            &nodes     = surface.get_nodes(cell);
    const unsigned int     n         = rule.size();
    ReferenceRule::Numbers phi;
    ReferenceRule::Vectors u;
    reference.interpolate(ReferenceRule::value, extract_cell(flow.potential, nodes), phi.data());
    reference.interpolate(ReferenceRule::value, extract_cell(flow.velocity, nodes), u);
    const ReferenceRule::Numbers w = rule.compute_fluxes(u);

    const bool has_energy =
        number == PlacedSurface::regular && Utilities::MPI::this_mpi_process(communicator) == 0;
    PointGradient           at_points;
    ReferenceRule::Numbers &by_w = at_points.by_w;
    ReferenceRule::Vectors &by_y = at_points.by_y, &by_N = at_points.by_N;
    for (unsigned int q = 0; q < n; ++q)
    {
      by_w[q] = has_energy ? -phi[q] : 0.;
      for (unsigned int d = 0; d < 3; ++d)
        by_y[d][q] = by_N[d][q] = 0.;
    }
    const double *const y_0 = rule.get_points(0), *const y_1 = rule.get_points(1),
                        *const y_2 = rule.get_points(2);
    const double *const N_0 = rule.get_areas(0), *const N_1 = rule.get_areas(1),
                        *const N_2 = rule.get_areas(2);
    for (const unsigned int node : observers)
    {
      const Point<3>        &x      = motion.positions[node];
      const double           lambda = adjoint(node), phi_x = flow.potential(node);
      ReferenceRule::Vectors by_r;
#pragma omp simd
      for (unsigned int q = 0; q < n; ++q)
      {
        const double        r_0 = y_0[q] - x[0], r_1 = y_1[q] - x[1], r_2 = y_2[q] - x[2];
        const LaplaceKernel kernel = evaluate_laplace_kernel(r_0, r_1, r_2, N_0[q], N_1[q], N_2[q]);
        const double        inverse = 1. / (r_0 * r_0 + r_1 * r_1 + r_2 * r_2);
        const double        jump    = lambda * (phi[q] - phi_x);
        const double        along_N = jump * kernel.single_layer * inverse;
        const double        along_r =
            inverse * (3. * jump * kernel.double_layer - lambda * w[q] * kernel.single_layer);
        by_y[0][q] += by_r[0][q] = along_N * N_0[q] + along_r * r_0;
        by_y[1][q] += by_r[1][q] = along_N * N_1[q] + along_r * r_1;
        by_y[2][q] += by_r[2][q] = along_N * N_2[q] + along_r * r_2;
        by_N[0][q] += along_N * r_0;
        by_N[1][q] += along_N * r_1;
        by_N[2][q] += along_N * r_2;
        by_w[q] += lambda * kernel.single_layer;
      }
      for (unsigned int q = 0; q < n; ++q)
        for (unsigned int d = 0; d < 3; ++d)
          gradient.place[node][d] -= by_r[d][q];
    }

    std::array<CellArray<double>, 3> by_place{}, by_velocity{};
    hand_to_nodes(rule, placed.get_nodes(cell), u, at_points, by_place, by_velocity);
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        gradient.place[nodes[k]][d] += by_place[d][k];
        gradient.velocity[nodes[k]][d] += by_velocity[d][k];
      }
  }
} // namespace caudal::ideal
