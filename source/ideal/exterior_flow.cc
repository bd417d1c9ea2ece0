#include <caudal/ideal/exterior_flow.h>
#include <caudal/ideal/laplace_kernel.h>

#include <deal.II/base/timer.h>

namespace caudal::ideal
{
  namespace
  {
    /** Integrals of kernels over a cell for each of its shape functions N_k. */
    struct KernelIntegrals
    {
      CellArray<double>       double_layer{}; ///< int N_k dG/dn_y dS [1]
      CellArray<Tensor<1, 3>> single_layer{}; ///< int N_k G n dS [m]
    };

    /** Adds the integrals by @p rule as seen from @p x. */
    void add_integrals(const PlacedRule &rule, const Point<3> &x, KernelIntegrals &integrals)
    {
      for (unsigned int q = 0; q < rule.points.size(); ++q)
      {
        const LaplaceKernel kernel = evaluate_laplace_kernel(rule.points[q] - x, rule.areas[q]);
        const Tensor<1, 3>  single = kernel.single_layer * rule.areas[q];
        const auto         &N      = rule.reference->values[q];
        for (unsigned int k = 0; k < N.size(); ++k)
        {
          integrals.double_layer[k] += N[k] * kernel.double_layer;
          integrals.single_layer[k] += N[k] * single;
        }
      }
    }

    /** What the mirror z -> -z does to the motions of Potentials; modes are in its plane. */
    double get_mirror_sign(const unsigned int motion)
    {
      const double signs[] = {-1., -1., 1., 1., 1., -1.};
      return motion < 6 ? signs[motion] : 1.;
    }

    /** Whether the surface and its modes are mirror images of themselves, z -> -z. */
    bool is_symmetric(const Surface &surface, const SurfaceMotion &motion)
    {
      const auto &images = surface.get_mirror_images();
      const auto  agree  = [](const Tensor<1, 3> &a, Tensor<1, 3> b, const double tolerance) {
        b[2] *= -1.;
        return (a - b).norm_square() <= tolerance * tolerance;
      };
      double size = 0.;
      for (const Point<3> &position : motion.positions)
        size = std::max(size, position.norm());
      for (unsigned int i = 0; i < images.size(); ++i)
      {
        if (!agree(motion.positions[i], motion.positions[images[i]], 1e-12 * size))
          return false;
        for (const auto &mode : motion.modes)
          if (!agree(mode[i], mode[images[i]], 1e-10 * (size + mode[i].norm())))
            return false;
      }
      return !images.empty();
    }

    /** Adds up what the ranks have computed. */
    void sum(LAPACKFullMatrix<double> &matrix, const MPI_Comm communicator)
    {
      if (matrix.n_elements() == 0)
        return;
      const ArrayView<double> entries(&matrix(0, 0), matrix.n_elements());
      Utilities::MPI::sum(ArrayView<const double>(entries), communicator, entries);
    }
  } // namespace

  ExteriorFlow::ExteriorFlow(const Surface &surface, SurfaceMotion moving, ReferenceRules &rules,
                             const MPI_Comm communicator, BoundaryElementCost &cost)
      : surface(surface)
      , motion(std::move(moving))
      , communicator(communicator)
      , cost(cost)
      , placed(surface, motion, rules)
  {
    Timer timer;
    compute_velocities();
    split_by_symmetry();
    assemble();
    cost.assembly += timer.cpu_time();
    timer.restart();
    potentials.values.reinit(surface.n_nodes(), velocities.size());
    for (Equations &equations : systems)
      solve(equations);
    integrate();
    cost.solution += timer.cpu_time();
  }

  void ExteriorFlow::compute_velocities()
  {
    velocities.resize(6, std::vector<Tensor<1, 3>>(surface.n_nodes()));
    for (unsigned int d = 0; d < 3; ++d)
    {
      Tensor<1, 3> axis;
      axis[d] = 1.;
      for (unsigned int i = 0; i < surface.n_nodes(); ++i)
      {
        velocities[d][i]     = cross_product_3d(axis, Tensor<1, 3>(motion.positions[i]));
        velocities[3 + d][i] = axis;
      }
    }
    velocities.insert(velocities.end(), motion.modes.begin(), motion.modes.end());
  }

  void ExteriorFlow::split_by_symmetry()
  {
    const auto &images    = surface.get_mirror_images();
    const bool  symmetric = is_symmetric(surface, motion);
    systems.resize(symmetric ? 2 : 1);
    for (unsigned int i = 0; i < surface.n_nodes(); ++i)
      if (!symmetric || i < images[i])
        for (Equations &equations : systems)
          equations.nodes.push_back(i);
    for (unsigned int l = 0; l < velocities.size(); ++l)
      systems[symmetric && get_mirror_sign(l) < 0. ? 1 : 0].motions.push_back(l);
    if (!symmetric)
      return;
    systems[0].sign = 1;
    systems[1].sign = -1;
    // Antisymmetric potentials vanish at the nodes in the plane.
    for (unsigned int i = 0; i < surface.n_nodes(); ++i)
      if (i == images[i])
        systems[0].nodes.push_back(i);
  }

  Vector<double> ExteriorFlow::fold(const Equations &equations, const Vector<double> &row) const
  {
    Vector<double> result(equations.nodes.size());
    for (unsigned int k = 0; k < result.size(); ++k)
    {
      const auto node = equations.nodes[k];
      result(k)       = row(node);
      if (equations.sign != 0 && surface.get_mirror_images()[node] != node)
        result(k) += equations.sign * row(surface.get_mirror_images()[node]);
    }
    return result;
  }

  void ExteriorFlow::assemble()
  {
    for (Equations &equations : systems)
    {
      equations.matrix.reinit(equations.nodes.size(), equations.nodes.size());
      equations.potentials.reinit(equations.nodes.size(), equations.motions.size());
    }
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    for (unsigned int k = Utilities::MPI::this_mpi_process(communicator);
         k < systems[0].nodes.size(); k += n_ranks)
    {
      const auto                node = systems[0].nodes[k];
      Vector<double>            double_layer(surface.n_nodes());
      std::vector<Tensor<1, 3>> single_layer(surface.n_nodes());
      for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
      {
        KernelIntegrals integrals;
        for (const unsigned int rule : placed.find_rules(cell, node))
          add_integrals(placed.get_rule(cell, rule), motion.positions[node], integrals);
        const auto &nodes = surface.get_nodes(cell);
        for (unsigned int i = 0; i < nodes.size(); ++i)
        {
          double_layer(nodes[i]) += integrals.double_layer[i];
          single_layer[nodes[i]] += integrals.single_layer[i];
        }
      }
      for (Equations &equations : systems)
        if (k < equations.nodes.size())
          add_equation(equations, k, double_layer, single_layer);
    }
    for (Equations &equations : systems)
    {
      sum(equations.matrix, communicator);
      sum(equations.potentials, communicator);
    }
  }

  void ExteriorFlow::add_equation(Equations &equations, const unsigned int k,
                                  const Vector<double>            &double_layer,
                                  const std::vector<Tensor<1, 3>> &single_layer) const
  {
    // phi(x) is subtracted from all phi(y), and so has no part in the double layer itself.
    const auto     node         = equations.nodes[k];
    Vector<double> row          = double_layer;
    row(node)                   = 0.;
    row(node)                   = -1. - row.size() * row.mean_value();
    const Vector<double> folded = fold(equations, row);
    for (unsigned int j = 0; j < folded.size(); ++j)
      equations.matrix(k, j) = -folded(j);
    for (unsigned int l = 0; l < equations.motions.size(); ++l)
      for (unsigned int i = 0; i < surface.n_nodes(); ++i)
        equations.potentials(k, l) -= velocities[equations.motions[l]][i] * single_layer[i];
  }

  void ExteriorFlow::solve(Equations &equations)
  {
    try
    {
      equations.matrix.compute_lu_factorization();
      equations.matrix.solve(equations.potentials);
    }
    catch (const ExceptionBase &)
    {
      AssertThrow(false, ExcMessage("The boundary elements' matrix is singular: the surface is "
                                    "degenerate, or intersects itself. Check section Shape, and "
                                    "refine section Surface."));
    }
    for (unsigned int k = 0; k < equations.nodes.size(); ++k)
      for (unsigned int l = 0; l < equations.motions.size(); ++l)
      {
        const auto node   = equations.nodes[k];
        const auto motion = equations.motions[l];
        if (equations.sign != 0)
          potentials.values(surface.get_mirror_images()[node], motion) =
              equations.sign * equations.potentials(k, l);
        potentials.values(node, motion) = equations.potentials(k, l);
      }
  }

  void ExteriorFlow::integrate()
  {
    const unsigned int n_motions = velocities.size();
    fluxes.reinit(surface.n_nodes(), n_motions);
    for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
    {
      const PlacedRule &rule  = placed.get_rule(cell, PlacedSurface::regular);
      const auto       &nodes = surface.get_nodes(cell);
      for (unsigned int q = 0; q < rule.points.size(); ++q)
      {
        const auto &N = rule.reference->values[q];
        for (unsigned int l = 0; l < n_motions; ++l)
        {
          Tensor<1, 3> velocity;
          for (unsigned int k = 0; k < nodes.size(); ++k)
            velocity += N[k] * velocities[l][nodes[k]];
          for (unsigned int k = 0; k < nodes.size(); ++k)
            fluxes(nodes[k], l) += N[k] * (velocity * rule.areas[q]);
        }
        potentials.volume += rule.points[q] * rule.areas[q] / 3.;
      }
    }
    FullMatrix<double> &mass = potentials.added_mass;
    mass.reinit(n_motions, n_motions);
    potentials.values.Tmmult(mass, fluxes);
    mass *= -1.;
    mass.symmetrize();
    for (unsigned int k = 0; k < n_motions; ++k)
      for (unsigned int l = 0; l < n_motions; ++l)
      {
        AssertThrow(std::isfinite(mass(k, l)),
                    ExcMessage("The boundary elements' solution is not finite: the surface is "
                               "degenerate. Refine it, or give a smoother shape."));
        // Flows of different symmetry have no energy in common; that is to hold exactly.
        if (systems.size() == 2 && get_mirror_sign(k) != get_mirror_sign(l))
          mass(k, l) = 0.;
      }
  }
} // namespace caudal::ideal
