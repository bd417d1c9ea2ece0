#include <caudal/ideal/exterior_flow.h>

#include <deal.II/base/timer.h>

#include <cstring>

namespace caudal::ideal
{
  namespace
  {
    constexpr unsigned int n = Surface::n_nodes_per_cell;

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

    /** From the double layer's row to that of the matrix, in which phi(x) is subtracted. */
    void complete(const unsigned int node, std::vector<double> &row)
    {
      double sum = 1.;
      row[node]  = 0.;
      for (double &entry : row)
      {
        sum += entry;
        entry *= -1.;
      }
      row[node] = sum;
    }

    /** The part [first, second) of n that this rank has. */
    std::pair<unsigned int, unsigned int> get_share(const unsigned int n,
                                                    const MPI_Comm     communicator)
    {
      const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
      const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
      return {n * rank / n_ranks, n * (rank + 1) / n_ranks};
    }

    /** Gives all ranks the columns that the others have computed; @p n is what was shared. */
    void exchange_columns(LAPACKFullMatrix<double> &matrix, const unsigned int n,
                          const MPI_Comm communicator)
    {
      const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
      if (n_ranks == 1 || matrix.n() == 0)
        return;
      const auto begin = [&](const unsigned int rank) {
        return static_cast<int>(std::min<unsigned int>(n * rank / n_ranks, matrix.n()));
      };
      MPI_Datatype column;
      int          ierr = MPI_Type_contiguous(matrix.m(), MPI_DOUBLE, &column);
      AssertThrowMPI(ierr);
      ierr = MPI_Type_commit(&column);
      AssertThrowMPI(ierr);
      std::vector<int> counts, offsets;
      for (unsigned int rank = 0; rank < n_ranks; ++rank)
      {
        offsets.push_back(begin(rank));
        counts.push_back(begin(rank + 1) - begin(rank));
      }
      ierr = MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, &matrix(0, 0), counts.data(),
                            offsets.data(), column, communicator);
      AssertThrowMPI(ierr);
      ierr = MPI_Type_free(&column);
      AssertThrowMPI(ierr);
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
    split_by_symmetry();
    assemble();
    cost.assembly += timer.cpu_time();
    timer.restart();
    potentials.values.reinit(surface.n_nodes(), placed.n_motions());
    for (Equations &equations : systems)
      solve(equations);
    integrate();
    cost.solution += timer.cpu_time();
  }

  void ExteriorFlow::split_by_symmetry()
  {
    const auto &images = surface.get_mirror_images();
    if (!is_symmetric(surface, motion))
    {
      systems.resize(1);
      for (unsigned int i = 0; i < surface.n_nodes(); ++i)
        systems[0].nodes.push_back(i);
      for (unsigned int l = 0; l < placed.n_motions(); ++l)
        systems[0].motions.push_back(l);
      return;
    }
    systems.resize(2);
    for (unsigned int i = 0; i < surface.n_nodes(); ++i)
      if (i < images[i])
        for (Equations &equations : systems)
          equations.nodes.push_back(i);
    // Antisymmetric potentials vanish at the nodes in the plane.
    for (unsigned int i = 0; i < surface.n_nodes(); ++i)
      if (i == images[i])
        systems[0].nodes.push_back(i);
    systems[0].sign = 1;
    systems[1].sign = -1;
    for (unsigned int l = 0; l < placed.n_motions(); ++l)
      systems[get_mirror_sign(l) > 0. ? 0 : 1].motions.push_back(l);
  }

  void ExteriorFlow::fold(const Equations &equations, const double *const row,
                          double *const result) const
  {
    const auto &images = surface.get_mirror_images();
    for (unsigned int k = 0; k < equations.nodes.size(); ++k)
    {
      const auto node = equations.nodes[k];
      result[k]       = row[node];
      if (equations.sign != 0 && images[node] != node)
        result[k] += equations.sign * row[images[node]];
    }
  }

  void ExteriorFlow::assemble()
  {
    for (Equations &equations : systems)
    {
      equations.matrix.reinit(equations.nodes.size(), equations.nodes.size());
      equations.rhs.reinit(equations.motions.size(), equations.nodes.size());
    }
    const auto n_equations   = systems[0].nodes.size();
    const auto [first, last] = get_share(n_equations, communicator);
    std::vector<double> row, rhs;
    for (unsigned int k = first; k < last; ++k)
    {
      const auto node = systems[0].nodes[k];
      row.assign(surface.n_nodes(), 0.);
      rhs.assign(placed.n_motions(), 0.);
      add_equation(node, row.data(), rhs.data());
      complete(node, row);
      for (Equations &equations : systems)
        if (k < equations.nodes.size())
        {
          fold(equations, row.data(), &equations.matrix(0, k));
          for (unsigned int l = 0; l < equations.motions.size(); ++l)
            equations.rhs(l, k) = rhs[equations.motions[l]];
        }
    }
    for (Equations &equations : systems)
    {
      exchange_columns(equations.matrix, n_equations, communicator);
      exchange_columns(equations.rhs, n_equations, communicator);
    }
  }

  /** The sum over the cells: double and single layer. */
  void ExteriorFlow::add_equation(const unsigned int node, double *const row, double *const rhs)
  {
    const Point<3>           &x         = motion.positions[node];
    const FullMatrix<double> &fluxes    = placed.get_fluxes();
    const unsigned int        n_motions = placed.n_motions();
    alignas(64) double        dipole[ReferenceRule::stride];
    CellMoments               moments;
    for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
    {
      const auto &nodes = surface.get_nodes(cell);
      const auto  own   = std::find(nodes.begin(), nodes.end(), node);
      if (own == nodes.end() && placed.is_far(cell, node))
      {
        const CellRule &rule = placed.get_regular(cell).rule;
        std::memset(dipole, 0, sizeof dipole);
        add_far_moments(rule, x, &fluxes(cell * rule.get_reference().n_points, 0), n_motions,
                        dipole, rhs);
        for (unsigned int k = 0; k < n; ++k)
          row[nodes[k]] += dipole[k];
        continue;
      }
      std::memset(&moments, 0, sizeof moments);
      if (own != nodes.end())
        add_moments(placed.get_singular(cell, own - nodes.begin()).rule, x, moments);
      else
        for (const PlacedRule *const near : placed.find_near(cell, node))
          add_moments(near->rule, x, moments);
      for (unsigned int k = 0; k < n; ++k)
      {
        const Tensor<1, 3> single =
            Point<3>(moments.single[0][k], moments.single[1][k], moments.single[2][k]);
        const Tensor<1, 3> moment = cross_product_3d(placed.get_positions(cell)[k], single);
        row[nodes[k]] += moments.dipole[k];
        for (unsigned int d = 0; d < 3; ++d)
        {
          rhs[d] += moment[d];
          rhs[3 + d] += single[d];
        }
        for (unsigned int mode = 0; mode < motion.modes.size(); ++mode)
          rhs[6 + mode] += motion.modes[mode][nodes[k]] * single;
      }
    }
  }

  void ExteriorFlow::solve(Equations &equations)
  {
    LAPACKFullMatrix<double> solution(equations.nodes.size(), equations.motions.size());
    for (unsigned int k = 0; k < solution.m(); ++k)
      for (unsigned int l = 0; l < solution.n(); ++l)
        solution(k, l) = -equations.rhs(l, k);
    try
    {
      equations.matrix.compute_lu_factorization();
      equations.matrix.solve(solution, /*transposed*/ true);
    }
    catch (const ExceptionBase &)
    {
      AssertThrow(false, ExcMessage("The boundary elements' matrix is singular: the surface is "
                                    "degenerate, or intersects itself. Check section Shape, and "
                                    "refine section Surface."));
    }
    for (unsigned int k = 0; k < solution.m(); ++k)
      for (unsigned int l = 0; l < solution.n(); ++l)
      {
        const auto node   = equations.nodes[k];
        const auto motion = equations.motions[l];
        if (equations.sign != 0)
          potentials.values(surface.get_mirror_images()[node], motion) =
              equations.sign * solution(k, l);
        potentials.values(node, motion) = solution(k, l);
      }
  }

  void ExteriorFlow::integrate()
  {
    const FullMatrix<double> &fluxes    = placed.get_fluxes();
    const unsigned int        n_motions = placed.n_motions();
    FullMatrix<double>        mass(n_motions, n_motions);
    std::vector<double>       phi(n_motions);
    for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
    {
      const CellRule      &rule      = placed.get_regular(cell).rule;
      const ReferenceRule &reference = rule.get_reference();
      const auto          &nodes     = surface.get_nodes(cell);
      for (unsigned int q = 0; q < reference.n_points; ++q)
      {
        std::fill(phi.begin(), phi.end(), 0.);
        for (unsigned int k = 0; k < n; ++k)
          for (unsigned int l = 0; l < n_motions; ++l)
            phi[l] += reference.values[q * reference.stride + k] * potentials.values(nodes[k], l);
        const double *const flux = &fluxes(cell * reference.n_points + q, 0);
        for (unsigned int k = 0; k < n_motions; ++k)
          for (unsigned int l = 0; l < n_motions; ++l)
            mass(k, l) -= phi[k] * flux[l];
        potentials.volume += rule.get_point(q) * rule.get_area(q) / 3.;
      }
    }
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
    potentials.added_mass = mass;
  }
} // namespace caudal::ideal
