// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/linear/inner_products.h>

#include <deal.II/base/mpi.h>

using namespace dealii;

namespace caudal
{
  namespace
  {
    using DistributedVector      = LinearAlgebra::distributed::Vector<double>;
    using DistributedBlockVector = LinearAlgebra::distributed::BlockVector<double>;

    double multiply(const double *a, const double *b, const std::size_t n)
    {
      double sum = 0;
#pragma omp simd reduction(+ : sum)
      for (std::size_t i = 0; i < n; ++i)
        sum += a[i] * b[i];
      return sum;
    }

    double multiply_own_parts(const Vector<double> &a, const Vector<double> &b)
    {
      return multiply(a.begin(), b.begin(), a.size());
    }

    double multiply_own_parts(const DistributedVector &a, const DistributedVector &b)
    {
      return multiply(a.begin(), b.begin(), a.locally_owned_size());
    }

    template <typename BlockVectorType>
    double multiply_own_parts(const BlockVectorType &a, const BlockVectorType &b)
    {
      double sum = 0;
      for (unsigned int block = 0; block < a.n_blocks(); ++block)
        sum += multiply_own_parts(a.block(block), b.block(block));
      return sum;
    }

    MPI_Comm get_communicator(const DistributedVector &vector)
    {
      return vector.get_mpi_communicator();
    }

    MPI_Comm get_communicator(const DistributedBlockVector &vector)
    {
      return get_communicator(vector.block(0));
    }

    template <typename SerialVector>
    MPI_Comm get_communicator(const SerialVector &)
    {
      return MPI_COMM_SELF;
    }
  } // namespace

  template <typename VectorType>
  std::vector<double> compute_inner_products(const std::vector<const VectorType *> &vectors,
                                             const VectorType                      &vector)
  {
    std::vector<double> products;
    for (const VectorType *other : vectors)
      products.push_back(multiply_own_parts(*other, vector));
    Utilities::MPI::sum(products, get_communicator(vector), products);
    return products;
  }

  template std::vector<double> compute_inner_products(const std::vector<const Vector<double> *> &,
                                                      const Vector<double> &);
  template std::vector<double>
  compute_inner_products(const std::vector<const BlockVector<double> *> &,
                         const BlockVector<double> &);
  template std::vector<double>
  compute_inner_products(const std::vector<const DistributedVector *> &, const DistributedVector &);
  template std::vector<double>
  compute_inner_products(const std::vector<const DistributedBlockVector *> &,
                         const DistributedBlockVector &);
} // namespace caudal
