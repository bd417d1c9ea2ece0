#include <caudal/linear/direct_solver.h>

#include <deal.II/base/exceptions.h>

#include <dmumps_c.h>
#include <mpi.h>

#include <algorithm>

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
    Implementation()
    {
      data.comm_fortran = MPI_Comm_c2f(MPI_COMM_SELF);
      data.sym          = 0;
      data.par          = 1;
      data.job          = job_initialise;
      dmumps_c(&data);
      for (const int channel : {1, 2, 3})
        set_control(channel, -1);
      set_control(4, 0); // no messages
      // Rows stay where the caller put them: what is zero on the diagonal, for the bodies'
      // force densities, fills in when their neighbours are eliminated.
      set_control(6, 0);
      set_control(10, 0); // no iterative refinement: the caller iterates
      set_control(15, 1); // unknowns come in groups
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

    void run(const int job)
    {
      data.job = job;
      dmumps_c(&data);
    }

    void set_matrix(const Triplets &entries)
    {
      rows.resize(entries.rows.size());
      columns.resize(entries.columns.size());
      const auto count_from_one = [](const int index) { return index + 1; };
      std::transform(entries.rows.begin(), entries.rows.end(), rows.begin(), count_from_one);
      std::transform(entries.columns.begin(), entries.columns.end(), columns.begin(),
                     count_from_one);
      data.nnz = entries.values.size();
      data.irn = rows.data();
      data.jcn = columns.data();
      data.a   = const_cast<double *>(entries.values.data()); // MUMPS only reads it
    }

    void set_groups(const std::vector<int> &group_begins)
    {
      begins.resize(group_begins.size());
      std::transform(group_begins.begin(), group_begins.end(), begins.begin(),
                     [](const int index) { return index + 1; });
      data.n      = group_begins.back();
      data.nblk   = begins.size() - 1;
      data.blkptr = begins.data();
    }

    void set_control(const int number, const int value)
    {
      data.icntl[number - 1] = value;
    }

    DMUMPS_STRUC_C   data{};
    std::vector<int> rows, columns, begins;
  };

  DirectSolver::DirectSolver()
      : mumps(std::make_unique<Implementation>())
  {}

  DirectSolver::~DirectSolver() = default;

  void DirectSolver::factorize(const std::vector<int> &group_begins, const Triplets &entries)
  {
    DMUMPS_STRUC_C &data = mumps->data;
    mumps->set_matrix(entries);
    mumps->set_groups(group_begins);
    // Approximate minimum fill: nested dissection (PORD) saves a fifth of the operations in
    // larger systems and takes longer than that.
    mumps->set_control(7, 2);
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
                           std::to_string(data.n) + " x " + std::to_string(data.n) +
                           " matrix: INFOG(1) = " + std::to_string(data.infog[0]) +
                           ", INFOG(2) = " + std::to_string(data.infog[1]) +
                           " (-10: singular, -13: out of memory)."));
  }

  void DirectSolver::solve(std::vector<double> &vector)
  {
    DMUMPS_STRUC_C &data = mumps->data;
    AssertDimension(static_cast<int>(vector.size()), data.n);
    data.rhs  = vector.data();
    data.nrhs = 1;
    data.lrhs = data.n;
    mumps->run(job_solve);
    AssertThrow(data.infog[0] >= 0,
                ExcMessage("The direct solver (MUMPS) failed in the solution phase: INFOG(1) = " +
                           std::to_string(data.infog[0]) + "."));
  }

  double DirectSolver::get_factor_entries() const
  {
    const double entries = mumps->data.infog[28];
    return entries < 0 ? -1e6 * entries : entries;
  }

  double DirectSolver::get_factor_operations() const
  {
    return mumps->data.rinfog[2];
  }
} // namespace caudal
