// Random networks with reports: what the planner writes is judged by verify, which shares no code
// with it.
#include "src/results/report/charts_text.hpp"

#include <gtest/gtest.h>

#include <set>

#include "src/results/verify/charts/check_charts.hpp"
#include "tests/support/random_cases.hpp"

namespace rubicon::report {
namespace {

using charts::SiteReport;

// Random numbers that are the same everywhere (SplitMix64).
class ReportRandom {
 public:
  explicit ReportRandom(std::uint64_t seed) : state_(seed) {}
  int whole(int low, int high) {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return low + static_cast<int>((z ^ (z >> 31)) % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::uint64_t state_;
};

// A ring both ways, the two lanes of a side beside each other, and some more lanes.
lanes::NetworkDescription random_network(ReportRandom& random) {
  lanes::NetworkDescription description;
  description.classes = {{"fast", 3, 4, 1}, {"slow", 0.7, 3, 0.5}};
  const int nodes = random.whole(4, 14);
  for (int i = 0; i < nodes; ++i) {
    const double x = random.whole(0, 400) / 3.0 + 150.0 * i;
    description.nodes.push_back({"n" + std::to_string(i), x, random.whole(0, 900) / 7.0, 0, true});
  }
  std::set<std::pair<int, int>> known;
  for (int i = 0; i < nodes; ++i) {
    const int to = (i + 1) % nodes;
    const int lane_class = random.whole(0, 1);
    const auto first = static_cast<lanes::LaneIndex>(description.lanes.size());
    description.lanes.push_back({i, to, lane_class, std::nullopt, lanes::kNone});
    description.lanes.push_back({to, i, lane_class, std::nullopt, first});
    known.insert({i, to});
    known.insert({to, i});
  }
  for (int k = random.whole(0, nodes); k > 0; --k) {
    const int from = random.whole(0, nodes - 1);
    const int to = random.whole(0, nodes - 1);
    if (from == to || !known.insert({from, to}).second) continue;
    description.lanes.push_back({from, to, random.whole(0, 1), std::nullopt, lanes::kNone});
  }
  return description;
}

interpreter::ChartsSpec random_errands(ReportRandom& random, int nodes) {
  interpreter::ChartsSpec spec;
  const int count = random.whole(2, 9);
  for (int i = 0; i < count; ++i) {
    charts::Robot robot;
    robot.name = "r" + std::to_string(i + 1);
    robot.priority = random.whole(0, 3);
    robot.start = random.whole(0, 60) * charts::kSecond;
    robot.from = random.whole(0, nodes - 1);
    robot.goal = (robot.from + random.whole(1, nodes - 1)) % nodes;
    robot.width = random.whole(0, 4) == 0 ? 3.5 : 2;
    if (random.whole(0, 2) == 0) robot.speed = random.whole(5, 20) / 10.0;
    spec.robots.push_back(robot);
  }
  spec.settings.avoidance.tolerance = random.whole(0, 8) * charts::kSecond;
  spec.settings.avoidance.delay = random.whole(1, 20) * charts::kSecond;
  spec.settings.avoidance.clearance = random.whole(1, 10) * charts::kSecond;
  spec.settings.criterion = static_cast<lanes::Criterion>(random.whole(0, 2));
  return spec;
}

// What a robot could report at some moment; not all that is guessed can be.
SiteReport random_guess(ReportRandom& random, const lanes::LaneNetwork& network,
                        const charts::Course& course) {
  const charts::Plan& plan = course.steps.back().plan;
  SiteReport report;
  report.robot = random.whole(0, static_cast<int>(plan.robots.size()) - 1);
  report.time = plan.now + random.whole(0, 60'000) * (charts::kSecond / 1000);
  const charts::Chart present =
      chart_at(plan.charts[static_cast<std::size_t>(report.robot)], report.time);
  const charts::Stop& front = present.stops.front();
  if (!plan.closed.empty() && random.whole(0, 2) == 0) {
    report.kind = SiteReport::Kind::kReopened;
    report.lane = plan.closed[static_cast<std::size_t>(
        random.whole(0, static_cast<int>(plan.closed.size()) - 1))];
  } else if (front.lane != charts::kNone) {
    report.kind = SiteReport::Kind::kObstacle;
    report.lane = front.lane;
    if (front.leg == charts::Leg::kAgainst) report.lane = network.lane(front.lane).beside;
    report.obstacle_from = random.whole(0, 40) / 10.0;
    report.obstacle_to = report.obstacle_from + random.whole(0, 80) / 10.0;
    if (report.lane == charts::kNone) report.lane = front.lane;
  } else {
    report.lane = present.stops.size() > 1 ? present.stops[1].lane
                                           : random.whole(0, network.lane_count() - 1);
    if (report.lane == charts::kNone) report.lane = 0;
  }
  return report;
}

TEST(ChartsText, IsFoundRightByVerifyWhateverIsReported) {
  int reports = 0, yields = 0, bypasses = 0, returns = 0, reopened = 0, found = 0;
  const int count = test::cases(300);
  for (int seed = 1; seed <= count; ++seed) {
    ReportRandom random(static_cast<std::uint64_t>(seed));
    interpreter::NetworkSpec description;
    description.name = "net";
    description.description = random_network(random);
    const lanes::LaneNetwork network(description.description);
    interpreter::ChartsSpec spec = random_errands(random, network.node_count());
    for (int barriers = random.whole(0, 3); barriers > 0; --barriers) {
      charts::Barrier barrier;
      barrier.lane = random.whole(0, network.lane_count() - 1);
      barrier.since = random.whole(0, 200) * charts::kSecond;
      if (random.whole(0, 3) > 0) {
        barrier.until = barrier.since + random.whole(1, 300) * charts::kSecond;
      }
      spec.barriers.push_back(barrier);
    }
    auto made = charts::carry_out(network, spec.robots, spec.settings, spec.reports, spec.barriers);
    ASSERT_TRUE(std::holds_alternative<charts::Course>(made));
    charts::Course course = std::get<charts::Course>(std::move(made));
    for (int guesses = random.whole(0, 8); guesses > 0; --guesses) {
      spec.reports.push_back(random_guess(random, network, course));
      auto next =
          charts::carry_out(network, spec.robots, spec.settings, spec.reports, spec.barriers);
      if (std::holds_alternative<charts::ReportFault>(next)) {
        spec.reports.pop_back();
      } else {
        course = std::get<charts::Course>(std::move(next));
      }
    }
    const ChartsResult result{spec, description, network, course};
    const verify::ChartsVerdict verdict = verify::check_charts(charts_json(result));
    ASSERT_TRUE(verdict.settled) << "seed " << seed;
    ASSERT_TRUE(verdict.faults.empty()) << "seed " << seed << ": " << verdict.faults.front() << "\n"
                                        << charts_table(result);
    reports += static_cast<int>(spec.reports.size());
    for (const charts::CourseStep& step : course.steps) {
      found += step.report && step.listed < 0;
      for (const charts::Record& record : step.plan.records) {
        yields += record.kind == charts::RecordKind::kYields;
        bypasses += record.kind == charts::RecordKind::kBypasses;
        returns += record.kind == charts::RecordKind::kReturns;
        reopened += record.kind == charts::RecordKind::kReopened;
      }
    }
  }
  // The cases are worth something.
  EXPECT_GE(reports, test::at_least(700));
  EXPECT_GE(yields, test::at_least(180));
  EXPECT_GE(bypasses, test::at_least(60));
  EXPECT_GE(returns, test::at_least(30));
  EXPECT_GE(reopened, test::at_least(150));
  EXPECT_GE(found, test::at_least(100));
  RecordProperty("found", found);
  RecordProperty("reports", reports);
  RecordProperty("yields", yields);
  RecordProperty("bypasses", bypasses);
  RecordProperty("returns", returns);
  RecordProperty("reopened", reopened);
}

}  // namespace
}  // namespace rubicon::report
