// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/outline.h>

#include <cmath>

namespace caudal
{
  namespace
  {
    /**
     * NACA's four-digit airfoils with the standard, open trailing edge
     * (Jacobs, Ward and Pinkerton, NACA Report 460, 1933):
     *   h(s) = 5 t (0.2969 sqrt(s) - 0.1260 s - 0.3516 s^2 + 0.2843 s^3 - 0.1015 s^4),
     * so that the tail of a NACA 0012 ends bluntly, 0.252 % of the chord thick.
     * The digits are camber and position of the largest camber (in hundredths
     * and tenths of the chord), and thickness t (in hundredths).
     */
    class NacaOutline : public Outline
    {
    public:
      explicit NacaOutline(const std::string &digits)
          : largest_camber(0.01 * (digits.at(0) - '0'))
          , camber_position(0.1 * (digits.at(1) - '0'))
          , thickness(0.01 * std::stoi(digits.substr(2, 2)))
      {}

      double half_thickness(const double s) const override
      {
        return 5. * thickness *
               (0.2969 * std::sqrt(s) + s * (-0.1260 + s * (-0.3516 + s * (0.2843 - s * 0.1015))));
      }

      double camber(const double s) const override
      {
        const double m = largest_camber, p = camber_position;
        if (s < p)
          return m / (p * p) * (2. * p * s - s * s);
        return m / ((1. - p) * (1. - p)) * (1. - 2. * p + 2. * p * s - s * s);
      }

      double camber_slope(const double s) const override
      {
        const double m = largest_camber, p = camber_position;
        return 2. * m * (p - s) / (s < p ? p * p : (1. - p) * (1. - p));
      }

    private:
      const double largest_camber, camber_position, thickness;
    };

    /** An airfoil as a fish seen from above. */
    template <int dim>
    class NacaShape : public SlenderShape<dim>
    {
    public:
      void add_parameters(ParameterHandler &prm) override
      {
        prm.add_parameter("Digits", digits,
                          "Camber [hundredths of the chord], its position [tenths], and thickness "
                          "[hundredths, two digits].");
      }

      void check(const std::string &path) const override
      {
        require(digits.size() == 4 && digits.find_first_not_of("0123456789") == std::string::npos,
                path, "Digits",
                "<" + digits + "> is no four-digit airfoil. Give four digits, such as 0012.");
        require(digits.substr(2) != "00", path, "Digits",
                "an airfoil " + digits + " has no thickness. Give last two digits above 00.");
        require((digits[0] == '0') == (digits[1] == '0'), path, "Digits",
                "of camber and its position in " + digits +
                    " just one is zero. Give both (2412) or none (0012).");
      }

    private:
      std::unique_ptr<Outline> make_outline() const override
      {
        return std::make_unique<NacaOutline>(digits);
      }

      std::string digits = "0012";
    };

    const DimensionalRegistration<Shape, NacaShape> registration("naca",
                                                                 "a NACA four-digit airfoil (2D)");
  } // namespace
} // namespace caudal
