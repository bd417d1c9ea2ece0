// The derivative of the fluid's energy with respect to the shape, by the adjoint equations.

#include <caudal/ideal/exterior_flow.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <cstring>

namespace caudal::ideal
{
  std::vector<double>
  ExteriorFlow::compute_energy_gradient(const std::vector<double>                    &u,
                                        const std::vector<std::vector<Tensor<1, 3>>> &mode_rates)
  {
    Timer               timer;
    std::vector<double> result(motion.modes.size(), 0.);
    const Tensor<1, 3>  omega = Point<3>(u[0], u[1], u[2]);
    for (const Equations &equations : systems)
    {
      // Flows of different symmetry have no energy in common, in symmetric shapes.
      if (std::all_of(equations.motions.begin(), equations.motions.end(),
                      [&](const unsigned int l) { return u[l] == 0.; }))
        continue;
      const NodalFlow     flow = combine(equations, u);
      const NodalGradient gradient =
          differentiate(equations, flow, compute_adjoint(equations, flow));
      const bool   has_modes = std::any_of(equations.motions.begin(), equations.motions.end(),
                                           [](const unsigned int l) { return l >= 6; });
      Tensor<1, 3> turn;
      for (const unsigned int l : equations.motions)
        if (l < 3)
          turn[l] = omega[l];
      for (unsigned int mode = 0; mode < result.size(); ++mode)
        for (unsigned int i = 0; i < surface.n_nodes(); ++i)
        {
          // Of X and of omega x X + v + sum_j c_j' dX/dc_j
          Tensor<1, 3> velocity = cross_product_3d(turn, motion.modes[mode][i]);
          if (has_modes)
            velocity += mode_rates[mode][i];
          result[mode] +=
              0.5 * (gradient.place[i] * motion.modes[mode][i] + gradient.velocity[i] * velocity);
        }
    }
    Utilities::MPI::sum(result, communicator, result);
    cost.gradient += timer.cpu_time();
    return result;
  }

  bool ExteriorFlow::interact(const Vector<double> &u, const Vector<double> &v) const
  {
    return std::any_of(systems.begin(), systems.end(), [&](const Equations &equations) {
      const auto moves = [&](const Vector<double> &motion) {
        return std::any_of(equations.motions.begin(), equations.motions.end(),
                           [&](const unsigned int l) { return motion(l) != 0.; });
      };
      return moves(u) && moves(v);
    });
  }

  ExteriorFlow::NodalFlow ExteriorFlow::combine(const Equations           &equations,
                                                const std::vector<double> &u) const
  {
    NodalFlow flow;
    flow.potential.assign(surface.n_nodes(), 0.);
    flow.velocity.resize(surface.n_nodes());
    for (const unsigned int l : equations.motions)
      for (unsigned int i = 0; i < surface.n_nodes(); ++i)
      {
        flow.potential[i] += u[l] * potentials.values(i, l);
        Tensor<1, 3> axis;
        axis[l % 3] = 1.;
        flow.velocity[i] +=
            u[l] * (l < 3   ? cross_product_3d(axis, Tensor<1, 3>(motion.positions[i]))
                    : l < 6 ? axis
                            : motion.modes[l - 6][i]);
      }
    return flow;
  }

  CellFlow ExteriorFlow::extract_cell(const NodalFlow &flow, const unsigned int cell) const
  {
    CellFlow result;
    std::memset(&result, 0, sizeof result);
    const auto &nodes = surface.get_nodes(cell);
    for (unsigned int k = 0; k < nodes.size(); ++k)
    {
      result.potential[k] = flow.potential[nodes[k]];
      for (unsigned int d = 0; d < 3; ++d)
        result.velocity[d][k] = flow.velocity[nodes[k]][d];
    }
    return result;
  }

  Vector<double> ExteriorFlow::compute_adjoint(const Equations &equations,
                                               const NodalFlow &flow) const
  {
    // f: the derivatives of int phi u.n dS with respect to phi at the nodes
    std::vector<double> by_potential(surface.n_nodes(), 0.);
    for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
    {
      const CellRule      &rule      = placed.get_regular(cell);
      const ReferenceRule &reference = rule.get_reference();
      const auto          &nodes     = surface.get_nodes(cell);
      for (unsigned int q = 0; q < reference.n_points; ++q)
      {
        const double *const values = &reference.values[q * reference.stride];
        Tensor<1, 3>        u;
        for (unsigned int k = 0; k < nodes.size(); ++k)
          u += values[k] * flow.velocity[nodes[k]];
        const double flux = u * rule.get_area(q);
        for (unsigned int k = 0; k < nodes.size(); ++k)
          by_potential[nodes[k]] += values[k] * flux;
      }
    }
    Vector<double> adjoint(equations.nodes.size());
    fold(equations, by_potential.data(), adjoint.begin());
    equations.matrix.solve(adjoint); // the transposed of what it holds is A
    return adjoint;
  }

  void ExteriorFlow::add_to_nodes(const unsigned int cell, const CellGradient &cell_gradient,
                                  NodalGradient &gradient) const
  {
    const auto &nodes = surface.get_nodes(cell);
    for (unsigned int k = 0; k < nodes.size(); ++k)
      for (unsigned int d = 0; d < 3; ++d)
      {
        gradient.place[nodes[k]][d] += cell_gradient.place[d][k];
        gradient.velocity[nodes[k]][d] += cell_gradient.velocity[d][k];
      }
  }

  /** All that the equations integrate over one cell; its rules fit into the cache. */
  void ExteriorFlow::add_cell(const Equations &equations, const unsigned int cell,
                              const NodalFlow &flow, const Vector<double> &adjoint,
                              NodalGradient &gradient)
  {
    const auto        &nodes     = surface.get_nodes(cell);
    const CellFlow     cell_flow = extract_cell(flow, cell);
    const unsigned int rank      = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int n_ranks   = Utilities::MPI::n_mpi_processes(communicator);
    CellGradient       sums;
    std::memset(&sums, 0, sizeof sums);
    const auto end = [&](PlacedRule &at) {
      if (!at.gradients.is_empty())
        at.gradients.end(at.rule, placed.get_positions(cell), cell_flow, sums);
    };
    for (unsigned int k = rank; k < equations.nodes.size(); k += n_ranks)
    {
      const auto node = equations.nodes[k];
      const auto add  = [&](PlacedRule &at) {
        if (at.gradients.is_empty())
          at.gradients.begin(at.rule, cell_flow);
        at.gradients.add(at.rule, motion.positions[node], adjoint(k), flow.potential[node],
                          gradient.place[node]);
      };
      const auto own = std::find(nodes.begin(), nodes.end(), node);
      if (own != nodes.end())
      {
        PlacedRule &singular = placed.get_singular(cell, own - nodes.begin());
        add(singular);
        end(singular);
      }
      else if (placed.is_far(cell, node))
        add(placed.get_regular(cell));
      else
        for (PlacedRule *const near : placed.find_near(cell, node))
          add(*near);
    }
    if (rank == 0)
    {
      // The explicit part, -df.phi
      PlacedRule &regular = placed.get_regular(cell);
      if (regular.gradients.is_empty())
        regular.gradients.begin(regular.rule, cell_flow);
      regular.gradients.add_energy(regular.rule, -1.);
    }
    placed.visit_rules(cell, end);
    add_to_nodes(cell, sums, gradient);
  }

  ExteriorFlow::NodalGradient ExteriorFlow::differentiate(const Equations      &equations,
                                                          const NodalFlow      &flow,
                                                          const Vector<double> &adjoint)
  {
    NodalGradient gradient;
    gradient.place.resize(surface.n_nodes());
    gradient.velocity.resize(surface.n_nodes());
    for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
      add_cell(equations, cell, flow, adjoint, gradient);
    return gradient;
  }
} // namespace caudal::ideal
