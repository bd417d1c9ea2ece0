#include <caudal/potential/stroke_model.h>

namespace caudal::potential
{
  namespace
  {
    /** From b to the solution x of A x = b by Cholesky's factors; false if there are none. */
    bool solve_positive_definite(Tensor<2, 6> A, Screw &x)
    {
      for (unsigned int i = 0; i < 6; ++i)
      {
        for (unsigned int j = 0; j < i; ++j)
        {
          for (unsigned int k = 0; k < j; ++k)
            A[i][j] -= A[i][k] * A[j][k];
          A[i][j] /= A[j][j];
          A[i][i] -= A[i][j] * A[i][j];
          x[i] -= A[i][j] * x[j];
        }
        if (!(A[i][i] > 0.))
          return false;
        A[i][i] = std::sqrt(A[i][i]);
        x[i] /= A[i][i];
      }
      for (unsigned int i = 6; i-- > 0;)
      {
        for (unsigned int k = i + 1; k < 6; ++k)
          x[i] -= A[k][i] * x[k];
        x[i] /= A[i][i];
      }
      return true;
    }

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

      std::vector<double> compute_torques(const double argument) override
      {
        const StrokeState   before = get(argument - increment).state;
        const StrokeState   after  = get(argument + increment).state;
        const StrokeState   at     = get(argument).state;
        std::vector<double> torques;
        for (std::size_t i = 0; i < at.momenta.size(); ++i)
          torques.push_back((after.momenta[i] - before.momenta[i]) / (2. * increment) -
                            at.energy_gradient[i]);
        return torques;
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

  Screw MotionCoefficients::compute_velocity(const Screw &impulse, const double rate) const
  {
    Screw result = impulse - rate * momentum;
    AssertThrow(solve_positive_definite(mass, result),
                ExcMessage("The mass matrix of body and fluid is not positive definite: the body's "
                           "surface intersects itself, or is too coarse. Reduce the deformation, "
                           "or refine section Surface."));
    return result;
  }

  double StrokeState::compute_energy_from_rest() const
  {
    return deformation_energy + 0.5 * (motion.momentum * motion.compute_velocity(Screw(), 1.));
  }

  SwimmingShape::SwimmingShape(const Surface &surface, const Deformation &deformation,
                               const Gait &gait, const Densities &densities,
                               const bool with_torques, const MPI_Comm communicator)
      : surface(surface)
      , deformation(deformation)
      , gait(gait)
      , densities(densities)
      , with_torques(with_torques)
      , boundary_elements(surface, communicator)
  {}

  StrokeState SwimmingShape::compute_state(const double argument, FullMatrix<double> *potentials)
  {
    const GaitState    at = gait.evaluate(argument);
    const unsigned int n  = deformation.n_modes();
    StrokeState        state;
    state.rates                   = at.rates;
    const auto               flow = boundary_elements.solve(deformation.place(at.c));
    const FullMatrix<double> body = deformation.compute_body_mass(at.c);
    FullMatrix<double>       mass = flow->get_potentials().added_mass;
    mass *= densities.fluid;
    mass.add(densities.body, body);
    if (potentials != nullptr)
      *potentials = flow->get_potentials().values;
    for (unsigned int i = 0; i < 6; ++i)
    {
      for (unsigned int j = 0; j < 6; ++j)
        state.motion.mass[i][j] = mass(i, j);
      for (unsigned int j = 0; j < n; ++j)
        state.motion.momentum[i] += mass(i, 6 + j) * at.rates[j];
    }
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        state.deformation_energy += 0.5 * at.rates[i] * mass(6 + i, 6 + j) * at.rates[j];

    // The block between rotation and translation of the body's own mass is m c^.
    state.centre = Point<3>(body(1, 5), body(2, 3), body(0, 4)) / -body(3, 3);

    // u = (q, c') from rest
    const Screw    q = state.motion.compute_velocity(Screw(), 1.);
    Vector<double> u(6 + n), momenta(6 + n);
    for (unsigned int i = 0; i < 6; ++i)
      u(i) = q[i];
    for (unsigned int i = 0; i < n; ++i)
      u(6 + i) = at.rates[i];
    mass.vmult(momenta, u);
    state.momenta.assign(momenta.begin() + 6, momenta.end());
    state.energy_gradient.assign(n, 0.);
    if (with_torques && n > 0)
    {
      const std::vector<double> motion(u.begin(), u.end());
      const std::vector<double> of_fluid =
          flow->compute_energy_gradient(motion, deformation.compute_mode_rates(at.c, at.rates));
      const std::vector<double> of_body = deformation.compute_body_energy_gradient(at.c, motion);
      for (unsigned int i = 0; i < n; ++i)
        state.energy_gradient[i] = densities.fluid * of_fluid[i] + densities.body * of_body[i];
    }
    return state;
  }

  std::unique_ptr<StrokeModel> create_brute_force(SwimmingShape &shape, const double increment)
  {
    return std::make_unique<BruteForce>(shape, increment);
  }
} // namespace caudal::potential
