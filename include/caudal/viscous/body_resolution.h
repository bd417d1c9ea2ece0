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

  /** The height of the body's element at a face of its surface, in the fluid's finest cells. */
  template <int dim>
  struct LayerHeight
  {
    double         n_cells;
    Point<dim>     place;     // in the domain, at the start
    Tensor<1, dim> direction; // in the domain
  };

  /** How fine fluid and body are beside each other. */
  template <int dim>
  struct BodyResolution
  {
    /** The first layer of elements where it is lowest and where it is highest. */
    LayerHeight<dim> lowest, highest;
    /** The heights in cells that it should have. */
    double least_height = 0, most_height = 0;
    /** The shares of the surface where it is lower or higher. */
    double share_too_low = 0, share_too_high = 0;
    /** The mean distance of the body's nodes, in cells of the fluid's finest level. */
    double spacing_ratio = 0;
    /** The regions where they have the fewest cells; infinite for a region inside the body. */
    std::vector<CountedThickness<dim>> thinnest;
    /** The median over the whole surface. */
    CountedThickness<dim> typical;
  };

  // What was measured with Turek and Hron's flag (prm/benchmarks/README.md): three cells of the
  // fluid across it are enough, with two its lift is a fifth too large.
  constexpr double least_thickness = 3;
  // With a body of half a cell to a cell prm/eel.prm swims at a quarter of its speed.
  constexpr double thinnest_meaningful = 0.5;
  // Lower first layers, in automatic elements, have more motions than the fluid and make the body
  // thicker, higher ones leak: 0.8 and 2 cells for elements of degree 1.
  constexpr double lowest_layer = 0.64, highest_layer = 1.6;
  constexpr double finest_ratio = 0.6;
  // Damping eta of what is held, over mu/h^2: with less of it the fluid moves through the body.
  constexpr double least_damping = 1e4;

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
