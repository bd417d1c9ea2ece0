// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/ideal/swimming_shape.h>

#include <deal.II/lac/lapack_full_matrix.h>

namespace caudal::ideal
{
  Screw MotionCoefficients::compute_velocity(const Screw &impulse, const double rate) const
  {
    LAPACKFullMatrix<double> matrix(6);
    Vector<double>           q(6);
    matrix.set_property(LAPACKSupport::symmetric);
    for (unsigned int i = 0; i < 6; ++i)
    {
      q(i) = impulse[i] - rate * momentum[i];
      for (unsigned int j = 0; j < 6; ++j)
        matrix(i, j) = mass[i][j];
    }
    try
    {
      matrix.compute_cholesky_factorization();
      matrix.solve(q);
    }
    catch (const ExceptionBase &)
    {
      AssertThrow(false,
                  ExcMessage("The mass matrix of body and fluid is not positive definite: "
                             "the body's surface intersects itself, or is too coarse. Reduce "
                             "the deformation, or refine section Surface."));
    }
    return Screw({q(0), q(1), q(2), q(3), q(4), q(5)});
  }

  void MotionCoefficients::add(const double factor, const MotionCoefficients &other)
  {
    mass += factor * other.mass;
    momentum += factor * other.momentum;
  }

  void StrokeState::add(const double factor, const StrokeState &other)
  {
    const auto add_to = [factor](std::vector<double> &sum, const std::vector<double> &values) {
      sum.resize(values.size(), 0.);
      for (std::size_t i = 0; i < values.size(); ++i)
        sum[i] += factor * values[i];
    };
    motion.add(factor, other.motion);
    deformation_energy += factor * other.deformation_energy;
    centre += factor * other.centre;
    add_to(torques.momenta, other.torques.momenta);
    add_to(torques.energy_gradient, other.torques.energy_gradient);
  }

  SwimmingShape::SwimmingShape(const Surface &surface, const Deformation &deformation,
                               const Gait &gait, const Densities &densities, const Torques torques,
                               const MPI_Comm communicator)
      : surface(surface)
      , deformation(deformation)
      , gait(gait)
      , densities(densities)
      , torques(torques)
      , boundary_elements(surface, communicator)
  {}

  StrokeSolution SwimmingShape::solve(const double argument)
  {
    const GaitState          at   = gait.evaluate(argument);
    const unsigned int       n    = deformation.n_modes();
    ExteriorFlow             flow = boundary_elements.solve(deformation.place(at.c));
    const FullMatrix<double> body = deformation.compute_body_mass(at.c);
    FullMatrix<double>       mass = flow.get_potentials().added_mass;
    mass *= densities.fluid;
    mass.add(densities.body, body);

    StrokeSolution result{{}, flow.get_potentials().values};
    StrokeState   &state = result.state;
    state.c              = at.c;
    state.rates          = at.rates;
    for (unsigned int i = 0; i < 6; ++i)
    {
      for (unsigned int j = i; j < 6; ++j)
        state.motion.mass[i][j] = mass(i, j);
      for (unsigned int j = 0; j < n; ++j)
        state.motion.momentum[i] += mass(i, 6 + j) * at.rates[j];
    }
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        state.deformation_energy += 0.5 * at.rates[i] * mass(6 + i, 6 + j) * at.rates[j];

    // The block between rotation and translation of the body's own mass is m c^.
    state.centre = Point<3>(body(1, 5), body(2, 3), body(0, 4)) / -body(3, 3);

    state.torques = compute_torque_coefficients(flow, mass, at, state.motion);
    return result;
  }

  /** (1/2) u^T (dM/dc_i) u */
  std::vector<double> SwimmingShape::compute_energy_gradient(ExteriorFlow              &flow,
                                                             const std::vector<double> &c,
                                                             const Vector<double>      &u) const
  {
    const std::vector<double> motion(u.begin(), u.end()), rates(u.begin() + 6, u.end());
    const std::vector<double> of_fluid =
        flow.compute_energy_gradient(motion, deformation.compute_mode_rates(c, rates));
    std::vector<double> gradient = deformation.compute_body_energy_gradient(c, motion);
    for (std::size_t i = 0; i < gradient.size(); ++i)
      gradient[i] = densities.fluid * of_fluid[i] + densities.body * gradient[i];
    return gradient;
  }

  TorqueCoefficients SwimmingShape::compute_torque_coefficients(ExteriorFlow             &flow,
                                                                const FullMatrix<double> &mass,
                                                                const GaitState          &at,
                                                                const MotionCoefficients &rigid)
  {
    const unsigned int          n_modes = deformation.n_modes(), n = n_drives();
    const unsigned int          n_pairs = n * (n + 1) / 2;
    TorqueCoefficients          result{std::vector<double>(n_modes * n),
                              std::vector<double>(n_modes * n_pairs, 0.)};
    std::vector<Vector<double>> motions;
    std::vector<double>         sizes;
    for (unsigned int a = 0; a < n; ++a)
    {
      Screw impulse;
      if (a > 0)
        impulse[a - 1] = 1.;
      const Screw    q = rigid.compute_velocity(impulse, a > 0 ? 0. : 1.);
      Vector<double> u(6 + n_modes), momenta(6 + n_modes);
      for (unsigned int i = 0; i < 6; ++i)
        u(i) = q[i];
      for (unsigned int i = 0; i < n_modes && a == 0; ++i)
        u(6 + i) = at.rates[i];
      mass.vmult(momenta, u);
      for (unsigned int i = 0; i < n_modes; ++i)
        result.momenta[i * n + a] = momenta(6 + i);
      // Motions of unit impulses are scaled to unit energy, against rounding in what follows.
      sizes.push_back(a > 0 ? std::sqrt(u * momenta) : 1.);
      u /= sizes.back();
      motions.push_back(u);
    }
    if (torques == Torques::none || n_modes == 0)
      return result;

    // What a sum of two motions has beyond its parts belongs to the pair.
    std::vector<std::vector<double>> alone;
    for (const Vector<double> &u : motions)
      alone.push_back(compute_energy_gradient(flow, at.c, u));
    unsigned int pair = 0;
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int b = a; b < n; ++b, ++pair)
      {
        if (!flow.interact(motions[a], motions[b]))
          continue;
        std::vector<double> gradient = alone[a];
        if (a != b)
        {
          Vector<double> both = motions[a];
          both += motions[b];
          gradient = compute_energy_gradient(flow, at.c, both);
          for (unsigned int i = 0; i < n_modes; ++i)
            gradient[i] -= alone[a][i] + alone[b][i];
        }
        for (unsigned int i = 0; i < n_modes; ++i)
          result.energy_gradient[i * n_pairs + pair] = gradient[i] * sizes[a] * sizes[b];
      }
    return result;
  }
} // namespace caudal::ideal
