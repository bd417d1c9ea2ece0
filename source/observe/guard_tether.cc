// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/observe/guard.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    /** The largest displacement of a node with springs, along an axis, in finest cells. */
    template <int dim>
    double compute_displacement(const Observation<dim>     &observation,
                                const BodyObservation<dim> &body)
    {
      const SolidBody<dim> &solid     = body.body.get_solid();
      const Vector<double> &positions = body.state.positions;
      const Vector<double>  held = body.body.get_solid().compute_held_positions(observation.time);
      const auto           &lattice = observation.lattice;
      const Tensor<1, dim>  h       = lattice.get_cell_size(lattice.get_finest_level());
      double                largest = 0;
      for (const auto &node : solid.get_nodes())
        for (unsigned int d = 0; d < dim; ++d)
          if (solid.has_springs(node[d]))
            largest = std::max(largest, std::abs(positions[node[d]] - held[node[d]]) / h[d]);
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

    const DimensionalRegistration<Guard, TetherDisplacement>
        tether("tether displacement", "displacement of feedback springs");
  } // namespace
} // namespace caudal
