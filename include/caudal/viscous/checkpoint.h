// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_checkpoint_h
#define caudal_viscous_checkpoint_h

#include <caudal/base/declared_parameters.h>
#include <caudal/fluid/fluid_snapshot.h>
#include <caudal/io/checkpoints.h>
#include <caudal/viscous/operators.h>

#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>

namespace caudal
{
  /** Everything that the coming steps of an immersed run depend on, and its reports. */
  struct Checkpoint
  {
    unsigned int    step_number = 0;
    double          time        = 0; // [s]
    ParameterValues parameters;      // that made it
    FluidSnapshot   fluid;           // a part of it on each rank, archived apart
    /** Archives of everything else, by what they hold. */
    std::map<std::string, std::string> parts;

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &step_number &time &parameters &parts;
    }
  };

  /** Reads the checkpoint from a slot; this rank has its share of the fluid. */
  void read(const CheckpointSlot &slot, Checkpoint &checkpoint);

  /** The checkpoint of a @p state, without reports, with this rank's cells of the fluid. */
  template <int dim>
  Checkpoint take_checkpoint(const Operators<dim> &operators, const State<dim> &state);

  /** The state of the @p checkpoint; the operators go over to its grid. Collective. */
  template <int dim>
  State<dim> restore(const Checkpoint &checkpoint, Operators<dim> &operators);
} // namespace caudal

#endif
