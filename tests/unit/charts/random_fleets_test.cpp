// Many random fleets with a bypass in each, judged by nodes and times alone: what the planner
// thinks of lanes, legs and right of way is not asked.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "src/fleets/charts/plan.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/charts/chart_fixtures.hpp"

namespace rubicon::charts {
namespace {

// Random numbers that are the same everywhere (SplitMix64).
class ChartRandom {
 public:
  explicit ChartRandom(std::uint64_t seed) : state_(seed) {}
  int whole(int low, int high) {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return low + static_cast<int>((z ^ (z >> 31)) % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::uint64_t state_;
};

lanes::LaneNetwork small_warehouse() {
  lanes::WarehouseQuery query;
  query.corridors = 2;
  query.rows = 3;
  return lanes::LaneNetwork(lanes::warehouse(query));
}

std::vector<Robot> random_robots(ChartRandom& random, const LaneNetwork& network) {
  std::vector<Robot> robots;
  const int count = random.whole(3, 9);
  for (int i = 0; i < count; ++i) {
    Robot robot;
    robot.name = "R" + std::to_string(i + 1);
    robot.priority = random.whole(1, 4);
    // No two starts are the same, so that the order of the robots says nothing.
    robot.start = random.whole(0, 99) * kSecond + i;
    robot.from = random.whole(0, network.node_count() - 1);
    do {
      robot.goal = random.whole(0, network.node_count() - 1);
    } while (robot.goal == robot.from);
    robots.push_back(robot);
  }
  return robots;
}

// A robot that is in a lane with another one beside it.
std::optional<BypassReport> random_report(ChartRandom& random, const LaneNetwork& network,
                                          const Plan& plan, int from, int to,
                                          bool any_state = false) {
  for (int attempt = 0; attempt < 50; ++attempt) {
    const Nanoseconds time = random.whole(from, to) * kSecond + 500'000'000;
    const RobotIndex robot = random.whole(0, static_cast<int>(plan.robots.size()) - 1);
    const Chart chart = chart_at(plan.charts[static_cast<std::size_t>(robot)], time);
    const Stop& now = chart.stops.front();
    if (now.node != kNone || now.lane == kNone || network.lane(now.lane).beside == kNone) continue;
    if (any_state && now.leg == Leg::kAgainst && chart.stops[1].lane == now.lane &&
        chart.stops[1].node == network.lane(now.lane).from) {
      // On a bypass, or on its way back; only the first may report that there is no way on.
      const LaneIndex own = network.lane(now.lane).beside;
      if (chart.passed != network.lane(own).from) continue;
      return BypassReport{robot, own, time, network.length(own) / 2, BypassWay::kReverse};
    }
    if (now.leg != Leg::kAlong) continue;
    if (chart.stops[1].leg != Leg::kAlong && !any_state) continue;
    const double rest =
        static_cast<double>(chart.stops[1].travel) / static_cast<double>(network.time(now.lane));
    return BypassReport{robot, now.lane, time,
                        network.length(now.lane) * std::clamp(1 - rest, 0.0, 0.999),
                        BypassWay::kLeftLane};
  }
  return std::nullopt;
}

// One move from node to node, and when it may be under way. A robot that is between two nodes at
// the time of a report comes from the one it passed by the plan before.
struct Move {
  NodeIndex from;
  NodeIndex to;
  Nanoseconds begin;
  Nanoseconds end;
};

std::vector<Move> moves_of(const Chart& before, const Chart& after, Nanoseconds time) {
  NodeIndex at = kNone;
  Nanoseconds since = 0;
  for (const Stop& stop : before.stops) {
    if (stop.arrival > time || stop.node == kNone) continue;
    at = stop.node;
    since = stop.arrival;
  }
  std::vector<Move> moves;
  for (const Stop& stop : after.stops) {
    if (stop.node == kNone) continue;
    if (at != kNone) moves.push_back({at, stop.node, since, stop.arrival});
    at = stop.node;
    since = stop.arrival;
  }
  return moves;
}

// Head-on meetings with the robot of the report: in the borrowed lane, and on the way across.
int head_ons(const LaneNetwork& network, const Plan& before, const Plan& after,
             const BypassReport& report) {
  const lanes::Lane& own = network.lane(report.lane);
  const lanes::Lane& beside = network.lane(network.lane(report.lane).beside);
  const std::vector<Stop>& its = after.charts[static_cast<std::size_t>(report.robot)].stops;
  EXPECT_EQ(its[1].node, beside.from);
  const bool has_way_across = beside.from != own.to;
  if (has_way_across) {
    EXPECT_EQ(its[2].node, own.to);
  }
  // A lane of its own leads across: nobody can meet it there.
  const bool against = has_way_across && network.find_lane(beside.from, own.to) == kNone;
  int count = 0;
  for (std::size_t i = 0; i < after.charts.size(); ++i) {
    if (static_cast<RobotIndex>(i) == report.robot) continue;
    for (const Move& move : moves_of(before.charts[i], after.charts[i], report.time)) {
      const auto meet = [&move](Nanoseconds begin, Nanoseconds end) {
        return move.begin <= end && begin <= move.end;
      };
      if (move.from == beside.from && move.to == beside.to &&
          meet(its[0].arrival, its[1].arrival)) {
        ++count;
      }
      if (against && move.from == own.to && move.to == beside.from &&
          meet(its[1].arrival, its[2].arrival)) {
        ++count;
      }
    }
  }
  return count;
}

// By their charts alone: two at one node, nearer in time than the tolerance.
int node_conflicts(const Plan& plan, Nanoseconds tolerance) {
  int count = 0;
  for (std::size_t a = 0; a < plan.charts.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      for (const Stop& one : plan.charts[a].stops) {
        for (const Stop& other : plan.charts[b].stops) {
          if (one.node == kNone || one.node != other.node) continue;
          if (std::abs(one.arrival - other.arrival) < tolerance) ++count;
        }
      }
    }
  }
  return count;
}

// Stops follow in time by at least the driving time, on lanes that join them.
void expect_drivable(const LaneNetwork& network, const Plan& plan) {
  for (const Chart& chart : plan.charts) {
    for (std::size_t i = 1; i < chart.stops.size(); ++i) {
      const Stop& stop = chart.stops[i];
      const Stop& last = chart.stops[i - 1];
      EXPECT_GE(stop.arrival, last.arrival + stop.travel);
      if (stop.leg != Leg::kAlong) continue;
      ASSERT_NE(stop.lane, kNone);
      EXPECT_EQ(network.lane(stop.lane).to, stop.node);
      if (last.node != kNone) {
        EXPECT_EQ(network.lane(stop.lane).from, last.node);
      }
    }
  }
}

// Before any bypass: who yields has the lower priority, or started later. Who goes before all never
// waits.
void expect_right_of_way(const Plan& plan) {
  const auto goes_before = [](const Robot& one, const Robot& other) {
    return one.priority != other.priority ? one.priority > other.priority : one.start < other.start;
  };
  for (const Record& record : plan.records) {
    if (record.kind != RecordKind::kYields) continue;
    EXPECT_TRUE(goes_before(plan.robots[static_cast<std::size_t>(record.other)],
                            plan.robots[static_cast<std::size_t>(record.robot)]));
  }
  const auto first = std::min_element(plan.robots.begin(), plan.robots.end(), goes_before);
  for (const Stay& stay :
       stays_of(plan.charts[static_cast<std::size_t>(std::distance(plan.robots.begin(), first))])) {
    EXPECT_EQ(stay.arrival, stay.departure);
  }
}

TEST(RandomFleets, EndWithoutAHeadOnOrAConflict) {
  ChartRandom random(7);
  const LaneNetwork network = small_warehouse();
  int bypasses = 0;
  int in_lane = 0;
  int across = 0;
  int at_node = 0;
  for (int i = 0; bypasses < test::cases(3000); ++i) {
    SCOPED_TRACE(i);
    ASSERT_LT(i, 9000);
    PlanSettings settings;
    settings.avoidance.tolerance = random.whole(0, 8) * kSecond;
    settings.avoidance.delay = random.whole(1, 20) * kSecond;
    settings.avoidance.clearance = random.whole(1, 10) * kSecond;
    const Plan plan = make_plan(network, random_robots(random, network), settings);
    ASSERT_TRUE(plan.settled);
    EXPECT_EQ(node_conflicts(plan, settings.avoidance.tolerance), 0);
    expect_drivable(network, plan);
    expect_right_of_way(plan);
    const std::optional<BypassReport> report = random_report(random, network, plan, 0, 150);
    if (!report) continue;
    ++bypasses;
    const Plan after = bypass(network, plan, *report, settings);
    ASSERT_TRUE(after.settled);
    EXPECT_EQ(node_conflicts(after, settings.avoidance.tolerance), 0);
    EXPECT_EQ(head_ons(network, plan, after, *report), 0);
    expect_drivable(network, after);
    for (const Record& record : after.records) {
      if (record.kind != RecordKind::kYields) continue;
      EXPECT_GT(record.after, record.before);
      at_node += record.conflict == Conflict::kNode ? 1 : 0;
      in_lane += record.conflict == Conflict::kLane ? 1 : 0;
      across += record.conflict == Conflict::kAcross ? 1 : 0;
    }
    for (std::size_t k = 0; k < after.charts.size(); ++k) {
      for (const Stop& stop : after.charts[k].stops) {
        EXPECT_TRUE(stop.lane != report->lane || &stop <= &after.charts[k].stops[1])
            << "enters the blocked lane";
      }
    }
    if (HasFailure()) return;
  }
  RecordProperty("yields_at_nodes", at_node);
  RecordProperty("yields_in_lane", in_lane);
  RecordProperty("yields_across", across);
  EXPECT_GT(at_node, test::at_least(300));
  EXPECT_GT(in_lane, test::at_least(300));
  EXPECT_GT(across, test::at_least(100));
}

TEST(RandomFleets, OrderOfTheRobotsMakesNoDifference) {
  ChartRandom random(8);
  const LaneNetwork network = small_warehouse();
  int bypasses = 0;
  for (int i = 0; i < test::cases(1000); ++i) {
    SCOPED_TRACE(i);
    const std::vector<Robot> robots = random_robots(random, network);
    std::vector<std::size_t> order(robots.size());
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t k = order.size(); k > 1; --k) {
      std::swap(order[k - 1],
                order[static_cast<std::size_t>(random.whole(0, static_cast<int>(k) - 1))]);
    }
    std::vector<Robot> shuffled;
    for (const std::size_t k : order) shuffled.push_back(robots[k]);
    Plan one = make_plan(network, robots);
    Plan other = make_plan(network, shuffled);
    std::optional<BypassReport> report = random_report(random, network, one, 0, 150);
    if (report) {
      ++bypasses;
      one = bypass(network, one, *report);
      report->robot = static_cast<RobotIndex>(
          std::find(order.begin(), order.end(), static_cast<std::size_t>(report->robot)) -
          order.begin());
      other = bypass(network, other, *report);
    }
    for (std::size_t k = 0; k < order.size(); ++k) {
      EXPECT_EQ(told(network, other.charts[k]), told(network, one.charts[order[k]]));
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(bypasses, test::at_least(500));
}

TEST(RandomFleets, HundredsOfRobotsEndWithoutAConflict) {
  lanes::WarehouseQuery query;
  query.corridors = 10;
  query.rows = 10;
  const LaneNetwork network(lanes::warehouse(query));
  const auto fleet = [&](int count, bool spread) {
    ChartRandom random(10);
    std::vector<Robot> robots;
    for (int i = 0; i < count; ++i) {
      Robot robot;
      robot.name = "R" + std::to_string(i + 1);
      robot.priority = random.whole(0, 4);
      robot.start = spread ? random.whole(0, 59) * kSecond : 0;
      robot.from = spread ? random.whole(0, network.node_count() - 1) : 0;
      robot.goal = random.whole(0, network.node_count() - 1);
      robots.push_back(robot);
    }
    return make_plan(network, robots);
  };
  const int many = test::cases(400);
  const Plan spread = fleet(many, true);
  EXPECT_TRUE(spread.settled);
  EXPECT_EQ(node_conflicts(spread, 5 * kSecond), 0);
  RecordProperty("yields_of_400_spread", static_cast<int>(spread.records.size()));
  // Each of those that start together yields once to each that goes before it.
  const int together = test::cases(200);
  const Plan from_gate = fleet(together, false);
  EXPECT_TRUE(from_gate.settled);
  EXPECT_EQ(node_conflicts(from_gate, 5 * kSecond), 0);
  EXPECT_EQ(from_gate.records.size(),
            static_cast<std::size_t>(together) * static_cast<std::size_t>(together - 1) / 2);
}

// Whether anybody drives along a lane while another drives against it, by charts of one plan.
int opposed(const Plan& plan) {
  int count = 0;
  for (std::size_t a = 0; a < plan.charts.size(); ++a) {
    const std::vector<Stop>& one = plan.charts[a].stops;
    for (std::size_t i = 1; i < one.size(); ++i) {
      if (one[i].leg != Leg::kAgainst) continue;
      for (std::size_t b = 0; b < plan.charts.size(); ++b) {
        const std::vector<Stop>& other = plan.charts[b].stops;
        for (std::size_t k = 1; k < other.size() && a != b; ++k) {
          if (other[k].lane != one[i].lane || other[k].leg == Leg::kAgainst) continue;
          // In one lane already: the one that goes back is behind.
          if (i == 1 && k == 1 && other[0].lane == one[0].lane) continue;
          // Out of another lane against its direction: it is under way when it has left the node.
          const bool turns = other[k - 1].leg == Leg::kAgainst;
          const Nanoseconds begin =
              turns ? other[k].arrival - other[k].travel : other[k - 1].arrival;
          if (begin <= one[i].arrival && one[i - 1].arrival <= other[k].arrival) {
            ++count;
          }
        }
      }
    }
  }
  return count;
}

TEST(RandomFleets, SeveralReportsInARowEndWithoutAHeadOn) {
  ChartRandom random(9);
  const LaneNetwork network = small_warehouse();
  int several = 0;
  int ended_bypasses = 0;
  for (int i = 0; i < test::cases(1500); ++i) {
    SCOPED_TRACE(i);
    PlanSettings settings;
    settings.avoidance.most_moves = 5000;
    Plan plan = make_plan(network, random_robots(random, network), settings);
    int bypasses = 0;
    int now = 0;
    for (int k = 0; k < 5; ++k) {
      now += random.whole(1, 40);
      const RobotIndex robot = random.whole(0, static_cast<int>(plan.robots.size()) - 1);
      const LaneIndex any = random.whole(0, network.lane_count() - 1);
      const int kind = random.whole(0, 4);
      if (kind == 0) {
        plan = lane_blocked(network, plan, {robot, any, now * kSecond}, settings);
      } else if (kind == 1 && !plan.closed.empty()) {
        plan = lane_free(network, plan, {robot, plan.closed.front(), now * kSecond}, settings);
      } else if (auto report = random_report(random, network, plan, now, now + 20, true)) {
        if (kind == 2 && report->way == BypassWay::kLeftLane) {
          report->way = static_cast<BypassWay>(random.whole(0, 3));
        }
        const Chart& before = plan.charts[static_cast<std::size_t>(report->robot)];
        ended_bypasses += is_out_of_lane(chart_at(before, report->time)) ? 1 : 0;
        plan = bypass(network, plan, *report, settings);
        now += 21;
        ++bypasses;
      }
      ASSERT_TRUE(plan.settled);
      EXPECT_EQ(opposed(plan), 0);
      EXPECT_EQ(node_conflicts(plan, settings.avoidance.tolerance), 0);
      expect_drivable(network, plan);
    }
    several += bypasses > 1 ? 1 : 0;
    if (HasFailure()) return;
  }
  EXPECT_GT(several, test::at_least(500));
  EXPECT_GT(ended_bypasses, test::at_least(100));
}

}  // namespace
}  // namespace rubicon::charts
