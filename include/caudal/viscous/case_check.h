// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_case_check_h
#define caudal_viscous_case_check_h

#include <caudal/viscous/body_resolution.h>
#include <caudal/viscous/cost_estimate.h>

#include <array>

namespace caudal
{
  // In FSI3 with steps of 5 ms, all whose figures are right.
  constexpr double largest_cfl = 7;

  /** Resolution and costs of a case, and what may go wrong, as far as it is known before it runs.
   */
  template <int dim>
  class CaseCheck
  {
  public:
    /** At the start, where the fluid's grid has @p n_cells; 0 if that is not known. */
    CaseCheck(const Operators<dim> &operators, unsigned int n_cells);

    /** Thickness and spacing of the bodies on the fluid's grid, steps that the schemes can take. */
    void print_resolution(std::ostream &out) const;

    /** Wall time, memory and disk that the whole run is likely to take, a step of it being so. */
    void print_costs(std::ostream &out, const StepCost &step) const;

    /** What is likely to spoil the results, each with a remedy. */
    std::vector<std::string> find_warnings() const;

  private:
    /** How a body lies on the fluid's grid and in the domain. */
    struct BodyOnGrid
    {
      const Body<dim>         &body;
      std::string              path;
      BodyResolution<dim>      resolution;
      double                   room_ahead       = 0;  // to the side that it swims to [m]
      double                   adverse_current  = 0;  // of the water at the start [m/s]
      double                   nearest_side     = 0;  // [m]
      double                   wave_speed       = 0;  // of the fastest elastic waves [m/s]
      double                   material_speed   = 0;  // likewise, without numerical stabilisations
      double                   spring_frequency = 0;  // of its feedback springs [rad/s]
      std::vector<std::string> remarks          = {}; // on its materials

      /** Whether no spring and no fixed region holds it. */
      bool is_free() const;

      bool swims() const
      {
        return body.undulates();
      }
      const std::vector<std::string> &get_regions() const
      {
        return body.get_parameters().solid.regions;
      }
    };

    const Operators<dim>     &operators;
    const RunParameters<dim> &parameters;
    const FlowScales          scales;
    const double              grad_div;       // [m^2/s]
    const double              outflow_change; // of prescribed outflows, to balance inflows
    const double              n_cells;
    const double              cell_size, kernel_width; // on the finest level [m]
    std::vector<BodyOnGrid>   bodies;
    std::array<bool, dim>     is_crossed{}; // planes by the number of their normals, see below

    BodyOnGrid describe_body(const Body<dim> &body) const;
    void       measure_room(BodyOnGrid &body) const;
    void       add_thickness_warnings(std::vector<std::string> &warnings) const;
    void       add_layer_warnings(const BodyOnGrid &body, std::vector<std::string> &warnings) const;
    void       add_domain_warnings(std::vector<std::string> &warnings) const;
    void       add_wake_warnings(std::vector<std::string> &warnings) const;
    void       add_flow_warnings(std::vector<std::string> &warnings) const;
    void       add_body_warnings(std::vector<std::string> &warnings) const;
    unsigned   find_mirror(const SolidBody<dim> &solid) const;
    void       print_flow(std::ostream &out) const;
    bool       has_swimmers() const;
    double     get_boundary_layer() const; // [m]
    double     get_explicit_limit() const; // [s]
  };
} // namespace caudal

#endif
