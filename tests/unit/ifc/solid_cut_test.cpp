#include "src/exchange/ifc/solid_cut.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "src/exchange/ifc/shape_reader.hpp"
#include "src/exchange/ifc/swept_solids.hpp"
#include "src/motion/math/angles.hpp"

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

/// Upright, with `sides` corners on a circle.
Solid column(int sides, double radius, const Vec3& foot, double height) {
  Region region;
  for (int i = 0; i < sides; ++i) {
    const double t = 360.0 * i / sides;
    region.outline.push_back(foot + radius * Vec3(math::cos_deg(t), math::sin_deg(t), 0));
  }
  WorkBudget budget = plenty();
  return *extruded(region, {0, 0, height}, budget);
}

double column_volume(int sides, double radius, double height) {
  return height * sides * radius * radius * math::sin_deg(360.0 / sides) / 2;
}

/// Faces along parallels and meridians.
Solid globe(int sides, double radius, const Vec3& middle) {
  Solid solid;
  const int rings = sides / 2;
  const auto at = [&](int ring, int k) { return 1 + (ring - 1) * sides + k % sides; };
  solid.points.push_back(middle - Vec3(0, 0, radius));
  for (int ring = 1; ring < rings; ++ring) {
    const double b = 180.0 * ring / rings - 90;
    for (int k = 0; k < sides; ++k) {
      const double l = 360.0 * k / sides;
      solid.points.push_back(middle + radius * Vec3(math::cos_deg(b) * math::cos_deg(l),
                                                    math::cos_deg(b) * math::sin_deg(l),
                                                    math::sin_deg(b)));
    }
  }
  solid.points.push_back(middle + Vec3(0, 0, radius));
  const int top = static_cast<int>(solid.points.size()) - 1;
  for (int k = 0; k < sides; ++k) {
    solid.triangles.push_back({0, at(1, k + 1), at(1, k)});
    solid.triangles.push_back({top, at(rings - 1, k), at(rings - 1, k + 1)});
    for (int ring = 1; ring + 1 < rings; ++ring) {
      solid.triangles.push_back({at(ring, k), at(ring, k + 1), at(ring + 1, k + 1)});
      solid.triangles.push_back({at(ring, k), at(ring + 1, k + 1), at(ring + 1, k)});
    }
  }
  return solid;
}

/// How often a surface winds about a point: its solid angle (van Oosterom and Strackee 1983).
double winding(const Solid& solid, const Vec3& p) {
  double sum = 0;
  for (const auto& t : solid.triangles) {
    const Vec3 a = solid.points[static_cast<std::size_t>(t[0])] - p;
    const Vec3 b = solid.points[static_cast<std::size_t>(t[1])] - p;
    const Vec3 c = solid.points[static_cast<std::size_t>(t[2])] - p;
    sum += 2 * std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                                 b.dot(c) * a.norm() + c.dot(a) * b.norm());
  }
  return sum / (4 * 3.14159265358979323846);
}

BodyCut cut_of(const Solid& tool) {
  WorkBudget budget = plenty();
  Bodies bodies;
  bodies.solids = {tool};
  const auto cells = cells_of(bodies, budget);
  EXPECT_TRUE(cells);
  return {cells.value_or(std::vector<Cell>()), "an opening"};
}

TEST(SolidCut, RoundHolesAsDeepAsTheirBlockLeaveFewTriangles) {
  for (int sides = 12; sides <= 40; ++sides) {
    SCOPED_TRACE(sides);
    WorkBudget budget(1'000'000);
    const auto rest =
        subtract(box({-1, -2, 0}, {1, 2, 3}), cell_of(column(sides, 0.3, {0, 1.5, 0}, 3)), budget);
    ASSERT_TRUE(rest);
    EXPECT_TRUE(is_closed(*rest));
    EXPECT_NEAR(volume_of(*rest), 24 - column_volume(sides, 0.3, 3), 1e-9);
    // Top and bottom: two corners more than the outline's and the hole's; eight and two for sides.
    EXPECT_EQ(rest->triangles.size(), static_cast<std::size_t>(2 * (sides + 4) + 8 + 2 * sides));
  }
}

TEST(SolidCut, ManyRoundHolesInASlabTakeLittleWork) {
  Bodies slab;
  slab.solids = {box({0, 0, 0}, {30, 20, 0.25})};
  std::vector<BodyCut> cuts;
  for (int i = 0; i < 60; ++i) {
    cuts.push_back(cut_of(column(36, 0.1, {1 + 2.0 * (i % 15), 2 + 4.0 * (i / 15), -0.1}, 0.45)));
  }
  WorkBudget budget(40'000'000);
  cut_bodies(slab, cuts, budget);
  EXPECT_TRUE(slab.notes.empty());
  ASSERT_EQ(slab.solids.size(), 1U);
  EXPECT_TRUE(is_closed(slab.solids[0]));
  EXPECT_NEAR(volume_of(slab.solids[0]), 150 - 60 * column_volume(36, 0.1, 0.25), 1e-8);
  EXPECT_LT(budget.used(), 10'000'000U);
}

TEST(SolidCut, ARingCutInCellsLeavesOnlyItsOwnFaces) {
  WorkBudget budget = plenty();
  Region ring;
  ring.holes.emplace_back();
  for (int i = 0; i < 36; ++i) {
    const Vec3 way(math::cos_deg(10 * i), math::sin_deg(10 * i), 0);
    ring.outline.push_back(1.25 * way + Vec3(0, 0, 1));
    ring.holes[0].push_back(0.75 * way + Vec3(0, 0, 1));
  }
  std::reverse(ring.holes[0].begin(), ring.holes[0].end());
  Bodies block;
  block.solids = {box({-2, -2, 0}, {2, 2, 3})};
  cut_bodies(block, {cut_of(*extruded(ring, {0, 0, 1}, budget))}, budget);
  EXPECT_TRUE(block.notes.empty());
  ASSERT_EQ(block.solids.size(), 1U);
  EXPECT_NEAR(volume_of(block.solids[0]),
              48 - column_volume(36, 1.25, 1) + column_volume(36, 0.75, 1), 1e-9);
  EXPECT_EQ(block.solids[0].triangles.size(), 12U + 4 * 72);
}

TEST(SolidCut, PointsAreInsideWhereTheBodyIsAndNoCutIs) {
  std::mt19937 random(9);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int inside = 0;
  int taken = 0;
  for (int round = 0; round < 120; ++round) {
    SCOPED_TRACE(round);
    Bodies bodies;
    bodies.solids = {round % 3 == 0 ? column(20, 1.8, {0, 0, 0}, 1)
                                    : box({-2, -1.5, 0}, {2, 1.5, 1})};
    const Solid whole = bodies.solids[0];
    std::vector<BodyCut> cuts;
    std::vector<Solid> tools;
    const auto count = random() % 6 + 1;
    for (unsigned k = 0; k < count; ++k) {
      // Right through, flush, blind; on a grid in every other round, so that they touch.
      Vec3 foot(0, 0, std::array{-0.1, 0.0, 0.3}[random() % 3]);
      foot.x() = uniform(-2.2, 2.2);
      foot.y() = uniform(-1.7, 1.7);
      if (round % 2 == 0) foot = (foot * 4).array().round() / 4;
      const double height = std::array{1.2, 1.0, 0.5}[random() % 3];
      const int sides = 3 + static_cast<int>(random() % 30);
      const double radius = uniform(0.1, 0.6);
      const auto kind = random() % 5;
      Solid tool = kind == 0   ? globe(12, radius, foot)
                   : kind == 1 ? box(foot, foot + Vec3(0.75, 0.5, height))
                               : column(sides, radius, foot, height);
      if (kind == 4) {
        Region angle;
        for (const auto& [x, y] :
             {std::pair(0.0, 0.0), {1.0, 0.0}, {1.0, 0.5}, {0.5, 0.5}, {0.5, 1.0}, {0.0, 1.0}}) {
          angle.outline.push_back(foot + Vec3(x, y, 0));
        }
        WorkBudget some = plenty();
        tool = *extruded(angle, {0, 0, height}, some);
      }
      if (kind == 3) tool = moved(tool, math::rotation_x_deg(uniform(-40, 40)));
      cuts.push_back(cut_of(tool));
      tools.push_back(tool);
    }
    WorkBudget budget = plenty();
    cut_bodies(bodies, cuts, budget);
    EXPECT_TRUE(bodies.notes.empty());
    Solid rest;
    if (!bodies.solids.empty()) {
      rest = bodies.solids[0];
      EXPECT_TRUE(is_closed(rest));
    }
    for (int n = 0; n < 40; ++n) {
      Vec3 p;
      p.x() = uniform(-2, 2);
      p.y() = uniform(-1.5, 1.5);
      p.z() = uniform(0, 1);
      double near = 1;
      for (const BodyCut& cut : cuts) {
        for (const Cell& cell : cut.cells) {
          double most = -1;
          for (const HalfSpace& plane : cell) most = std::max(most, plane.n.dot(p) - plane.w);
          near = std::min(near, std::fabs(most));
        }
      }
      if (near < 2 * kShift) continue;
      const bool is_cut = std::any_of(tools.begin(), tools.end(),
                                      [&](const Solid& tool) { return winding(tool, p) > 0.5; });
      const bool was_inside = winding(whole, p) > 0.5;
      ASSERT_NEAR(winding(rest, p), was_inside && !is_cut ? 1 : 0, 1e-3);
      if (was_inside) ++(is_cut ? taken : inside);
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(taken, 150);
}

TEST(SolidCut, CutsThatTakeMoreThanTheirShareAreLeftOutAndTheOthersStay) {
  const auto cut_with = [&](std::uint64_t steps) {
    Bodies bodies;
    bodies.solids = {box({0, 0, 0}, {10, 2, 2})};
    std::vector<BodyCut> cuts;
    for (int i = 0; i < 9; ++i) cuts.push_back(cut_of(globe(24, 0.4, {1.0 + i, 1, 1})));
    WorkBudget budget(steps);
    cut_bodies(bodies, cuts, budget);
    EXPECT_FALSE(budget.is_spent());
    EXPECT_EQ(bodies.solids.size(), 1U);
    EXPECT_TRUE(is_closed(bodies.solids[0]));
    const double each = volume_of(globe(24, 0.4, {0, 0, 0}));
    EXPECT_NEAR(volume_of(bodies.solids[0]),
                40 - each * (9 - static_cast<double>(bodies.notes.size())), 1e-9);
    return bodies.notes.size();
  };
  EXPECT_EQ(cut_with(100'000'000), 0U);
  const std::size_t some = cut_with(8'000'000);
  EXPECT_GT(some, 0U);
  EXPECT_LT(some, 9U);
  EXPECT_EQ(cut_with(1'000), 9U);
}

TEST(SolidCut, WithoutWorkThereIsNoAnswer) {
  WorkBudget none(10);
  const Solid body = box({0, 0, 0}, {1, 1, 1});
  EXPECT_FALSE(subtract(body, cell_of(box({0, 0, 0}, {0.5, 0.5, 0.5})), none));
}

TEST(SolidCut, WhatLiesTooFarOutIsNotCut) {
  for (const double far : {1e13, 1e160, 1e300}) {
    WorkBudget budget = plenty();
    const Solid body = box({0, 0, 0}, {1, 1, 1});
    Solid distant = body;
    for (Vec3& p : distant.points) p *= far;
    EXPECT_FALSE(convex_cells(distant, budget));
    EXPECT_FALSE(subtract(distant, cell_of(body), budget));
    EXPECT_FALSE(intersect(distant, cell_of(body), budget));
  }
}

}  // namespace
}  // namespace rubicon::ifc
