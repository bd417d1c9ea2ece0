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
     * w_h = s_b = 0.04, s_t = 0.95, w_t = 0.01; with w_t = 0.002083 it tapers evenly from s_b on,
     * as IBAMR's eel does. Where the original tail ends in
     * a point, this one tapers to the half width 0.1 w_t, because a quadrilateral
     * can't end in a point: it adds 0.1 % to the area.
     */
    class EelOutline : public Outline
    {
    public:
      explicit EelOutline(const double tail_half_width)
          : w_t(tail_half_width)
      {}

      double half_thickness(const double s) const override
      {
        const double w_h = 0.04, s_b = 0.04, s_t = 0.95, w_tip = 0.1 * w_t;
        if (s < s_b)
          return std::sqrt(s * (2. * w_h - s));
        if (s < s_t)
          return w_h - (w_h - w_t) * (s - s_b) / (s_t - s_b);
        return w_t - (w_t - w_tip) * (s - s_t) / (1. - s_t);
      }

    private:
      const double w_t;
    };

    template <int dim>
    class EelShape : public SlenderShape<dim>
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Tail half-width", tail_half_width,
                          "Half the width at 95 % of the length, over the length [1].");
      }

      void check(const std::string &path) const override
      {
        require(tail_half_width > 1e-4 && tail_half_width <= 0.04, path, "Tail half-width",
                "the value is " + std::to_string(tail_half_width) +
                    ". Give more than 0.0001 and no more than 0.04, the half-width of the head.");
      }

    private:
      std::unique_ptr<Outline> make_outline() const override
      {
        return std::make_unique<EelOutline>(tail_half_width);
      }

      double tail_half_width = 0.01;
    };

    const DimensionalRegistration<Shape, EelShape> registration("eel", "Carling's eel (2D)");
  } // namespace
} // namespace caudal
