// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef caudal_fish_muscle_h
#define caudal_fish_muscle_h

#include <caudal/fish/controller.h>
#include <caudal/fish/ramp.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <boost/serialization/vector.hpp>

#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace caudal
{
  /** A point of the body. */
  template <int dim>
  struct MaterialPoint
  {
    /** Place in the reference shape [m], in the body frame: origin at the nose,
        x towards the tail, y lateral. */
    Point<dim> s;
    /** The region of the body that it belongs to. */
    types::material_id region;
  };

  /** What a muscle has to remember from one step to the next, in its own terms. */
  using MuscleMemory = std::vector<double>;

  /** What a muscle does in one step: a value, which a rejected step forgets. */
  struct Contraction
  {
    double        begin = 0.; ///< of the step [s]
    double        step  = 0.; ///< its length [s]
    MuscleCommand command;
    MuscleMemory  before, after;

    /** What the muscle has decided for this step, in its own terms. */
    std::vector<double> decision;

    double get_middle() const
    {
      return begin + 0.5 * step;
    }

    template <class Archive>
    void serialize(Archive &archive, unsigned int /*version*/)
    {
      archive &begin &step &command.gain &command.bias &before &after &decision;
    }
  };

  /** The entries of section `Muscle` that the muscles share. */
  struct SharedMuscleParameters
  {
    std::vector<std::string> regions;
    double                   monitored_point = 0.96;
    StartUpRamp              ramp;
    std::string              force_distribution = "1";
  };

  /**
   * What drives the body: a force density f_a [N/m^3 of reference volume] and
   * an active stress S_a [Pa], a second Piola-Kirchhoff stress (P_a = F S_a),
   * both in the axes of the body frame. This base class is a passive muscle.
   *
   * After set_up() it does not change. What it does in a step is decided at its beginning by
   * contract(), from its memory; accepting the step is keeping Contraction::after as the memory.
   */
  template <int dim>
  class Muscle : public Plugin
  {
  public:
    /**
     * Prepares the muscle for a body of length @p length [m] whose regions have the numbers
     * @p region_ids by name; throws if a region is not known.
     */
    virtual void set_up(const SharedMuscleParameters &shared, double length,
                        const std::map<std::string, types::material_id> &region_ids = {});

    /** The memory at the start of a run. */
    virtual MuscleMemory get_initial_memory() const
    {
      return {};
    }

    /** Throws unless @p memory, read from a checkpoint, is that of such a muscle. */
    void check_memory(const MuscleMemory &memory) const;

    /** The muscle's decision for the step that @p state describes. */
    virtual Contraction contract(const MuscleMemory &memory, const SwimmerState &state,
                                 const MuscleCommand &command) const
    {
      return {state.time, state.step, command, memory, memory, {}};
    }

    virtual bool has_force() const
    {
      return false;
    }

    virtual bool has_active_stress() const
    {
      return false;
    }

    /** Frequency of the beat [Hz] if the muscle alone decides on it; otherwise 0. */
    virtual double get_beat_frequency() const
    {
      return 0.;
    }

    /** The first and the last time [s] of which the muscle knows something. */
    virtual std::pair<double, double> get_time_range() const
    {
      return {0., std::numeric_limits<double>::max()};
    }

    /** Whether it can pull harder on one side than on the other. */
    virtual bool can_steer() const
    {
      return true;
    }

    /** Whether it counts the arc length s from x = 0 of the body frame. */
    virtual bool counts_from_nose() const
    {
      return has_force() || has_active_stress();
    }

    /** f_a at @p time, which lies in the step of @p contraction or at its end. */
    virtual Tensor<1, dim> force_density(const Contraction & /*contraction*/,
                                         const MaterialPoint<dim> & /*point*/,
                                         double /*time*/) const
    {
      return Tensor<1, dim>();
    }

    /** S_a, likewise. */
    virtual Tensor<2, dim> active_stress(const Contraction & /*contraction*/,
                                         const MaterialPoint<dim> & /*point*/,
                                         double /*time*/) const
    {
      return Tensor<2, dim>();
    }

    /** Activation in the middle of the step, 1 at full strength (for the statistics). */
    virtual double activation(const Contraction & /*contraction*/) const
    {
      return 0.;
    }

  protected:
    /** Whether the muscle reaches into the region. */
    bool acts_in(const types::material_id region) const
    {
      return active_regions.empty() || active_regions.count(region) > 0;
    }

    double      length = 1.;
    StartUpRamp ramp;

  private:
    std::set<types::material_id> active_regions; // empty: all
  };

  /** Section `Muscle` of a body. */
  template <int dim>
  struct MuscleParameters
  {
    Choice<Muscle<dim>>    type{"Type", "none", "What drives the body"};
    SharedMuscleParameters shared;

    /** Declares the section in the one that @p prm is in. */
    void add_parameters(ParameterHandler &prm);

    /** Throws a sentence about the first bad entry; @p path is the body's section. */
    void check(const std::string &path) const;

    /** The chosen muscle, for a body of length @p length [m] with these regions. */
    std::unique_ptr<Muscle<dim>>
    create(const double                                     length,
           const std::map<std::string, types::material_id> &region_ids = {}) const
    {
      std::unique_ptr<Muscle<dim>> muscle = type.create();
      muscle->set_up(shared, length, region_ids);
      return muscle;
    }
  };
} // namespace caudal

#endif
