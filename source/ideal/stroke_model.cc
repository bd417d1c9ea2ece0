// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/ideal/stroke_model.h>

#include <boost/serialization/vector.hpp>

#include <complex>
#include <map>

namespace caudal::ideal
{
  std::vector<double> compute_torques(const StrokeState &state, const StrokeState &state_rate,
                                      const Drive &drive)
  {
    std::vector<double> torques(state.rates.size(), 0.);
    auto                momentum      = state.torques.momenta.begin();
    auto                momentum_rate = state_rate.torques.momenta.begin();
    auto                gradient      = state.torques.energy_gradient.begin();
    for (double &torque : torques)
      for (std::size_t a = 0, n = state.torques.momenta.size() / torques.size(); a < n; ++a)
      {
        torque +=
            *momentum_rate++ * drive.rate * drive.get(a) + *momentum++ * drive.get_derivative(a);
        for (std::size_t b = a; b < n; ++b)
          torque -= *gradient++ * drive.get(a) * drive.get(b);
      }
    return torques;
  }

  std::vector<double> StrokeModel::compute_torques(const double argument, const Drive &drive)
  {
    return ideal::compute_torques(compute_state(argument), compute_state_rate(argument), drive);
  }

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

      StrokeState compute_state_rate(const double argument) override
      {
        StrokeState rate;
        for (const double side : {-1., 1.})
          rate.add(side / (2. * increment), get(argument + side * increment).state);
        return rate;
      }

      FullMatrix<double> compute_potentials(const double argument) override
      {
        return get(argument).potentials;
      }

    private:
      /** Solves, unless the argument is one of the last few. */
      const StrokeSolution &get(const double argument)
      {
        auto known = solutions.find(argument);
        if (known == solutions.end())
        {
          if (solutions.size() > 8)
            solutions.erase(solutions.begin());
          known = solutions.emplace(argument, shape.solve(argument)).first;
        }
        return known->second;
      }

      SwimmingShape                   &shape;
      const double                     increment;
      std::map<double, StrokeSolution> solutions; // by argument
    };

    /** What the mirror y -> -y does to rotations, translations and modes (c -> -c). */
    double get_mirror_sign(const unsigned int motion)
    {
      const double signs[] = {-1., 1., -1., 1., -1., 1.};
      return motion < 6 ? signs[motion] : -1.;
    }

    /** What it does to the drives; the gait's rate stays. */
    double get_drive_sign(const unsigned int drive)
    {
      return drive > 0 ? get_mirror_sign(drive - 1) : 1.;
    }

    StrokeState mirror(StrokeState state, const unsigned int n_drives)
    {
      for (unsigned int i = 0; i < 6; ++i)
      {
        for (unsigned int j = i; j < 6; ++j)
          state.motion.mass[i][j] *= get_mirror_sign(i) * get_mirror_sign(j);
        state.motion.momentum[i] *= get_mirror_sign(i);
      }
      state.centre[1] *= -1.;
      auto momentum = state.torques.momenta.begin();
      while (momentum != state.torques.momenta.end())
        for (unsigned int a = 0; a < n_drives; ++a)
          *momentum++ *= -get_drive_sign(a);
      auto gradient = state.torques.energy_gradient.begin();
      while (gradient != state.torques.energy_gradient.end())
        for (unsigned int a = 0; a < n_drives; ++a)
          for (unsigned int b = a; b < n_drives; ++b)
            *gradient++ *= -get_drive_sign(a) * get_drive_sign(b);
      return state;
    }

    /** @p images are those of the nodes. */
    FullMatrix<double> mirror(const FullMatrix<double>        &potentials,
                              const std::vector<unsigned int> &images)
    {
      FullMatrix<double> result(potentials.m(), potentials.n());
      for (unsigned int node = 0; node < result.m(); ++node)
        for (unsigned int l = 0; l < result.n(); ++l)
          result(node, l) = get_mirror_sign(l) * potentials(images[node], l);
      return result;
    }
  } // namespace

  std::unique_ptr<StrokeModel> create_brute_force(SwimmingShape &shape, const double increment)
  {
    return std::make_unique<BruteForce>(shape, increment);
  }

  PhaseTable::PhaseTable(SwimmingShape &shape, const unsigned int n, const MPI_Comm communicator)
      : gait(shape.gait)
      , n_phases(shape.deformation.n_modes() == 0 ? 1 : n)
      , is_mirrored(n_phases % 2 == 0 && has_glide_symmetry(gait) &&
                    shape.deformation.is_symmetric())
      , solutions(get_n_computed())
  {
    const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    for (unsigned int k = rank; k < solutions.size(); k += n_ranks)
      solutions[k] = shape.solve(2. * numbers::PI * k / n_phases);
    for (unsigned int k = 0; k < solutions.size(); ++k)
      solutions[k] = Utilities::MPI::broadcast(communicator, solutions[k], k % n_ranks);
    if (is_mirrored)
    {
      const auto images = find_mirror_images(shape.surface.get_reference_points(), 1);
      for (unsigned int k = 0; k < get_n_computed(); ++k)
        solutions.push_back({mirror(solutions[k].state, shape.n_drives()),
                             mirror(solutions[k].potentials, images)});
    }
  }

  /**
   * By phase, the trigonometric polynomial at @p psi, or its derivative, of which only the sample
   * at that phase is not zero, but one. With an even number of phases the highest sine, which
   * vanishes at all of them, is left out.
   */
  std::vector<double> PhaseTable::compute_weights(const double psi, const bool of_derivative) const
  {
    std::vector<double> weights(n_phases, of_derivative ? 0. : 1.);
    for (unsigned int k = 0; k < n_phases; ++k)
    {
      const std::complex<double> turn     = std::polar(1., psi - 2. * numbers::PI * k / n_phases);
      std::complex<double>       harmonic = 1.;
      for (unsigned int j = 1; 2 * j <= n_phases; ++j)
      {
        // *= looks for infinities, too, which takes longer than the rest.
        harmonic = {harmonic.real() * turn.real() - harmonic.imag() * turn.imag(),
                    harmonic.real() * turn.imag() + harmonic.imag() * turn.real()};
        weights[k] += (2 * j == n_phases ? 1. : 2.) *
                      (of_derivative ? -(j * harmonic.imag()) : harmonic.real());
      }
      weights[k] /= n_phases;
    }
    return weights;
  }

  MotionCoefficients PhaseTable::compute_motion(const double psi)
  {
    const std::vector<double> weights = compute_weights(psi, false);
    MotionCoefficients        motion;
    for (unsigned int k = 0; k < n_phases; ++k)
      motion.add(weights[k], solutions[k].state.motion);
    return motion;
  }

  StrokeState PhaseTable::interpolate(const std::vector<double> &weights) const
  {
    StrokeState state;
    for (unsigned int k = 0; k < n_phases; ++k)
      state.add(weights[k], solutions[k].state);
    return state;
  }

  StrokeState PhaseTable::compute_state(const double psi)
  {
    StrokeState     state = interpolate(compute_weights(psi, false));
    const GaitState at    = gait.evaluate(psi);
    state.c               = at.c;
    state.rates           = at.rates;
    return state;
  }

  StrokeState PhaseTable::compute_state_rate(const double psi)
  {
    return interpolate(compute_weights(psi, true));
  }

  FullMatrix<double> PhaseTable::compute_potentials(const double psi)
  {
    const std::vector<double> weights = compute_weights(psi, false);
    FullMatrix<double>        potentials(solutions[0].potentials.m(), solutions[0].potentials.n());
    double *const             sums = &potentials(0, 0);
    for (unsigned int k = 0; k < n_phases; ++k)
    {
      const double        weight = weights[k];
      const double *const values = &solutions[k].potentials(0, 0);
#pragma omp simd
      for (std::size_t i = 0; i < potentials.n_elements(); ++i)
        sums[i] += weight * values[i];
    }
    return potentials;
  }
} // namespace caudal::ideal
