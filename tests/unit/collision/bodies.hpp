#pragma once

#include "tests/unit/collision/random_scene.hpp"

namespace rubicon::collision::test {

/// A box, sphere, cylinder, capsule, prism with a notch, or L of triangles, of about a metre.
BodyPtr random_body(Random& random);

/// A translation or screw of about half a metre.
Motion random_motion(Random& random);

/// The part [s0, s1] of a screw as a motion of its own.
Motion part_of(const Motion& motion, double s0, double s1);

/// What a random site is made of: each body may stand in many places.
std::vector<BodyPtr> site_bodies();

}  // namespace rubicon::collision::test
