#include <fmt/format.h>

#include <cmath>

#include "tests/proof/convex_truth.hpp"
#include "tests/proof/generators.hpp"
#include "tests/proof/graze.hpp"

namespace rubicon::collision::proof {
namespace {

/// Boxes by their centres.
struct BoxCase {
  Vec3 half_a;
  Path path_a;
  Vec3 half_b;
  Path path_b;
  double tolerance = 1e-3;
};

Truth truth_of(const BoxCase& boxes) {
  return polytopes_truth(box_polytope(boxes.half_a), boxes.path_a, box_polytope(boxes.half_b),
                         boxes.path_b, boxes.tolerance);
}

/// Shifts the standing box so that the step just hits or just does not.
void graze(BoxCase& boxes, Random& random) {
  const Pose X_WB = boxes.path_b.pose(0);
  const auto at_offset = [&](const Vec3& offset) {
    Pose X = X_WB;
    X.translation() += offset;
    boxes.path_b = standing(X);
  };
  const Vec3 towards = boxes.path_a.pose(random.unit()).translation() - X_WB.translation();
  const double finest = boxes.path_a.translates() ? 4 * kExactBand : kBand;
  at_offset(grazing_offset(random, towards, finest, [&](const Vec3& offset) {
    at_offset(offset);
    return truth_of(boxes);
  }));
}

/// One in `graze_every` cases is brought to the very boundary.
void judge(BoxCase boxes, Random& random, CaseRecord& record, int graze_every = 2) {
  Outcome outcome;
  outcome.grazes = boxes.path_b.kind == MotionKind::kStill && random.below(graze_every) == 0;
  if (outcome.grazes) graze(boxes, random);
  outcome.motion = boxes.path_b.kind == MotionKind::kStill ? boxes.path_a.kind : MotionKind::kPair;
  outcome.truth = truth_of(boxes);
  const BodyPtr a = test::box(boxes.half_a);
  const BodyPtr b = test::box(boxes.half_b);
  if (boxes.path_b.kind == MotionKind::kStill) {
    const Pose X_WB = boxes.path_b.pose(0);
    const Solid solid_a = box_solid(boxes.half_a);
    const Solid solid_b = box_solid(boxes.half_b);
    outcome.engine_hit = test::blocked(*a, boxes.path_a.motion, b, X_WB, boxes.tolerance);
    outcome.fcl_hit = fcl_continuous(solid_a.fcl(), boxes.path_a, solid_b.fcl(), X_WB);
    if (random.below(kThirdVoiceEvery) == 0)
      outcome.third = fcl_truth(solid_a, boxes.path_a, solid_b, X_WB, boxes.tolerance);
  } else {
    outcome.engine_hit =
        test::pair_blocked(*a, boxes.path_a.motion, *b, boxes.path_b.motion, boxes.tolerance);
  }
  record.outcomes.push_back(outcome);
  record.note([&] {
    return fmt::format(
        "a: half {} from {} to {}\nb: half {} from {} to {}\ntolerance {} m", text_of(boxes.half_a),
        text_of(boxes.path_a.pose(0)), text_of(boxes.path_a.pose(1)), text_of(boxes.half_b),
        text_of(boxes.path_b.pose(0)), text_of(boxes.path_b.pose(1)), boxes.tolerance);
  });
}

Vec3 random_half(Random& random, double least, double greatest) {
  return Vec3{random.between(least, greatest), random.between(least, greatest),
              random.between(least, greatest)};
}

double random_tolerance(Random& random) {
  constexpr double kTolerances[] = {1e-3, 1e-3, 1e-3, 0, 1e-6, 1e-2};
  return kTolerances[random.below(6)];
}

BoxCase generic_case(Random& random) {
  BoxCase boxes;
  boxes.half_a = random_half(random, 0.05, 1);
  boxes.half_b = random_half(random, 0.05, 1);
  PathSizes sizes;
  sizes.angle_deg = random.below(2) ? 90 : 5;
  sizes.may_be_tiny = true;
  boxes.path_a = random_path(random, random.pose(1.0), sizes);
  boxes.path_b = standing(random.pose(1.0));
  boxes.tolerance = random_tolerance(random);
  return boxes;
}

void generic(Random& random, CaseRecord& record) { judge(generic_case(random), random, record); }

/// Sizes, places and axes on a lattice of 0.25 m: most cases touch somewhere.
void lattice(Random& random, CaseRecord& record) {
  const auto half = [&] {
    return Vec3{0.125 * (1 + random.below(8)), 0.125 * (1 + random.below(8)),
                0.125 * (1 + random.below(8))};
  };
  const auto pose = [&] {
    Pose X = Pose::Identity();
    X.linear() = math::rotation_about_deg(Vec3::Unit(random.below(3)), 90.0 * random.below(4));
    X.translation() = random.lattice_vector(1.5);
    return X;
  };
  BoxCase boxes;
  boxes.half_a = half();
  boxes.half_b = half();
  boxes.path_b = standing(pose());
  const Pose X0 = pose();
  if (random.below(2)) {
    Vec3 d = Vec3::Zero();
    d[random.below(3)] = random.lattice(0.5);
    if (random.below(4) == 0) d[random.below(3)] = random.lattice(0.5);
    boxes.path_a = translating(X0, d);
    boxes.tolerance = random.below(2) ? 1e-3 : 1e-6;
  } else {
    const Vec3 axis = Vec3::Unit(random.below(3));
    const double angle = random.below(2) ? 5 : 22.5 * (random.below(9) - 4);
    boxes.path_a = turning(X0, axis, random.lattice_vector(3), angle,
                           random.below(3) == 0 ? random.lattice(0.5) : 0);
  }
  judge(boxes, random, record, 8);
}

/// Small parts against walls of 20 to 150 mm.
void thin(Random& random, CaseRecord& record) {
  BoxCase boxes;
  boxes.half_a = random_half(random, 0.01, 0.2);
  boxes.half_b = Vec3{random.between(0.5, 3), random.between(0.01, 0.075), random.between(0.5, 3)};
  boxes.path_b = standing(random.pose(0.3));
  PathSizes sizes;
  sizes.travel = 1;
  sizes.radius = 10;
  boxes.path_a = random_path(random, random.pose(0.6), sizes);
  boxes.tolerance = random_tolerance(random);
  judge(boxes, random, record);
}

/// Small parts that go through a thin wall within one step and out again, or just past its rim.
void tunnel(Random& random, CaseRecord& record) {
  BoxCase boxes;
  boxes.half_a = random_half(random, 0.005, 0.03);
  boxes.half_b = Vec3{random.between(0.5, 3), random.between(0.01, 0.025), random.between(0.5, 3)};
  const Mat3 R = random.rotation();  // of the wall
  Pose X_middle = Pose::Identity();
  X_middle.linear() = random.rotation();
  X_middle.translation() = random.vector(0.5);
  Pose X_WB = Pose::Identity();
  X_WB.linear() = R;
  X_WB.translation() =
      X_middle.translation() + R * Vec3{1.02 * random.between(-boxes.half_b.x(), boxes.half_b.x()),
                                        random.between(-0.1, 0.1),
                                        random.between(-boxes.half_b.z(), boxes.half_b.z())};
  boxes.path_b = standing(X_WB);
  const Vec3 across = R.col(1);
  if (random.below(2)) {
    const Vec3 d = random.between(0.3, 0.5) * (across + random.vector(0.3)).normalized();
    X_middle.translation() -= 0.5 * d;
    boxes.path_a = translating(X_middle, d);
  } else {
    const Vec3 axis = across.cross(random.direction()).normalized();
    const double angle = random.below(2) ? 5 : -5;
    const Vec3 arm = random.between(5, 30) * axis.cross(across);
    const Path first_half = turning(X_middle, axis, X_middle.translation() + arm, -0.5 * angle);
    boxes.path_a = turning(first_half.pose(1), axis, X_middle.translation() + arm, angle,
                           random.below(3) == 0 ? random.between(-0.2, 0.2) : 0);
  }
  judge(boxes, random, record);
}

/// Five degrees with up to 30 m of jib, walls in the way.
void slew(Random& random, CaseRecord& record) {
  BoxCase boxes;
  boxes.half_a = Vec3{random.between(0.1, 2), random.between(0.05, 0.2), random.between(0.1, 1.5)};
  const double radius = random.between(5, 30);
  const double heading = random.between(0, 360);
  const double angle = random.below(2) ? 5 : -5;
  if (random.below(4) == 0) {
    const Vec3 way = random.vector(0.5);
    boxes.path_a = crane(Vec3(radius, 0, 0), way, heading, angle);
  } else {
    const double twist = random.below(4) * random.between(0, 90);
    const Pose X0 = math::rotation_z_deg(heading) * at(radius, 0, 0) * math::rotation_z_deg(twist);
    const double slide = random.below(3) == 0 ? random.between(-0.5, 0.5) : 0;
    boxes.path_a = turning(X0, Vec3::UnitZ(), Vec3::Zero(), angle, slide);
  }
  Pose X_WB = boxes.path_a.pose(random.between(-0.3, 1.3));
  X_WB.linear() = X_WB.linear() * random.rotation();
  X_WB.translation() += random.vector(1);
  boxes.path_b = standing(X_WB);
  boxes.half_b = Vec3{random.between(0.2, 3), random.between(0.01, 0.075), random.between(0.2, 3)};
  judge(boxes, random, record);
}

/// 100 km from the origin.
void far(Random& random, CaseRecord& record) {
  BoxCase boxes;
  boxes.half_a = random_half(random, 0.05, 1);
  boxes.half_b = random_half(random, random.below(2) ? 0.01 : 0.05, 1);
  const Vec3 there = 1e5 * random.direction();
  Pose X = random.pose(1);
  X.translation() += there;
  constexpr MotionKind kKinds[] = {MotionKind::kTranslation, MotionKind::kRotation,
                                   MotionKind::kScrew};
  PathSizes sizes;
  sizes.radius = 30;
  sizes.angle_deg = 5;
  boxes.path_a = random_path(random, kKinds[random.below(3)], X, sizes);
  Pose X_WB = random.pose(1);
  X_WB.translation() += there;
  boxes.path_b = standing(X_WB);
  judge(boxes, random, record);
}

/// Both bodies move: by unrelated motions, about one axis, side by side.
void both_move(Random& random, CaseRecord& record) {
  BoxCase boxes;
  boxes.half_a = random_half(random, 0.05, 0.6);
  boxes.half_b = random_half(random, 0.05, 0.6);
  PathSizes sizes;
  sizes.angle_deg = 30;
  sizes.travel = 0.5;
  Pose X_WA = random.pose(1);
  Pose X_WB = random.pose(1);
  switch (random.below(4)) {
    case 0: {
      const Vec3 axis = random.direction();
      const Vec3 point = random.vector(2);
      boxes.path_a = turning(X_WA, axis, point, random.between(-40, 40), random.between(-0.3, 0.3));
      boxes.path_b = turning(X_WB, axis, point, random.between(-40, 40), random.between(-0.3, 0.3));
      break;
    }
    case 1: {
      const Vec3 d = random.vector(0.5);
      const Vec3 other = random.below(2) ? d : random.vector(0.5);
      boxes.path_a = translating(X_WA, d);
      boxes.path_b = translating(X_WB, other);
      break;
    }
    default:
      // General ones turn about the world's axis: away from it.
      X_WA.translation().x() += 4;
      X_WB.translation().x() += 4;
      sizes.angle_deg = 10;
      boxes.path_a = random_path(random, X_WA, sizes);
      boxes.path_b = random_path(random, X_WB, sizes);
  }
  judge(boxes, random, record);
}

constexpr Generator kBoxGenerators[] = {
    {"generic", "boxes anyhow", 16, 1, generic},
    {"lattice", "boxes on a lattice of 0.25 m", 12, 1, lattice},
    {"thin", "walls of 20 to 150 mm", 12, 1, thin},
    {"tunnel", "small parts through walls of 20 to 50 mm in one step", 8, 1, tunnel},
    {"slew", "5 degrees, radius to 30 m, thin walls", 10, 1, slew},
    {"far", "boxes 100 km from the origin", 8, 1, far},
    {"both_move", "two boxes, both moving", 8, 1, both_move},
};

}  // namespace

std::span<const Generator> box_generators() { return kBoxGenerators; }

}  // namespace rubicon::collision::proof
