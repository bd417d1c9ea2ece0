// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/ideal/exterior_flow.h>

#include <deal.II/base/timer.h>

#include <numeric>

namespace caudal::ideal
{
  namespace
  {
    /** Integrals of kernels over a cell for each of its shape functions N_k. */
    struct KernelIntegrals
    {
      CellArray<double>                double_layer{}; ///< int N_k dG/dn_y dS [1]
      std::array<CellArray<double>, 3> single_layer{}; ///< int N_k G n dS by coordinate [m]
    };

    /** Adds the integrals by @p rule as seen from @p x. */
    CAUDAL_WIDE_VECTORS
    void add_integrals(const PlacedRule &rule, const Point<3> &x, KernelIntegrals &integrals)
    {
      const double *const y_x = rule.get_points(0), *const y_y = rule.get_points(1),
                          *const y_z = rule.get_points(2);
      const double *const N_x = rule.get_areas(0), *const N_y = rule.get_areas(1),
                          *const N_z = rule.get_areas(2);
      const double               x_x = x[0], x_y = x[1], x_z = x[2];
      ReferenceRule::Numbers     double_layer;
      ReferenceRule::Vectors     single_layer;
#pragma omp simd
      for (unsigned int q = 0; q < rule.size(); ++q)
      {
        const LaplaceKernel kernel = evaluate_laplace_kernel(y_x[q] - x_x, y_y[q] - x_y,
                                                             y_z[q] - x_z, N_x[q], N_y[q], N_z[q]);
        double_layer[q]            = kernel.double_layer;
        single_layer[0][q]         = kernel.single_layer * N_x[q];
        single_layer[1][q]         = kernel.single_layer * N_y[q];
        single_layer[2][q]         = kernel.single_layer * N_z[q];
      }
      const ReferenceRule &reference = rule.get_reference();
      reference.add_sums(ReferenceRule::value, double_layer, integrals.double_layer);
      for (unsigned int d = 0; d < 3; ++d)
        reference.add_sums(ReferenceRule::value, single_layer[d], integrals.single_layer[d]);
    }

    /** Whether the surface and its modes are mirror images of themselves, z -> -z. */
    bool has_mirror_symmetry(const Surface &surface, const SurfaceMotion &motion)
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
      , is_symmetric(has_mirror_symmetry(surface, motion))
      , images(surface.get_mirror_images())
      , matrix(surface.n_nodes())
  {
    Timer timer;
    if (!is_symmetric)
    {
      images.resize(surface.n_nodes());
      std::iota(images.begin(), images.end(), 0);
    }
    compute_velocities();
    LAPACKFullMatrix<double> right_hand_sides = assemble();
    cost.assembly += timer.cpu_time();
    timer.restart();
    solve(std::move(right_hand_sides));
    integrate();
    cost.solution += timer.cpu_time();
  }

  void ExteriorFlow::compute_velocities()
  {
    for (unsigned int l = 0; l < 6; ++l)
    {
      Screw unit;
      unit[l] = 1.;
      velocities.push_back(motion.compute_velocities(unit, {}, 0.));
    }
    velocities.insert(velocities.end(), motion.modes.begin(), motion.modes.end());
  }

  std::vector<unsigned int> ExteriorFlow::get_own_nodes() const
  {
    const unsigned int        rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int        n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    std::vector<unsigned int> nodes;
    for (unsigned int node = 0, n = 0; node < surface.n_nodes(); ++node)
      if (node <= images[node] && n++ % n_ranks == rank)
        nodes.push_back(node);
    return nodes;
  }

  double ExteriorFlow::get_mirror_sign(const unsigned int motion) const
  {
    const double signs[] = {-1., -1., 1., 1., 1., -1.}; // modes are in the mirror's plane
    return is_symmetric && motion < 6 ? signs[motion] : 1.;
  }

  Vector<double> ExteriorFlow::extract_part(const Vector<double> &motions, const double sign) const
  {
    Vector<double> part = motions;
    for (unsigned int l = 0; l < part.size(); ++l)
      if (get_mirror_sign(l) != sign)
        part(l) = 0.;
    return part;
  }

  LAPACKFullMatrix<double> ExteriorFlow::assemble()
  {
    LAPACKFullMatrix<double> right_hand_sides(surface.n_nodes(), velocities.size());
    for (const unsigned int node : get_own_nodes())
    {
      std::vector<double>       double_layer(surface.n_nodes(), 0.);
      std::vector<Tensor<1, 3>> single_layer(surface.n_nodes());
      for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
      {
        KernelIntegrals integrals;
        for (const unsigned int rule : placed.find_rules(cell, node))
          add_integrals(placed.get_rule(cell, rule), motion.positions[node], integrals);
        const auto &nodes = surface.get_nodes(cell);
        for (unsigned int i = 0; i < nodes.size(); ++i)
        {
          double_layer[nodes[i]] += integrals.double_layer[i];
          for (unsigned int d = 0; d < 3; ++d)
            single_layer[nodes[i]][d] += integrals.single_layer[d][i];
        }
      }
      // phi(x) is subtracted from all phi(y), and so has no part in the double layer itself.
      double_layer[node] = 0.;
      double_layer[node] = -1. - std::accumulate(double_layer.begin(), double_layer.end(), 0.);
      for (unsigned int j = 0; j < surface.n_nodes(); ++j)
        matrix(images[node], images[j]) = matrix(node, j) = -double_layer[j];
      for (unsigned int l = 0; l < velocities.size(); ++l)
      {
        const double flux = std::inner_product(velocities[l].begin(), velocities[l].end(),
                                               single_layer.begin(), 0.);
        right_hand_sides(images[node], l) = -get_mirror_sign(l) * flux;
        right_hand_sides(node, l)         = -flux;
      }
    }
    sum(matrix, communicator);
    sum(right_hand_sides, communicator);
    return right_hand_sides;
  }

  void ExteriorFlow::solve(LAPACKFullMatrix<double> solution)
  {
    try
    {
      matrix.compute_lu_factorization();
      matrix.solve(solution);
    }
    catch (const ExceptionBase &)
    {
      AssertThrow(false, ExcMessage("The boundary elements' matrix is singular: the surface is "
                                    "degenerate, or intersects itself. Check section Shape, and "
                                    "refine section Surface."));
    }
    potentials.values.reinit(solution.m(), solution.n());
    for (unsigned int i = 0; i < solution.m(); ++i)
      for (unsigned int l = 0; l < solution.n(); ++l)
        potentials.values(i, l) = solution(i, l);
  }

  void ExteriorFlow::integrate()
  {
    const unsigned int n_motions = velocities.size();
    fluxes.reinit(surface.n_nodes(), n_motions);
    for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
    {
      const PlacedRule      &rule  = placed.get_rule(cell, PlacedSurface::regular);
      const auto            &nodes = surface.get_nodes(cell);
      ReferenceRule::Vectors u;
      CellArray<double>      sums;
      for (unsigned int l = 0; l < n_motions; ++l)
      {
        rule.get_reference().interpolate(ReferenceRule::value, extract_cell(velocities[l], nodes),
                                         u);
        for (unsigned int k = 0; k < nodes.size(); ++k)
          sums[k] = fluxes(nodes[k], l);
        rule.get_reference().add_sums(ReferenceRule::value, rule.compute_fluxes(u), sums);
        for (unsigned int k = 0; k < nodes.size(); ++k)
          fluxes(nodes[k], l) = sums[k];
      }
      for (unsigned int q = 0; q < rule.size(); ++q)
        potentials.volume += rule.get_point(q) * rule.get_area(q) / 3.;
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
        if (get_mirror_sign(k) != get_mirror_sign(l))
          mass(k, l) = 0.;
      }
  }
} // namespace caudal::ideal
