#include <caudal/ideal/stroke_model.h>

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
      struct Entry
      {
        double             argument;
        StrokeState        state;
        FullMatrix<double> potentials;
      };

      /** Computes it, unless it is one of the last few. */
      const Entry &get(const double argument)
      {
        for (const auto &entry : entries)
          if (entry->argument == argument)
            return *entry;
        auto entry      = std::make_unique<Entry>();
        entry->argument = argument;
        entry->state    = shape.compute_state(argument, &entry->potentials);
        if (entries.size() > 8)
          entries.erase(entries.begin());
        entries.push_back(std::move(entry));
        return *entries.back();
      }

      SwimmingShape                      &shape;
      const double                        increment;
      std::vector<std::unique_ptr<Entry>> entries;
    };
  } // namespace

  std::unique_ptr<StrokeModel> create_brute_force(SwimmingShape &shape, const double increment)
  {
    return std::make_unique<BruteForce>(shape, increment);
  }
} // namespace caudal::ideal
