// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/energies.h>
#include <caudal/observe/guard.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    const char *const volume_hint =
        "Volume errors of the interpolated motion add up: use a finer fluid grid, the kernel "
        "dirac, or Body/Region/Cell volume stabilisation.";

    /** The measure that tells one of the changes of a body's volume. */
    template <int dim>
    typename Guard<dim>::BodyMeasure make_measure(double DeformationSummary::*value)
    {
      return [value](const Observation<dim> &, const BodyObservation<dim> &body) {
        return body.report.deformation.*value;
      };
    }

    /** Change of a body's volume; it is incompressible. */
    template <int dim>
    struct AreaChange : public Guard<dim>
    {
      AreaChange()
          : Guard<dim>({"Largest area change",
                        "Warn if a body's area (volume) has changed by more than this part; 0: "
                        "never. The body is incompressible: a change is an error of the coupling "
                        "[1].",
                        "the area change", "", volume_hint},
                       0.02, make_measure<dim>(&DeformationSummary::volume_change), 10)
      {}
    };

    /** Compression of a body's material at its worst. */
    template <int dim>
    struct SmallestJacobian : public Guard<dim>
    {
      SmallestJacobian()
          : Guard<dim>({"Smallest J",
                        "Warn if the volume ratio J falls below this anywhere in a body; 0: never "
                        "[1].",
                        "the smallest J", "", volume_hint},
                       0.5, make_measure<dim>(&DeformationSummary::smallest_jacobian), 20,
                       Guard<dim>::Side::below)
      {}
    };

    /** Expansion of a body's material at its worst. */
    template <int dim>
    struct LargestJacobian : public Guard<dim>
    {
      LargestJacobian()
          : Guard<dim>({"Largest J", "Warn if J exceeds this anywhere in a body; 0: never [1].",
                        "the largest J", "", volume_hint},
                       2, make_measure<dim>(&DeformationSummary::largest_jacobian), 30)
      {}
    };

    /** The largest displacement of a node with springs, along an axis, in finest cells. */
    template <int dim>
    double compute_displacement(const Observation<dim>     &observation,
                                const BodyObservation<dim> &body)
    {
      const SolidBody<dim> &solid     = body.body.get_solid();
      const Vector<double> &positions = body.state.positions;
      const auto           &lattice   = observation.lattice;
      const Tensor<1, dim>  h         = lattice.get_cell_size(lattice.get_finest_level());
      double                largest   = 0;
      for (const auto &node : solid.get_nodes())
        for (unsigned int d = 0; d < dim; ++d)
          if (solid.get_feedback_stiffness().diag_element(node[d]) > 0)
            largest = std::max(
                largest,
                std::abs(positions[node[d]] - solid.get_initial_positions()[node[d]]) / h[d]);
      return largest;
    }

    /** Distance by which feedback springs let a node go from its place. */
    template <int dim>
    struct TetherDisplacement : public Guard<dim>
    {
      TetherDisplacement()
          : Guard<dim>({"Largest tether displacement",
                        "Warn if feedback springs let a node go further than this from its place, "
                        "in cells of the finest fluid grid; 0: never [1].",
                        "the displacement of the springs", " cells",
                        "Where springs are to hold a part in its place, increase "
                        "Body/Region/Feedback stiffness."},
                       2, compute_displacement<dim>, 40)
      {}
    };

    /** The residual of the energy ledger relative to the sum of its terms. */
    template <int dim>
    double compute_residual(const Observation<dim>     &observation,
                            const ObserverContext<dim> &context)
    {
      // A start at once is damped by the time scheme, and there is little other energy yet.
      if (observation.step_number < 10)
        return 0;
      const auto         &energies = context.others.template get<Energies<dim>>();
      const EnergyLedger &ledger = energies.get_ledger(), &start = energies.get_initial_ledger();
      const double        sum = std::abs(ledger.muscle_work) + std::abs(ledger.feedback_work) +
                         std::abs(ledger.external_work) + start.kinetic_energy +
                         ledger.kinetic_energy + std::abs(ledger.elastic_energy) +
                         ledger.dissipation;
      return std::abs(ledger.get_residual(start)) / std::max(sum, 1e-300);
    }

    /** Difference of the powers that body and fluid exchange, relative to them. */
    template <int dim>
    struct PowerDifference : public Guard<dim>
    {
      PowerDifference()
          : Guard<dim>(
                {"Largest power identity",
                 "Warn if the power of the body forces differs between fluid and body by "
                 "more than this part; 0: never [1].",
                 "the relative difference of powers", "",
                 "Body and fluid do not exchange the same power: an error in the program, "
                 "please report it."},
                1e-6,
                [](const Observation<dim> &, const BodyObservation<dim> &body) {
                  return body.report.power_identity;
                },
                50)
      {}
    };

    /** What the energy ledger leaves unaccounted for. */
    template <int dim>
    struct EnergyResidual : public Guard<dim>
    {
      EnergyResidual()
          : Guard<dim>({"Largest energy residual",
                        "Warn if what the energy ledger leaves unaccounted for exceeds this part "
                        "of its terms' sum, from the tenth step on; 0: never [1].",
                        "the energy residual", " of the ledger's sum",
                        "Steps or cells are too large for the motion: reduce Time/Step, refine the "
                        "wake (Refinement/Vorticity threshold)."},
                       0.1, compute_residual<dim>, 60)
      {}
    };

    const DimensionalRegistration<Guard, AreaChange> area_change("area change", "change of volume");
    const DimensionalRegistration<Guard, SmallestJacobian> smallest("smallest J", "compression");
    const DimensionalRegistration<Guard, LargestJacobian>  largest("largest J", "expansion");
    const DimensionalRegistration<Guard, TetherDisplacement>
        tether("tether displacement", "displacement of feedback springs");
    const DimensionalRegistration<Guard, PowerDifference>
        power_difference("power identity", "difference of the exchanged powers");
    const DimensionalRegistration<Guard, EnergyResidual> energy_residual("energy residual",
                                                                         "unaccounted energy");
  } // namespace
} // namespace caudal
