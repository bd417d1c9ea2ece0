// SPDX-License-Identifier: LGPL-2.1-or-later
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
    void add(const double time, const Tensor<1, dim> &value)
    {
      samples.emplace_back(time, value);
      if (samples.size() > 3)
        samples.pop_front();
    }

    /** Adds @p jump to all samples so far, so that it does not count as a change. */
    void shift(const Tensor<1, dim> &jump)
    {
      for (auto &sample : samples)
        sample.second += jump;
    }

    /** The derivative; first order from two samples, zero from one. */
    Tensor<1, dim> get_derivative() const
    {
      if (samples.size() < 2)
        return Tensor<1, dim>();
      const Tensor<1, dim> slope = get_change() / get_step();
      if (samples.size() == 2)
        return slope;
      // The derivative at its last point of the parabola through the three samples.
      const auto &[first_time, first]   = samples[0];
      const auto &[middle_time, middle] = samples[1];
      const Tensor<1, dim> old_slope    = (middle - first) / (middle_time - first_time);
      return slope + get_step() / (samples[2].first - first_time) * (slope - old_slope);
    }

    /** Change between the last two samples, zero if there are not two. */
    Tensor<1, dim> get_change() const
    {
      const std::size_t n = samples.size();
      return n < 2 ? Tensor<1, dim>() : samples[n - 1].second - samples[n - 2].second;
    }

    /** Time between the last two samples, zero if there are not two. */
    double get_step() const
    {
      const std::size_t n = samples.size();
      return n < 2 ? 0. : samples[n - 1].first - samples[n - 2].first;
    }

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
