#ifndef caudal_viscous_grid_adaptation_h
#define caudal_viscous_grid_adaptation_h

#include <caudal/mesh/refinement.h>
#include <caudal/viscous/time_scheme.h>

namespace caudal
{
  /** What an adaptation of the grid has changed. */
  struct AdaptationReport
  {
    bool         changed = false;
    unsigned int n_cells = 0;
    /** Kinetic energy and (relative to rho U volume) momentum: after minus before [J/m], [1] */
    double kinetic_energy_change = 0;
    double momentum_change       = 0;
  };

  /**
   * Keeps the fluid's grid fine around the bodies and their wake. Fields are
   * interpolated to the new grid and the velocities then projected to
   * discretely divergence-free ones.
   */
  template <int dim>
  class GridAdaptation
  {
  public:
    GridAdaptation(parallel::distributed::Triangulation<dim> &triangulation, FluidSpace<dim> &space,
                   const RefinementParameters &parameters, const ImmersedSystem<dim> &system);

    /** Refines the coarse grid where bodies and initial velocity need it. */
    void make_initial_grid();

    /** Whether the bodies, soon to be at their extrapolated places, come near coarser cells. */
    bool is_needed() const;

    AdaptationReport adapt(double time, double old_time, double step);

    /** What follows from the grid alone, after each change of it. */
    void set_up_operators();

  private:
    parallel::distributed::Triangulation<dim> &triangulation;
    FluidSpace<dim>                           &space;
    const RefinementParameters                &parameters;
    ImmersedSystem<dim>                        system;

    CellSet<dim> make_body_cells(double margin) const;
    bool         set_flags(const CellSet<dim> &body_cells, double time) const;
    void         transfer(double time, double old_time);
    void         project(FieldVector &velocity, double step);
  };
} // namespace caudal

#endif
