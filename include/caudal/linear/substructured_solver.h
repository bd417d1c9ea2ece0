#ifndef caudal_linear_substructured_solver_h
#define caudal_linear_substructured_solver_h

#include <caudal/base/types.h>
#include <caudal/linear/direct_solver.h>
#include <caudal/linear/multifrontal_solver.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <optional>

namespace caudal
{
  /**
   * Direct solver of all ranks by substructuring (Przemieniecki 1963, doi:10.2514/3.1728): each
   * rank eliminates the unknowns that no other rank's entries touch, the Schur complements of
   * all ranks add up to the dense matrix of the interface between them, and every rank
   * factorises that one. Where the order of elimination has no sound pivots, as with bodies whose
   * nodes are closer than the fluid's, rank 0 eliminates all unknowns in another one. Nothing
   * depends on the order in which messages arrive: equal runs give equal bits. Every member
   * function is collective over the communicator.
   */
  class SubstructuredSolver
  {
  public:
    explicit SubstructuredSolver(MPI_Comm communicator);

    /**
     * Divides the unknowns that have a place: each rank gives the @p positions of the next ones,
     * by which they are cut into one strip for each rank. The factors are forgotten.
     */
    void set_positions(const std::vector<double> &positions);

    /**
     * Orders and factorises the matrix that is the sum of all ranks' parts (indices from 0).
     * Unknowns behind those with a position go to where their neighbours are; they have no
     * elements. Groups of consecutive unknowns stay together: @p group_begins has their first
     * unknowns, and behind them the number of all unknowns. Those of a group have one position, or
     * none.
     * Throws on all ranks if the matrix is singular or memory runs out on one of them.
     */
    void factorize(const std::vector<int> &group_begins, const MatrixParts &parts);

    /**
     * Replaces @p vector by the solution: the unknowns in their order, block by block and rank
     * by rank.
     */
    void solve(BlockFieldVector &vector);

    /** Entries of the factors, over all ranks. */
    double get_factor_entries() const
    {
      return n_factor_entries;
    }

    bool is_factorized() const
    {
      return factorized;
    }

    /** Forgets the factors. */
    void clear()
    {
      factorized = false;
    }

    /** Forgets everything: what is solved next does not depend on what was before. */
    void reset();

    /**
     * What a factorisation costs, in units of a solution: estimated by the operations and
     * entries of the factors, so that equal matrices give equal numbers.
     */
    double get_factorisation_cost() const
    {
      return factorisation_cost;
    }

  private:
    const MPI_Comm     communicator;
    const unsigned int rank, n_ranks;

    bool   factorized         = false;
    double n_factor_entries   = 0;
    double factorisation_cost = 0;

    /** Positions of all ranks' unknowns, and the unknowns in their order. */
    std::vector<double> positions;
    std::vector<int>    sorted_unknowns;
    /** Whether each rank has a strip; else rank 0 has all, and exchanges pivots. */
    bool in_strips = true;
    /** Shares of the ranks in what the strips are estimated to cost. */
    std::vector<double> shares;

    MultifrontalSolver          interior;
    std::optional<DirectSolver> exchanging_solver;
    /** This rank's unknowns: those it eliminates, then those of the interface. */
    std::vector<int> unknowns;
    unsigned int     n_interior = 0;
    /** The whole interface, in the order of its matrix, and the places there of this rank's. */
    std::vector<int>                 interface_unknowns, interface_places;
    dealii::LAPACKFullMatrix<double> interface_matrix;

    /** Returns whether the pivots are sound. */
    bool try_to_factorize(const std::vector<int> &group_begins, const MatrixParts &parts);
    void factorize_interface(const MatrixParts &matrix);
    /** Learns from what the elimination took, so that the ranks finish together next time. */
    void draw_conclusions();
  };
} // namespace caudal

#endif
