// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/outline.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    /**
     * Carling's eel (Carling, Williams and Bowtell 1998; Kern and Koumoutsakos
     * 2006): half width
     *   sqrt(2 w_h s - s^2)                          for s < s_b,
     *   w_h - (w_h - w_t) (s - s_b) / (s_t - s_b)    for s_b <= s < s_t,
     *   w_t (1 - s) / (1 - s_t)                      beyond,
     * w_h = s_b = 0.04, s_t = 0.95, w_t = 0.01. Where the original tail ends in
     * a point, this one tapers to the half width 0.1 w_t, because a quadrilateral
     * can't end in a point: it adds 0.1 % to the area.
     */
    class EelOutline : public Outline
    {
    public:
      double half_thickness(const double s) const override
      {
        const double w_h = 0.04, s_b = 0.04, w_t = 0.01, s_t = 0.95, w_tip = 0.1 * w_t;
        if (s < s_b)
          return std::sqrt(s * (2. * w_h - s));
        if (s < s_t)
          return w_h - (w_h - w_t) * (s - s_b) / (s_t - s_b);
        return w_t - (w_t - w_tip) * (s - s_t) / (1. - s_t);
      }
    };

    template <int dim>
    class EelShape : public SlenderShape<dim>
    {
      std::unique_ptr<Outline> make_outline() const override
      {
        return std::make_unique<EelOutline>();
      }
    };

    const DimensionalRegistration<Shape, EelShape> registration("eel", "Carling's eel (2D)");
  } // namespace
} // namespace caudal
