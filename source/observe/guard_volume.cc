// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/guard.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    const std::string hint =
        "Volume errors of the interpolated motion add up: use a finer fluid grid, the kernel "
        "dirac, or Body/Region/Cell volume stabilisation.";

    /** Change of a body's volume; it is incompressible. */
    template <int dim>
    class AreaChange : public Guard<dim>
    {
    public:
      AreaChange()
          : Guard<dim>({"Largest area change",
                        "Warn if a body's area (volume) has changed by more than this part; 0: "
                        "never. The body is incompressible: a change is an error of the coupling "
                        "[1].",
                        "the area change", "", hint},
                       0.02, 10)
      {}

      std::optional<double> measure_body(const Observation<dim> &observation,
                                         const unsigned int      body) const override
      {
        return observation.bodies[body].report.deformation.volume_change;
      }

      bool is_violated(const double value) const override
      {
        return Guard<dim>::is_violated(std::abs(value));
      }
    };

    /** Compression of a body's material at its worst. */
    template <int dim>
    class SmallestJacobian : public Guard<dim>
    {
    public:
      SmallestJacobian()
          : Guard<dim>({"Smallest J",
                        "Warn if the volume ratio J falls below this anywhere in a body; 0: never "
                        "[1].",
                        "the smallest J", "", hint},
                       0.5, 20)
      {}

      std::optional<double> measure_body(const Observation<dim> &observation,
                                         const unsigned int      body) const override
      {
        return observation.bodies[body].report.deformation.smallest_jacobian;
      }

      bool is_violated(const double value) const override
      {
        return value < this->get_limit();
      }
    };

    /** Expansion of a body's material at its worst. */
    template <int dim>
    class LargestJacobian : public Guard<dim>
    {
    public:
      LargestJacobian()
          : Guard<dim>({"Largest J", "Warn if J exceeds this anywhere in a body; 0: never [1].",
                        "the largest J", "", hint},
                       2, 30)
      {}

      std::optional<double> measure_body(const Observation<dim> &observation,
                                         const unsigned int      body) const override
      {
        return observation.bodies[body].report.deformation.largest_jacobian;
      }
    };

    const DimensionalRegistration<Guard, AreaChange> area_change("area change", "change of volume");
    const DimensionalRegistration<Guard, SmallestJacobian> smallest("smallest J", "compression");
    const DimensionalRegistration<Guard, LargestJacobian>  largest("largest J", "expansion");
  } // namespace
} // namespace caudal
