// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_instant_h
#define caudal_fluid_instant_h

#include <deal.II/base/function.h>
#include <deal.II/base/tensor.h>

#include <memory>

namespace caudal
{
  using namespace dealii;

  /** A vector of the domain; those of a plane have zeros at the end. */
  using DomainVector = Tensor<1, 3>;

  /** The first components, all that the vector has in this dimension. */
  template <int dim>
  Tensor<1, dim> restrict_to(const DomainVector &vector)
  {
    Tensor<1, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = vector[d];
    return result;
  }

  /**
   * A time [s], and where the grid is then: it moves rigidly, and its place x is x + origin [m] in
   * the laboratory's frame.
   */
  struct Instant
  {
    double       time = 0;
    DomainVector origin;

    bool operator==(const Instant &other) const
    {
      return time == other.time && origin == other.origin;
    }
    bool operator!=(const Instant &other) const
    {
      return !(*this == other);
    }
  };

  /** A function of places in the laboratory's frame as one of the grid's places. */
  template <int dim>
  class FunctionOnGrid : public Function<dim>
  {
  public:
    FunctionOnGrid(std::unique_ptr<Function<dim>> function, const DomainVector &origin)
        : Function<dim>(function->n_components)
        , function(std::move(function))
        , origin(restrict_to<dim>(origin))
    {}

    double value(const Point<dim> &place, const unsigned int component) const override
    {
      return function->value(place + origin, component);
    }

  private:
    const std::unique_ptr<Function<dim>> function;
    const Tensor<1, dim>                 origin;
  };
} // namespace caudal

#endif
