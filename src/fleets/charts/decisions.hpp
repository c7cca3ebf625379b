#pragma once

#include <string_view>

namespace rubicon::charts {

/// What a robot at a landmark makes of something in the lane ahead, having measured twice.
enum class Judgement {
  kStatic,      ///< the distance is unchanged: it stands, so report it and plan again
  kMovesAhead,  ///< it has grown: another robot, so go on
  kComesNearer  ///< it has shrunk: wait for one more scan
};
std::string_view name_of(Judgement judgement);

/// Distances that differ by less count as unchanged: what a sensor leaves open. Larger, and a slow
/// robot ahead is taken for a wall; smaller, and noise makes a wall move.
inline constexpr double kSameDistance = 0.05;  // m

/// By the distance at the first and at the second scan, in m (the Blackmon paper, "Background").
/// The paper does not say what a shrinking distance means: ours. Throws std::invalid_argument for
/// distances that are negative or not numbers.
Judgement judge_distance(double first, double second, double tolerance = kSameDistance);

/// An obstacle in the travelway, as measured across it from the right-hand wall. Lengths in m, or
/// all in another unit: the paper's own numbers are in units of half a robot.
struct BypassQuery {
  double obstacle_from = 0;
  double obstacle_to = 0;
  double robot_width = 2;
  double clearance = 0;  ///< what a gap has to be wider than the robot
  double lane_width = 4;
  double travelway_width = 8;  ///< no more than the lane: there is no lane beside to borrow
};

enum class BypassWay {
  kRightInLane,  ///< between the wall and the obstacle
  kLeftInLane,   ///< left of the obstacle, still in the own lane
  kLeftLane,     ///< in the lane beside, against its direction
  kReverse,      ///< back to the last node, and plan another way
};
std::string_view name_of(BypassWay way);

struct BypassResult {
  BypassWay way = BypassWay::kReverse;
  double gap = 0;     ///< the width of the gap that is used; 0 for kReverse
  double centre = 0;  ///< where the middle of the robot goes, from the right-hand wall; likewise
};

/// The rules of the Blackmon paper, "Bypass Planning", in their order: right gap, left lane,
/// reverse. It leaves the lane only where there is not enough room in it, so between the first two
/// we try the room left of the obstacle in the own lane. The robot stays as near to the middle of
/// its lane (of the lane beside) as the gap allows. Throws std::invalid_argument for widths that
/// are not above 0, a clearance below 0, an obstacle that ends before it begins, and for what is
/// not a number.
BypassResult choose_bypass(const BypassQuery& query);

}  // namespace rubicon::charts
