// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_observe_flow_quantity_h
#define caudal_observe_flow_quantity_h

#include <caudal/base/plugin_list.h>

#include <deal.II/base/tensor.h>

namespace caudal
{
  /**
   * A scalar of the velocity's gradient that becomes a field of the fluid if `Output/Additional
   * fields` names it. The name under which it is registered is that of the field.
   */
  template <int dim>
  class FlowQuantity : public Plugin
  {
  public:
    const unsigned int place = last_place;

    /** Its value where du_i/dx_j = @p gradient[i][j] [1/s]. */
    virtual double evaluate(const Tensor<2, dim> &gradient) const = 0;
  };
} // namespace caudal

#endif
