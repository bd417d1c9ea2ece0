#ifndef caudal_base_direct_solver_h
#define caudal_base_direct_solver_h

#include <caudal/base/types.h>

#include <memory>
#include <vector>

namespace caudal
{
  /**
   * Distributed sparse direct solver: a thin layer over MUMPS (Amestoy et al.
   * 2001, doi:10.1137/S0895479899358194) that takes the matrix as triplets, so
   * that a matrix composed of several operators never has to be put together.
   * Every member function is collective over the communicator.
   */
  class DirectSolver
  {
  public:
    enum class Symmetry
    {
      general,
      /** Only entries on and above the diagonal are read. */
      symmetric
    };

    /**
     * @p on_root: rank 0 factorises the matrix of all ranks alone. Several ranks add up in
     * the order in which their messages arrive, so that round-off differs from run to run.
     */
    explicit DirectSolver(MPI_Comm communicator, Symmetry symmetry = Symmetry::general,
                          bool on_root = false);
    ~DirectSolver();

    /**
     * Orders and factorises the @p n x @p n matrix that is the sum of all
     * entries of all ranks (indices from 0; @p entries is left unchanged). Unknowns are
     * ordered in groups of @p group_size with consecutive indices, such as the components of a
     * velocity: that is cheaper than one by one.
     * Throws if the matrix is singular or memory runs out.
     */
    void factorize(int n, Triplets &entries, unsigned int group_size = 1);

    /** Replaces @p vector, its blocks one after the other, by the solution. */
    void solve(BlockFieldVector &vector);

    /** Entries of the factors, over all ranks. */
    double get_factor_entries() const;

    bool is_factorized() const;

    /** Forgets the factors. */
    void clear();

    /** Forgets everything: what is solved next does not depend on what was before. */
    void reset();

    /**
     * What a factorisation costs, in units of a solution: estimated by the operations and
     * entries of the factors, so that equal matrices give equal numbers.
     */
    double get_factorisation_cost() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> mumps;
  };
} // namespace caudal

#endif
