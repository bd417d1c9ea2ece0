// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_solid_prescribed_place_h
#define caudal_solid_prescribed_place_h

#include <caudal/base/expression.h>
#include <caudal/solid/rigid_map.h>

#include <deal.II/base/parameter_handler.h>

#include <optional>

namespace caudal
{
  /** The entries of a region that say how what holds it moves. */
  template <int dim>
  struct PrescribedPlaceParameters
  {
    std::string translation, rotation;
    Point<dim>  center;

    /** Declares the entries in the section that @p prm is in. */
    void add_parameters(ParameterHandler &prm);

    /** Throws a sentence about the first bad entry; @p path is the section's. */
    void check(const std::string &path) const;

    bool moves() const
    {
      return !translation.empty() || !rotation.empty();
    }
  };

  /**
   * The rigid motion of what holds a region,
   *   x(X, t) = c + Q(t) (X - c) + d(t),
   * of the place X [m] in the domain that it has at t = 0. The rotation Q is by an angle in the
   * plane; in space it is by the length of a vector, about this vector's direction.
   */
  template <int dim>
  class PrescribedPlace
  {
  public:
    /** @p path is that of the region's section. */
    PrescribedPlace(const PrescribedPlaceParameters<dim> &parameters, const std::string &path);

    /** At @p time [s]. */
    RigidMotion<dim> compute(double time) const;

  private:
    static constexpr unsigned int n_rotations = dim * (dim - 1) / 2;

    const Tensor<1, dim>           center;
    std::optional<Expression<dim>> translation, rotation;

    template <int n>
    static Tensor<1, n> evaluate(const std::optional<Expression<dim>> &function, double time);
  };
} // namespace caudal

#endif
