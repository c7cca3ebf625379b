#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/simulation/taskplan/stage.hpp"

namespace rubicon::taskplan {

/// How people turn the load of a task while they adjust it.
struct LoadTurning {
  double angle_deg = 0;  ///< counter-clockwise as seen from above; 0: it hangs as it is to stand
  std::optional<interpreter::HitPair> refused;  ///< what the shorter way would meet, where this is
                                                ///< the longer one
  /// What each way meets, the shorter first; empty: `angle_deg` is free.
  std::vector<interpreter::HitPair> hits;
};

/// The turn that brings the load to how it is to stand where it is set down; the shorter way, or
/// the longer one if that is barred. It must hang; people need `duration` for it.
LoadTurning load_turning(Stage& stage, int task, Ticks duration);

/// Why no turn about the vertical brings the load to how it is to stand; nothing if one does.
std::optional<std::string> why_not_by_turning(const Stage& stage, int task);

/// Why the turn is rejected.
std::string text_of_barred(const LoadTurning& turning, const std::string& component);

}  // namespace rubicon::taskplan
