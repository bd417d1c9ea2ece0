// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_body_resolution_h
#define caudal_viscous_body_resolution_h

#include <caudal/viscous/operators.h>

#include <limits>

namespace caudal
{
  /** The thickness of a body in metres, and in the fluid's finest cells in its direction. */
  template <int dim>
  struct CountedThickness
  {
    double         thickness = std::numeric_limits<double>::infinity(); // [m]
    double         n_cells   = std::numeric_limits<double>::infinity();
    Tensor<1, dim> direction; // in the domain
  };

  /** How fine fluid and body are beside each other. */
  template <int dim>
  struct BodyResolution
  {
    /** The mean distance of the body's nodes, in cells of the fluid's finest level. */
    double spacing_ratio = 0;
    /** The regions where they have the fewest cells; infinite for a region inside the body. */
    std::vector<CountedThickness<dim>> thinnest;
    /** The median over the whole surface. */
    CountedThickness<dim> typical;
  };

  // What was measured with Turek and Hron's flag (prm/benchmarks/README.md): three cells of the
  // fluid across it are enough, with two its lift is a fifth too large; body nodes much closer
  // than the fluid's cells make a body thicker, much wider ones leak.
  constexpr double least_thickness = 3;
  // With a body of half a cell to a cell prm/eel.prm swims at a quarter of its speed.
  constexpr double thinnest_meaningful = 0.5;
  constexpr double finest_ratio = 0.6, coarsest_ratio = 1.7;

  /** The mean edge of the fluid's cells of the finest level [m]. */
  template <int dim>
  double get_finest_cell(const DomainParameters<dim> &domain);

  template <int dim>
  BodyResolution<dim> measure_resolution(const Body<dim>             &body,
                                         const DomainParameters<dim> &domain);

  /**
   * Throws a sentence if most of a body that swims is thinner than half a cell of the fluid, which
   * is the distance of velocity nodes: such a body does not part the fluid on its two sides, and
   * may even swim backwards. Coupling/Accept unresolved bodies allows it.
   */
  template <int dim>
  void check_resolution(const Operators<dim> &operators);
} // namespace caudal

#endif
