// SPDX-License-Identifier: LGPL-2.1-or-later
// The derivative of the fluid's energy with respect to the shape, by the adjoint equations.

#include <caudal/ideal/exterior_flow.h>

#include <deal.II/base/timer.h>

#include <algorithm>

namespace caudal::ideal
{
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
  void ExteriorFlow::differentiate_rule(const unsigned int cell, const unsigned int number,
                                        const std::vector<unsigned int> &observers,
                                        const NodalFlow &flow, const Vector<double> &adjoint,
                                        NodalGradient &gradient) const
  {
    const PlacedRule &rule  = placed.get_rule(cell, number);
    const auto       &nodes = surface.get_nodes(cell);
    const bool        has_energy =
        number == PlacedSurface::regular && Utilities::MPI::this_mpi_process(communicator) == 0;
    for (unsigned int q = 0; q < rule.points.size(); ++q)
    {
      const Point<3>     &y   = rule.points[q];
      const Tensor<1, 3> &N   = rule.areas[q];
      const auto         &N_k = rule.reference->values[q];
      double              phi = 0.;
      Tensor<1, 3>        u;
      for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        phi += N_k[k] * flow.potential(nodes[k]);
        u += N_k[k] * flow.velocity[nodes[k]];
      }
      const double w    = u * N;
      double       by_w = has_energy ? -phi : 0.;
      Tensor<1, 3> by_y, by_N;
      for (const unsigned int node : observers)
      {
        const double        lambda  = adjoint(node);
        const Tensor<1, 3>  r       = y - motion.positions[node];
        const LaplaceKernel kernel  = evaluate_laplace_kernel(r, N);
        const double        inverse = 1. / r.norm_square();
        const double        jump    = lambda * (phi - flow.potential(node));
        const double        along_N = jump * kernel.single_layer * inverse;
        const double        along_r =
            inverse * (3. * jump * kernel.double_layer - lambda * w * kernel.single_layer);
        const Tensor<1, 3> by_r = along_N * N + along_r * r;
        by_y += by_r;
        gradient.place[node] -= by_r;
        by_N += along_N * r;
        by_w += lambda * kernel.single_layer;
      }
      // N = weight X_x x X_y, and w = u.N
      by_N                      = rule.reference->weights[q] * (by_N + by_w * u);
      const auto [X_x, X_y]     = rule.compute_tangents(placed.get_nodes(cell), q);
      const Tensor<1, 3> by_X_x = cross_product_3d(X_y, by_N);
      const Tensor<1, 3> by_X_y = cross_product_3d(by_N, X_x);
      for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const Tensor<1, 2> &gradient_k = rule.reference->gradients[q][k];
        gradient.place[nodes[k]] += N_k[k] * by_y + gradient_k[0] * by_X_x + gradient_k[1] * by_X_y;
        gradient.velocity[nodes[k]] += N_k[k] * by_w * N;
      }
    }
  }
} // namespace caudal::ideal
