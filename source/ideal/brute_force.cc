// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/ideal/stroke_model.h>

#include <map>

namespace caudal::ideal
{
  namespace
  {
    class BruteForce : public StrokeModel
    {
    public:
      BruteForce(SwimmingShape &shape, const double increment)
          : shape(shape)
          , increment(increment)
      {}

      MotionCoefficients compute_motion(const double argument) override
      {
        return get(argument).state.motion;
      }

      StrokeState compute_state(const double argument) override
      {
        return get(argument).state;
      }

      std::vector<double> compute_torques(const double argument, const Drive &drive) override
      {
        const std::vector<double> before = get(argument - increment).state.torques.momenta;
        std::vector<double>       rates  = get(argument + increment).state.torques.momenta;
        for (std::size_t k = 0; k < rates.size(); ++k)
          rates[k] = (rates[k] - before[k]) / (2. * increment);
        const StrokeState &at = get(argument).state;
        return compute_lagrange_torques(at.torques, rates, at.rates.size(), drive);
      }

      Tensor<1, 3> compute_centre_rate(const double argument) override
      {
        const Tensor<1, 3> before = get(argument - increment).state.centre;
        return (get(argument + increment).state.centre - before) / (2. * increment);
      }

      FullMatrix<double> compute_potentials(const double argument) override
      {
        return get(argument).potentials;
      }

    private:
      struct Solution
      {
        StrokeState        state;
        FullMatrix<double> potentials;
      };

      /** Solves, unless the argument is one of the last few. */
      const Solution &get(const double argument)
      {
        auto known = solutions.find(argument);
        if (known == solutions.end())
        {
          Solution solution;
          solution.state = shape.compute_state(argument, &solution.potentials);
          if (solutions.size() > 8)
            solutions.erase(solutions.begin());
          known = solutions.emplace(argument, std::move(solution)).first;
        }
        return known->second;
      }

      SwimmingShape             &shape;
      const double               increment;
      std::map<double, Solution> solutions; // by argument
    };
  } // namespace

  std::unique_ptr<StrokeModel> create_brute_force(SwimmingShape &shape, const double increment)
  {
    return std::make_unique<BruteForce>(shape, increment);
  }
} // namespace caudal::ideal
