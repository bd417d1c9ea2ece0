// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/compatibility.h>
#include <caudal/mesh/canonical_grid.h>

#include <deal.II/distributed/p4est_wrappers.h>

namespace caudal
{
  template <int dim>
  void make_canonical(parallel::distributed::Triangulation<dim> &triangulation,
                      const DomainParameters<dim>               &domain)
  {
    using Forest = typename internal::p4est::types<dim>::forest;
    using P4est  = internal::p4est::functions<dim>;
    // The copy outlives the connectivity of the triangulation: it gets that of another one.
    parallel::distributed::Triangulation<dim> coarse(
        compatibility::get_communicator(triangulation));
    make_domain(coarse, domain);
    Forest *forest       = P4est::copy_forest(const_cast<Forest *>(triangulation.get_p4est()), 0);
    forest->connectivity = coarse.get_p4est()->connectivity;
    triangulation.clear();
    make_domain(triangulation, domain);
    triangulation.load(forest);
    P4est::destroy(forest);
  }

  template void make_canonical(parallel::distributed::Triangulation<2> &,
                               const DomainParameters<2> &);
  template void make_canonical(parallel::distributed::Triangulation<3> &,
                               const DomainParameters<3> &);
} // namespace caudal
