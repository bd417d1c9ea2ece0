#include <caudal/base/direct_solver.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <dmumps_c.h>

using namespace dealii;

namespace caudal
{
  namespace
  {
    // Values of MUMPS' `job`.
    constexpr int job_initialise = -1, job_end = -2, job_analyse_factorise = 4, job_solve = 3;
  } // namespace

  struct DirectSolver::Implementation
  {
    Implementation(MPI_Comm communicator, const Symmetry symmetry, const bool on_root)
        : communicator(communicator)
        , symmetry(symmetry)
        , on_root(on_root)
        , rank(Utilities::MPI::this_mpi_process(communicator))
    {
      data.comm_fortran = MPI_Comm_c2f(on_root ? MPI_COMM_SELF : communicator);
      data.sym          = symmetry == Symmetry::general ? 0 : 2;
      data.par          = 1;
      data.job          = job_initialise;
      dmumps_c(&data);
      for (const int channel : {1, 2, 3})
        set_control(channel, -1);
      set_control(4, 0); // no messages
      // Rows stay where the caller put them: what is zero on the diagonal, for the bodies'
      // force densities, fills in when their neighbours are eliminated.
      set_control(6, 0);
      set_control(18, is_distributed() ? 3 : 0);
      set_control(10, 0); // no iterative refinement: the caller iterates
      // Pivots move only where they are tiny: the augmented and the bodies' rows
      // would else delay each other (three times the time). The caller checks
      // the residual.
      data.cntl[0] = 1e-6;
    }

    ~Implementation()
    {
      data.job = job_end;
      dmumps_c(&data);
    }

    /** Lets MUMPS do its work; what it tells is the same on all ranks. */
    void run(const int job)
    {
      data.job = job;
      if (!on_root || rank == 0)
        dmumps_c(&data);
      if (on_root)
      {
        MPI_Bcast(data.infog, std::size(data.infog), MPI_INT, 0, communicator);
        MPI_Bcast(data.rinfog, std::size(data.rinfog), MPI_DOUBLE, 0, communicator);
      }
    }

    /** Moves all ranks' entries to rank 0, one rank after the other. */
    void collect(Triplets &entries) const
    {
      const auto collect_one = [&](auto &part) {
        const auto parts = Utilities::MPI::gather(communicator, part);
        part.clear();
        for (const auto &one : parts)
          part.insert(part.end(), one.begin(), one.end());
      };
      collect_one(entries.rows);
      collect_one(entries.columns);
      collect_one(entries.values);
    }

    /** Whether MUMPS gets the matrix from several ranks. */
    bool is_distributed() const
    {
      return !on_root && Utilities::MPI::n_mpi_processes(communicator) > 1;
    }

    /** The matrix, which has to live until MUMPS has factorised it. */
    void set_matrix(Triplets &entries)
    {
      if (is_distributed())
      {
        data.nnz_loc = entries.values.size();
        data.irn_loc = entries.rows.data();
        data.jcn_loc = entries.columns.data();
        data.a_loc   = entries.values.data();
      }
      else
      {
        data.nnz = entries.values.size();
        data.irn = entries.rows.data();
        data.jcn = entries.columns.data();
        data.a   = entries.values.data();
      }
    }

    /** Groups of @p group_size unknowns are ordered as one; the last may be smaller. */
    void set_groups(const unsigned int group_size)
    {
      group_begins.clear();
      for (int first = 1; first <= data.n; first += group_size)
        group_begins.push_back(first);
      data.nblk = group_begins.size();
      group_begins.push_back(data.n + 1);
      data.blkptr = group_begins.data();
      set_control(15, 1);
    }

    void set_control(const int number, const int value)
    {
      data.icntl[number - 1] = value;
    }

    MPI_Comm           communicator;
    const Symmetry     symmetry;
    const bool         on_root;
    const unsigned int rank;
    DMUMPS_STRUC_C     data{};
    std::vector<int>   group_begins;
    bool               factorized = false;
  };

  DirectSolver::DirectSolver(MPI_Comm communicator, const Symmetry symmetry, const bool on_root)
      : mumps(std::make_unique<Implementation>(communicator, symmetry, on_root))
  {}

  DirectSolver::~DirectSolver() = default;

  void DirectSolver::factorize(const int n, Triplets &entries, const unsigned int group_size)
  {
    Triplets kept;
    for (std::size_t k = 0; k < entries.values.size(); ++k)
      if (mumps->data.sym == 0 || entries.rows[k] <= entries.columns[k])
        kept.add(entries.rows[k] + 1, entries.columns[k] + 1, entries.values[k]);
    if (mumps->on_root)
      mumps->collect(kept);

    DMUMPS_STRUC_C &data = mumps->data;
    data.n               = n;
    mumps->factorized    = false;
    mumps->set_matrix(kept);
    mumps->set_groups(group_size);

    // Approximate minimum fill orders small matrices faster than METIS, whose
    // nested dissection pays off in the factorisation of larger ones.
    mumps->set_control(7, n < 60000 ? 2 : 5);
    // MUMPS may underestimate the working space: -8 and -9 ask for more.
    for (const int extra_space : {30, 100, 300})
    {
      mumps->set_control(14, extra_space);
      mumps->run(job_analyse_factorise);
      if (data.infog[0] != -8 && data.infog[0] != -9)
        break;
    }
    AssertThrow(data.infog[0] >= 0,
                ExcMessage("The direct solver (MUMPS) could not factorise the " +
                           std::to_string(n) + " x " + std::to_string(n) +
                           " matrix: INFOG(1) = " + std::to_string(data.infog[0]) +
                           ", INFOG(2) = " + std::to_string(data.infog[1]) +
                           " (-10: singular, -13: out of memory)."));
    mumps->factorized = true;
  }

  void DirectSolver::solve(BlockFieldVector &vector)
  {
    Assert(mumps->factorized, ExcMessage("factorize() comes before solve()."));
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(mumps->communicator);

    std::vector<double> everything(mumps->rank == 0 ? vector.size() : 0);
    const auto          for_each_block = [&](const auto &transfer) {
      std::size_t offset = 0;
      for (unsigned int b = 0; b < vector.n_blocks(); ++b)
      {
        FieldVector     &block = vector.block(b);
        const int        count = block.locally_owned_size();
        const int        begin = block.get_partitioner()->local_range().first;
        std::vector<int> counts(n_ranks), begins(n_ranks);
        MPI_Gather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, mumps->communicator);
        MPI_Gather(&begin, 1, MPI_INT, begins.data(), 1, MPI_INT, 0, mumps->communicator);
        transfer(block, count, counts, begins, everything.data() + offset);
        offset += block.size();
      }
    };
    for_each_block([&](FieldVector &block, int count, auto &counts, auto &begins, double *data) {
      MPI_Gatherv(block.begin(), count, MPI_DOUBLE, data, counts.data(), begins.data(), MPI_DOUBLE,
                  0, mumps->communicator);
    });
    mumps->data.rhs  = everything.data();
    mumps->data.nrhs = 1;
    mumps->data.lrhs = vector.size();
    mumps->run(job_solve);
    AssertThrow(mumps->data.infog[0] >= 0,
                ExcMessage("The direct solver (MUMPS) failed in the solution phase: INFOG(1) = " +
                           std::to_string(mumps->data.infog[0]) + "."));
    for_each_block([&](FieldVector &block, int count, auto &counts, auto &begins, double *data) {
      MPI_Scatterv(data, counts.data(), begins.data(), MPI_DOUBLE, block.begin(), count, MPI_DOUBLE,
                   0, mumps->communicator);
    });
  }

  double DirectSolver::get_factor_entries() const
  {
    const double entries = mumps->data.infog[28];
    return entries < 0 ? -1e6 * entries : entries;
  }

  double DirectSolver::get_factorisation_cost() const
  {
    return mumps->data.rinfog[2] / get_factor_entries();
  }

  bool DirectSolver::is_factorized() const
  {
    return mumps->factorized;
  }

  void DirectSolver::reset()
  {
    mumps = std::make_unique<Implementation>(mumps->communicator, mumps->symmetry, mumps->on_root);
  }

  void DirectSolver::clear()
  {
    mumps->factorized = false;
  }
} // namespace caudal
