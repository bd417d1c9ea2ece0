#include <caudal/potential/boundary_elements.h>
#include <caudal/potential/placed_surface.h>

#include <deal.II/base/timer.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <cstring>

namespace caudal::potential
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

    /** The sum over the cells of the equation of one node: double and single layer. */
    void assemble(PlacedSurface &placed, const unsigned int node, double *const row,
                  double *const rhs)
    {
      const Point<3>           &x         = placed.motion.positions[node];
      const FullMatrix<double> &fluxes    = placed.get_fluxes();
      const unsigned int        n_motions = placed.n_motions();
      alignas(64) double        dipole[ReferenceRule::stride];
      CellMoments               moments;
      for (unsigned int cell = 0; cell < placed.surface.n_cells(); ++cell)
      {
        const auto &nodes = placed.surface.get_nodes(cell);
        const auto  own   = std::find(nodes.begin(), nodes.end(), node);
        if (own == nodes.end() && placed.is_far(cell, node))
        {
          const CellRule &rule = placed.get_regular(cell);
          std::memset(dipole, 0, sizeof dipole);
          add_far_moments(rule, x, &fluxes(cell * rule.get_reference().n_points, 0), n_motions,
                          dipole, rhs);
          for (unsigned int k = 0; k < n; ++k)
            row[nodes[k]] += dipole[k];
          continue;
        }
        std::memset(&moments, 0, sizeof moments);
        if (own != nodes.end())
          placed.add_singular(cell, own - nodes.begin(), moments);
        else
          placed.add_near(cell, node, moments);
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
          for (unsigned int mode = 0; mode < placed.motion.modes.size(); ++mode)
            rhs[6 + mode] += placed.motion.modes[mode][nodes[k]] * single;
        }
      }
    }

    /** From the double layer's row to that of the matrix, in which phi(x) is subtracted. */
    void complete(const unsigned int node, const unsigned int size, double *const row)
    {
      double sum = 1.;
      row[node]  = 0.;
      for (unsigned int j = 0; j < size; ++j)
      {
        sum += row[j];
        row[j] *= -1.;
      }
      row[node] = sum;
    }

    /** Gives all ranks the columns that the others have computed. */
    void exchange_columns(LAPACKFullMatrix<double> &matrix, const unsigned int n_columns,
                          const MPI_Comm communicator)
    {
      const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
      if (n_ranks == 1)
        return;
      std::vector<int> counts, offsets;
      for (unsigned int rank = 0; rank < n_ranks; ++rank)
      {
        const int first = n_columns * rank / n_ranks, last = n_columns * (rank + 1) / n_ranks;
        offsets.push_back(first * matrix.m());
        counts.push_back((last - first) * matrix.m());
      }
      const int ierr = MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, &matrix(0, 0),
                                      counts.data(), offsets.data(), MPI_DOUBLE, communicator);
      AssertThrowMPI(ierr);
    }

    /** The equations of all nodes, as columns, since these are contiguous. */
    struct Equations
    {
      LAPACKFullMatrix<double> matrix, rhs;
    };

    Equations assemble_all(PlacedSurface &placed, const MPI_Comm communicator)
    {
      const unsigned int size = placed.surface.n_nodes(), n_motions = placed.n_motions();
      Equations          equations;
      equations.matrix.reinit(size, size);
      equations.rhs.reinit(n_motions, size);

      // Of two nodes that are mirror images only the first is computed.
      const bool                           symmetric = is_symmetric(placed.surface, placed.motion);
      const auto                          &images    = placed.surface.get_mirror_images();
      std::vector<types::global_dof_index> nodes;
      for (unsigned int i = 0; i < size; ++i)
        if (!symmetric || i <= images[i])
          nodes.push_back(i);

      LAPACKFullMatrix<double> rows(size + n_motions, nodes.size());
      const unsigned int       rank    = Utilities::MPI::this_mpi_process(communicator);
      const unsigned int       n_ranks = Utilities::MPI::n_mpi_processes(communicator);
      for (unsigned int k = nodes.size() * rank / n_ranks; k < nodes.size() * (rank + 1) / n_ranks;
           ++k)
      {
        assemble(placed, nodes[k], &rows(0, k), &rows(size, k));
        complete(nodes[k], size, &rows(0, k));
      }
      exchange_columns(rows, nodes.size(), communicator);

      for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const double *const row = &rows(0, k), *const rhs = row + size;
        const auto i = nodes[k];
        std::copy(row, rhs, &equations.matrix(0, i));
        std::copy(rhs, rhs + n_motions, &equations.rhs(0, i));
        if (symmetric && images[i] != i)
        {
          double *const image = &equations.matrix(0, images[i]);
          for (unsigned int j = 0; j < size; ++j)
            image[images[j]] = row[j];
          for (unsigned int l = 0; l < n_motions; ++l)
            equations.rhs(l, images[i]) = get_mirror_sign(l) * rhs[l];
        }
      }
      return equations;
    }

    /** The integrals of the potentials over the surface. */
    Potentials collect(const PlacedSurface &placed, const LAPACKFullMatrix<double> &solution)
    {
      const FullMatrix<double> &fluxes    = placed.get_fluxes();
      const unsigned int        n_motions = placed.n_motions();
      Potentials                result;
      result.values.reinit(solution.m(), n_motions);
      for (unsigned int i = 0; i < solution.m(); ++i)
        for (unsigned int l = 0; l < n_motions; ++l)
          result.values(i, l) = solution(i, l);

      FullMatrix<double>  mass(n_motions, n_motions);
      std::vector<double> phi(n_motions);
      for (unsigned int cell = 0; cell < placed.surface.n_cells(); ++cell)
      {
        const CellRule      &rule      = placed.get_regular(cell);
        const ReferenceRule &reference = rule.get_reference();
        const auto          &nodes     = placed.surface.get_nodes(cell);
        for (unsigned int q = 0; q < reference.n_points; ++q)
        {
          std::fill(phi.begin(), phi.end(), 0.);
          for (unsigned int k = 0; k < n; ++k)
            for (unsigned int l = 0; l < n_motions; ++l)
              phi[l] += reference.values[q * reference.stride + k] * result.values(nodes[k], l);
          const double *const flux = &fluxes(cell * reference.n_points + q, 0);
          for (unsigned int k = 0; k < n_motions; ++k)
            for (unsigned int l = 0; l < n_motions; ++l)
              mass(k, l) -= phi[k] * flux[l];
          result.volume += rule.get_point(q) * rule.get_area(q) / 3.;
        }
      }
      mass.symmetrize();
      for (unsigned int k = 0; k < n_motions; ++k)
        for (unsigned int l = 0; l < n_motions; ++l)
          AssertThrow(std::isfinite(mass(k, l)),
                      ExcMessage("The boundary elements' solution is not finite: the surface is "
                                 "degenerate. Refine it, or give a smoother shape."));
      result.added_mass = mass;
      return result;
    }
  } // namespace

  BoundaryElements::BoundaryElements(const Surface &surface, const MPI_Comm communicator)
      : surface(surface)
      , communicator(communicator)
      , rules(surface.get_fe())
  {}

  Potentials BoundaryElements::compute_potentials(const SurfaceMotion &motion)
  {
    Timer         timer;
    PlacedSurface placed(surface, motion, rules);
    Equations     equations = assemble_all(placed, communicator);
    cost.assembly += timer.cpu_time();

    timer.restart();
    LAPACKFullMatrix<double> solution(surface.n_nodes(), placed.n_motions());
    for (unsigned int i = 0; i < solution.m(); ++i)
      for (unsigned int l = 0; l < solution.n(); ++l)
        solution(i, l) = -equations.rhs(l, i);
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
    cost.solution += timer.cpu_time();
    return collect(placed, solution);
  }
} // namespace caudal::potential
