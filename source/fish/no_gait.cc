// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/fish/gait.h>

namespace caudal
{
  namespace
  {
    /** A spine without coordinates: straight in an ideal fluid, free in a viscous one. */
    class NoGait : public ModalGait
    {
    public:
      unsigned int n_coordinates() const override
      {
        return 0;
      }

      bool is_prescribed() const override
      {
        return false;
      }

    protected:
      GaitState evaluate_stroke(const double) const override
      {
        return {};
      }

      double mode(const unsigned int, const double) const override
      {
        return 0.;
      }
    };

    const Registration<Gait, NoGait> registration("none", "nothing is prescribed (in an ideal "
                                                          "fluid: a rigid body)");
  } // namespace
} // namespace caudal
