// SPDX-License-Identifier: LGPL-2.1-or-later
#include "near_division.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <numeric>

using namespace dealii;

namespace caudal
{
  namespace
  {
    /** Coordinates of points along the axis along which they reach farthest. */
    std::vector<double> project(const std::vector<double> &positions, const unsigned int dim)
    {
      const unsigned int  n_points = positions.size() / dim;
      std::vector<double> longest(n_points);
      double              length = -1;
      for (unsigned int d = 0; d < dim && n_points > 0; ++d)
      {
        std::vector<double> coordinates;
        for (unsigned int k = 0; k < n_points; ++k)
          coordinates.push_back(positions[k * dim + d]);
        const auto [least, largest] = std::minmax_element(coordinates.begin(), coordinates.end());
        if (*largest - *least > length)
        {
          length  = *largest - *least;
          longest = std::move(coordinates);
        }
      }
      return longest;
    }

    /** Slices of equal numbers of points; points in a plane across stay together. */
    std::vector<unsigned int> slice(const std::vector<double> &coordinates,
                                    const unsigned int         n_slices)
    {
      std::vector<double> sorted = coordinates, cuts;
      std::sort(sorted.begin(), sorted.end());
      for (unsigned int k = 1; k < n_slices; ++k)
        cuts.push_back(sorted[k * sorted.size() / n_slices] -
                       1e-6 * (sorted.back() - sorted.front()));
      std::vector<unsigned int> slices;
      for (const double coordinate : coordinates)
        slices.push_back(std::upper_bound(cuts.begin(), cuts.end(), coordinate) - cuts.begin());
      return slices;
    }
  } // namespace

  NearDivision::NearDivision(const NearMatrices &matrices, const unsigned int smallest,
                             const MPI_Comm communicator)
  {
    const std::vector<BodyPlaces> &bodies = matrices.bodies;
    const unsigned int             dim    = bodies.front().n_components;
    const unsigned int             n_q    = matrices.n_q;
    std::vector<double>            all    = matrices.positions;
    std::vector<int>               forces; // their places among x
    for (const BodyPlaces &body : bodies)
      for (unsigned int i = 0; i < body.force.size(); ++i)
      {
        forces.push_back(body.force[i]);
        const auto node = body.positions.begin() + i / dim * dim;
        all.insert(all.end(), node, node + dim);
      }
    const unsigned int              rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int              n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int              n       = n_q + forces.size();
    const std::vector<unsigned int> slices =
        slice(project(all, dim), std::clamp(n / smallest, 1u, n_ranks));

    std::vector<int> next(n_ranks + 1); // number in each slice
    for (const unsigned int slice : slices)
      ++next[slice + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    owned = IndexSet(n);
    owned.add_range(next[rank], next[rank + 1]);
    place_of_x.assign(matrices.owned_x.size(), -1);
    is_force.resize(n);
    for (unsigned int k = 0; k < n; ++k)
    {
      const int place = next[slices[k]]++;
      is_force[place] = k >= n_q;
      if (k >= n_q)
        place_of_x[forces[k - n_q]] = place;
      else
      {
        place_of_q.push_back(place);
        if (slices[k] == rank)
          own_q.push_back(k);
      }
    }

    auto of_force = slices.begin() + n_q;
    for (unsigned int b = 0; b < bodies.size(); ++b)
    {
      std::vector<unsigned int> numbers(n_ranks);
      for (unsigned int i = 0; i < bodies[b].force.size(); ++i)
        ++numbers[*of_force++];
      if (std::max_element(numbers.begin(), numbers.end()) - numbers.begin() == rank)
        own_bodies.push_back(b);
    }
  }
} // namespace caudal
