#include "src/fleets/charts/avoidance.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <tuple>

namespace rubicon::charts {
namespace {

constexpr std::size_t kNoGroup = static_cast<std::size_t>(-1);

std::size_t at(RobotIndex robot) { return static_cast<std::size_t>(robot); }

// Whether `one` is where `other` is about to drive against the direction.
bool stands_in_the_way(const Chart& one, const Chart& other) {
  if (one.stops.size() < 2 || one.stops.front().node != kNone) return false;
  if (one.stops[1].leg == Leg::kAgainst || one.stops[1].lane == kNone) return false;
  // Both in one lane: the other one goes back and this one is ahead of it.
  if (one.stops.front().lane != kNone && one.stops.front().lane == other.stops.front().lane) {
    return false;
  }
  return std::any_of(other.stops.begin() + 1, other.stops.end(), [&one](const Stop& stop) {
    return stop.leg == Leg::kAgainst && stop.lane == one.stops[1].lane;
  });
}

// One call of avoid_conflicts.
class Avoidance {
 public:
  Avoidance(const std::vector<Robot>& robots, std::vector<Chart>& charts,
            const AvoidanceSettings& settings, std::vector<Record>& records)
      : charts_(charts),
        settings_(settings),
        records_(records),
        order_(right_of_way(robots, charts)),
        rank_(robots.size()) {
    for (std::size_t i = 0; i < order_.size(); ++i) rank_[at(order_[i])] = i;
    group_by_node();
  }

  bool settle() {
    bool changed = true;
    while (changed && is_within_limits_) {
      changed = avoid_at_nodes();
      changed |= avoid_head_on();
    }
    return is_within_limits_;
  }

 private:
  struct Visit {
    Nanoseconds arrival;
    RobotIndex robot;
    std::size_t stop;
    bool is_fixed;  // out of its lane until there: it cannot wait before it
  };

  struct Meeting {
    Nanoseconds time;
    NodeIndex node;
    std::size_t first_rank;
    std::size_t second_rank;
    std::size_t stop;  // of the second
    bool operator<(const Meeting& other) const {
      return std::tie(time, node, first_rank, second_rank, stop) <
             std::tie(other.time, other.node, other.first_rank, other.second_rank, other.stop);
    }
  };

  // All visits to one node, by arrival, and their first conflict.
  struct Group {
    NodeIndex node = kNone;
    std::vector<Visit> visits;
    std::optional<Meeting> earliest;
  };

  void group_by_node() {
    std::map<NodeIndex, std::size_t> group_of;
    group_of_stop_.resize(charts_.size());
    for (std::size_t i = 0; i < charts_.size(); ++i) {
      const std::vector<Stop>& stops = charts_[i].stops;
      group_of_stop_[i].assign(stops.size(), kNoGroup);
      for (std::size_t k = 0; k < stops.size(); ++k) {
        if (stops[k].node == kNone) continue;
        const auto [found, is_new] = group_of.try_emplace(stops[k].node, groups_.size());
        if (is_new) groups_.push_back({stops[k].node, {}, std::nullopt});
        const auto robot = static_cast<RobotIndex>(i);
        const bool is_fixed = stops[k].leg != Leg::kAlong && waits_before(robot, k) == k;
        groups_[found->second].visits.push_back({0, robot, k, is_fixed});
        group_of_stop_[i][k] = found->second;
      }
    }
    for (Group& group : groups_) update(group);
  }

  // Arrivals and the first conflict of a group, after a move. The visits are nearly in order, so
  // they are put in order by insertion.
  void update(Group& group) {
    std::vector<Visit>& visits = group.visits;
    for (Visit& visit : visits) visit.arrival = stop_of(visit.robot, visit.stop).arrival;
    for (std::size_t i = 1; i < visits.size(); ++i) {
      for (std::size_t k = i; k > 0 && visits[k].arrival < visits[k - 1].arrival; --k) {
        std::swap(visits[k], visits[k - 1]);
      }
    }
    group.earliest.reset();
    for (std::size_t i = 0; i < visits.size(); ++i) {
      if (group.earliest && group.earliest->time != visits[i].arrival) break;
      for (std::size_t k = i + 1; k < visits.size(); ++k) {
        if (visits[k].arrival - visits[i].arrival >= settings_.tolerance) break;
        if (visits[k].robot == visits[i].robot) continue;
        const bool i_first = visits[i].is_fixed != visits[k].is_fixed
                                 ? visits[i].is_fixed
                                 : rank_[at(visits[i].robot)] < rank_[at(visits[k].robot)];
        const Visit& keeps = i_first ? visits[i] : visits[k];
        const Visit& yields = i_first ? visits[k] : visits[i];
        const Meeting meeting{visits[i].arrival, group.node, rank_[at(keeps.robot)],
                              rank_[at(yields.robot)], yields.stop};
        if (!group.earliest || meeting < *group.earliest) group.earliest = meeting;
      }
    }
  }

  Stop& stop_of(RobotIndex robot, std::size_t stop) { return charts_[at(robot)].stops[stop]; }

  // Where the robot waits so as to be later at this stop: before a bypass, not on it.
  std::size_t waits_before(RobotIndex robot, std::size_t stop) {
    std::size_t first = stop;
    while (first > 0 && stop_of(robot, first).leg != Leg::kAlong) --first;
    return stop_of(robot, first).leg == Leg::kAlong ? first : stop;
  }

  void move(RobotIndex robot, std::size_t stop, Nanoseconds by, Record record) {
    record.kind = RecordKind::kYields;
    record.robot = robot;
    record.stop = static_cast<std::int32_t>(stop);
    record.before = stop_of(robot, stop).arrival;
    record.after = record.before + by;
    if (moves_ >= settings_.most_moves ||
        charts_[at(robot)].stops.back().arrival > lanes::kEndOfTime - by) {
      is_within_limits_ = false;
      return;
    }
    ++moves_;
    apply_yield(record, charts_);
    records_.push_back(record);
    const std::vector<std::size_t>& groups = group_of_stop_[at(robot)];
    for (std::size_t i = stop; i < groups.size(); ++i) {
      if (groups[i] != kNoGroup) update(groups_[groups[i]]);
    }
  }

  std::optional<Meeting> earliest_meeting() const {
    std::optional<Meeting> earliest;
    for (const Group& group : groups_) {
      if (group.earliest && (!earliest || *group.earliest < *earliest)) earliest = group.earliest;
    }
    return earliest;
  }

  bool avoid_at_nodes() {
    bool changed = false;
    while (is_within_limits_) {
      const std::optional<Meeting> meeting = earliest_meeting();
      if (!meeting) break;
      Record record;
      record.time = meeting->time;
      record.node = meeting->node;
      record.other = order_[meeting->first_rank];
      record.conflict = Conflict::kNode;
      const RobotIndex robot = order_[meeting->second_rank];
      move(robot, waits_before(robot, meeting->stop), settings_.delay, record);
      changed = true;
    }
    return changed;
  }

  bool avoid_head_on() {
    bool changed = false;
    for (const RobotIndex bypassing : order_) {
      const std::vector<Stop>& stops = charts_[at(bypassing)].stops;
      if (std::none_of(stops.begin(), stops.end(),
                       [](const Stop& stop) { return stop.leg == Leg::kAgainst; })) {
        continue;
      }
      for (const RobotIndex other : order_) {
        if (other == bypassing) continue;
        while (is_within_limits_ && avoid_one_head_on(bypassing, other)) changed = true;
      }
    }
    return changed;
  }

  // The way across is looked at before the borrowed lane.
  bool avoid_one_head_on(RobotIndex bypassing, RobotIndex other) {
    const std::vector<Stop>& its_stops = charts_[at(bypassing)].stops;
    const std::vector<Stop>& stops = charts_[at(other)].stops;
    for (std::size_t leg = its_stops.size() - 1; leg > 0; --leg) {
      if (its_stops[leg].leg != Leg::kAgainst || its_stops[leg].lane == kNone) continue;
      for (std::size_t end = 1; end < stops.size(); ++end) {
        if (stops[end].lane != its_stops[leg].lane || stops[end].leg == Leg::kAgainst) continue;
        // Ahead of one that goes back.
        if (end == 1 && stops[0].node == kNone && stops[0].lane != kNone &&
            stops[0].lane == its_stops[0].lane) {
          continue;
        }
        const bool meet = begin_of(stops, end) <= its_stops[leg].arrival &&
                          its_stops[leg - 1].arrival <= stops[end].arrival;
        if (!meet) continue;
        resolve(bypassing, leg, other, end);
        return true;
      }
    }
    return false;
  }

  // Whether the robot comes to the stop before against the direction of a lane. There it waits at
  // the node: others may have to come out of that lane behind it, or want to enter it.
  static bool waits_at_node(const std::vector<Stop>& stops, std::size_t end) {
    return stops[end - 1].leg == Leg::kAgainst;
  }

  // From when on a robot may be on its way to this stop: as in the paper from its arrival at the
  // stop before, unless it waits at that node; then from its departure.
  static Nanoseconds begin_of(const std::vector<Stop>& stops, std::size_t end) {
    return waits_at_node(stops, end) ? stops[end].arrival - stops[end].travel
                                     : stops[end - 1].arrival;
  }

  void resolve(RobotIndex bypassing, std::size_t leg, RobotIndex other, std::size_t end) {
    const Stop& borrowed = stop_of(bypassing, leg);
    const bool in_lane = leg == 1 || stop_of(bypassing, leg - 1).leg == Leg::kAlong;
    Record record;
    record.lane = borrowed.lane;
    record.conflict = in_lane ? Conflict::kLane : Conflict::kAcross;
    record.time = std::max(stop_of(other, end - 1).arrival, stop_of(bypassing, leg - 1).arrival);
    record.node = in_lane ? borrowed.node : stop_of(bypassing, leg - 1).node;
    const std::vector<Stop>& stops = charts_[at(other)].stops;
    // Back out of this very lane, and in again.
    const bool turns_round = waits_at_node(stops, end) && stops[end - 1].lane == stops[end].lane;
    const bool can_wait = waits_before(bypassing, leg) < leg;
    if (can_wait && !turns_round && rank_[at(other)] < rank_[at(bypassing)]) {
      record.other = other;
      const Nanoseconds by =
          stop_of(other, end).arrival + settings_.clearance - stop_of(bypassing, leg - 1).arrival;
      move(bypassing, waits_before(bypassing, leg), by, record);
      return;
    }
    record.other = bypassing;
    if (waits_at_node(stops, end)) {
      move(other, end, borrowed.arrival + settings_.clearance - begin_of(stops, end), record);
      return;
    }
    // In the lane: it waits one node earlier, so that the bypassing robot finds the node free.
    const bool one_earlier = in_lane && end >= 2 && !waits_at_node(stops, end - 1);
    const std::size_t stop = one_earlier ? end - 2 : end - 1;
    const Nanoseconds by = borrowed.arrival + settings_.clearance - stop_of(other, stop).arrival;
    move(other, waits_before(other, stop), by, record);
  }

  std::vector<Chart>& charts_;
  const AvoidanceSettings& settings_;
  std::vector<Record>& records_;
  std::vector<RobotIndex> order_;
  std::vector<std::size_t> rank_;  // by robot: its place in the order
  std::vector<Group> groups_;
  std::vector<std::vector<std::size_t>> group_of_stop_;  // by robot and stop
  std::int64_t moves_ = 0;
  bool is_within_limits_ = true;
};

}  // namespace

std::vector<RobotIndex> right_of_way(const std::vector<Robot>& robots,
                                     const std::vector<Chart>& charts) {
  std::vector<RobotIndex> order(robots.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](RobotIndex i) {
    const Robot& robot = robots[at(i)];
    return std::make_tuple(is_out_of_lane(charts[at(i)]) ? 0 : 1, -std::int64_t{robot.priority},
                           robot.start, i);
  };
  std::sort(order.begin(), order.end(),
            [&key](RobotIndex a, RobotIndex b) { return key(a) < key(b); });
  // Each who is in the way of another goes right before it. Each pass mends one at least; a circle,
  // which robots in lanes cannot make, ends by the count.
  bool changed = true;
  for (std::size_t pass = 0; changed && pass < robots.size(); ++pass) {
    changed = false;
    for (std::size_t first = 0; first < order.size(); ++first) {
      const Chart& chart = charts[at(order[first])];
      if (chart.stops.empty()) continue;
      for (std::size_t later = first + 1; later < order.size(); ++later) {
        if (!stands_in_the_way(charts[at(order[later])], chart)) continue;
        std::rotate(order.begin() + static_cast<std::ptrdiff_t>(first),
                    order.begin() + static_cast<std::ptrdiff_t>(later),
                    order.begin() + static_cast<std::ptrdiff_t>(later) + 1);
        ++first;
        changed = true;
      }
    }
  }
  return order;
}

bool avoid_conflicts(const std::vector<Robot>& robots, std::vector<Chart>& charts,
                     const AvoidanceSettings& settings, std::vector<Record>& records) {
  constexpr Nanoseconds kMost = Nanoseconds{366} * 24 * 3600 * kSecond;
  if (settings.tolerance < 0 || settings.tolerance > kMost) {
    throw std::invalid_argument("charts: expected a tolerance of 0 s or more, up to a year");
  }
  if (settings.delay <= 0 || settings.delay > kMost || settings.clearance <= 0 ||
      settings.clearance > kMost) {
    throw std::invalid_argument("charts: expected a delay and a clearance above 0 s, up to a year");
  }
  if (robots.size() != charts.size()) {
    throw std::invalid_argument("charts: expected one chart for each robot");
  }
  return Avoidance(robots, charts, settings, records).settle();
}

}  // namespace rubicon::charts
