// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_source_linear_window_h
#define caudal_source_linear_window_h

#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/vector.h>

#include <memory>
#include <vector>

namespace caudal
{
  /** Some entries of distributed vectors, which this rank reads and adds to. */
  class Window
  {
  public:
    using FieldVector = dealii::LinearAlgebra::distributed::Vector<double>;

    Window() = default;

    /** Onto the entries @p indices of vectors of which this rank owns @p owned. Collective. */
    Window(const dealii::IndexSet                             &owned,
           const std::vector<dealii::types::global_dof_index> &indices, MPI_Comm communicator);

    /** The entries, in the order of the indices. Collective. */
    dealii::Vector<double> read(const FieldVector &vector) const;

    /** Adds to the entries of @p vector what this and other ranks give for them. Collective. */
    void add(const dealii::Vector<double> &entries, FieldVector &vector) const;

  private:
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> layout; // with the entries
    std::vector<unsigned int>                                  places;
  };
} // namespace caudal

#endif
