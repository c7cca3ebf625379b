#pragma once

#include <array>
#include <utility>
#include <vector>

#include "bench/swept_scene.hpp"

namespace rubicon::bench {

/// The bodies of robots/tower_crane/tower_crane.robot, and what hangs on its hook.
enum CranePart { kMast, kJib, kCounterJib, kTrolley, kHook, kLoad };
inline constexpr int kCraneParts = 6;

/// The boxes of each body in its own frame; the load is a plank.
std::array<std::vector<geometry::Box>, kCraneParts> crane_boxes();

/// One step of one parameter.
struct CraneStep {
  std::array<geometry::ScrewMotion, kCraneParts> motions;
  std::array<bool, kCraneParts> moves{};
  bool loaded = true;

  /// Parts that the step moves against each other and that may not meet: no parent with its child,
  /// not the load with its hook.
  std::vector<std::pair<int, int>> pairs() const;
};

/// Brings planks from a stack beside the building to `places` (their centres) and goes back empty:
/// up, trolley in, slew, trolley out, down, as behaviour lift_over does, in steps of 2 degrees and
/// half a metre.
std::vector<CraneStep> crane_path(const std::vector<Vec3>& places);

}  // namespace rubicon::bench
