#pragma once

#include <cstdint>
#include <vector>

#include "src/motion/geometry/motion.hpp"

namespace rubicon::geometry {

/// Where a frame is at a time.
struct TimedPlace {
  std::int64_t time = 0;  ///< ns
  Pose X_WO = Pose::Identity();
};

/// Where a frame is at which time: its origin goes straight and evenly from place to place, its
/// axes turn evenly the short way. There are at least two places, their times ascend, and from one
/// to the next it turns by less than 180 degrees. What repeats ends where it begins, and begins
/// again there.
struct Timetable {
  std::vector<TimedPlace> places;
  bool repeat = false;

  std::int64_t begin() const { return places.front().time; }
  std::int64_t end() const { return places.back().time; }  ///< of the first passage
  std::int64_t period() const { return end() - begin(); }
};

/// A stretch of a timetable, as a motion in s from 0 to 1.
struct TimedMotion {
  std::int64_t from = 0;  ///< ns
  std::int64_t to = 0;
  Motion motion;
};

/// Where the frame is at a time; before the first time at the first place, after the last one at
/// the last, unless the timetable repeats.
Pose pose_at(const Timetable& timetable, std::int64_t time);

/// How the frame moves between two times (from < to), a motion for each stretch between two places,
/// in their order. Outside of the first and the last time it stands, unless the timetable repeats.
std::vector<TimedMotion> motions_between(const Timetable& timetable, std::int64_t from,
                                         std::int64_t to);

/// How far the frame turns between two poses, in degrees, [0, 180].
double turn_between_deg(const Pose& X_first, const Pose& X_second);

}  // namespace rubicon::geometry
