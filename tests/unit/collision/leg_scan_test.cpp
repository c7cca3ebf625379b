#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "src/motion/collision/leg_query.hpp"
#include "tests/support/random_cases.hpp"
#include "tests/unit/collision/bodies.hpp"
#include "tests/unit/collision/two_joint_motion.hpp"

namespace rubicon::collision::test {
namespace {

using geometry::ScrewMotion;
using rubicon::test::at_least;
using rubicon::test::cases;

/// The piece of a screw between two shares of it.
Motion piece(const ScrewMotion& screw, double from, double to) {
  ScrewMotion part = screw;
  part.X0 = Motion{screw}.pose(from);
  part.angle_deg *= to - from;
  part.slide *= to - from;
  return Motion{part};
}

/// Two bodies on screws, which may not meet each other nor what stands.
class TwoScrews : public LegMotion {
 public:
  TwoScrews(const CollisionWorld& world, std::array<BodyPtr, 2> bodies,
            std::array<ScrewMotion, 2> screws)
      : world_(world), bodies_(std::move(bodies)), screws_(std::move(screws)) {}

  void frames(const double (&shares)[math::kLanes], math::LaneFrame* X_WF) const override {
    for (int i : {0, 1}) {
      const ScrewMotion& screw = screws_[static_cast<std::size_t>(i)];
      for (int lane = 0; lane < math::kLanes; ++lane) {
        const Pose X = Motion{screw}.pose(shares[lane]);
        const Vec3 w = math::radians(screw.angle_deg) * screw.axis;
        const Vec3 v = w.cross(X.translation() - screw.point) + screw.slide;
        for (int row = 0; row < 3; ++row) {
          for (int col = 0; col < 3; ++col) X_WF[i].R[row][col].v[lane] = X.linear()(row, col);
          X_WF[i].t[row].v[lane] = X.translation()[row];
          X_WF[i].v[row].v[lane] = v[row];
          X_WF[i].w[row].v[lane] = w[row];
        }
      }
    }
  }
  bool is_free(double from, double to) const override {
    SweptQuery query;
    for (int i : {0, 1}) query.items.push_back(item(*bodies_[i], piece(screws_[i], from, to)));
    query.pairs = {{0, 1}};
    return !world_.test(query).hit;
  }
  LegQuery::Acceleration acceleration(int i) const {
    const ScrewMotion& screw = screws_[static_cast<std::size_t>(i)];
    const double turning = math::radians(std::fabs(screw.angle_deg));
    const double radius = screw.axis.cross(screw.X0.translation() - screw.point).norm();
    return {turning * turning * radius, turning * turning};
  }
  std::pair<LegQuery::Acceleration, LegQuery::Acceleration> seen_from_base(
      const LegQuery::Pair&) const override {
    return {acceleration(0), acceleration(1)};
  }
  LegQuery query(bool whole) const {
    LegQuery query;
    query.whole = whole;
    query.least = 1e-2;
    query.frames = 2;
    for (int i : {0, 1}) {
      const ScrewMotion& screw = screws_[i];
      const bool moves = screw.angle_deg != 0 || screw.slide.norm() > 0;
      query.items.push_back({bodies_[i].get(), i, moves, acceleration(i)});
    }
    query.pairs = {{0, 1, -1}};
    return query;
  }

 private:
  const CollisionWorld& world_;
  std::array<BodyPtr, 2> bodies_;
  std::array<ScrewMotion, 2> screws_;
};

ScrewMotion random_screw(Random& random, double size) {
  ScrewMotion screw;
  screw.X0 = random.pose(size);
  screw.axis = random.direction();
  screw.point = random.vector(size);
  screw.angle_deg = random.below(4) == 0 ? 0 : random.between(-120, 120);
  screw.slide = screw.axis * random.between(-2, 2);
  return screw;
}

TEST(LegScan, SaysOfALegWhatTheTestOfItsPartsSays) {
  int free = 0;
  int met = 0;
  int open = 0;
  for (int seed = 1; seed <= cases(600); ++seed) {
    Random random(static_cast<unsigned>(seed));
    const std::vector<BodyPtr> kinds = site_bodies();
    const auto body = [&] { return kinds[random.below(static_cast<int>(kinds.size()))]; };
    CollisionWorld world;
    const double size = 3;
    const int count = random.below(8);
    for (int i = 0; i < count; ++i) world.insert(body(), random.pose(size));
    const BodyPtr first = body();
    const BodyPtr second = body();
    const ScrewMotion screw = random_screw(random, size);
    const TwoScrews leg(world, {first, second}, {screw, random_screw(random, size)});
    for (const bool whole : {false, true}) {
      const LegAnswer answer = world.look_along(leg.query(whole), leg);
      SCOPED_TRACE(testing::Message() << "seed " << seed << " free until " << answer.free_until
                                      << " met from " << answer.met_from);
      EXPECT_LT(answer.free_until, answer.met_from);
      if (answer.free_until > 0) {
        ++free;
        EXPECT_TRUE(leg.is_free(0, answer.free_until));
      }
      if (answer.met_from <= 1) {
        ++met;
        EXPECT_FALSE(leg.is_free(0, answer.met_from));
      }
      const bool is_open = whole ? answer.free_until < 1 && answer.met_from > 1
                                 : answer.free_until == 0 && answer.met_from > 1;
      if (is_open) ++open;
    }
  }
  // All kinds of answers were given.
  EXPECT_GT(free, at_least(200));
  EXPECT_GT(met, at_least(150));
  EXPECT_LT(open, 400);
}

TEST(LegScan, SaysTheSameWithAllKernels) {
  const std::vector<BodyPtr> kinds = site_bodies();
  Random random(7);
  const auto body = [&] { return kinds[random.below(static_cast<int>(kinds.size()))]; };
  int met = 0;
  for (int i = 0; i < 200; ++i) {
    CollisionWorld world;
    for (int k = 0; k < 6; ++k) world.insert(body(), random.pose(3));
    const ScrewMotion screw = random_screw(random, 3);
    const TwoScrews leg(world, {body(), body()}, {screw, random_screw(random, 3)});
    use_simd(Simd::kBaseline);
    const LegAnswer plain = world.look_along(leg.query(false), leg);
    use_simd(Simd::kAvx2);
    const LegAnswer wide = world.look_along(leg.query(false), leg);
    EXPECT_EQ(plain.free_until, wide.free_until);
    EXPECT_EQ(plain.met_from, wide.met_from);
    met += wide.met_from <= 1;
  }
  EXPECT_GT(met, 20);
}

TEST(LegScan, NamesWhatIsMet) {
  CollisionWorld world;
  const BodyPtr cube = box(Vec3::Constant(0.5));
  world.insert(cube, at(0, 9, 0));
  const ObstacleId wall = world.insert(cube, at(4, 0, 0));
  ScrewMotion ahead;
  ahead.slide = Vec3(8, 0, 0);
  ScrewMotion beside;
  beside.X0 = at(0, 5, 0);
  const TwoScrews leg(world, {cube, cube}, {ahead, beside});
  const LegAnswer answer = world.look_along(leg.query(false), leg);
  ASSERT_TRUE(answer.hit.has_value());
  EXPECT_EQ(answer.hit->item, 0);
  EXPECT_EQ(answer.hit->obstacle, wall);
  // It touches the wall after 3 m of 8: a quarter of the way is the longest part that is free.
  EXPECT_GE(answer.free_until, 0.25);
  EXPECT_LT(answer.free_until, 0.375 + 1e-3);
  EXPECT_LE(answer.met_from, 0.5);

  // The other one comes the other way, nearer than the wall.
  beside.X0 = at(2.5, 0, 0);
  beside.slide = Vec3(-2, 0, 0);
  const TwoScrews both(world, {cube, cube}, {ahead, beside});
  const LegAnswer against = world.look_along(both.query(false), both);
  ASSERT_TRUE(against.hit.has_value());
  EXPECT_EQ(against.hit->other_item, 1);
  EXPECT_LE(against.free_until, 0.15 + 1e-3);
}

TEST(LegScan, ABodyThatStandsMeetsNothing) {
  CollisionWorld world;
  const BodyPtr cube = box(Vec3::Constant(0.5));
  world.insert(cube, Pose::Identity());
  ScrewMotion still;
  ScrewMotion moving;
  moving.X0 = at(5, 0, 0);
  moving.slide = Vec3(1, 0, 0);
  const TwoScrews leg(world, {cube, cube}, {still, moving});
  const LegAnswer answer = world.look_along(leg.query(true), leg);
  EXPECT_EQ(answer.free_until, 1);
  EXPECT_FALSE(answer.hit.has_value());
}

}  // namespace
}  // namespace rubicon::collision::test
