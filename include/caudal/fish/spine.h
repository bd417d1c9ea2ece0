// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_spine_h
#define caudal_fish_spine_h

#include <caudal/fish/gait.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace caudal
{
  /** The bent spine at a place along it: vectors in the body's frame, in the plane of the bend. */
  struct SpinePoint
  {
    Tensor<1, 2> position; ///< m(s), from the nose on [m]
    Tensor<1, 2> tangent; ///< T = (cos theta, sin theta); the normal is N = (-sin theta, cos theta)

    std::vector<double>       turn_by_c;     ///< H_i = d theta/dc_i
    std::vector<Tensor<1, 2>> position_by_c; ///< W_i = dm/dc_i

    // With rates c_j' of the coordinates, the rates of these two.
    std::vector<double>       turn_by_c_rate;     ///< sum_j c_j' dH_i/dc_j
    std::vector<Tensor<1, 2>> position_by_c_rate; ///< sum_j c_j' dW_i/dc_j

    Tensor<1, 2> get_normal() const
    {
      return Point<2>(-tangent[1], tangent[0]);
    }
  };

  /**
   * The spine m(s), dm/ds = T = (cos theta, sin theta), which starts at the nose, the frame's
   * origin, seen at given places. Sections stay normal to it, X = m(s) + y N(s), and the body
   * keeps the volume of a symmetric section. Then dX/dc_i = W_i - y H_i T, W_i = int H_i N ds.
   *
   * Integrals by Gauss quadrature on 112 equal intervals (the hats of the joints have their kinks
   * between them) up to the place.
   */
  class Spine
  {
  public:
    static constexpr unsigned int n_intervals = 112;

    /** @p places are arc lengths [m]. The gait has to outlive the object. */
    Spine(const Gait &gait, const std::vector<double> &places);

    /** The spine for the coordinates @p c of the gait; with their @p rates also the rates. */
    std::vector<SpinePoint> bend(const std::vector<double> &c,
                                 const std::vector<double> &rates = {}) const;

  private:
    static constexpr unsigned int n_quadrature_points = 4;

    void add_piece(double begin, double end);

    const Gait &gait;

    /** Where the angles are needed: the quadrature points of all pieces, then the places. */
    std::vector<double> points;
    std::vector<double> weights; // of the quadrature points [m]

    std::vector<unsigned int> intervals; // that the places are in
  };
} // namespace caudal

#endif
