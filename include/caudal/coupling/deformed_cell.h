// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_coupling_deformed_cell_h
#define caudal_coupling_deformed_cell_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace caudal
{
  using namespace dealii;

  /** One deformed cell of a body after the other, with quadrature points for the fluid around. */
  template <int dim>
  class DeformedCell
  {
  public:
    /**
     * The body has the nodal positions @p positions; neighbouring points of a deformed cell are
     * @p largest_spacing apart at most, as long as 32 in each direction do. The body's surface has
     * points of its own, weighted as @p surface_weight times a layer of cells.
     */
    DeformedCell(const DoFHandler<dim> &dofs, const Vector<double> &positions,
                 double largest_spacing, double surface_weight);

    void reinit(const typename DoFHandler<dim>::active_cell_iterator &new_cell);

    unsigned int n_points() const;

    const std::vector<types::global_dof_index> &get_indices() const
    {
      return indices;
    }

    /** A box that holds the cell: bent edges reach beyond that of the nodes. */
    BoundingBox<dim> get_box() const;

    /**
     * Calls operation(place, weight, values of the scalar shape functions) for each point, of the
     * volume and of the surface; the weights are those of the reference shape.
     */
    void for_each_point(const std::function<void(const Point<dim> &, double,
                                                 const std::vector<double> &)> &operation);

  private:
    const FiniteElement<dim> &element;
    const Vector<double>     &positions;
    const double              largest_spacing, surface_weight;

    typename DoFHandler<dim>::active_cell_iterator cell;
    std::vector<types::global_dof_index>           indices;
    std::vector<Point<dim>>                        nodes;

    /** Numbers of Gauss points in each direction, and a face or the volume. */
    using Numbers = std::array<unsigned int, dim>;
    using Rule    = std::pair<Numbers, unsigned int>;
    Numbers                   n{};
    std::vector<unsigned int> parts; // of the cell: the volume, and faces on the surface

    std::map<Rule, std::unique_ptr<FEValues<dim>>> values_by_rule;

    FEValues<dim> &get_values(unsigned int part);
  };
} // namespace caudal

#endif
