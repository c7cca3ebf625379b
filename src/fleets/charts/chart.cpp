#include "src/fleets/charts/chart.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rubicon::charts {
namespace {

std::string seconds_text(Nanoseconds time) {
  return fmt::format("{}", static_cast<double>(time) / static_cast<double>(kSecond));
}

std::string place_text(const LaneNetwork& network, NodeIndex node) {
  return node == kNone ? "Cur-Pos" : network.node(node).name;
}

std::size_t index(RobotIndex robot) { return static_cast<std::size_t>(robot); }

// When the robot leaves stop i for the next one.
Nanoseconds departure(const std::vector<Stop>& stops, std::size_t i) {
  if (i + 1 == stops.size()) return stops[i].arrival;
  return std::max(stops[i].arrival, stops[i + 1].arrival - stops[i + 1].travel);
}

}  // namespace

std::vector<Stay> stays_of(const Chart& chart) {
  std::vector<Stay> stays;
  for (std::size_t i = 0; i < chart.stops.size(); ++i) {
    stays.push_back({chart.stops[i].node, chart.stops[i].arrival, departure(chart.stops, i)});
  }
  return stays;
}

Chart chart_at(const Chart& chart, Nanoseconds now) {
  const std::vector<Stop>& stops = chart.stops;
  if (stops.empty() || stops.front().arrival > now) return chart;
  std::size_t last = 0;
  while (last + 1 < stops.size() && stops[last + 1].arrival <= now) ++last;

  Chart result;
  const Stop& behind = stops[last];
  const bool is_node = behind.node != kNone;
  result.passed = is_node ? behind.node : chart.passed;
  const Nanoseconds left = departure(stops, last);
  Stop present{kNone, now, is_node ? kNone : behind.lane, is_node ? Leg::kAlong : behind.leg, 0};
  const bool has_next = last + 1 < stops.size();
  const bool has_left = has_next && left < now;
  if (has_left) {
    present.lane = stops[last + 1].lane;
    present.leg = stops[last + 1].leg;
  }
  // A place on a lane is still in the lane that was entered at the node before.
  const bool same_lane =
      !is_node && behind.lane != kNone && (!has_left || present.leg == behind.leg);
  result.entered = same_lane ? chart.entered : left;
  result.stops.push_back(present);
  result.stops.insert(result.stops.end(), stops.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                      stops.end());
  if (has_left) {
    Stop& next = result.stops[1];
    next.travel = std::min(next.travel, next.arrival - now);
  }
  return result;
}

bool is_out_of_lane(const Chart& chart) {
  return !chart.stops.empty() && chart.stops.front().node == kNone &&
         chart.stops.front().leg != Leg::kAlong;
}

std::string_view name_of(RecordKind kind) {
  switch (kind) {
    case RecordKind::kSeen:
      return "seen";
    case RecordKind::kReported:
      return "reported";
    case RecordKind::kPassesInLane:
      return "passes_in_lane";
    case RecordKind::kBypasses:
      return "bypasses";
    case RecordKind::kGoesBack:
      return "goes_back";
    case RecordKind::kPlannedAgain:
      return "planned_again";
    case RecordKind::kReturns:
      return "returns";
    case RecordKind::kStranded:
      return "stranded";
    case RecordKind::kReopened:
      return "reopened";
    case RecordKind::kYields:
      return "yields";
  }
  return "";
}

std::string_view name_of(Conflict conflict) {
  switch (conflict) {
    case Conflict::kNode:
      return "node";
    case Conflict::kLane:
      return "lane";
    case Conflict::kAcross:
      return "across";
  }
  return "";
}

std::string told(const LaneNetwork& network, const std::vector<Robot>& robots,
                 const std::vector<Chart>& charts, const Record& record) {
  const std::string who = record.robot == kNone ? "" : robots[index(record.robot)].name;
  const std::string lane = record.lane == kNone ? "" : network.name_of(record.lane);
  const std::string node = place_text(network, record.node);
  switch (record.kind) {
    case RecordKind::kSeen:
      return fmt::format("{} sees at {} s that {} is blocked", who, seconds_text(record.time),
                         lane);
    case RecordKind::kReported:
      return fmt::format("{} is closed to all", lane);
    case RecordKind::kPassesInLane:
      return fmt::format("{} passes inside its lane, {}", who, lane);
    case RecordKind::kBypasses:
      return fmt::format("{} takes the lane beside, {}, against its direction", who, lane);
    case RecordKind::kGoesBack:
      return fmt::format("{} goes back to {}", who, node);
    case RecordKind::kPlannedAgain:
      return fmt::format("{} has a new way from {}", who, node);
    case RecordKind::kReturns:
      return fmt::format("{} finds no way from {} to its goal and returns to its start", who, node);
    case RecordKind::kStranded:
      return fmt::format("{} finds no way from {} to its goal or back", who, node);
    case RecordKind::kReopened:
      return fmt::format("{} is open again", lane);
    case RecordKind::kYields: {
      const Chart& chart = charts[index(record.robot)];
      const NodeIndex moved = chart.stops[static_cast<std::size_t>(record.stop)].node;
      return fmt::format("{} yields to {} at {}: {} at {} s, not {} s ({})", who,
                         robots[index(record.other)].name, node, place_text(network, moved),
                         seconds_text(record.after), seconds_text(record.before),
                         name_of(record.conflict));
    }
  }
  return "";
}

void apply_yield(const Record& record, std::vector<Chart>& charts) {
  if (record.kind != RecordKind::kYields) return;
  std::vector<Stop>& stops = charts[index(record.robot)].stops;
  for (std::size_t i = static_cast<std::size_t>(record.stop); i < stops.size(); ++i) {
    stops[i].arrival += record.after - record.before;
  }
}

std::string told(const LaneNetwork& network, const Chart& chart) {
  std::string text;
  for (const Stop& stop : chart.stops) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", place_text(network, stop.node),
                        seconds_text(stop.arrival));
  }
  return text;
}

std::string table_text(const LaneNetwork& network, const std::vector<Robot>& robots,
                       const std::vector<Chart>& charts) {
  std::size_t lines = 0;
  std::vector<std::string> head;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    lines = std::max(lines, charts[i].stops.size());
    head.push_back(fmt::format("{} (priority {})", robots[i].name, robots[i].priority));
  }
  std::vector<std::string> rows(lines + 1);
  for (std::size_t i = 0; i < charts.size(); ++i) {
    std::size_t places = 0;
    std::size_t times = 0;
    for (const Stop& stop : charts[i].stops) {
      places = std::max(places, place_text(network, stop.node).size());
      times = std::max(times, seconds_text(stop.arrival).size());
    }
    const std::size_t width = std::max(head[i].size(), places + 1 + times);
    rows[0] += fmt::format("{:<{}}  ", head[i], width);
    for (std::size_t line = 0; line < lines; ++line) {
      std::string cell;
      if (line < charts[i].stops.size()) {
        const Stop& stop = charts[i].stops[line];
        cell = fmt::format("{:<{}} {:>{}}", place_text(network, stop.node), places,
                           seconds_text(stop.arrival), times);
      }
      rows[line + 1] += fmt::format("{:<{}}  ", cell, width);
    }
  }
  std::string text;
  for (std::string& row : rows) {
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + "\n";
  }
  return text;
}

}  // namespace rubicon::charts
