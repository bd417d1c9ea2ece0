// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_linear_inner_products_h
#define caudal_linear_inner_products_h

#include <deal.II/lac/block_vector.h>
#include <deal.II/lac/la_parallel_block_vector.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace caudal
{
  /**
   * The inner products of a vector with others of its kind, by one reduction over the ranks where
   * one at a time would take as many as there are vectors. Instantiated for the serial and
   * distributed vectors and block vectors of deal.II. Collective.
   */
  template <typename VectorType>
  std::vector<double> compute_inner_products(const std::vector<const VectorType *> &vectors,
                                             const VectorType                      &vector);
} // namespace caudal

#endif
