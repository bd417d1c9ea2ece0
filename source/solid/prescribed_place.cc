// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/solid/prescribed_place.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/physics/transformations.h>

namespace caudal
{
  template <int dim>
  void PrescribedPlaceParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Translation", translation,
                      "How far what holds this region, springs or Motion = prescribed, has moved "
                      "[m]: functions of t that vanish at t = 0, components separated by ';'; "
                      "empty: it does not move.",
                      Patterns::Anything());
    prm.add_parameter("Rotation", rotation,
                      std::string("How far it has turned [rad]: ") +
                          (dim == 2
                               ? "the angle"
                               : "the components, separated by ';', of a vector along the axis "
                                 "whose length is the angle") +
                          ", a function of t that vanishes at t = 0; empty: it does not turn.",
                      Patterns::Anything());
    prm.add_parameter("Centre of rotation", center,
                      "The point of the domain about which it turns at t = 0, and which then moves "
                      "with the translation [m].");
  }

  template <int dim>
  void PrescribedPlaceParameters<dim>::check(const std::string &path) const
  {
    const auto motion = PrescribedPlace<dim>(*this, path).compute(0.);
    AssertThrow((motion.center - motion.reference_center).norm() < 1e-12,
                ExcMessage(path + "/Translation: it is not 0 at t = 0. Let it begin at 0; "
                                  "Shape/Position places the body."));
    AssertThrow((motion.rotation - Tensor<2, dim>(unit_symmetric_tensor<dim>())).norm() < 1e-12,
                ExcMessage(path +
                           "/Rotation: it is not 0 at t = 0. Let it begin at 0; Shape/Rotation "
                           "turns the body."));
  }

  template <int dim>
  PrescribedPlace<dim>::PrescribedPlace(const PrescribedPlaceParameters<dim> &parameters,
                                        const std::string                    &path)
      : center(parameters.center)
  {
    if (!parameters.translation.empty())
      translation.emplace(path + "/Translation", parameters.translation, dim);
    if (!parameters.rotation.empty())
      rotation.emplace(path + "/Rotation", parameters.rotation, n_rotations);
  }

  template <int dim>
  template <int n>
  Tensor<1, n> PrescribedPlace<dim>::evaluate(const std::optional<Expression<dim>> &function,
                                              const double                          time)
  {
    Tensor<1, n> result;
    if (!function)
      return result;
    Expression<dim> at_time(*function);
    at_time.set_time(time);
    for (unsigned int d = 0; d < n; ++d)
      result[d] = at_time.value(Point<dim>(), d);
    return result;
  }

  template <int dim>
  RigidMotion<dim> PrescribedPlace<dim>::compute(const double time) const
  {
    const Tensor<1, n_rotations> turn  = evaluate<n_rotations>(rotation, time);
    const double                 angle = turn.norm();
    RigidMotion<dim>             motion{unit_symmetric_tensor<dim>(), center,
                            center + evaluate<dim>(translation, time)};
    if constexpr (dim == 2)
      motion.rotation = Physics::Transformations::Rotations::rotation_matrix_2d(turn[0]);
    else if (angle > 0.)
      motion.rotation =
          Physics::Transformations::Rotations::rotation_matrix_3d(turn / angle, angle);
    return motion;
  }

  template struct PrescribedPlaceParameters<2>;
  template struct PrescribedPlaceParameters<3>;
  template class PrescribedPlace<2>;
  template class PrescribedPlace<3>;
} // namespace caudal
