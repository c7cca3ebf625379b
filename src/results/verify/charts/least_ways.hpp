#pragma once

#include <map>
#include <vector>

#include "src/results/verify/charts/charts_result.hpp"

namespace rubicon::verify {

/// Whole nanoseconds that a robot takes for so many metres of a lane, at least 1.
Ticks driving_time(const ChartLane& lane, double metres, double robot_speed);

/// The least sum of weights (nanoseconds, nanometres, billionths of money) from every node to one,
/// past closed lanes, by relaxing all lanes until nothing changes (Bellman 1958, Ford 1956).
class LeastWays {
 public:
  explicit LeastWays(const ChartsResult& result) : result_(result) {}

  /// Lanes that nobody may enter from here on.
  void close(const std::vector<int>& lanes);
  /// The sum of a way along lanes.
  Ticks weight(int lane, const ChartRobot& robot) const;
  /// Of the best way; kNoWayThere where none leads.
  Ticks least(int from, int to, const ChartRobot& robot);

  static constexpr Ticks kNoWayThere = 4'000'000'000'000'000'000;

 private:
  using Key = std::pair<int, std::pair<double, double>>;  // goal; speed and width of the robot
  const std::vector<Ticks>& to_goal(int goal, const ChartRobot& robot);

  const ChartsResult& result_;
  std::vector<char> is_closed_;
  std::map<Key, std::vector<Ticks>> known_;
};

}  // namespace rubicon::verify
