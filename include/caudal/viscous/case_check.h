#ifndef caudal_viscous_case_check_h
#define caudal_viscous_case_check_h

#include <caudal/viscous/parameters.h>
#include <caudal/viscous/time_scheme.h>

namespace caudal
{
  /** What a few steps from the start have cost. */
  struct TrialCost
  {
    unsigned int n_steps = 0;
    double       seconds = 0; // of wall time for a step but the first
    double       memory  = 0; // [MiB] on all ranks
  };

  /** What can be told of a case before it runs: its resolution, its costs, and doubts. */
  template <int dim>
  class CaseCheck
  {
  public:
    CaseCheck(const RunParameters<dim> &parameters, const ImmersedSystem<dim> &system);

    /** Thickness and spacing of the bodies on the fluid's grid, steps that the schemes can take. */
    void print_resolution(std::ostream &out) const;

    /** Wall time, memory and disk that the whole run is likely to take. */
    void print_costs(std::ostream &out, const TrialCost &trial) const;

    /** What is likely to spoil the results, each with a remedy. */
    std::vector<std::string> find_doubts() const;

  private:
    /** How a body lies on the fluid's grid and in the domain. */
    struct Body
    {
      std::string              path;
      std::vector<std::string> regions;
      std::vector<double>      thickness; // of the regions at their thinnest [m]
      bool                     swims            = false;
      double                   length           = 0; // [m]
      double                   spacing_ratio    = 0; // of its nodes to the finest fluid cells
      double                   room_ahead       = 0; // to the side that it swims to [m]
      double                   nearest_side     = 0; // [m]
      double                   beat_frequency   = 0; // [Hz]; 0 if it is not given
      double                   wave_speed       = 0; // of the fastest elastic waves [m/s]
      double                   spring_frequency = 0; // of its feedback springs [rad/s]
    };

    const RunParameters<dim> &parameters;
    const double              n_cells;
    const double              cell_size, kernel_width; // on the finest level [m]
    std::vector<Body>         bodies;

    Body   describe_body(const SwimmingBody<dim> &swimmer) const;
    void   measure_room(const SolidBody<dim> &solid, Body &body) const;
    void   add_thickness_doubts(std::vector<std::string> &doubts) const;
    void   add_domain_doubts(std::vector<std::string> &doubts) const;
    void   add_wake_doubts(std::vector<std::string> &doubts) const;
    double get_explicit_limit() const; // [s]
  };
} // namespace caudal

#endif
