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
    const unsigned int n = samples.size();
    if (n < 2)
      return Tensor<1, dim>();
    const auto slope = [this](const unsigned int i) {
      return (samples[i].second - samples[i - 1].second) /
             (samples[i].first - samples[i - 1].first);
    };
    if (n == 2)
      return slope(1);
    // The derivative at its last point of the parabola through the three samples.
    const double step  = samples[2].first - samples[1].first;
    const double range = samples[2].first - samples[0].first;
    return slope(2) + step / range * (slope(2) - slope(1));
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
