#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/motion/math/pose.hpp"

namespace rubicon::why {

/// Since when something stands where it is in the way. Times in seconds from the beginning of the
/// plan.
struct Origin {
  enum class Kind {
    site,       ///< part of the site
    component,  ///< it stands there
    zone,       ///< people work there
    machine,    ///< another machine
    own         ///< the machine itself
  };
  Kind kind = Kind::site;
  std::string task;  ///< that put it there, or that it belongs to; "": it was there from the first
  double since = 0;
  bool at_work = false;  ///< of a machine: in that task; else it stands since the task ended
};

/// A refused step, asked once more of the collision engine.
struct ContactAnswer {
  double free_to = 0;  ///< share of the step up to which it is proved free of this pair
  math::Vec3 point_W = math::Vec3::Zero();  ///< of both bodies, where contact begins (m)
  double depth_at_end = 0;                  ///< m: how deep they would be, had the step been made
};

/// Something that the way to the goal meets.
struct InTheWay {
  std::string moved;
  std::string met;
  double from = 0;  ///< share of that way
  std::optional<Origin> origin;
};

/// How near a task came to what it did not touch.
struct NearestMiss {
  double range = 0;     ///< m: what is farther off was not looked at
  bool found = false;   ///< something is within the range
  double at_least = 0;  ///< m, certified: nothing came nearer
  double at_most = 0;   ///< m, between the two points
  int step = 0;         ///< by its number
  double time = 0;      ///< s, when the step began
  double share = 0;     ///< of the step
  std::string moved;
  std::string met;
  math::Vec3 moved_point_W = math::Vec3::Zero();
  math::Vec3 met_point_W = math::Vec3::Zero();
  std::vector<std::string> touched;  ///< at the beginning or end of a way, and so left out
};

}  // namespace rubicon::why
