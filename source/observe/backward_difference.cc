#include <caudal/observe/backward_difference.h>

namespace caudal
{
  template <int dim>
  void BackwardDifference<dim>::add(const double time, const Tensor<1, dim> &value)
  {
    samples.emplace_back(time, value);
    if (samples.size() > 3)
      samples.pop_front();
  }

  template <int dim>
  void BackwardDifference<dim>::shift(const Tensor<1, dim> &jump)
  {
    for (auto &sample : samples)
      sample.second += jump;
  }

  template <int dim>
  Tensor<1, dim> BackwardDifference<dim>::get_derivative() const
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

  template <int dim>
  Tensor<1, dim> BackwardDifference<dim>::get_change() const
  {
    const unsigned int n = samples.size();
    return n < 2 ? Tensor<1, dim>() : samples[n - 1].second - samples[n - 2].second;
  }

  template <int dim>
  double BackwardDifference<dim>::get_step() const
  {
    const unsigned int n = samples.size();
    return n < 2 ? 0. : samples[n - 1].first - samples[n - 2].first;
  }

  template class BackwardDifference<2>;
  template class BackwardDifference<3>;
} // namespace caudal
