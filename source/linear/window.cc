// SPDX-License-Identifier: LGPL-2.1-or-later
#include "window.h"

#include <algorithm>

using namespace dealii;

namespace caudal
{
  Window::Window(const IndexSet &owned, const std::vector<types::global_dof_index> &indices,
                 const MPI_Comm communicator)
  {
    std::vector<types::global_dof_index> sorted = indices;
    std::sort(sorted.begin(), sorted.end()); // else each would move those behind it
    IndexSet all(owned.size());
    all.add_indices(sorted.begin(), sorted.end());
    layout = std::make_shared<Utilities::MPI::Partitioner>(owned, all, communicator);
    for (const auto i : indices)
      places.push_back(layout->global_to_local(i));
  }

  Vector<double> Window::read(const FieldVector &vector) const
  {
    FieldVector values(layout);
    values.copy_locally_owned_data_from(vector);
    values.update_ghost_values();
    Vector<double> entries(places.size());
    for (unsigned int k = 0; k < places.size(); ++k)
      entries[k] = values.local_element(places[k]);
    return entries;
  }

  void Window::add(const Vector<double> &entries, FieldVector &vector) const
  {
    FieldVector values(layout);
    for (unsigned int k = 0; k < places.size(); ++k)
      values.local_element(places[k]) = entries[k];
    values.compress(VectorOperation::add);
    for (unsigned int i = 0; i < vector.locally_owned_size(); ++i)
      vector.local_element(i) += values.local_element(i);
  }
} // namespace caudal
