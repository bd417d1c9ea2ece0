// The derivative of the fluid's energy with respect to the shape, by the adjoint equations.

#include <caudal/ideal/exterior_flow.h>
#include <caudal/ideal/laplace_kernel.h>

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
    for (const Equations &equations : systems)
    {
      // Flows of different symmetry have no energy in common, in symmetric shapes.
      std::vector<double> part(u.size(), 0.);
      for (const unsigned int l : equations.motions)
        part[l] = u[l];
      if (part == std::vector<double>(u.size(), 0.))
        continue;
      const auto of_part = compute_energy_gradient(equations, part, mode_rates);
      for (unsigned int mode = 0; mode < gradient.size(); ++mode)
        gradient[mode] += of_part[mode];
    }
    Utilities::MPI::sum(gradient, communicator, gradient);
    cost.gradient += timer.cpu_time();
    return gradient;
  }

  bool ExteriorFlow::interact(const Vector<double> &u, const Vector<double> &v) const
  {
    return std::any_of(systems.begin(), systems.end(), [&](const Equations &equations) {
      const auto moves = [&](const Vector<double> &rates) {
        return std::any_of(equations.motions.begin(), equations.motions.end(),
                           [&](const unsigned int l) { return rates(l) != 0.; });
      };
      return moves(u) && moves(v);
    });
  }

  /** This rank's part, for motions that have the symmetry of the equations. */
  std::vector<double>
  ExteriorFlow::compute_energy_gradient(const Equations &equations, const std::vector<double> &u,
                                        const std::vector<std::vector<Tensor<1, 3>>> &mode_rates)
  {
    const unsigned int   n = surface.n_nodes();
    const Vector<double> rates(u.begin(), u.end());
    NodalFlow            flow{Vector<double>(n), std::vector<Tensor<1, 3>>(n)};
    Vector<double>       f(n); // by the potential at the nodes: derivatives of int phi u.n dS
    potentials.values.vmult(flow.potential, rates);
    fluxes.vmult(f, rates);
    for (const unsigned int l : equations.motions)
      for (unsigned int i = 0; i < n; ++i)
        flow.velocity[i] += u[l] * velocities[l][i];

    Vector<double> adjoint = fold(equations, f);
    equations.matrix.solve(adjoint, /*transposed*/ true);
    const NodalGradient by_nodes = differentiate(equations, flow, adjoint);

    const Tensor<1, 3> omega({u[0], u[1], u[2]});
    const bool has_modes = std::any_of(u.begin() + 6, u.end(), [](double c) { return c != 0.; });
    std::vector<double> gradient(motion.modes.size(), 0.);
    for (unsigned int mode = 0; mode < gradient.size(); ++mode)
      for (unsigned int i = 0; i < n; ++i)
      {
        // Of X and of omega x X + v + sum_j c_j' dX/dc_j
        Tensor<1, 3> velocity = cross_product_3d(omega, motion.modes[mode][i]);
        if (has_modes)
          velocity += mode_rates[mode][i];
        gradient[mode] +=
            0.5 * (by_nodes.place[i] * motion.modes[mode][i] + by_nodes.velocity[i] * velocity);
      }
    return gradient;
  }

  /**
   * Derivatives of the sum over nodes x of lambda_x times the residual of their equation,
   *   R_x = phi_x + int ((phi_y - phi_x) (y - x).N/(4 pi |y - x|^3) + u.N/(4 pi |y - x|)),
   * minus int phi u.N: this rank's part.
   */
  ExteriorFlow::NodalGradient ExteriorFlow::differentiate(const Equations      &equations,
                                                          const NodalFlow      &flow,
                                                          const Vector<double> &adjoint)
  {
    const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    NodalGradient      gradient;
    gradient.place.resize(surface.n_nodes());
    gradient.velocity.resize(surface.n_nodes());
    for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
    {
      std::vector<std::vector<unsigned int>> observers(1); // equations by the rules they use
      for (unsigned int k = rank; k < equations.nodes.size(); k += n_ranks)
        for (const unsigned int rule : placed.find_rules(cell, equations.nodes[k]))
        {
          observers.resize(std::max<std::size_t>(observers.size(), rule + 1));
          observers[rule].push_back(k);
        }
      for (unsigned int rule = 0; rule < observers.size(); ++rule)
        differentiate_rule(equations, cell, rule, observers[rule], flow, adjoint, gradient);
    }
    return gradient;
  }

  /** What one rule has to add, through places y, elements N and fluxes w = u.N of its points. */
  void ExteriorFlow::differentiate_rule(const Equations &equations, const unsigned int cell,
                                        const unsigned int               number,
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
      for (const unsigned int k : observers)
      {
        const auto          node    = equations.nodes[k];
        const double        lambda  = adjoint(k);
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
