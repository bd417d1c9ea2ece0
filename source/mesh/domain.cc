// SPDX-License-Identifier: LGPL-2.1-or-later
#include <caudal/base/checks.h>
#include <caudal/base/expression.h>
#include <caudal/mesh/domain.h>

#include <deal.II/distributed/p4est_wrappers.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

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
    prm.add_parameter("Periodic directions", periodic_directions,
                      "Directions in which the domain repeats itself, letters of xyz: what leaves "
                      "it on one side comes back on the other, bodies, too, whose positions go on "
                      "counting. Such sides have no boundary conditions. Two bodies that meet "
                      "across such a side are not noticed.",
                      Patterns::Selection("none|x|y|z|xy|xz|yz|xyz"));
    prm.add_parameter(
        "Frame", frame,
        "How the grid moves, with all that is said of places in it: levels, probes, control "
        "volume. "
        "fixed: not at all; moving: by Frame velocity; the name of a body: it follows its centre "
        "of "
        "mass, smoothly, so that a fish has always the same room ahead. Velocities are absolute, "
        "bodies and fields are reported where they are in the laboratory, and sides keep their "
        "conditions: a wall lets fluid pass as it moves and holds what touches it.",
        Patterns::Anything());
    prm.add_parameter("Frame velocity", frame_velocity,
                      "Velocity of a moving grid [m/s], functions of t, components separated by "
                      "';'.",
                      Patterns::Anything());
    prm.add_parameter("Frame time", frame_time,
                      "Time in which the grid comes after the body that it follows [s]; 0: a beat, "
                      "if the parameters tell how long it takes, else 1 s.");
    prm.leave_subsection();
  }

  template <int dim>
  void DomainParameters<dim>::check() const
  {
    for (unsigned int d = 0; d < dim; ++d)
      check_positive("Domain/Size", size[d], "Give positive lengths [m].");
    check_between("Domain/Levels", levels, 1, 12, "Give 1 to 12.");
    AssertThrow(dim == 3 || periodic_directions.find('z') == std::string::npos,
                ExcMessage("Domain/Periodic directions: the value is " + periodic_directions +
                           ", and z is normal to the plane. Give none, x, y or xy."));
    for (unsigned int d = 0; d < dim; ++d)
      AssertThrow(!is_periodic(d) || cells[d] > 1,
                  ExcMessage("Domain/Cells: there is one coarse cell in a periodic direction. Give "
                             "two at least."));
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

  template <int dim>
  void DomainParameters<dim>::check_frame(const std::vector<std::string> &bodies,
                                          const bool                      is_explicit) const
  {
    AssertThrow(frame == "fixed" || frame == "moving" ||
                    std::find(bodies.begin(), bodies.end(), frame) != bodies.end(),
                ExcMessage("Domain/Frame: the value is <" + frame +
                           ">. Give fixed, moving or the name of a body."));
    for (const std::string &body : bodies)
      AssertThrow(body != "fixed" && body != "moving",
                  ExcMessage("Bodies: a body can't be called " + body +
                             ", which Domain/Frame has another meaning for. Give another name."));
    AssertThrow(
        frame_time == 0. || (has_moving_frame() && frame != "moving"),
        ExcMessage("Domain/Frame time: it belongs to a grid that follows a body. Set Frame, "
                   "or leave it at 0."));
    AssertThrow(!has_moving_frame() || !is_explicit,
                ExcMessage("Domain/Frame: a grid that moves needs Time/Scheme = semi-implicit."));
    AssertThrow(
        (frame == "moving") == !frame_velocity.empty(),
        ExcMessage(frame == "moving"
                       ? "Domain/Frame velocity: it is empty. Give the velocity of the moving "
                         "grid."
                       : "Domain/Frame velocity: it belongs to Frame = moving. Set that, or "
                         "leave it empty."));
    if (frame == "moving")
      Expression<dim>("Domain/Frame velocity", frame_velocity, dim);
    check_not_negative("Domain/Frame time", frame_time, "Give a positive time [s], or 0.");
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
    std::vector<GridTools::PeriodicFacePair<typename Triangulation<dim>::cell_iterator>> pairs;
    for (unsigned int d = 0; d < dim; ++d)
      if (parameters.is_periodic(d))
        GridTools::collect_periodic_faces(triangulation, 2 * d, 2 * d + 1, d, pairs);
    if (!pairs.empty())
      triangulation.add_periodicity(pairs);
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
