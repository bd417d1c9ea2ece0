// SPDX-License-Identifier: LGPL-2.1-or-later
// Straight bodies and gaits from entries of the sections Shape and Gait.
#ifndef caudal_tests_ideal_bodies_h
#define caudal_tests_ideal_bodies_h

#include <caudal/fish/gait.h>
#include <caudal/ideal/bending_body.h>
#include <caudal/mesh/shape.h>

#include "../entries.h"
#include "pulsating_sphere.h"

namespace caudal::ideal
{
  // A body of a length of 0.1 m, unless the entries say another one.
  inline std::unique_ptr<StraightBody> make_body(const Entries &entries)
  {
    ShapeParameters<3> parameters("stations", 0.1);
    ParameterHandler   prm;
    parameters.add_entries(prm);
    set_entries(prm, entries);
    parameters.check("Shape");
    return parameters.make_straight_body("Shape");
  }

  inline std::unique_ptr<Gait> make_gait(const Entries &entries, const double length)
  {
    GaitParameters parameters("arctangent");
    set_entries(parameters, "Gait", entries);
    parameters.check("Body fish");
    return parameters.create(length);
  }

  // A gait with its body: bent, or the pulsating sphere of this radius if the gait is its own.
  struct TestBody
  {
    TestBody(const Surface &surface, const Entries &shape_entries, const Entries &gait_entries)
        : straight(make_body(shape_entries))
        , gait(make_gait(gait_entries, straight->get_length()))
        , deformation(std::make_unique<BendingBody>(surface, *straight, *gait))
    {}

    TestBody(const Surface &surface, const double radius, const double amplitude)
        : gait(std::make_unique<PulsatingGait>())
        , deformation(std::make_unique<PulsatingSphere>(surface, radius, amplitude, 2))
    {}

    std::unique_ptr<StraightBody> straight;
    std::unique_ptr<Gait>         gait;
    std::unique_ptr<Deformation>  deformation;
  };
} // namespace caudal::ideal

#endif
