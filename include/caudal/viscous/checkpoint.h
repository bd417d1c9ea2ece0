// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_viscous_checkpoint_h
#define caudal_viscous_checkpoint_h

#include <caudal/base/declared_parameters.h>
#include <caudal/fluid/fluid_snapshot.h>
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
    FluidSnapshot   fluid;
    /** Archives of everything else, by what they hold. */
    std::map<std::string, std::string> parts;

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &step_number &time &parameters &fluid &parts;
    }
  };

  /** The checkpoint of a @p state, without reports; complete on rank 0. Collective. */
  template <int dim>
  Checkpoint take_checkpoint(const Operators<dim> &operators, const State<dim> &state);

  /** The state of the @p checkpoint; the operators go over to its grid. Collective. */
  template <int dim>
  State<dim> restore(const Checkpoint &checkpoint, Operators<dim> &operators);
} // namespace caudal

#endif
