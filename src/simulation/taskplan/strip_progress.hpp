#pragma once

#include <cstddef>
#include <vector>

#include "src/motion/coverage/joints.hpp"
#include "src/simulation/schedule/calendar_rules.hpp"

namespace rubicon::taskplan {

/// Follows a tool along one strip of a floor: which part of it each step lays, and when. A part
/// counts as laid when the tool first passes it. A value.
class StripProgress {
 public:
  /// The strip number `number` of the way, from one place to another, m; nothing where that is the
  /// one under way.
  void begin(std::size_t number, const coverage::Place& from, const coverage::Place& to);

  /// The tool goes from one place to another, near the strip, between two moments (ticks). Steps
  /// that follow each other at one speed, to within kEvenTicks, are one stretch of `laid`.
  void add(const coverage::Place& from, const coverage::Place& to, std::int64_t begin,
           std::int64_t end, std::vector<coverage::LaidStretch>& laid);

 private:
  double along(const coverage::Place& place) const;
  coverage::Place at(double along) const;

  std::size_t number_ = 0;
  coverage::Place from_, direction_;
  double length_ = 0;  ///< m
  double laid_ = 0;    ///< m of it, from its beginning
  // The stretch that goes on, and which mean speeds of it (ticks per m) are near enough to all of
  // its steps; least > most: none goes on.
  double begin_ = 0;  ///< m
  double least_ = 0, most_ = -1;
};

/// Ticks by which a place of a stretch may have been laid earlier or later than it tells: half a
/// second, of minutes that concrete has.
inline constexpr double kEvenTicks = 5e8;

}  // namespace rubicon::taskplan
