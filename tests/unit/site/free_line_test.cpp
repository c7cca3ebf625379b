#include "src/simulation/site/free_line.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <utility>
#include <vector>

#include "src/simulation/site/make_site.hpp"
#include "src/simulation/site/robot_view.hpp"
#include "tests/unit/site/hit_text.hpp"
#include "tests/unit/taskplan/crane_plan.hpp"

namespace rubicon::site {
namespace {

using math::translation;
using Q = std::vector<double>;

/// Two parameters: the first from 0 to 100, the second an angle.
robot::RobotModel model() {
  robot::RobotModel model;
  model.parameters.resize(2);
  model.parameters[0].lower = 0;
  model.parameters[0].upper = 100;
  model.parameters[1].cyclic = true;
  return model;
}

TEST(FreeLine, LooksAheadAlongEqualSteps) {
  const robot::RobotModel robot = model();
  FreeLine line;
  EXPECT_EQ(line.ahead(robot, Q{10, 5}, Q{12, 5}), (Q{18, 5}));
  line.found_free(Q{10, 5}, {18, 5}, 1);
  EXPECT_TRUE(line.covers(Q{12, 5}, Q{14, 5}, 1));
  EXPECT_EQ(line.ahead(robot, Q{18, 5}, Q{20, 5}), (Q{34, 5})) << "twice as far";
}

TEST(FreeLine, WaitsForEqualStepsWhereLinesWereOfNoUse) {
  const robot::RobotModel robot = model();
  FreeLine line;
  EXPECT_EQ(line.ahead(robot, Q{10, 5}, Q{12, 5}), (Q{18, 5}));
  line.found_free(Q{10, 5}, {18, 5}, 1);
  EXPECT_TRUE(line.ahead(robot, Q{12, 5}, Q{12, 6}).empty());
  EXPECT_TRUE(line.ahead(robot, Q{12, 6}, Q{14, 6}).empty());
  EXPECT_TRUE(line.ahead(robot, Q{12, 6}, Q{14, 6}).empty()) << "the same step again";
  EXPECT_EQ(line.ahead(robot, Q{14, 6}, Q{16, 6}), (Q{30, 6})) << "it goes on";
}

TEST(FreeLine, CoversWhatLiesOnItWhileNothingChanges) {
  FreeLine line;
  EXPECT_FALSE(line.covers(Q{0, 0}, Q{0, 0}, 0));
  line.found_free(Q{10, 5}, {20, 10}, 7);
  EXPECT_TRUE(line.covers(Q{12, 6}, Q{14, 7}, 7));
  EXPECT_TRUE(line.covers(Q{14, 7}, Q{12, 6}, 7)) << "back again";
  EXPECT_TRUE(line.covers(Q{10, 5}, Q{20, 10}, 7));
  EXPECT_FALSE(line.covers(Q{12, 6}, Q{14, 7}, 8));
  EXPECT_FALSE(line.covers(Q{12, 6}, Q{14, 7.000001}, 7));
  EXPECT_FALSE(line.covers(Q{18, 9}, Q{20.000001, 10.0000005}, 7));
  EXPECT_FALSE(line.covers(Q{9.999999, 4.9999995}, Q{12, 6}, 7));
  line.found_free(Q{10, 5}, {20, 5}, 7);
  EXPECT_FALSE(line.covers(Q{12, 5}, Q{14, 5.0000000000001}, 7)) << "what stood still";
}

TEST(FreeLine, KeepsWithinTheLimits) {
  const robot::RobotModel robot = model();
  FreeLine line;
  EXPECT_EQ(line.ahead(robot, Q{93.5, 170}, Q{95.5, 174}), (Q{99.5, 182}));
  line.ahead(robot, Q{95.5, 174}, Q{97.5, 178});
  EXPECT_TRUE(line.ahead(robot, Q{97.5, 178}, Q{99.5, 182}).empty());
}

TEST(FreeLine, LooksLessFarWhereSomethingIsInTheWay) {
  const robot::RobotModel robot = model();
  FreeLine line;
  double x = 1;
  const auto next = [&] {
    const Q ahead = line.ahead(robot, Q{x, 0}, Q{x + 1, 0});
    const double steps = ahead.empty() ? 0 : ahead[0] - x;
    x += 1;
    if (steps > 0) line.found_blocked();
    return steps;
  };
  Q steps;
  for (int i = 0; i < 12; ++i) steps.push_back(next());
  EXPECT_EQ(steps, (Q{4, 2, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0}));
}

/// Three cranes in each other's reach among panels and people. They make runs of equal steps; now
/// and then a panel is picked up, set down or turned, and a zone held or given up.
class BusySite {
 public:
  explicit BusySite(unsigned seed) : random_(seed) {
    plan_ = test::crane_plan();
    plan_.site.push_back({geometry::Box{{-80, -80, -1}, {80, 80, 0}}, math::Pose::Identity()});
    plan_.robots.resize(1);
    const std::vector<math::Pose> places = {translation(0, 0, 0), translation(34, 0, -5),
                                            translation(0, 36, 4)};
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (i > 0) plan_.robots.push_back(plan_.robots[0]);
      plan_.robots[i].name = "crane " + std::to_string(i);
      plan_.robots[i].X_WM = places[i];
      plan_.robots[i].start = {between(-180, 180), 20, 20, 0};
    }
    for (int i = 0; i < 30; ++i) {
      const math::Pose X = translation(between(-45, 70), between(-45, 70), 0);
      plan_.components.push_back(
          test::box_component("panel " + std::to_string(i), {6, 0.3, between(2, 25)}, X));
    }
    site_ = make_site(plan_);
    for (int i = 0; i < static_cast<int>(places.size()); ++i) views_.emplace_back(site_, i);
    runs_.resize(places.size());
  }

  /// Every answer beside that of a view that knows of no line.
  void run(int rounds) {
    for (int round = 0; round < rounds; ++round) {
      site_.set_time(++now_);
      disturb();
      for (std::size_t i = 0; i < runs_.size(); ++i) step(static_cast<int>(i));
      if (testing::Test::HasFailure()) return;
    }
  }

  int steps = 0;
  int refused = 0;

 private:
  struct Run {
    Q step;
    int left = 0;
  };

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) * 0x1p-32;
  }

  void step(int machine) {
    Run& run = runs_[static_cast<std::size_t>(machine)];
    if (run.left-- <= 0) begin(run);
    const Q from = site_.configuration(machine);
    Q to = from;
    for (std::size_t i = 0; i < to.size(); ++i) to[i] += run.step[i];
    if (to[1] < 4 || to[1] > 50 || to[2] < 0 || to[2] > 42) {
      run.left = 0;
      return;
    }
    const interpreter::MotionStep step{from, to, now_, 1};
    const RobotView fresh(site_, machine);
    RobotView& view = views_[static_cast<std::size_t>(machine)];
    const std::string expected = test::hit_text(fresh.refusal(step));
    const auto hit = view.propose(step);
    ASSERT_EQ(test::hit_text(hit), expected) << "machine " << machine << " at " << now_;
    ++steps;
    if (!hit) return;
    ++refused;
    run.left = static_cast<int>(random_() % 3);  // it may try again
  }

  void begin(Run& run) {
    run.left = static_cast<int>(random_() % 25);
    run.step = {0, 0, 0, 0};
    const std::size_t which = random_() % 5;
    const double size = random_() % 2 == 0 ? 1 : -1;
    if (which < 3) run.step[which] = size * between(0.2, 2);
    if (which == 3) run.step = {size * 2, 0.5, 0.25, 0};
    if (which == 4) run.step[3] = size * 10;
  }

  void disturb() {
    if (random_() % 20 != 0) return;
    const int machine = static_cast<int>(random_() % runs_.size());
    const auto& load = site_.load(machine);
    if (random_() % 3 == 0) {
      const int task = static_cast<int>(random_() % 3);
      zone_[0] = {geometry::Box{{0, 0, 0}, {8, 8, 3}},
                  translation(between(-40, 60), between(-40, 60), 0)};
      if (random_() % 2 == 0) {
        site_.hold_zone(task, "task", {zone_, zone_}, -1);
      } else {
        site_.release_zone(task);
      }
    } else if (!load) {
      const int component = static_cast<int>(random_() % plan_.components.size());
      if (site_.stands(component)) site_.attach(machine, component);
    } else if (random_() % 3 == 0) {
      if (!site_.is_in_step(machine)) site_.begin_turn(machine, between(-90, 90), now_ + 1);
    } else {
      site_.detach(machine);
    }
  }

  interpreter::PlanModel plan_;
  SiteWorld site_{1e-3};
  std::mt19937 random_;
  std::vector<RobotView> views_;
  std::vector<Run> runs_;
  std::vector<geometry::Shape> zone_{1};
  Ticks now_ = 0;
};

TEST(FreeLineProperty, ChangesNoAnswer) {
  int steps = 0;
  int refused = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    BusySite site(seed);
    site.run(1200);
    if (HasFailure()) return;
    steps += site.steps;
    refused += site.refused;
  }
  EXPECT_GT(steps, 20000);
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace rubicon::site
