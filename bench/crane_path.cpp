#include "bench/crane_path.hpp"

#include <algorithm>
#include <cmath>

#include "bench/residential_site.hpp"
#include "src/motion/math/angles.hpp"

namespace rubicon::bench {
namespace {

constexpr double kTurn = 2;              // degrees a step
constexpr double kSlide = 0.5;           // m a step
constexpr double kTrolleyHeight = 31.2;  // m
constexpr double kSling = 1;             // m, from the top of the load to the hook
constexpr double kAboveGoal = 3;         // m, how far above its goal the load travels
constexpr std::array<int, kCraneParts> kParent = {-1, kMast, kJib, kJib, kTrolley, kHook};

/// What the crane's three parameters say.
struct Configuration {
  double theta = -20;  // degrees: at the stack,
  double x = 24;       // m
  double z = 1.5;      // m, the load just above the ground
};

Pose hook_pose(const Configuration& at) {
  return math::rotation_z_deg(at.theta) * math::translation(at.x, 0, at.z);
}

/// Writes down the steps of a crane that goes from configuration to configuration.
class Recorder {
 public:
  std::vector<CraneStep> steps;
  Configuration at;
  bool loaded = true;
  double load_yaw = 0;  // degrees, of the load on the hook

  void slew_to(double theta) {
    go(at.theta, theta, kTurn, [this](double delta) {
      CraneStep step = standing(kJib);
      for (auto& motion : step.motions) motion.angle_deg = delta;
      return step;
    });
  }
  void trolley_to(double x) {
    go(at.x, x, kSlide, [this](double delta) {
      CraneStep step = standing(kTrolley);
      for (auto& motion : step.motions) {
        motion.slide = delta * (math::rotation_z_deg(at.theta) * Vec3::UnitX());
      }
      return step;
    });
  }
  void hoist_to(double z) {
    go(at.z, z, kSlide, [this](double delta) {
      CraneStep step = standing(kHook);
      for (auto& motion : step.motions) motion.slide = delta * Vec3::UnitZ();
      return step;
    });
  }

 private:
  /// Whole steps, the last one shorter.
  template <typename Make>
  void go(double& value, double goal, double step, Make make) {
    const double start = value;
    const int count = static_cast<int>(std::ceil(std::abs(goal - start) / step - 1e-9));
    for (int i = 1; i <= count; ++i) {
      const double next = i == count ? goal : start + std::copysign(step * i, goal - start);
      CraneStep made = make(next - value);
      for (int part = 0; part < kCraneParts; ++part) {
        if (made.moves[part]) continue;
        made.motions[part].angle_deg = 0;
        made.motions[part].slide.setZero();
      }
      steps.push_back(made);
      value = next;
    }
  }

  /// All parts where they are; those from `first_moving` on are marked to move.
  CraneStep standing(CranePart first_moving) const {
    const Pose X_jib = math::rotation_z_deg(at.theta);
    const Pose X_trolley = X_jib * math::translation(at.x, 0, kTrolleyHeight);
    const Pose X_hook = hook_pose(at);
    const Pose X_load =
        X_hook * math::translation(0, 0, -kSling - kPlankHalf.z()) * math::rotation_z_deg(load_yaw);
    CraneStep step;
    step.loaded = loaded;
    const std::array<Pose, kCraneParts> poses = {Pose::Identity(), X_jib,  X_jib,
                                                 X_trolley,        X_hook, X_load};
    for (int part = 0; part < kCraneParts; ++part) {
      step.motions[part].X0 = poses[part];
      step.moves[part] = part >= first_moving && (loaded || part != kLoad);
    }
    return step;
  }
};

}  // namespace

std::array<std::vector<geometry::Box>, kCraneParts> crane_boxes() {
  const auto box = [](double x0, double y0, double z0, double x1, double y1, double z1) {
    return geometry::Box{{x0, y0, z0}, {x1, y1, z1}};
  };
  return {{{box(-0.9, -0.9, 0, 0.9, 0.9, 31), box(-3, -3, 0, 3, 3, 0.8)},
           {box(-1.2, -1.2, 31, 1.2, 1.2, 34), box(1.2, -0.7, 31.5, 45, 0.7, 33)},
           {box(-13, -0.9, 31.5, -1.2, 0.9, 32.5), box(-13, -1.2, 29.5, -9.5, 1.2, 31.5)},
           {box(-0.6, -0.6, 0, 0.6, 0.6, 0.3)},
           {box(-0.25, -0.25, 0, 0.25, 0.25, 1.2)},
           {centred_box(kPlankHalf)}}};
}

std::vector<std::pair<int, int>> CraneStep::pairs() const {
  std::vector<std::pair<int, int>> result;
  const int parts = loaded ? kCraneParts : kCraneParts - 1;
  for (int a = 0; a < parts; ++a) {
    for (int b = a + 1; b < parts; ++b) {
      if (moves[a] != moves[b] && kParent[b] != a) result.emplace_back(a, b);
    }
  }
  return result;
}

std::vector<CraneStep> crane_path(const std::vector<Vec3>& places) {
  Recorder crane;
  const Configuration stack = crane.at;
  for (const Vec3& place : places) {
    const double theta = math::atan2_deg(place.y(), place.x());
    const double radius = std::hypot(place.x(), place.y());
    const double hook = place.z() + kPlankHalf.z() + kSling;
    crane.loaded = true;
    crane.load_yaw = -theta;  // so that it lies along y where it is put down
    crane.hoist_to(hook + kAboveGoal);
    crane.trolley_to(std::min(crane.at.x, radius));
    crane.slew_to(theta);
    crane.trolley_to(radius);
    crane.hoist_to(hook);
    crane.loaded = false;
    crane.hoist_to(hook + kAboveGoal);
    crane.trolley_to(std::min(crane.at.x, stack.x));
    crane.slew_to(stack.theta);
    crane.trolley_to(stack.x);
    crane.hoist_to(stack.z);
  }
  return crane.steps;
}

}  // namespace rubicon::bench
