#include "src/results/gltf/key_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rubicon::gltf {
namespace {

Vec3 at(const KeyCurve& curve, double time) {
  if (time <= curve.front().time) return curve.front().value;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    if (time > curve[i].time) continue;
    const double share = (time - curve[i - 1].time) / (curve[i].time - curve[i - 1].time);
    return curve[i - 1].value + share * (curve[i].value - curve[i - 1].value);
  }
  return curve.back().value;
}

TEST(KeyCurve, LeavesOutKeysOnALine) {
  KeyCurve curve;
  for (int i = 0; i <= 100; ++i) curve.push_back({i * 0.1, {i * 0.1, -i * 0.2, 3}});
  for (int i = 1; i <= 100; ++i) curve.push_back({10 + i * 0.1, {10, -20, 3 + i * 0.1}});
  const KeyCurve few = reduced(curve, 1e-9);
  ASSERT_EQ(few.size(), 3U);
  EXPECT_EQ(few[1].time, 10);
}

TEST(KeyCurve, StaysWithinItsSlack) {
  std::mt19937 random(1995);
  std::uniform_real_distribution<double> some(-1, 1);
  for (int round = 0; round < 200; ++round) {
    KeyCurve curve;
    Vec3 value = Vec3::Zero();
    double time = 0;
    for (int i = 0; i < 60; ++i) {
      curve.push_back({time, value});
      time += 0.01 + std::fabs(some(random));
      if (i % 7 != 0) value += Vec3(some(random), 0.01 * some(random), std::sin(time));
    }
    const double slack = 0.5;
    const KeyCurve few = reduced(curve, slack);
    EXPECT_LT(few.size(), curve.size());
    for (const Key& key : curve) {
      EXPECT_LE((at(few, key.time) - key.value).cwiseAbs().maxCoeff(), slack * (1 + 1e-9));
    }
  }
}

TEST(KeyCurve, KeepsJumps) {
  const KeyCurve curve = {
      {0, Vec3::Zero()}, {1, Vec3::Zero()}, {1, Vec3::Ones()}, {2, Vec3::Ones()}};
  const KeyCurve same = reduced(curve, 1e-3);
  ASSERT_EQ(same.size(), 4U);
  EXPECT_EQ(same[1].value, Vec3::Zero());
  EXPECT_EQ(same[2].value, Vec3::Ones());
  EXPECT_EQ(same[2].time, 1);
}

TEST(KeyCurve, CutsLongTurns) {
  const KeyCurve curve = {{0, Vec3::Zero()}, {6, {540, 0, 0}}, {7, {530, 0, 0}}};
  const KeyCurve turns = with_short_turns(curve, 90);
  ASSERT_EQ(turns.size(), 8U);
  EXPECT_DOUBLE_EQ(turns[1].value.x(), 90);
  EXPECT_DOUBLE_EQ(turns[1].time, 1);
  EXPECT_EQ(count_with_short_turns(curve, 90), turns.size());
}

}  // namespace
}  // namespace rubicon::gltf
