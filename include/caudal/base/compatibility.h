// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_base_compatibility_h
#define caudal_base_compatibility_h

/**
 * @file
 * What deal.II calls differently in its versions 9.4 to 9.8 and later, under one name.
 */

#include <deal.II/base/config.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#if DEAL_II_VERSION_GTE(9, 7, 0)
#include <deal.II/numerics/solution_transfer.h>
#else
#include <deal.II/distributed/solution_transfer.h>
#endif

namespace caudal::compatibility
{
  using namespace dealii;

  /** Carries a vector of unknowns over to the grid that is refined, on all ranks. */
#if DEAL_II_VERSION_GTE(9, 7, 0)
  template <int dim, class Vector>
  using SolutionTransfer = dealii::SolutionTransfer<dim, Vector>;
#else
  template <int dim, class Vector>
  using SolutionTransfer = parallel::distributed::SolutionTransfer<dim, Vector>;
#endif

  /** The ranks among which a Triangulation or a DoFHandler is distributed. */
  template <class Distributed>
  MPI_Comm get_communicator(const Distributed &object)
  {
#if DEAL_II_VERSION_GTE(9, 7, 0)
    return object.get_mpi_communicator();
#else
    return object.get_communicator();
#endif
  }

  /** No constraints yet, with room for those of all unknowns that this rank has to know. */
  inline AffineConstraints<double> make_constraints([[maybe_unused]] const IndexSet &owned,
                                                    const IndexSet                  &relevant)
  {
#if DEAL_II_VERSION_GTE(9, 6, 0)
    return AffineConstraints<double>(owned, relevant);
#else
    return AffineConstraints<double>(relevant);
#endif
  }

  /** An XDMFEntry of quadrilaterals or hexahedra, as text. */
  template <int dim, class Entry>
  std::string get_xdmf_content(const Entry &entry)
  {
#if DEAL_II_VERSION_GTE(9, 5, 0)
    return entry.get_xdmf_content(0);
#else
    return entry.get_xdmf_content(0, ReferenceCells::get_hypercube<dim>());
#endif
  }
} // namespace caudal::compatibility

#endif
