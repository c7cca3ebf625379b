#pragma once

#include <string>
#include <vector>

#include "src/fleets/charts/plan.hpp"
#include "src/fleets/lanes/warehouse.hpp"
#include "tests/unit/lanes/lane_fixtures.hpp"

namespace rubicon::charts {

using lanes::lane;
using lanes::node;

/// A robot between two nodes by their names; start in s.
inline Robot robot(const LaneNetwork& network, const std::string& name, int priority, int start,
                   const std::string& from, const std::string& goal) {
  Robot result;
  result.name = name;
  result.priority = priority;
  result.start = start * kSecond;
  result.from = node(network, from);
  result.goal = node(network, goal);
  return result;
}

/// Charts as text, one below the other.
inline std::vector<std::string> told(const LaneNetwork& network, const std::vector<Chart>& charts) {
  std::vector<std::string> text;
  for (const Chart& chart : charts) text.push_back(told(network, chart));
  return text;
}

/// Records as text.
inline std::vector<std::string> told(const LaneNetwork& network, const Plan& plan) {
  std::vector<std::string> text;
  for (const Record& record : plan.records) {
    text.push_back(told(network, plan.robots, plan.charts, record));
  }
  return text;
}

}  // namespace rubicon::charts
