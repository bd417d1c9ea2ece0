#include <caudal/ideal/phase_table.h>

namespace caudal::ideal
{
  namespace
  {
    // Where the parts of a state stand in a row of the table.
    const unsigned int momentum_begin = 21;
    const unsigned int energy_begin   = 27;
    const unsigned int centre_begin   = 28;
    const unsigned int momenta_begin  = 31;

    std::vector<double> pack(const StrokeState &state)
    {
      std::vector<double> row;
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = i; j < 6; ++j)
          row.push_back(state.motion.mass[i][j]);
      for (unsigned int i = 0; i < 6; ++i)
        row.push_back(state.motion.momentum[i]);
      row.push_back(state.deformation_energy);
      for (unsigned int d = 0; d < 3; ++d)
        row.push_back(state.centre[d]);
      for (const auto *const part : {&state.torques.momenta, &state.torques.energy_gradient})
        row.insert(row.end(), part->begin(), part->end());
      return row;
    }

    MotionCoefficients unpack_motion(const std::vector<double> &row)
    {
      MotionCoefficients motion;
      unsigned int       k = 0;
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = i; j < 6; ++j)
          motion.mass[i][j] = motion.mass[j][i] = row[k++];
      for (unsigned int i = 0; i < 6; ++i)
        motion.momentum[i] = row[momentum_begin + i];
      return motion;
    }

    StrokeState unpack(const std::vector<double> &row, const std::vector<double> &rates,
                       const unsigned int n_drives)
    {
      const auto  middle = row.begin() + momenta_begin + rates.size() * n_drives;
      StrokeState state;
      state.motion             = unpack_motion(row);
      state.deformation_energy = row[energy_begin];
      for (unsigned int d = 0; d < 3; ++d)
        state.centre[d] = row[centre_begin + d];
      state.rates = rates;
      state.torques.momenta.assign(row.begin() + momenta_begin, middle);
      state.torques.energy_gradient.assign(middle, row.end());
      return state;
    }

    /** What the mirror y -> -y does to rotations, translations and modes (c -> -c). */
    double get_mirror_sign(const unsigned int motion)
    {
      const double signs[] = {-1., 1., -1., 1., -1., 1.};
      return motion < 6 ? signs[motion] : -1.;
    }

    /** The same to the drives; the gait's rate stays. */
    double get_drive_sign(const unsigned int drive)
    {
      return drive > 0 ? get_mirror_sign(drive - 1) : 1.;
    }

    /** The state of the mirror image of the body. */
    std::vector<double> mirror(StrokeState state, const unsigned int n_drives)
    {
      for (unsigned int i = 0; i < 6; ++i)
      {
        state.motion.momentum[i] *= get_mirror_sign(i);
        for (unsigned int j = 0; j < 6; ++j)
          state.motion.mass[i][j] *= get_mirror_sign(i) * get_mirror_sign(j);
      }
      state.centre[1] *= -1.;
      auto momentum = state.torques.momenta.begin(),
           gradient = state.torques.energy_gradient.begin();
      for (unsigned int mode = 0; mode < state.rates.size(); ++mode)
        for (unsigned int a = 0; a < n_drives; ++a)
        {
          *momentum++ *= -get_drive_sign(a);
          for (unsigned int b = a; b < n_drives; ++b)
            *gradient++ *= -get_drive_sign(a) * get_drive_sign(b);
        }
      return pack(state);
    }

    /** The rows that each rank has computed, on all ranks. */
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
  {
    const bool is_rigid = n_modes == 0;
    const bool mirrors  = !is_rigid && n_phases % 2 == 0 && has_glide_symmetry(gait) &&
                         shape.deformation.is_symmetric();
    const unsigned int M         = is_rigid ? 1 : n_phases;
    const unsigned int n_motions = 6 + n_modes;
    n_computed                   = mirrors ? M / 2 : M;

    const unsigned int               rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int               n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    std::vector<std::vector<double>> rows(n_computed), flows(n_computed);
    for (unsigned int k = rank; k < n_computed; k += n_ranks)
    {
      FullMatrix<double> flow;
      rows[k] = pack(shape.compute_state(2. * numbers::PI * k / M, &flow));
      flows[k].assign(&flow(0, 0), &flow(0, 0) + flow.m() * flow.n());
    }
    exchange(rows, momenta_begin + n_modes * (n_drives + n_drives * (n_drives + 1) / 2),
             communicator);
    exchange(flows, shape.surface.n_nodes() * n_motions, communicator);

    if (mirrors)
    {
      const std::vector<unsigned int> nodes =
          find_mirror_images(shape.surface.get_reference_points(), 1);
      for (unsigned int k = 0; k < M / 2; ++k)
      {
        rows.push_back(mirror(unpack(rows[k], std::vector<double>(n_modes), n_drives), n_drives));
        flows.emplace_back();
        for (const unsigned int node : nodes)
          for (unsigned int l = 0; l < n_motions; ++l)
            flows.back().push_back(get_mirror_sign(l) * flows[k][node * n_motions + l]);
      }
    }
    states     = TrigonometricTable(rows);
    potentials = TrigonometricTable(flows);
  }

  MotionCoefficients PhaseTable::compute_motion(const double psi)
  {
    return unpack_motion(states.values(psi, 0, energy_begin));
  }

  StrokeState PhaseTable::compute_state(const double psi)
  {
    return unpack(states.values(psi, 0, states.n_functions()), gait.evaluate(psi).rates, n_drives);
  }

  std::vector<double> PhaseTable::compute_torques(const double psi, const Drive &drive)
  {
    const unsigned int middle = momenta_begin + n_modes * n_drives;
    return compute_lagrange_torques({states.values(psi, momenta_begin, middle),
                                     states.values(psi, middle, states.n_functions())},
                                    states.derivatives(psi, momenta_begin, middle), n_modes, drive);
  }

  Tensor<1, 3> PhaseTable::compute_centre_rate(const double psi)
  {
    const std::vector<double> rate = states.derivatives(psi, centre_begin, momenta_begin);
    return Point<3>(rate[0], rate[1], rate[2]);
  }

  FullMatrix<double> PhaseTable::compute_potentials(const double psi)
  {
    const std::vector<double> values = potentials.values(psi, 0, potentials.n_functions());
    FullMatrix<double>        result(values.size() / (6 + n_modes), 6 + n_modes);
    std::copy(values.begin(), values.end(), &result(0, 0));
    return result;
  }
} // namespace caudal::ideal
