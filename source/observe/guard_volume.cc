// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/guard.h>

namespace caudal
{
  namespace
  {
    const char *const hint =
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
                        "the area change", "", hint},
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
                        "the smallest J", "", hint},
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
                        "the largest J", "", hint},
                       2, make_measure<dim>(&DeformationSummary::largest_jacobian), 30)
      {}
    };

    const DimensionalRegistration<Guard, AreaChange> area_change("area change", "change of volume");
    const DimensionalRegistration<Guard, SmallestJacobian> smallest("smallest J", "compression");
    const DimensionalRegistration<Guard, LargestJacobian>  largest("largest J", "expansion");
  } // namespace
} // namespace caudal
