#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "src/motion/coverage/grid.hpp"

namespace rubicon::coverage {

/// A straight stretch that a tool worked without a stop and at one speed, in the plan view, m.
struct LaidStretch {
  Place from;
  Place to;
  std::int64_t begin = 0;  ///< ticks, when the tool was at `from`
  std::int64_t end = 0;    ///< ticks, when it was at `to`
};

/// A joint at which what was laid first had lain for longer than the limit when the rest came.
struct ColdJoint {
  Place from;               ///< m; of the stretch that is too old
  Place to;                 ///< m
  std::int64_t age = 0;     ///< ticks; of what was laid first, where it is oldest
  std::int64_t laid = 0;    ///< ticks; when that was laid
  std::int64_t joined = 0;  ///< ticks; when the rest came beside it
};

/// The joints between all that a tool laid.
struct JointFindings {
  double joint_length = 0;      ///< m; of all joints
  double cold_length = 0;       ///< m; of those older than the limit
  std::int64_t oldest = 0;      ///< ticks; the greatest age of a joint
  Place oldest_at;              ///< m; where that is
  std::vector<ColdJoint> cold;  ///< in the order in which they are joined; neighbours are one
};

/// The joints between stretches of `width`, in the order in which they were laid. A stretch is a
/// rectangle; the edge of one that nothing lies beside yet is free. The first later stretch that
/// lies on the outer side of a piece of a free edge, within kJointGap of it, makes a joint there.
/// Its age is the time from when the tool passed that place of the first stretch to when it passed
/// it on the second: linear along the joint, so that the oldest place and the length that is over
/// `limit` (ticks) are exact. The edge where the tool stopped, at the end of a line or of a shift,
/// is an edge like the others.
JointFindings find_joints(const std::vector<LaidStretch>& laid, double width, std::int64_t limit);

/// m: stretches that are nearer than this touch.
inline constexpr double kJointGap = 0.03;
/// m: joints shorter than this are corners that touch.
inline constexpr double kShortestJoint = 0.05;

}  // namespace rubicon::coverage
