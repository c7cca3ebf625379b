#include "src/exchange/ifc/solid_cut.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "src/exchange/ifc/swept_solids.hpp"

namespace rubicon::ifc {
namespace {

using math::Vec3;

WorkBudget plenty() { return WorkBudget(2'000'000'000); }

Solid box(const Vec3& low, const Vec3& high) {
  WorkBudget budget = plenty();
  return *extruded({{low,
                     {high.x(), low.y(), low.z()},
                     {high.x(), high.y(), low.z()},
                     {low.x(), high.y(), low.z()}},
                    {}},
                   {0, 0, high.z() - low.z()}, budget);
}

Cell cell_of(const Solid& solid) {
  WorkBudget budget = plenty();
  const auto cells = convex_cells(solid, budget);
  EXPECT_TRUE(cells && cells->size() == 1);
  return cells->front();
}

Solid moved(Solid solid, const math::Pose& X) {
  for (Vec3& p : solid.points) p = X * p;
  return solid;
}

TEST(SolidCut, WhatIsInsideAndWhatIsOutsideMakeTheWhole) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> at(-1.5, 1.5);
  std::uniform_real_distribution<double> size(0.2, 2);
  int shifted = 0;
  for (int round = 0; round < 400; ++round) {
    Solid body = box({-1, -1, -1}, {1, 1, 1});
    double volume = 8;
    // Several cuts, one after the other: turned boxes, and such as lie along the body's own sides.
    for (int k = 0; k < 4; ++k) {
      const Vec3 low(at(random), at(random), at(random));
      Solid tool = box(low, low + Vec3(size(random), size(random), size(random)));
      if (round % 2 == 0) {
        tool = moved(
            tool, math::rotation_z_deg(100 * at(random)) * math::rotation_x_deg(100 * at(random)));
      } else {
        // On a grid: faces of tools and body fall together.
        for (Vec3& p : tool.points) p = (p * 2).array().round() / 2;
        if (!(volume_of(tool) > 0.01)) continue;
      }
      WorkBudget budget = plenty();
      const Cell cell = cell_of(tool);
      const auto inside = intersect(body, cell, budget);
      const auto outside = subtract(body, cell, budget);
      ASSERT_TRUE(inside && outside) << round << " " << k;
      const double taken = volume_of(*inside);
      EXPECT_GE(taken, -1e-12);
      // Now and then the planes had to be moved.
      const double error = std::fabs(volume_of(*outside) - (volume - taken));
      EXPECT_LT(error, 40 * kShift) << round << " " << k;
      if (error > 1e-9) ++shifted;
      if (!inside->triangles.empty()) {
        EXPECT_TRUE(is_closed(*inside));
      }
      if (outside->triangles.empty()) break;
      EXPECT_TRUE(is_closed(*outside));
      body = *outside;
      volume = volume_of(body);
    }
  }
  EXPECT_LE(shifted, 4);
}

TEST(SolidCut, FacesThatNearlyFallTogetherDoNoHarm) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> noise(-5e-6, 5e-6);
  int failed = 0;
  for (int round = 0; round < 400; ++round) {
    Solid body = box({0, 0, 0}, {4, 0.2, 3});
    double volume = 2.4;
    for (const double x : {0.0, 1.0, 1.5, 3.0}) {
      Solid tool = box({x, 0, 1}, {x + 1, 0.2, 2});
      const Vec3 shift(noise(random), noise(random), noise(random));
      for (Vec3& p : tool.points) p += shift;
      tool = moved(tool, math::rotation_z_deg(10 * noise(random)));
      WorkBudget budget = plenty();
      const auto outside = subtract(body, cell_of(tool), budget);
      if (!outside) {
        ++failed;
        continue;
      }
      EXPECT_TRUE(is_closed(*outside));
      EXPECT_LT(volume_of(*outside), volume + 1e-6);
      body = *outside;
      volume = volume_of(body);
    }
    EXPECT_NEAR(volume, 2.4 - 0.2 * 3.5, 5e-4);
  }
  EXPECT_EQ(failed, 0);
}

TEST(SolidCut, ABodyThatIsNotConvexBecomesCellsThatFillIt) {
  WorkBudget budget = plenty();
  const Region frame{{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}},
                     {{{1, 1, 0}, {2, 1, 0}, {2, 2, 0}}, {{3, 1, 0}, {3.5, 1, 0}, {3.2, 2, 0}}}};
  const auto body = extruded(frame, {0, 0, 2}, budget);
  ASSERT_TRUE(body);
  const auto cells = convex_cells(*body, budget);
  ASSERT_TRUE(cells);
  const Solid all = box({-1, -1, -1}, {5, 4, 3});
  double sum = 0;
  for (const Cell& cell : *cells) sum += volume_of(*intersect(all, cell, budget));
  EXPECT_NEAR(sum, volume_of(*body), 1e-9);
  EXPECT_NEAR(sum, (12 - 0.5 - 0.25) * 2, 1e-9);
}

TEST(SolidCut, WithoutWorkThereIsNoAnswer) {
  WorkBudget none(10);
  const Solid body = box({0, 0, 0}, {1, 1, 1});
  EXPECT_FALSE(subtract(body, cell_of(box({0, 0, 0}, {0.5, 0.5, 0.5})), none));
}

}  // namespace
}  // namespace rubicon::ifc
