// SPDX-License-Identifier: LGPL-2.1-or-later
#include "own_parts.h"

#include <deal.II/base/mpi.h>

#include <algorithm>

using namespace dealii;

namespace caudal
{
  namespace
  {
    constexpr int single_entry = -1; // in place of an element's number of unknowns
  }

  OwnParts::OwnParts(const MatrixParts &matrix, const std::vector<int> &rank_of,
                     const MPI_Comm communicator)
  {
    const int                       rank = Utilities::MPI::this_mpi_process(communicator);
    std::map<unsigned int, Message> messages;
    for (const ElementMatrix &element : matrix.elements)
    {
      int target = rank_of[element.unknowns[0]];
      for (int i = 1; i < element.n; ++i)
        target = std::min(target, rank_of[element.unknowns[i]]);
      if (target == rank)
      {
        add(element);
        continue;
      }
      auto &[indices, values] = messages[target];
      indices.push_back(element.n);
      indices.insert(indices.end(), element.unknowns, element.unknowns + element.n);
      values.insert(values.end(), element.values, element.values + element.n_entries());
    }
    const auto &[rows, columns, entries] = matrix.entries;
    for (std::size_t k = 0; k < entries.size(); ++k)
    {
      const int target = std::min(rank_of[rows[k]], rank_of[columns[k]]);
      if (target == rank)
      {
        parts.entries.add(rows[k], columns[k], entries[k]);
        continue;
      }
      auto &[indices, values] = messages[target];
      indices.insert(indices.end(), {single_entry, rows[k], columns[k]});
      values.push_back(entries[k]);
    }

    received = Utilities::MPI::some_to_some(communicator, messages);
    for (const auto &[source, message] : received)
      unpack(message);
    const int *begin = unknowns.data(); // which grow no more
    for (ElementMatrix &element : parts.elements)
    {
      element.unknowns = begin;
      begin += element.n;
    }
  }

  /** The unknowns are copied; where they are follows when all are there. */
  void OwnParts::add(const ElementMatrix &element)
  {
    unknowns.insert(unknowns.end(), element.unknowns, element.unknowns + element.n);
    parts.elements.push_back({element.n, nullptr, element.values});
  }

  void OwnParts::unpack(const Message &message)
  {
    const double *value = message.values.data();
    const int    *end   = message.indices.data() + message.indices.size();
    for (const int *index = message.indices.data(); index != end;)
      if (*index == single_entry)
      {
        parts.entries.add(index[1], index[2], *value);
        index += 3;
        ++value;
      }
      else
      {
        const ElementMatrix element{*index, index + 1, value};
        add(element);
        index += 1 + element.n;
        value += element.n_entries();
      }
  }

  void OwnParts::renumber(const std::vector<int> &new_index)
  {
    for (auto *indices : {&unknowns, &parts.entries.rows, &parts.entries.columns})
      for (int &index : *indices)
        index = new_index[index];
  }
} // namespace caudal
