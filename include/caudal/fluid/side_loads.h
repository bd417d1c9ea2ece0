// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fluid_side_loads_h
#define caudal_fluid_side_loads_h

#include <caudal/fluid/boundary_condition.h>
#include <caudal/fluid/cell_loads.h>

#include <memory>

namespace caudal
{
  /** The loads int t.N_i dS of the tractions t(x, t) that are prescribed on sides. */
  template <int dim>
  class SideLoads : public CellLoads<dim>
  {
  public:
    using Conditions = std::vector<std::unique_ptr<BoundaryCondition<dim>>>;

    /** @p conditions are those on the sides, by boundary id. */
    explicit SideLoads(const Conditions &conditions);

    /**
     * Computes the loads of the locally owned cells of @p dofs at this @p instant, unless that has
     * been done. Throws if a traction is not finite, which can happen on one rank only.
     */
    void update(const DoFHandler<dim> &dofs, const Instant &instant);

    /** Whether no side has a traction, and there are no loads. */
    bool are_zero() const
    {
      return !has_tractions;
    }

  private:
    const Conditions &conditions;
    const bool        has_tractions;
  };
} // namespace caudal

#endif
