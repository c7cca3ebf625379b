#include "src/results/verify/charts/least_ways.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

namespace rubicon::verify {

namespace {

std::size_t number(int i) { return static_cast<std::size_t>(i); }

Ticks whole(double billionths) {
  if (!(billionths < 4e18)) return LeastWays::kNoWayThere;
  return std::max<Ticks>(1, std::llround(billionths));
}

}  // namespace

Ticks driving_time(const ChartLane& lane, double metres, double robot_speed) {
  return whole(metres / std::min(lane.speed, robot_speed) * 1e9);
}

void LeastWays::close(const std::vector<int>& lanes) {
  is_closed_.assign(result_.lanes.size(), 0);
  for (const int lane : lanes) is_closed_[number(lane)] = 1;
  known_.clear();
}

Ticks LeastWays::weight(int lane, const ChartRobot& robot) const {
  const ChartLane& of = result_.lanes[number(lane)];
  if (result_.minimise == "distance") return whole(of.length * 1e9);
  if (result_.minimise == "cost") return whole(of.length * of.cost * 1e9);
  return driving_time(of, of.length, robot.speed);
}

Ticks LeastWays::least(int from, int to, const ChartRobot& robot) {
  return to_goal(to, robot)[number(from)];
}

const std::vector<Ticks>& LeastWays::to_goal(int goal, const ChartRobot& robot) {
  const auto [place, is_new] = known_.try_emplace(Key{goal, {robot.speed, robot.width}});
  std::vector<Ticks>& sum = place->second;
  if (!is_new) return sum;
  // Relaxed backwards from where something changed, first come first served.
  std::vector<std::vector<int>> arriving(result_.nodes.size());
  for (std::size_t i = 0; i < result_.lanes.size(); ++i) {
    const ChartLane& lane = result_.lanes[i];
    if (is_closed_[i] == 0 && lane.width >= robot.width) {
      arriving[number(lane.to)].push_back(static_cast<int>(i));
    }
  }
  sum.assign(result_.nodes.size(), kNoWayThere);
  sum[number(goal)] = 0;
  std::deque<int> changed = {goal};
  std::vector<char> waits(result_.nodes.size(), 0);
  while (!changed.empty()) {
    const int node = changed.front();
    changed.pop_front();
    waits[number(node)] = 0;
    for (const int lane : arriving[number(node)]) {
      const Ticks step = weight(lane, robot);
      if (step >= kNoWayThere - sum[number(node)]) continue;
      const int before = result_.lanes[number(lane)].from;
      if (sum[number(node)] + step >= sum[number(before)]) continue;
      sum[number(before)] = sum[number(node)] + step;
      if (waits[number(before)] == 0) changed.push_back(before);
      waits[number(before)] = 1;
    }
  }
  return sum;
}

}  // namespace rubicon::verify
