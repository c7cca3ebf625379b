#pragma once

#include <cstddef>
#include <vector>

#include "src/motion/math/pose.hpp"

namespace rubicon::gltf {

using math::Vec3;

/// A value at a moment; between keys it runs in a straight line.
struct Key {
  double time = 0;  ///< s
  Vec3 value = Vec3::Zero();
};
using KeyCurve = std::vector<Key>;

/// The curve with as few of its own keys as leave it within `slack` of itself in every component.
/// Greedy: each straight piece goes on as long as one line passes all its keys (the "swinging door"
/// of Bristol, 1990).
KeyCurve reduced(const KeyCurve& curve, double slack);

/// The curve with keys added where the first component, an angle in degrees, turns by more than
/// `most` from one key to the next.
KeyCurve with_short_turns(const KeyCurve& curve, double most);

/// How many keys that makes, without making them.
std::size_t count_with_short_turns(const KeyCurve& curve, double most);

}  // namespace rubicon::gltf
