// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/ideal/phase_table.h>
#include <caudal/ideal/trigonometric_interpolation.h>

namespace caudal::ideal
{
  namespace
  {
    // Where the parts of a state stand in a row of the table.
    const unsigned int motion_end    = 27;
    const unsigned int centre_begin  = 28;
    const unsigned int momenta_begin = 31;

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

    /** Calls @p visit with each number and the sign that it gets in the mirror y -> -y. */
    template <class Motion, class Visit>
    void visit_motion(Motion &motion, const Visit &visit)
    {
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = i; j < 6; ++j)
          visit(motion.mass[i][j], get_mirror_sign(i) * get_mirror_sign(j));
      for (unsigned int i = 0; i < 6; ++i)
        visit(motion.momentum[i], get_mirror_sign(i));
    }

    /** Visits a whole state in the order of a row of the table, but for what the gait says. */
    template <class State, class Visit>
    void visit_state(State &state, const unsigned int n_drives, const Visit &visit)
    {
      visit_motion(state.motion, visit);
      visit(state.deformation_energy, 1.);
      for (unsigned int d = 0; d < 3; ++d)
        visit(state.centre[d], d == 1 ? -1. : 1.);
      auto momentum = state.torques.momenta.begin();
      while (momentum != state.torques.momenta.end())
        for (unsigned int a = 0; a < n_drives; ++a)
          visit(*momentum++, -get_drive_sign(a));
      auto gradient = state.torques.energy_gradient.begin();
      while (gradient != state.torques.energy_gradient.end())
        for (unsigned int a = 0; a < n_drives; ++a)
          for (unsigned int b = a; b < n_drives; ++b)
            visit(*gradient++, -get_drive_sign(a) * get_drive_sign(b));
    }

    MotionCoefficients unpack_motion(const std::vector<double> &row)
    {
      MotionCoefficients motion;
      auto               number = row.begin();
      visit_motion(motion, [&](double &value, double) { value = *number++; });
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = 0; j < i; ++j)
          motion.mass[i][j] = motion.mass[j][i];
      return motion;
    }

    /** Puts the rows that each rank has computed on all ranks. */
    void exchange(std::vector<std::vector<double>> &rows, const unsigned int n_columns,
                  const MPI_Comm communicator)
    {
      for (auto &row : rows)
      {
        row.resize(n_columns, 0.);
        Utilities::MPI::sum(row, communicator, row);
      }
    }
  } // namespace

  PhaseTable::PhaseTable(SwimmingShape &shape, const unsigned int n_phases,
                         const MPI_Comm communicator)
      : gait(shape.gait)
      , n_modes(shape.deformation.n_modes())
      , n_drives(shape.n_drives())
      , n_phases(n_modes == 0 ? 1 : n_phases)
      , is_mirrored(n_modes > 0 && n_phases % 2 == 0 && has_glide_symmetry(gait) &&
                    shape.deformation.is_symmetric())
  {
    const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    states.resize(get_n_computed());
    potentials.resize(get_n_computed());
    for (unsigned int k = rank; k < get_n_computed(); k += n_ranks)
    {
      FullMatrix<double> flow;
      const StrokeState  state = shape.compute_state(2. * numbers::PI * k / this->n_phases, &flow);
      visit_state(state, n_drives, [&](const double value, double) { states[k].push_back(value); });
      potentials[k].assign(&flow(0, 0), &flow(0, 0) + flow.m() * flow.n());
    }
    exchange(states, momenta_begin + n_modes * (n_drives + n_drives * (n_drives + 1) / 2),
             communicator);
    exchange(potentials, shape.surface.n_nodes() * (6 + n_modes), communicator);
    if (is_mirrored)
      add_second_half(shape.surface);
  }

  void PhaseTable::add_second_half(const Surface &surface)
  {
    const unsigned int              n_motions = 6 + n_modes;
    const std::vector<unsigned int> images = find_mirror_images(surface.get_reference_points(), 1);
    for (unsigned int k = 0; k < get_n_computed(); ++k)
    {
      StrokeState signs = make_state(states[k]);
      states.push_back(states[k]);
      auto number = states.back().begin();
      visit_state(signs, n_drives, [&](double, const double sign) { *number++ *= sign; });
      potentials.emplace_back();
      for (const unsigned int node : images)
        for (unsigned int l = 0; l < n_motions; ++l)
          potentials.back().push_back(get_mirror_sign(l) * potentials[k][node * n_motions + l]);
    }
  }

  /** The state whose numbers are in the row, without what the gait says. */
  StrokeState PhaseTable::make_state(const std::vector<double> &row) const
  {
    StrokeState state;
    state.torques.momenta.resize(n_modes * n_drives);
    state.torques.energy_gradient.resize(row.size() - momenta_begin - n_modes * n_drives);
    auto number = row.begin();
    visit_state(state, n_drives, [&](double &value, double) { value = *number++; });
    state.motion = unpack_motion(row); // and the other half of the mass
    return state;
  }

  MotionCoefficients PhaseTable::compute_motion(const double psi)
  {
    return unpack_motion(interpolate(states, psi, 0, motion_end));
  }

  StrokeState PhaseTable::compute_state(const double psi)
  {
    StrokeState     state = make_state(interpolate(states, psi, 0, states[0].size()));
    const GaitState at    = gait.evaluate(psi);
    state.c               = at.c;
    state.rates           = at.rates;
    return state;
  }

  std::vector<double> PhaseTable::compute_torques(const double psi, const Drive &drive)
  {
    const unsigned int middle = momenta_begin + n_modes * n_drives;
    return compute_lagrange_torques({interpolate(states, psi, momenta_begin, middle),
                                     interpolate(states, psi, middle, states[0].size())},
                                    interpolate(states, psi, momenta_begin, middle, true), n_modes,
                                    drive);
  }

  Tensor<1, 3> PhaseTable::compute_centre_rate(const double psi)
  {
    const std::vector<double> rate = interpolate(states, psi, centre_begin, momenta_begin, true);
    return Tensor<1, 3>({rate[0], rate[1], rate[2]});
  }

  FullMatrix<double> PhaseTable::compute_potentials(const double psi)
  {
    const std::vector<double> values = interpolate(potentials, psi, 0, potentials[0].size());
    return FullMatrix<double>(values.size() / (6 + n_modes), 6 + n_modes, values.data());
  }
} // namespace caudal::ideal
