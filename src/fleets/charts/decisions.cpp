#include "src/fleets/charts/decisions.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace rubicon::charts {

std::string_view name_of(Judgement judgement) {
  switch (judgement) {
    case Judgement::kStatic:
      return "static";
    case Judgement::kMovesAhead:
      return "moves_ahead";
    case Judgement::kComesNearer:
      return "comes_nearer";
  }
  return "";
}

Judgement judge_distance(double first, double second, double tolerance) {
  if (!(first >= 0) || !(second >= 0) || !(tolerance >= 0) || !std::isfinite(first) ||
      !std::isfinite(second)) {
    throw std::invalid_argument("scan: distances and their tolerance have to be 0 m or more");
  }
  if (second > first + tolerance) return Judgement::kMovesAhead;
  if (second < first - tolerance) return Judgement::kComesNearer;
  return Judgement::kStatic;
}

std::string_view name_of(BypassWay way) {
  switch (way) {
    case BypassWay::kRightInLane:
      return "right_in_lane";
    case BypassWay::kLeftInLane:
      return "left_in_lane";
    case BypassWay::kLeftLane:
      return "left_lane";
    case BypassWay::kReverse:
      return "reverse";
  }
  return "";
}

BypassResult choose_bypass(const BypassQuery& query) {
  if (!std::isfinite(query.obstacle_from) || !std::isfinite(query.obstacle_to) ||
      query.obstacle_to < query.obstacle_from) {
    throw std::invalid_argument("bypass: expected an obstacle that ends where it begins or later");
  }
  if (!(query.robot_width > 0) || !(query.lane_width > 0) || !(query.travelway_width > 0) ||
      !(query.clearance >= 0)) {
    throw std::invalid_argument("bypass: expected widths above 0 and a clearance of 0 or more");
  }
  const double room = query.robot_width + query.clearance;
  const double half = query.robot_width / 2;
  const double from = std::max(query.obstacle_from, 0.0);
  const double to = std::max(query.obstacle_to, 0.0);

  // Between the wall and the obstacle, but no further left than the lane goes.
  const double right_gap = std::min(from, query.lane_width);
  if (right_gap >= room) {
    const double middle = query.lane_width / 2;
    return {BypassWay::kRightInLane, right_gap,
            std::clamp(middle, half, std::max(half, from - query.clearance - half))};
  }
  const double in_lane = query.lane_width - to;
  if (in_lane >= room) {
    const double middle = query.lane_width / 2;
    return {BypassWay::kLeftInLane, in_lane,
            std::clamp(middle, to + query.clearance + half,
                       std::max(to + query.clearance + half, query.lane_width - half))};
  }
  const double left_gap = query.travelway_width - std::max(to, 0.0);
  if (query.travelway_width > query.lane_width && left_gap >= room) {
    const double middle = (query.lane_width + query.travelway_width) / 2;
    const double least = to + query.clearance + half;
    return {BypassWay::kLeftLane, left_gap,
            std::clamp(middle, least, std::max(least, query.travelway_width - half))};
  }
  return {};
}

}  // namespace rubicon::charts
