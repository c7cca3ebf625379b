#include "src/motion/travel/outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/travel/travel_worlds.hpp"

namespace rubicon::travel {
namespace {

std::vector<double> loop_lengths(const Outline& outline) {
  std::vector<double> lengths;
  for (const Composite& composite : outline.composites()) {
    for (const Loop& loop : composite.loops) lengths.push_back(loop.length);
  }
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

std::vector<double> loop_lengths(const std::vector<Corners>& world) {
  return loop_lengths(Outline(pieces_of(world)));
}

/// What a walk needs: each edge has its follower, which goes back to it, and starts where it ends.
void expect_linked(const Outline& outline) {
  for (const Composite& composite : outline.composites()) {
    for (std::size_t i = 0; i < composite.edges.size(); ++i) {
      const Edge& edge = composite.edges[i];
      const Edge& next = composite.edges[static_cast<std::size_t>(edge.next)];
      ASSERT_EQ(next.from, edge.to);
      ASSERT_EQ(next.previous, static_cast<int>(i));
      ASSERT_EQ(next.loop, edge.loop);
      ASSERT_GT(edge.length, 0);
    }
  }
}

TEST(Outline, PerimetersOfUnions) {
  using Lengths = std::vector<double>;
  EXPECT_EQ(loop_lengths({box(-10, 0, 12, 10), box(0, 4, 10, 10)}), Lengths{68});
  // Touching in a corner, along a side, along half a side, one in the other, one twice.
  EXPECT_EQ(loop_lengths({box(0, 0, 10, 10), box(10, 10, 10, 10)}), Lengths{80});
  EXPECT_EQ(loop_lengths({box(0, 0, 10, 10), box(10, 0, 10, 10)}), Lengths{60});
  EXPECT_EQ(loop_lengths({box(0, 0, 10, 10), box(10, 5, 10, 10)}), Lengths{70});
  EXPECT_EQ(loop_lengths({box(0, 0, 10, 10), box(4, 4, 2, 2)}), Lengths{40});
  EXPECT_EQ(loop_lengths({box(0, 0, 10, 10), box(4, 0, 2, 2)}), Lengths{40});
  EXPECT_EQ(loop_lengths({box(0, 0, 10, 10), box(0, 0, 10, 10)}), Lengths{40});
  EXPECT_EQ(loop_lengths({box(0, 0, 10, 10), box(20, 0, 10, 10)}), (Lengths{40, 40}));
}

TEST(Outline, ARoomHasAHole) {
  const Outline outline(
      pieces_of({box(0, 0, 10, 2), box(8, 0, 2, 10), box(0, 8, 10, 2), box(0, 0, 2, 10)}));
  ASSERT_EQ(outline.composites().size(), 1u);
  const Composite& room = outline.composites()[0];
  ASSERT_EQ(room.loops.size(), 2u);
  for (const Loop& loop : room.loops) EXPECT_DOUBLE_EQ(loop.length, loop.hole ? 24 : 40);
  EXPECT_NE(room.loops[0].hole, room.loops[1].hole);
}

TEST(Outline, WhereObstaclesTouchNothingIsFree) {
  const Outline outline(pieces_of({box(0, 0, 10, 10), box(10, 0, 10, 10)}));
  EXPECT_EQ(outline.place_of(snap({10, 5})), 1);
  EXPECT_EQ(outline.place_of(snap({10, 10})), 0);
  EXPECT_EQ(outline.place_of(snap({0, 0})), 0);
  EXPECT_EQ(outline.place_of(snap({20, 3})), 0);
  EXPECT_EQ(outline.place_of(snap({-1, 0})), -1);
  EXPECT_EQ(outline.place_of(snap({30, 10})), -1);
}

TEST(Outline, ManyEdgesThroughOnePointHaveOneNode) {
  // Eight triangles whose long sides all cross in the origin.
  std::vector<Corners> world;
  for (int i = 0; i < 8; ++i) {
    const Vec2 tip(i - 3.5, 7);
    world.push_back({-tip, tip, {tip.x() + 0.25, 7}});
  }
  const Outline outline(pieces_of(world));
  expect_linked(outline);
  int at_origin = 0;
  for (const ExactPoint& node : outline.composites()[0].nodes) {
    at_origin += node.p.norm() < 1e-9 ? 1 : 0;
  }
  EXPECT_EQ(at_origin, 1);
}

TEST(Outline, RandomWorldsLinkAndKnowWhereSpaceIsFree) {
  TestRandom random(11);
  for (int i = 0; i < cases(150); ++i) {
    const auto kind = static_cast<WorldKind>(i % 4);
    const auto world = random_world(random, kind, random.whole(2, 14), 15);
    const Outline outline(pieces_of(world));
    expect_linked(outline);
    // Just beside the middle of each edge: free on the left, covered on the right.
    for (const Composite& composite : outline.composites()) {
      for (const Edge& edge : composite.edges) {
        if (edge.length < 1e-3) continue;
        const Vec2 middle = (composite.nodes[static_cast<std::size_t>(edge.from)].p +
                             composite.nodes[static_cast<std::size_t>(edge.to)].p) /
                            2;
        const Vec2 left(-edge.heading.y(), edge.heading.x());
        EXPECT_TRUE(outline.covers(nearby(middle - 1e-6 * left)));
        EXPECT_FALSE(outline.covers(nearby(middle + 1e-6 * left)));
      }
    }
  }
}

TEST(Outline, AChangeGivesWhatBuildingAnewGives) {
  TestRandom random(12);
  for (int i = 0; i < cases(60); ++i) {
    const auto kind = static_cast<WorldKind>(i % 4);
    auto world = random_world(random, kind, random.whole(3, 12), 15);
    Outline outline(pieces_of(world));
    for (int change = 0; change < 4; ++change) {
      std::vector<Outline::Change> changes;
      for (int moved = random.whole(1, 2); moved > 0; --moved) {
        const auto which = static_cast<std::size_t>(random.whole(0, 2));
        const Vec2 by(random.whole(-9, 9), random.whole(-9, 9));
        for (Vec2& corner : world[which]) corner += by;
        changes.push_back({static_cast<int>(which), ring_of(world[which])});
      }
      outline.replace(changes);
      expect_linked(outline);
      const std::vector<double> kept = loop_lengths(outline);
      const std::vector<double> anew = loop_lengths(world);
      ASSERT_EQ(kept.size(), anew.size());
      for (std::size_t k = 0; k < kept.size(); ++k) EXPECT_NEAR(kept[k], anew[k], 1e-9);
    }
  }
}

TEST(Outline, OnlyWhatAMoveTouchesIsBuiltAnew) {
  std::vector<Corners> world;
  for (int y = 0; y < 100; y += 10) {
    for (int x = 0; x < 100; x += 10) world.push_back(box(x, y, 4, 4));
  }
  Outline outline(pieces_of(world));
  EXPECT_EQ(outline.work().built, 100);
  EXPECT_EQ(outline.work().pairs, 0);
  const std::uint64_t far = outline.composites()[99].version;
  outline.replace(std::vector<Outline::Change>{{0, ring_of(box(7, 2, 4, 4))}});
  EXPECT_EQ(outline.work().built, 101);  // it and the box that it touches now are one
  EXPECT_EQ(outline.work().pairs, 1);
  EXPECT_EQ(outline.composites()[99].version, far);
  EXPECT_EQ(outline.composite_of(0), outline.composite_of(1));
  outline.replace(std::vector<Outline::Change>{{0, ring_of(box(0, 0, 4, 4))}});
  EXPECT_NE(outline.composite_of(0), outline.composite_of(1));
}

}  // namespace
}  // namespace rubicon::travel
