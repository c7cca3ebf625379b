#include "src/motion/geometry/timetable.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/random_cases.hpp"

namespace rubicon::geometry {
namespace {

using math::rotation_z_deg;
using math::translation;

constexpr std::int64_t kSecond = 1'000'000'000;

Timetable there_and_back() {
  return {{{10 * kSecond, translation(0, 0, 0)},
           {20 * kSecond, translation(10, 0, 0) * rotation_z_deg(90)},
           {24 * kSecond, translation(10, 0, 0) * rotation_z_deg(90)},
           {30 * kSecond, translation(0, 0, 0)}},
          true};
}

void expect_near(const Pose& X, const Pose& X_expected) {
  EXPECT_LE((X.matrix() - X_expected.matrix()).cwiseAbs().maxCoeff(), 1e-12) << X.matrix();
}

TEST(Timetable, GoesStraightAndTurnsEvenly) {
  const Timetable timetable = there_and_back();
  expect_near(pose_at(timetable, 15 * kSecond), translation(5, 0, 0) * rotation_z_deg(45));
  expect_near(pose_at(timetable, 22 * kSecond), translation(10, 0, 0) * rotation_z_deg(90));
  expect_near(pose_at(timetable, 27 * kSecond), translation(5, 0, 0) * rotation_z_deg(45));
  expect_near(pose_at(timetable, 0), Pose::Identity());
}

TEST(Timetable, TurnsTheShortWay) {
  const Timetable timetable{{{0, rotation_z_deg(170)}, {kSecond, rotation_z_deg(-170)}}, false};
  expect_near(pose_at(timetable, kSecond / 2), rotation_z_deg(180));
}

TEST(Timetable, RepeatsForEver) {
  const Timetable timetable = there_and_back();
  for (const std::int64_t round : {1, 2, 1'000'000}) {
    expect_near(pose_at(timetable, round * 20 * kSecond + 15 * kSecond),
                translation(5, 0, 0) * rotation_z_deg(45));
  }
  Timetable once = timetable;
  once.repeat = false;
  expect_near(pose_at(once, 35 * kSecond), Pose::Identity());
}

TEST(Timetable, MotionsCoverTheTimeAndMeetThePoses) {
  const Timetable timetable = there_and_back();
  std::mt19937_64 random(7);
  std::uniform_int_distribution<std::int64_t> time(0, 100 * kSecond);
  for (int i = 0; i < test::cases(500); ++i) {
    std::int64_t from = time(random), to = time(random);
    if (from == to) continue;
    if (from > to) std::swap(from, to);
    std::int64_t at = from;
    for (const TimedMotion& each : motions_between(timetable, from, to)) {
      ASSERT_EQ(each.from, at);
      ASSERT_LT(each.from, each.to);
      at = each.to;
      for (const double s : {0.0, 0.25, 1.0}) {
        const auto then =
            each.from + static_cast<std::int64_t>(s * static_cast<double>(each.to - each.from));
        const Pose X = each.motion.pose(s), X_then = pose_at(timetable, then);
        ASSERT_LE((X.matrix() - X_then.matrix()).cwiseAbs().maxCoeff(), 1e-6);
      }
    }
    ASSERT_EQ(at, to);
  }
}

// The bound that swept volumes are built on, for points all round the origin.
TEST(Timetable, NoPointIsFartherFromItsChordThanSaid) {
  const Timetable timetable{
      {{0, translation(1, 2, 0) * rotation_z_deg(20)},
       {kSecond, translation(4, -3, 1) * math::rotation_x_deg(30) * rotation_z_deg(150)}},
      false};
  const Motion motion = motions_between(timetable, 0, kSecond).front().motion;
  const auto* general = std::get_if<std::shared_ptr<const GeneralMotion>>(&motion.kind);
  ASSERT_NE(general, nullptr);
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> part(-1, 1);
  for (int i = 0; i < test::cases(2000); ++i) {
    const double reach = 5;
    const Vec3 p_O = Vec3(part(random), part(random), part(random)).normalized() * reach;
    double s0 = std::abs(part(random)), s1 = std::abs(part(random));
    if (s0 > s1) std::swap(s0, s1);
    const double u = std::abs(part(random));
    const Vec3 chord = (1 - u) * (motion.pose(s0) * p_O) + u * (motion.pose(s1) * p_O);
    const double away = (motion.pose(s0 + u * (s1 - s0)) * p_O - chord).norm();
    ASSERT_LE(away, (*general)->chord_deviation(s0, s1, reach) + 1e-12);
  }
}

}  // namespace
}  // namespace rubicon::geometry
