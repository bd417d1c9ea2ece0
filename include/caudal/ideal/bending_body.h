// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_ideal_bending_body_h
#define caudal_ideal_bending_body_h

#include <caudal/fish/spine.h>
#include <caudal/ideal/deformation.h>
#include <caudal/mesh/straight_body.h>

#include <memory>

namespace caudal::ideal
{
  /**
   * A straight body that a gait bends in its plane: sections stay rigid and normal to the Spine,
   * X = m(s) + y N(s) + z e_3, with the nose in the frame's origin.
   */
  class BendingBody : public Deformation
  {
  public:
    BendingBody(const Surface &surface, const StraightBody &body, const Gait &gait);

    unsigned int n_modes() const override
    {
      return gait.n_coordinates();
    }

    bool is_symmetric() const override
    {
      return symmetric;
    }

    double get_length() const override
    {
      return length;
    }

    SurfaceMotion      place(const std::vector<double> &c) const override;
    FullMatrix<double> compute_body_mass(const std::vector<double> &c) const override;
    double             compute_bend(const std::vector<double> &c) const override;

    std::vector<std::vector<Tensor<1, 3>>>
    compute_mode_rates(const std::vector<double> &c,
                       const std::vector<double> &rates) const override;

    std::vector<double> compute_body_energy_gradient(const std::vector<double> &c,
                                                     const std::vector<double> &u) const override;

  private:
    const Gait  &gait;
    const double length;
    const bool   symmetric;

    std::vector<Point<3>>        node_places; // of the surface: (s, y, z)
    std::unique_ptr<const Spine> node_spine;

    std::vector<BodySlice>       slices;
    std::unique_ptr<const Spine> slice_spine;

    std::vector<double>          stations, half_widths; // where the bend is looked at
    std::unique_ptr<const Spine> station_spine;
  };
} // namespace caudal::ideal

#endif
