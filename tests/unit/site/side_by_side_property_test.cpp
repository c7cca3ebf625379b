#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "src/simulation/site/make_site.hpp"
#include "src/simulation/site/robot_view.hpp"
#include "tests/unit/collision/box_oracle.hpp"
#include "tests/unit/taskplan/crane_plan.hpp"

namespace rubicon::site {
namespace {

using collision::test::box_depth;
using collision::test::OracleBox;
using math::translation;
using Q = std::vector<double>;

/// A step that was made.
struct Made {
  int machine = 0;
  Q q_from;
  Q q_to;
  Ticks start = 0;
  Ticks end = 0;
};

/// Four tower cranes in each other's reach, at three heights; the first two carry panels.
interpreter::PlanModel crowded_plan() {
  interpreter::PlanModel plan = test::crane_plan();
  const std::vector<math::Pose> places = {translation(0, 0, 0), translation(30, 0, -5),
                                          translation(0, 30, -5), translation(31, 32, 0)};
  const std::vector<double> angles = {-135, -45, 135, 45};
  plan.robots.resize(1);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i > 0) plan.robots.push_back(plan.robots[0]);
    plan.robots[i].name = "crane " + std::to_string(i);
    plan.robots[i].X_WM = places[i];
    plan.robots[i].start = {angles[i], 20, 20, 0};
  }
  return plan;
}

std::vector<OracleBox> boxes_at(const SiteWorld& site, int machine, const Q& q,
                                const std::vector<interpreter::ComponentSpec>& loads) {
  const SiteRobot& robot = site.robot(machine);
  std::vector<math::Pose> poses;
  robot::body_poses(*robot.model, robot.mounting, q, poses);
  std::vector<OracleBox> boxes;
  const auto add = [&](const geometry::Shape& shape, const math::Pose& X) {
    const auto& box = std::get<geometry::Box>(shape.solid);
    OracleBox& oracle = boxes.emplace_back();
    oracle.half = 0.5 * (box.upper - box.lower);
    const math::Vec3 centre = 0.5 * (box.lower + box.upper);
    oracle.X_WC = X * translation(centre.x(), centre.y(), centre.z());
  };
  for (std::size_t i = 0; i < poses.size(); ++i) add(robot.model->bodies[i].shapes[0], poses[i]);
  const auto& load = site.load(machine);
  if (load) {
    add(loads[static_cast<std::size_t>(load->component)].shapes[0],
        robot::tool_pose(*robot.model, robot.mounting, q) * load->X_TO);
  }
  return boxes;
}

Q at_time(const Made& step, Ticks now) {
  const double share =
      static_cast<double>(now - step.start) / static_cast<double>(step.end - step.start);
  Q q = step.q_from;
  for (std::size_t i = 0; i < q.size(); ++i) q[i] += share * (step.q_to[i] - step.q_from[i]);
  return q;
}

class Crowd {
 public:
  explicit Crowd(unsigned seed) : random_(seed) {
    for (int i = 0; i < 2; ++i) {
      const math::Pose X_WT = site_.tool_pose(i);
      plan_.components.push_back(test::box_component(
          "panel", {8, 0.2, 3}, X_WT * translation(0, 0, -3) * math::rotation_z_deg(40)));
    }
    site_ = make_site(plan_);
    for (int i = 0; i < 2; ++i) site_.attach(i, i);
    free_at_.assign(plan_.robots.size(), 0);
  }

  void run(Ticks until) {
    for (Ticks now = 0; now < until; ++now) {
      site_.set_time(now);
      for (int i = 0; i < static_cast<int>(free_at_.size()); ++i) {
        if (free_at_[static_cast<std::size_t>(i)] <= now) try_step(i, now);
      }
    }
  }

  /// Pairs of boxes of different machines that are deep in each other, over all moments.
  void expect_apart(Ticks until) const {
    for (Ticks now = 0; now < until; ++now) {
      std::vector<std::vector<OracleBox>> machines;
      for (int i = 0; i < static_cast<int>(free_at_.size()); ++i) {
        machines.push_back(boxes_at(site_, i, configuration(i, now), plan_.components));
      }
      for (std::size_t i = 0; i < machines.size(); ++i) {
        for (std::size_t j = i + 1; j < machines.size(); ++j) {
          for (const OracleBox& a : machines[i]) {
            for (const OracleBox& b : machines[j]) {
              ASSERT_LE(box_depth(a, b), plan_.contact + 1e-9)
                  << "machines " << i << " and " << j << " at " << now;
            }
          }
        }
      }
    }
  }

  int made() const { return static_cast<int>(made_.size()); }
  int refused_by_others = 0;

 private:
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) * 0x1p-32;
  }

  void try_step(int machine, Ticks now) {
    const Q from = site_.configuration(machine);
    Q to = from;
    to[0] += between(-60, 60);
    if (random_() % 2 == 0) to[1] = std::clamp(to[1] + between(-8, 8), 4.0, 50.0);
    if (random_() % 2 == 0) to[2] = std::clamp(to[2] + between(-8, 8), 0.0, 42.0);
    if (random_() % 2 == 0) to[3] += between(-40, 40);
    const Ticks duration = 5 + random_() % 40;
    RobotView view(site_, machine);
    const auto hit = view.propose({from, to, now, duration});
    if (hit) {
      if (hit->machine >= 0) ++refused_by_others;
      return;
    }
    made_.push_back({machine, from, to, now, now + duration});
    free_at_[static_cast<std::size_t>(machine)] = now + duration;
  }

  Q configuration(int machine, Ticks now) const {
    const Made* last = nullptr;
    for (const Made& step : made_) {
      if (step.machine == machine && step.start <= now) last = &step;
    }
    if (last == nullptr) return plan_.robots[static_cast<std::size_t>(machine)].start;
    return at_time(*last, std::min(now, last->end));
  }

  interpreter::PlanModel plan_ = crowded_plan();
  SiteWorld site_ = make_site(plan_);
  std::mt19937 random_;
  std::vector<Ticks> free_at_;
  std::vector<Made> made_;
};

TEST(SideBySideProperty, MachinesThatStepAtRandomNeverOverlap) {
  int made = 0;
  int refused = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    Crowd crowd(seed);
    crowd.run(3000);
    crowd.expect_apart(3000);
    made += crowd.made();
    refused += crowd.refused_by_others;
  }
  EXPECT_GT(made, 300);
  EXPECT_GT(refused, 250);  // by parts that move
}

}  // namespace
}  // namespace rubicon::site
