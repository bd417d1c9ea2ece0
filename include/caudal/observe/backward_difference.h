#ifndef caudal_observe_backward_difference_h
#define caudal_observe_backward_difference_h

#include <deal.II/base/tensor.h>

#include <boost/serialization/deque.hpp>
#include <boost/serialization/utility.hpp>

#include <deque>

namespace caudal
{
  using namespace dealii;

  /** Time derivative of sampled values at the last of them, from the last three: second order. */
  template <int dim>
  class BackwardDifference
  {
  public:
    void add(double time, const Tensor<1, dim> &value);

    /** Adds @p jump to all samples so far, so that it does not count as a change. */
    void shift(const Tensor<1, dim> &jump);

    /** The derivative; first order from two samples, zero from one. */
    Tensor<1, dim> get_derivative() const;

    /** Change between the last two samples, zero if there are not two. */
    Tensor<1, dim> get_change() const;

    /** Time between the last two samples, zero if there are not two. */
    double get_step() const;

    bool is_empty() const
    {
      return samples.empty();
    }

    const Tensor<1, dim> &get_last() const
    {
      return samples.back().second;
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &samples;
    }

  private:
    std::deque<std::pair<double, Tensor<1, dim>>> samples;
  };
} // namespace caudal

#endif
