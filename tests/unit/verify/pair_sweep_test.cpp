#include "src/results/verify/geometry/pair_sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/verify/random.hpp"

namespace rubicon::verify {
namespace {

constexpr double kTolerance = 1e-3;

Solid solid_of(const std::vector<Convex>& pieces) {
  Solid solid;
  solid.pieces = pieces;
  std::vector<Bounds> boxes;
  for (const Convex& piece : pieces) {
    boxes.push_back(bounds_of(piece));
    solid.bounds.add(boxes.back());
    solid.inner_points.push_back({piece.centre(), piece.width});
  }
  solid.tree = BoxTree(boxes);
  solid.centre = solid.bounds.centre();
  solid.radius = (solid.bounds.upper - solid.centre).norm();
  return solid;
}

/// A turn about an axis and a slide, from X0.
class Screw : public PartMotion {
 public:
  Screw(const Solid& solid, const Pose& X0, const Vec3& axis, const Vec3& point, double angle_deg,
        const Vec3& slide)
      : solid_(solid), X0_(X0), axis_(axis), point_(point), angle_deg_(angle_deg), slide_(slide) {}

  Pose pose(double u) const {
    Pose X = Pose::Identity();
    X.linear() = math::rotation_about_deg(axis_, u * angle_deg_);
    X.translation() = point_ - X.linear() * point_ + u * slide_;
    return X * X0_;
  }
  PartState state(double u0, double u1) const override {
    const double half = (u1 - u0) / 2;
    PartState state;
    state.X_WS = pose(u0 + half);
    const Vec3 arm = state.X_WS * solid_.centre - point_;
    state.reach.rest = half * (math::radians(std::fabs(angle_deg_)) *
                                   (arm.norm() + half * slide_.norm() + solid_.radius) +
                               slide_.norm());
    return state;
  }

 private:
  const Solid& solid_;
  Pose X0_;
  Vec3 axis_;
  Vec3 point_;
  double angle_deg_;
  Vec3 slide_;
};

Screw sliding(const Solid& solid, const Pose& X0, const Vec3& slide) {
  return {solid, X0, Vec3::UnitZ(), Vec3::Zero(), 0, slide};
}

TEST(PairSweep, NothingThinIsJumpedOver) {
  for (const double thickness : {0.2, 0.02, 2e-3, 5e-4, 5e-5}) {
    const Solid wall = solid_of({box_piece({-thickness / 2, -1, -1}, {thickness / 2, 1, 1})});
    const Solid plate =
        solid_of({box_piece({-thickness / 2, -0.1, -0.1}, {thickness / 2, 0.1, 0.1})});
    const Screw through = sliding(plate, math::translation(-3, 0, 0), {5, 0, 0});
    EXPECT_TRUE(PairSweep(plate, through, wall, StandingPart(Pose::Identity()), kTolerance).run())
        << thickness;
    const Screw past = sliding(plate, math::translation(-3, 1.11, 0), {5, 0, 0});
    EXPECT_FALSE(PairSweep(plate, past, wall, StandingPart(Pose::Identity()), kTolerance).run())
        << thickness;
  }
}

TEST(PairSweep, ResidesSlidesAndTurnsOnASlab) {
  const Solid slab = solid_of({box_piece({-9, -9, -1}, {9, 9, 0})});
  const Solid box = solid_of({box_piece({-1, -1, 0}, {1, 1, 1})});
  const StandingPart stands(Pose::Identity());
  for (const double z : {0.0, 1e-4, -1e-3, -1.2e-3}) {
    const Pose X0 = math::translation(0, 0, z);
    EXPECT_FALSE(PairSweep(box, sliding(box, X0, {3, 2, 0}), slab, stands, kTolerance).run()) << z;
    const Screw turn(box, X0, Vec3::UnitZ(), Vec3(4, 0, 0), 30, Vec3::Zero());
    EXPECT_FALSE(PairSweep(box, turn, slab, stands, kTolerance).run()) << z;
  }
  const Screw tilting(box, Pose::Identity(), Vec3::UnitY(), Vec3(0, 0, 0), 0.1, Vec3::Zero());
  EXPECT_TRUE(PairSweep(box, tilting, slab, stands, kTolerance).run());
}

/// The depth of two sets of pieces at a pose, as far as sampled directions and the axes tell.
double pose_depth(const Solid& a, const Pose& X_BA, const Solid& b) {
  double deepest = -1e300;
  for (const Convex& piece_a : a.pieces) {
    for (const Convex& piece_b : b.pieces) {
      // Bisection on the limit of the test itself would trust it; here only its axes are used.
      double least = 1e300;
      const auto add = [&](const Vec3& n) {
        for (const double sign : {1.0, -1.0}) {
          const Vec3 m = sign * n;
          least = std::min(
              least,
              (X_BA * piece_a.support(X_BA.linear().transpose() * m) - piece_b.support(-m)).dot(m));
        }
      };
      for (const Vec3& n : piece_b.normals) add(n);
      for (const Vec3& n : piece_a.normals) add(X_BA.linear() * n);
      for (const Vec3& e : piece_a.edges) {
        for (const Vec3& f : piece_b.edges) {
          const Vec3 n = (X_BA.linear() * e).cross(f);
          if (n.norm() > 1e-9) add(n.normalized());
        }
      }
      deepest = std::max(deepest, least);
    }
  }
  return deepest;
}

TEST(PairSweep, AgreesWithDenseSamples) {
  Random random(7);
  int hits = 0, misses = 0;
  for (int round = 0; round < 400; ++round) {
    std::vector<Convex> pieces_a, pieces_b;
    for (int i = random.whole(0, 2); i >= 0; --i) {
      pieces_a.push_back(placed(random_piece(random, false), random.pose(0.5)));
    }
    for (int i = random.whole(0, 2); i >= 0; --i) {
      pieces_b.push_back(placed(random_piece(random, false), random.pose(0.5)));
    }
    const bool thick = std::all_of(pieces_a.begin(), pieces_a.end(),
                                   [](const Convex& each) { return each.width > 8e-3; }) &&
                       std::all_of(pieces_b.begin(), pieces_b.end(),
                                   [](const Convex& each) { return each.width > 8e-3; });
    if (!thick) continue;
    const Solid a = solid_of(pieces_a);
    const Solid b = solid_of(pieces_b);
    const Screw motion_a(a, random.pose(1.5), random.direction(), random.point(2),
                         random.real(-40, 40), random.point(0.5));
    const Screw motion_b(b, random.pose(1.5), random.direction(), random.point(2),
                         random.real(-40, 40), random.point(0.5));
    const bool found = PairSweep(a, motion_a, b, motion_b, kTolerance).run().has_value();
    double deepest = -1e300;
    constexpr int kSamples = 500;
    for (int i = 0; i <= kSamples; ++i) {
      const double u = static_cast<double>(i) / kSamples;
      deepest = std::max(deepest, pose_depth(a, motion_b.pose(u).inverse() * motion_a.pose(u), b));
    }
    if (deepest > kTolerance + kBand) {
      EXPECT_TRUE(found) << round << ' ' << deepest;
    }
    // Between two samples it may get a little deeper than at both.
    if (deepest < kTolerance - 8e-3) {
      EXPECT_FALSE(found) << round << ' ' << deepest;
    }
    (found ? hits : misses) += 1;
  }
  EXPECT_GT(hits, 30);
  EXPECT_GT(misses, 30);
}

MeshData mesh_box(const Vec3& lower, const Vec3& upper, bool inwards = false) {
  MeshData mesh;
  mesh.closed = true;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back((i & 1) != 0 ? upper.x() : lower.x(),
                               (i & 2) != 0 ? upper.y() : lower.y(),
                               (i & 4) != 0 ? upper.z() : lower.z());
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  if (inwards) {
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

MeshData joined(MeshData a, const MeshData& b) {
  const int offset = static_cast<int>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& [i, j, k] : b.triangles)
    a.triangles.push_back({i + offset, j + offset, k + offset});
  return a;
}

ShapeData mesh_shape() {
  ShapeData shape;
  shape.kind = ShapeData::Kind::mesh;
  shape.mesh = 0;
  return shape;
}

TEST(PairSweep, WhatIsInsideAClosedMeshIsFound) {
  const std::vector<MeshData> meshes = {
      joined(mesh_box({-5, -5, -5}, {5, 5, 5}), mesh_box({-1, -1, -1}, {1, 1, 1}, true))};
  const auto hollow = make_solid({mesh_shape()}, meshes);
  const Solid ball = solid_of({capsule_piece({0, 0, 0}, {0, 0, 0}, 0.3)});
  const StandingPart stands(Pose::Identity());
  const auto meets = [&](const Vec3& from, const Vec3& slide) {
    const Pose X0 = math::translation(from.x(), from.y(), from.z());
    return PairSweep(ball, sliding(ball, X0, slide), *hollow, stands, kTolerance).run().has_value();
  };
  EXPECT_TRUE(meets({3, 0, 0}, {0.1, 0, 0}));   // in the wall of the hollow
  EXPECT_FALSE(meets({0, 0, 0}, {0.6, 0, 0}));  // in the cavity
  EXPECT_TRUE(meets({0, 0, 0}, {1.2, 0, 0}));   // out of the cavity
  EXPECT_FALSE(meets({7, 0, 0}, {0, 3, 0}));    // outside
  EXPECT_TRUE(meets({7, 0, 0}, {-14, 0, 0}));   // through all of it
}

TEST(PairSweep, EqualMeshesAtOnePlaceAreFound) {
  // Not convex, so that surfaces are what is tested, and all of them lie in each other.
  MeshData angle;
  angle.closed = true;
  const std::vector<Eigen::Vector2d> outline = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (const double z : {0.0, 1.0}) {
    for (const auto& p : outline) angle.vertices.emplace_back(p.x(), p.y(), z);
  }
  for (int i = 0; i < 6; ++i) {
    const int j = (i + 1) % 6;
    angle.triangles.push_back({i, j, j + 6});
    angle.triangles.push_back({i, j + 6, i + 6});
  }
  for (const auto& [a, b, c] : {std::array{0, 1, 3}, {1, 2, 3}, {0, 3, 5}, {3, 4, 5}}) {
    angle.triangles.push_back({c, b, a});
    angle.triangles.push_back({a + 6, b + 6, c + 6});
  }
  const auto solid = make_solid({mesh_shape()}, {angle});
  ASSERT_EQ(solid->surfaces.size(), 1u);
  const StandingPart stands(Pose::Identity());
  EXPECT_TRUE(PairSweep(*solid, stands, *solid, stands, kTolerance).run());
  EXPECT_TRUE(
      PairSweep(*solid, StandingPart(math::translation(0, 0, 0.5)), *solid, stands, kTolerance)
          .run());
  EXPECT_FALSE(
      PairSweep(*solid, StandingPart(math::translation(0, 0, 1)), *solid, stands, kTolerance)
          .run());
  EXPECT_FALSE(
      PairSweep(*solid, StandingPart(math::translation(1, 1, 0)), *solid, stands, kTolerance)
          .run());
}

TEST(PairSweep, ConvexPartsOfMeshesAreSolid) {
  const auto solid = make_solid(
      {mesh_shape()}, {joined(mesh_box({0, 0, 0}, {1, 1, 1}), mesh_box({3, 0, 0}, {4, 1, 1}))});
  EXPECT_EQ(solid->pieces.size(), 2u);
  EXPECT_TRUE(solid->surfaces.empty());
  EXPECT_EQ(solid->pieces[0].normals.size(), 3u);
  EXPECT_EQ(solid->pieces[0].edges.size(), 3u);
}

}  // namespace
}  // namespace rubicon::verify
