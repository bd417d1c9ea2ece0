// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_parameters_h
#define caudal_viscous_parameters_h

#include <caudal/base/parameter_file.h>
#include <caudal/base/time_stepping.h>
#include <caudal/coupling/interaction_operator.h>
#include <caudal/fluid/fluid_parameters.h>
#include <caudal/io/checkpoints.h>
#include <caudal/io/field_output.h>
#include <caudal/mesh/refinement.h>
#include <caudal/observe/observers.h>
#include <caudal/solid/body.h>
#include <caudal/viscous/coupled_solver.h>

namespace caudal
{
  /** All parameters of a run of the immersed swimmer. */
  template <int dim>
  struct RunParameters
  {
    /**
     * What grids, unknowns, columns of the tables or the kind of state depend on: entries that
     * can't change in the middle of a run, as a regular expression.
     */
    static constexpr const char *fixed_entries =
        "Model|Dimension|Bodies|Domain/.*|Time/Scheme|Fluid/Control volume|Fluid/Gravity|"
        "Fluid/Exact solution|Body [^/]*/(Regions|Polynomial degree|"
        "Region [^/]*/Motion|Shape/.*|Muscle/Type|Gait/Type)";

    std::string  model     = "immersed";
    unsigned int dimension = dim;
    std::string  bodies_text;

    TimeParameters                                    time;
    DomainParameters<dim>                             domain;
    FluidParameters<dim>                              fluid;
    CouplingParameters                                coupling;
    RefinementParameters                              refinement;
    SolverParameters                                  solver;
    OutputParameters                                  output;
    CheckpointParameters                              checkpoint;
    Observers<dim>                                    observers;
    std::vector<std::unique_ptr<BodyParameters<dim>>> bodies;

    /**
     * The bodies and their regions, which decide what sections there are, are
     * those that @p file names; without a file one body `<name>` with one region.
     */
    explicit RunParameters(const ParameterFile *file);

    /** Entries that had other names in earlier versions. */
    static std::vector<RenamedEntry> get_renamed_entries();

    void declare(ParameterHandler &prm);
    void check() const;
  };

  /** The space dimension that the file asks for: 2 or 3. */
  unsigned int get_dimension(const ParameterFile &file);
} // namespace caudal

#endif
