// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/mesh/domain.h>

#include <deal.II/distributed/p4est_wrappers.h>
#include <deal.II/grid/grid_generator.h>

#include <cmath>

namespace caudal
{
  template <int dim>
  DomainParameters<dim>::DomainParameters()
  {
    for (unsigned int d = 0; d < dim; ++d)
      size[d] = 1;
  }

  template <int dim>
  void DomainParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Domain");
    prm.add_parameter("Lower corner", lower_corner, "Corner with the smallest coordinates [m].");
    prm.add_parameter("Size", size, "Lengths of the box [m].");
    prm.add_parameter("Cells", cells, "Numbers of coarse cells in each direction [1].",
                      Patterns::List(Patterns::Integer(1), dim, dim));
    prm.add_parameter("Levels", levels,
                      "Number of refinement levels, the coarse grid included [1].",
                      Patterns::Integer(1));
    prm.leave_subsection();
  }

  template <int dim>
  void DomainParameters<dim>::check() const
  {
    for (unsigned int d = 0; d < dim; ++d)
      check_positive("Domain/Size", size[d], "Give positive lengths [m].");
    check_between("Domain/Levels", levels, 1, 12, "Give 1 to 12.");
    const Tensor<1, dim> edges   = get_cell_size(0);
    std::string          squares = std::to_string(cells[0]);
    for (unsigned int d = 1; d < dim; ++d)
      squares += ", " + std::to_string(std::max(1L, std::lround(size[d] / edges[0])));
    for (unsigned int d = 1; d < dim; ++d)
      AssertThrow(edges[d] / edges[0] < 2.001 && edges[0] / edges[d] < 2.001,
                  ExcMessage("Domain/Cells: the cells have edges of " + std::to_string(edges[0]) +
                             " m and " + std::to_string(edges[d]) +
                             " m, and have to be nearly square. Give " + squares + "."));
  }

  std::vector<std::string> get_side_names(const unsigned int dim)
  {
    std::vector<std::string> names = {"left", "right", "bottom", "top", "back", "front"};
    names.resize(2 * dim);
    return names;
  }

  template <int dim>
  void make_domain(parallel::distributed::Triangulation<dim> &triangulation,
                   const DomainParameters<dim>               &parameters)
  {
    GridGenerator::subdivided_hyper_rectangle(triangulation, parameters.cells,
                                              parameters.lower_corner,
                                              parameters.lower_corner + parameters.size,
                                              /*colorize=*/true);
  }

  template <int dim>
  void make_canonical(parallel::distributed::Triangulation<dim> &triangulation,
                      const DomainParameters<dim>               &domain)
  {
    using Forest   = typename internal::p4est::types<dim>::forest;
    using P4est    = internal::p4est::functions<dim>;
    Forest *forest = P4est::copy_forest(const_cast<Forest *>(triangulation.get_p4est()), 0);
    triangulation.clear();
    make_domain(triangulation, domain);
    // The one that the copy had is gone.
    forest->connectivity = triangulation.get_p4est()->connectivity;
    triangulation.load(forest);
    P4est::destroy(forest);
  }

  template struct DomainParameters<2>;
  template struct DomainParameters<3>;
  template void make_domain(parallel::distributed::Triangulation<2> &, const DomainParameters<2> &);
  template void make_domain(parallel::distributed::Triangulation<3> &, const DomainParameters<3> &);
  template void make_canonical(parallel::distributed::Triangulation<2> &,
                               const DomainParameters<2> &);
  template void make_canonical(parallel::distributed::Triangulation<3> &,
                               const DomainParameters<3> &);
} // namespace caudal
