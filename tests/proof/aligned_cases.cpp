#include <fmt/format.h>

#include <cmath>

#include "src/motion/collision/sweep/body.hpp"
#include "tests/proof/generators.hpp"
#include "tests/proof/grid_mesh.hpp"
#include "tests/unit/collision/meshes.hpp"

// Meshes whose faces lie in each other's planes. They are the surfaces of solids of grid cells, so
// what is true is counted in cells (grid_solid.hpp).

namespace rubicon::collision::proof {
namespace {

/// A body drawn in a frame of its own.
struct Drawn {
  BodyPtr body;
  Pose X_DrawnGrid = Pose::Identity();
  std::size_t triangles = 0;
  bool convex = false;  ///< some part of it is tested as a convex solid
};

/// Two solids of one grid, the first one shifted, and the bodies made of them.
struct AlignedCase {
  GridSolid a;
  GridSolid b;
  Vec3 shift = Vec3::Zero();
  double tolerance = 1e-3;
  double finest = 0;  ///< m, the most that the triangles allow
  double doubt = 0;   ///< m
  Drawn drawn_a;
  Drawn drawn_b;
  Pose X_WGrid = Pose::Identity();

  GridRules rules() const {
    // What is thin in a mesh is not known where it meets a convex solid.
    return {tolerance, finest, doubt, !drawn_a.convex && !drawn_b.convex};
  }
  Pose pose_a() const {
    return X_WGrid * math::translation(shift.x(), shift.y(), shift.z()) *
           drawn_a.X_DrawnGrid.inverse();
  }
  Pose pose_b() const { return X_WGrid * drawn_b.X_DrawnGrid.inverse(); }
};

Drawn drawn(const GridSolid& solid, double noise, bool turned, Random& random, double& finest) {
  GridMeshStyle style = random_style(random);
  style.noise = noise;
  geometry::TriangleMesh mesh = grid_mesh(solid, style, random);
  // A quarter of the altitude, at least 0.01 mm: docs/collision.md.
  finest = std::min(finest, std::max(0.25 * finest_altitude(mesh), 1e-5));
  Drawn result;
  if (turned) result.X_DrawnGrid = random.pose(1);
  for (Vec3& vertex : mesh.vertices) vertex = result.X_DrawnGrid * vertex;
  result.triangles = mesh.triangles.size();
  result.body = test::mesh_body(mesh);
  result.convex = !result.body->convexes().empty();
  return result;
}

/// A shift that brings a plane of one solid to a plane of the other, along each axis, or leaves it.
Vec3 aligned_shift(const std::array<std::vector<double>, 3>& planes, Random& random) {
  Vec3 shift = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    if (random.below(2)) continue;
    const int count = static_cast<int>(planes[axis].size());
    shift[axis] = planes[axis][random.below(count)] - planes[axis][random.below(count)];
  }
  return shift;
}

AlignedCase random_case(Random& random) {
  AlignedCase result;
  const auto planes = random_planes(random);
  result.a = random_grid_solid(random, planes);
  result.b = random.below(4) ? random_grid_solid(random, planes) : result.a;
  result.shift = aligned_shift(planes, random);
  if (random.below(4) == 0) {
    // Pressed into each other by more or less than the tolerance, or a little apart.
    constexpr double kPresses[] = {-2e-3, -5e-4, -5e-6, 5e-6, 2e-4, 5e-4, 1.5e-3, 4e-3};
    result.shift += kPresses[random.below(8)] * Vec3::Unit(random.below(3));
  }
  constexpr double kTolerances[] = {1e-3, 1e-3, 1e-3, 1e-2, 1e-4, 0};
  result.tolerance = kTolerances[random.below(6)];
  double noise = 0;
  if (random.below(3) == 0 && result.tolerance > 0) noise = random.below(2) ? 1e-6 : 5e-5;
  result.doubt = std::min(kExactBand, 0.1 * std::max(result.tolerance, 1e-9)) + 4 * noise;
  const bool turned = random.below(2) == 0;
  result.finest = result.tolerance > 0 ? result.tolerance : 1e-9;
  result.drawn_a = drawn(result.a, noise, turned, random, result.finest);
  result.drawn_b = drawn(result.b, noise, turned, random, result.finest);
  if (random.below(2)) result.X_WGrid = random.pose(10);
  return result;
}

void note(CaseRecord& record, const AlignedCase& one, const Vec3& way) {
  record.note([&] {
    const auto cells = [](const GridSolid& solid) {
      std::string text;
      for_each_cell(solid, [&](const std::array<int, 3>& cell) {
        if (!solid.has(cell)) return;
        const auto& p = solid.planes;
        text += fmt::format("  ({}, {}, {}) to ({}, {}, {})\n", p[0][cell[0]], p[1][cell[1]],
                            p[2][cell[2]], p[0][cell[0] + 1], p[1][cell[1] + 1], p[2][cell[2] + 1]);
      });
      return text;
    };
    return fmt::format(
        "a: {} triangles, drawn {}, {}, cells\n{}b: {} triangles, drawn {}, {}, cells\n{}"
        "a shifted by {}, then along {}\ntolerance {} m, triangles allow {} m, in doubt {} m",
        one.drawn_a.triangles, text_of(one.drawn_a.X_DrawnGrid), text_of(one.pose_a()),
        cells(one.a), one.drawn_b.triangles, text_of(one.drawn_b.X_DrawnGrid),
        text_of(one.pose_b()), cells(one.b), text_of(one.shift), text_of(way), one.tolerance,
        one.finest, one.doubt);
  });
}

void aligned_poses(Random& random, CaseRecord& record) {
  const AlignedCase one = random_case(random);
  Outcome outcome;
  outcome.truth = grid_truth(shifted(one.a, one.shift), one.b, one.rules());
  if (random.below(2)) {
    outcome.engine_hit =
        overlaps(*one.drawn_a.body, one.pose_a(), *one.drawn_b.body, one.pose_b(), one.tolerance);
  } else {
    CollisionWorld world;
    world.insert(one.drawn_b.body, one.pose_b());
    outcome.engine_hit =
        world.blocked_at(*one.drawn_a.body, one.pose_a(), one.tolerance, {}).has_value();
  }
  record.outcomes.push_back(outcome);
  note(record, one, Vec3::Zero());
}

void aligned_steps(Random& random, CaseRecord& record) {
  AlignedCase one = random_case(random);
  const int axis = random.below(3);
  const auto& planes = one.a.planes[axis];
  // From or to where planes meet, or anywhere; a third of the steps are short.
  double way = random.between(-1, 1) * (planes.back() - planes.front());
  if (random.below(3) == 0) way *= 0.01;
  if (random.below(3) == 0) one.shift[axis] -= way;
  if (random.below(4) == 0) {
    way = aligned_shift(one.a.planes, random)[axis];
    if (way == 0) way = planes.back() - planes.front();
  }
  Outcome outcome;
  outcome.motion = MotionKind::kTranslation;
  outcome.truth = grid_truth_along(shifted(one.a, one.shift), axis, way, one.b, one.rules());
  const Vec3 way_grid = way * Vec3::Unit(axis);
  const Vec3 way_W = one.X_WGrid.linear() * way_grid;
  if (random.below(4) == 0) {
    const Pose X_WB = one.pose_b();
    outcome.engine_hit = test::pair_blocked(
        *one.drawn_a.body, geometry::translating(one.pose_a(), 0.5 * way_W), *one.drawn_b.body,
        geometry::translating(X_WB, -0.5 * way_W), one.tolerance);
  } else {
    outcome.engine_hit =
        test::blocked(*one.drawn_a.body, geometry::translating(one.pose_a(), way_W),
                      one.drawn_b.body, one.pose_b(), one.tolerance);
  }
  record.outcomes.push_back(outcome);
  note(record, one, way_grid);
}

constexpr Generator kAlignedGenerators[] = {
    {"aligned_poses", "meshes whose faces lie in each other", 3, 1, aligned_poses},
    {"aligned_steps", "the same, shifted along an axis of their grid", 1, 1, aligned_steps},
};

}  // namespace

std::span<const Generator> aligned_generators() { return kAlignedGenerators; }

}  // namespace rubicon::collision::proof
