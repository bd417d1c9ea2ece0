#include <caudal/linear/own_parts.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

using namespace dealii;

namespace caudal
{
  namespace
  {
    /** In messages in place of an element's number of unknowns. */
    constexpr int single_entry = -1;

    /** What goes to other ranks: (number of unknowns, unknowns) or (single_entry, row, column). */
    struct Messages
    {
      std::map<unsigned int, std::vector<int>>    indices;
      std::map<unsigned int, std::vector<double>> values;

      void add(const unsigned int target, const ElementMatrix &element)
      {
        std::vector<int>    &target_indices = indices[target];
        std::vector<double> &target_values  = values[target];
        target_indices.push_back(element.n);
        target_indices.insert(target_indices.end(), element.unknowns, element.unknowns + element.n);
        target_values.insert(target_values.end(), element.values,
                             element.values + element.n_entries());
      }

      void add(const unsigned int target, const int row, const int column, const double value)
      {
        std::vector<int> &target_indices = indices[target];
        target_indices.insert(target_indices.end(), {single_entry, row, column});
        values[target].push_back(value);
      }
    };
  } // namespace

  OwnParts::OwnParts(const MatrixParts &matrix, const std::vector<int> &rank_of,
                     MPI_Comm communicator)
  {
    const int rank = Utilities::MPI::this_mpi_process(communicator);
    Messages  messages;
    for (const ElementMatrix &element : matrix.elements)
    {
      int target = rank_of[element.unknowns[0]];
      for (int i = 1; i < element.n; ++i)
        target = std::min(target, rank_of[element.unknowns[i]]);
      if (target == rank)
        add(element);
      else
        messages.add(target, element);
    }
    const auto &[rows, columns, values] = matrix.entries;
    for (std::size_t k = 0; k < values.size(); ++k)
    {
      const int target = std::min(rank_of[rows[k]], rank_of[columns[k]]);
      if (target == rank)
        parts.entries.add(rows[k], columns[k], values[k]);
      else
        messages.add(target, rows[k], columns[k], values[k]);
    }

    const auto indices = Utilities::MPI::some_to_some(communicator, messages.indices);
    received_values    = Utilities::MPI::some_to_some(communicator, messages.values);
    for (const auto &[source, received] : indices)
      unpack(received, received_values.at(source));
    const int *begin = unknowns.data();
    for (ElementMatrix &element : parts.elements)
    {
      element.unknowns = begin;
      begin += element.n;
    }
  }

  void OwnParts::add(const ElementMatrix &element)
  {
    unknowns.insert(unknowns.end(), element.unknowns, element.unknowns + element.n);
    parts.elements.push_back({element.n, nullptr, element.values});
  }

  void OwnParts::unpack(const std::vector<int> &indices, const std::vector<double> &values)
  {
    const double *value = values.data();
    for (const int *index = indices.data(); index != indices.data() + indices.size();)
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
