#include "src/motion/robot/trapezoid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rubicon::robot {
namespace {

/// The oracle: what the speed is at each moment, and the way as its integral.
class Drive {
 public:
  Drive(double whole, double speed, double acceleration) {
    constexpr double kStep = 1e-4;  // s
    double distance = 0;
    for (double v = 0; distance < whole;) {
      // It brakes where it could not stop any more otherwise.
      const bool brakes = v * v / (2 * acceleration) >= whole - distance;
      const double next =
          brakes ? v - acceleration * kStep : std::min(speed, v + acceleration * kStep);
      if (next <= 0) break;
      distance += (v + next) / 2 * kStep;
      v = next;
      seconds_ += kStep;
      way_.push_back(distance);
    }
  }

  double seconds() const { return seconds_; }
  /// s until it has gone so far.
  double time_at(double distance) const {
    const auto found = std::lower_bound(way_.begin(), way_.end(), distance);
    return static_cast<double>(found - way_.begin() + 1) * 1e-4;
  }

 private:
  std::vector<double> way_;
  double seconds_ = 0;
};

struct Case {
  double speed;
  double acceleration;
};
constexpr Case kCases[] = {{0.5, 0.3}, {0.67, 0.2}, {3.6, 1.5}, {2, 0.25}, {0.1, 4}};

TEST(Trapezoid, AgreesWithAnIntegratedDrive) {
  for (const auto& [speed, acceleration] : kCases) {
    for (const double whole : {0.05, 0.4, 1.3, 7.0, 40.0}) {
      const Drive drive(whole, speed, acceleration);
      // The last step of the oracle ends at most one step and the way it crawls before it.
      EXPECT_NEAR(time_to_rest(whole, speed, acceleration), drive.seconds(), 0.05)
          << whole << " m at " << speed;
      // What is under way does not know yet where it will stop: up to where the oracle brakes.
      const double peak = std::min(speed, std::sqrt(acceleration * whole));
      const double until = whole - peak * peak / (2 * acceleration);
      for (const double share : {0.1, 0.5, 0.9}) {
        EXPECT_NEAR(time_under_way(share * until, speed, acceleration),
                    drive.time_at(share * until), 3e-4)
            << share << " of " << until;
      }
    }
  }
}

TEST(Trapezoid, HasTheFiguresOfTheFormula) {
  // 0.5 m/s at 0.25 m/s2: 2 s and 0.5 m until it is fast.
  EXPECT_DOUBLE_EQ(time_under_way(0.5, 0.5, 0.25), 2);
  EXPECT_DOUBLE_EQ(time_under_way(0.125, 0.5, 0.25), 1);
  EXPECT_DOUBLE_EQ(time_under_way(2, 0.5, 0.25), 5);
  EXPECT_DOUBLE_EQ(time_to_rest(0.25, 0.5, 0.25), 2);
  EXPECT_DOUBLE_EQ(time_to_rest(1, 0.5, 0.25), 4);
  EXPECT_DOUBLE_EQ(time_to_rest(4, 0.5, 0.25), 10);
  EXPECT_EQ(time_under_way(0, 1, 1), 0);
  EXPECT_EQ(time_to_rest(0, 1, 1), 0);
}

TEST(Trapezoid, IsSmoothWhereItsPartsMeetAndLastsLongerThanSpeedAlone) {
  for (const auto& [speed, acceleration] : kCases) {
    const double ramp = speed * speed / acceleration;
    for (const double meet : {ramp / 2, ramp}) {
      const double below = meet * (1 - 1e-12), above = meet * (1 + 1e-12);
      EXPECT_NEAR(time_under_way(below, speed, acceleration),
                  time_under_way(above, speed, acceleration), 1e-9);
      EXPECT_NEAR(time_to_rest(below, speed, acceleration),
                  time_to_rest(above, speed, acceleration), 1e-9);
    }
    double before = 0;
    for (double d = ramp / 50; d < 4 * ramp; d += ramp / 50) {
      const double now = time_under_way(d, speed, acceleration);
      EXPECT_GT(now, before);
      EXPECT_GT(time_to_rest(d, speed, acceleration), now);
      EXPECT_GT(now, d / speed);
      before = now;
    }
  }
}

}  // namespace
}  // namespace rubicon::robot
