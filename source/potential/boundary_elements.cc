#include <caudal/potential/boundary_elements.h>
#include <caudal/potential/laplace_kernel.h>

#include <deal.II/base/timer.h>
#include <deal.II/lac/lapack_full_matrix.h>

namespace caudal::potential
{
  namespace
  {
    constexpr unsigned int n = Surface::n_nodes_per_cell;

    // A rule serves points x that are farther from its cell or part than this, in radii.
    const double far_from_cell = 3.;
    const double far_from_part = 2.;

    /** The surface in one position, with rules on its cells that are made when needed. */
    class PlacedSurface
    {
    public:
      PlacedSurface(const Surface &surface, const SurfaceMotion &motion, ReferenceRules &rules)
          : surface(surface)
          , motion(motion)
          , rules(rules)
          , parts(surface.n_cells())
      {
        for (unsigned int cell = 0; cell < surface.n_cells(); ++cell)
        {
          positions.emplace_back();
          for (const auto node : surface.get_nodes(cell))
            positions.back().push_back(motion.positions[node]);
          regular.emplace_back(rules.get_regular(), positions.back());
          regular.back().compute_ball();
        }
      }

      unsigned int n_motions() const
      {
        return 6 + motion.modes.size();
      }

      const CellRule &get_part(const unsigned int cell, const unsigned int level,
                               const unsigned int i, const unsigned int j)
      {
        auto &list = parts[cell];
        if (list.empty())
          list.resize(ReferenceRules::get_index(ReferenceRules::finest_level + 1, 0, 0));
        auto &part = list[ReferenceRules::get_index(level, i, j)];
        if (!part)
        {
          part = std::make_unique<CellRule>(rules.get_part(level, i, j), positions[cell]);
          part->compute_ball();
        }
        return *part;
      }

      const Surface                     &surface;
      const SurfaceMotion               &motion;
      ReferenceRules                    &rules;
      std::vector<std::vector<Point<3>>> positions; // by cell
      std::vector<CellRule>              regular;   // by cell

    private:
      std::vector<std::vector<std::unique_ptr<CellRule>>> parts; // by cell, then index
    };

    /** The flux u_l.N of each motion through the points of the regular rules. */
    FullMatrix<double> compute_fluxes(const PlacedSurface &placed)
    {
      const auto        &rule     = placed.rules.get_regular();
      const unsigned int n_points = rule.n_points;
      FullMatrix<double> fluxes(placed.surface.n_cells() * n_points, placed.n_motions());
      for (unsigned int cell = 0; cell < placed.surface.n_cells(); ++cell)
      {
        const CellRule &at    = placed.regular[cell];
        const auto     &nodes = placed.surface.get_nodes(cell);
        for (unsigned int q = 0; q < n_points; ++q)
        {
          const unsigned int row = cell * n_points + q;
          const Point<3>     X(at.points[0][q], at.points[1][q], at.points[2][q]);
          const Point<3>     N(at.areas[0][q], at.areas[1][q], at.areas[2][q]);
          const Tensor<1, 3> moment = cross_product_3d(X, N);
          for (unsigned int d = 0; d < 3; ++d)
          {
            fluxes(row, d)     = moment[d];
            fluxes(row, d + 3) = N[d];
          }
          for (unsigned int mode = 0; mode < placed.motion.modes.size(); ++mode)
            for (unsigned int k = 0; k < n; ++k)
              fluxes(row, 6 + mode) +=
                  rule.values[q * n + k] * (placed.motion.modes[mode][nodes[k]] * N);
        }
      }
      return fluxes;
    }

    /**
     * The equation of one node: int N_j dG/dn dS for all unknowns j, and int G u_l.n dS
     * for all motions l.
     */
    class RowAssembler
    {
    public:
      RowAssembler(PlacedSurface &placed, const FullMatrix<double> &fluxes)
          : placed(placed)
          , fluxes(fluxes)
          , n_points(placed.rules.get_regular().n_points)
          , single(n_points)
          , dipole(n_points)
      {}

      /** Adds to @p row (of the double layer) and @p rhs (of the single layer). */
      void assemble(const unsigned int node, double *const row, double *const rhs)
      {
        x = placed.motion.positions[node];
        for (unsigned int cell = 0; cell < placed.surface.n_cells(); ++cell)
        {
          const auto     &nodes   = placed.surface.get_nodes(cell);
          const auto      own     = std::find(nodes.begin(), nodes.end(), node);
          const CellRule &regular = placed.regular[cell];
          if (own == nodes.end() &&
              x.distance_square(regular.centre) > square(far_from_cell * regular.radius))
          {
            add_far(cell, row, rhs);
            continue;
          }
          double_layer.fill(0.);
          single_layer.fill(Tensor<1, 3>());
          if (own != nodes.end())
            add(CellRule(placed.rules.get_singular(own - nodes.begin()), placed.positions[cell]));
          else
            add_parts(cell, 0, 0, 0);
          scatter(cell, row, rhs);
        }
      }

    private:
      static double square(const double value)
      {
        return value * value;
      }

      void evaluate(const CellRule &rule)
      {
        const unsigned int size = rule.reference->n_points;
        single.resize(size);
        dipole.resize(size);
        for (unsigned int q = 0; q < size; ++q)
        {
          const LaplaceKernel kernel = evaluate_laplace_kernel(
              rule.points[0][q] - x[0], rule.points[1][q] - x[1], rule.points[2][q] - x[2],
              rule.areas[0][q], rule.areas[1][q], rule.areas[2][q]);
          single[q] = kernel.single_layer;
          dipole[q] = kernel.double_layer;
        }
      }

      void add_far(const unsigned int cell, double *const row, double *const rhs)
      {
        const CellRule &rule   = placed.regular[cell];
        const auto     &nodes  = placed.surface.get_nodes(cell);
        const auto     &values = rule.reference->values;
        const unsigned  size   = fluxes.n();
        evaluate(rule);
        std::array<double, n> sums{};
        for (unsigned int q = 0; q < n_points; ++q)
        {
          for (unsigned int k = 0; k < n; ++k)
            sums[k] += dipole[q] * values[q * n + k];
          const double *const flux = &fluxes(cell * n_points + q, 0);
          for (unsigned int l = 0; l < size; ++l)
            rhs[l] += single[q] * flux[l];
        }
        for (unsigned int k = 0; k < n; ++k)
          row[nodes[k]] += sums[k];
      }

      /** Adds a part of a cell if x is far enough from it, or else its four parts. */
      void add_parts(const unsigned int cell, const unsigned int level, const unsigned int i,
                     const unsigned int j)
      {
        const CellRule &part = placed.get_part(cell, level, i, j);
        if (level == ReferenceRules::finest_level ||
            x.distance_square(part.centre) > square(far_from_part * part.radius))
          add(part);
        else
          for (unsigned int child = 0; child < 4; ++child)
            add_parts(cell, level + 1, 2 * i + child % 2, 2 * j + child / 2);
      }

      void add(const CellRule &rule)
      {
        const auto &values = rule.reference->values;
        evaluate(rule);
        for (unsigned int q = 0; q < rule.reference->n_points; ++q)
        {
          const double Gx = single[q] * rule.areas[0][q], Gy = single[q] * rule.areas[1][q],
                       Gz = single[q] * rule.areas[2][q];
          for (unsigned int k = 0; k < n; ++k)
          {
            const double value = values[q * n + k];
            double_layer[k] += dipole[q] * value;
            single_layer[k][0] += Gx * value;
            single_layer[k][1] += Gy * value;
            single_layer[k][2] += Gz * value;
          }
        }
      }

      /** From the moments int N_k dG/dn dS and int G N_k n dS of a cell to the equation. */
      void scatter(const unsigned int cell, double *const row, double *const rhs) const
      {
        const auto &nodes = placed.surface.get_nodes(cell);
        for (unsigned int k = 0; k < n; ++k)
        {
          row[nodes[k]] += double_layer[k];
          const Tensor<1, 3> moment = cross_product_3d(placed.positions[cell][k], single_layer[k]);
          for (unsigned int d = 0; d < 3; ++d)
          {
            rhs[d] += moment[d];
            rhs[d + 3] += single_layer[k][d];
          }
          for (unsigned int mode = 0; mode < placed.motion.modes.size(); ++mode)
            rhs[6 + mode] += placed.motion.modes[mode][nodes[k]] * single_layer[k];
        }
      }

      PlacedSurface            &placed;
      const FullMatrix<double> &fluxes;
      const unsigned int        n_points;

      Point<3>                    x;
      std::vector<double>         single, dipole;
      std::array<double, n>       double_layer;
      std::array<Tensor<1, 3>, n> single_layer;
    };

    /** Gives all ranks the columns [first, last) of each other. */
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

    /** The integrals of the potentials over the surface. */
    Potentials collect(const PlacedSurface &placed, const FullMatrix<double> &fluxes,
                       const LAPACKFullMatrix<double> &solution)
    {
      const auto        &rule      = placed.rules.get_regular();
      const unsigned int n_motions = placed.n_motions();
      Potentials         result;
      result.values.reinit(solution.m(), n_motions);
      for (unsigned int i = 0; i < solution.m(); ++i)
        for (unsigned int l = 0; l < n_motions; ++l)
          result.values(i, l) = solution(i, l);

      FullMatrix<double>  mass(n_motions, n_motions);
      std::vector<double> phi(n_motions);
      for (unsigned int cell = 0; cell < placed.surface.n_cells(); ++cell)
        for (unsigned int q = 0; q < rule.n_points; ++q)
        {
          std::fill(phi.begin(), phi.end(), 0.);
          for (unsigned int k = 0; k < n; ++k)
            for (unsigned int l = 0; l < n_motions; ++l)
              phi[l] +=
                  rule.values[q * n + k] * result.values(placed.surface.get_nodes(cell)[k], l);
          for (unsigned int k = 0; k < n_motions; ++k)
            for (unsigned int l = 0; l < n_motions; ++l)
              mass(k, l) -= phi[k] * fluxes(cell * rule.n_points + q, l);
          for (unsigned int d = 0; d < 3; ++d)
            result.volume +=
                placed.regular[cell].points[d][q] * placed.regular[cell].areas[d][q] / 3.;
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
    Timer                    timer;
    PlacedSurface            placed(surface, motion, rules);
    const FullMatrix<double> fluxes    = compute_fluxes(placed);
    const unsigned int       size      = surface.n_nodes();
    const unsigned int       n_motions = placed.n_motions();

    // Equations are columns here, since those are contiguous.
    LAPACKFullMatrix<double> matrix(size, size), rows_of_rhs(n_motions, size);
    RowAssembler             assembler(placed, fluxes);
    const unsigned int       rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int       n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    for (unsigned int i = size * rank / n_ranks; i < size * (rank + 1) / n_ranks; ++i)
    {
      assembler.assemble(i, &matrix(0, i), &rows_of_rhs(0, i));
      double sum = 1.;
      for (unsigned int j = 0; j < size; ++j)
      {
        sum += j != i ? matrix(j, i) : 0.;
        matrix(j, i) *= -1.;
      }
      matrix(i, i) = sum;
    }
    exchange_columns(matrix, size, communicator);
    exchange_columns(rows_of_rhs, size, communicator);
    cost.assembly += timer.cpu_time();

    timer.restart();
    LAPACKFullMatrix<double> solution(size, n_motions);
    for (unsigned int i = 0; i < size; ++i)
      for (unsigned int l = 0; l < n_motions; ++l)
        solution(i, l) = -rows_of_rhs(l, i);
    matrix.compute_lu_factorization();
    matrix.solve(solution, /*transposed*/ true);
    cost.solution += timer.cpu_time();

    return collect(placed, fluxes, solution);
  }
} // namespace caudal::potential
