#include "tests/unit/collision/bodies.hpp"

#include "tests/unit/collision/meshes.hpp"

namespace rubicon::collision::test {

BodyPtr random_body(Random& random) {
  const double r = random.between(0.1, 0.5);
  const double length = random.between(0.2, 0.8);
  switch (random.below(6)) {
    case 0:
      return box(Vec3(r, length, random.between(0.05, 0.6)));
    case 1:
      return prepare({{geometry::Sphere{Vec3::Zero(), r}, Pose::Identity()}});
    case 2:
      return prepare({{geometry::Cylinder{r, -length, length}, Pose::Identity()}});
    case 3:
      return prepare(
          {{geometry::Capsule{Vec3(0, 0, -length), Vec3(0, 0, length), r}, Pose::Identity()}});
    case 4:
      return prepare(
          {{geometry::Prism{0, length, {{0, 0}, {1, 0}, {1, 0.3}, {0.3, 0.3}, {0.3, 1}, {0, 1}}},
            Pose::Identity()}});
    default:
      return mesh_body(l_mesh(1));
  }
}

Motion random_motion(Random& random) {
  const Pose X = random.pose(1.2);
  return random.below(2) ? geometry::translating(X, random.vector(0.6))
                         : turning(X, random.direction(), random.vector(2), random.between(-30, 30),
                                   random.between(-0.2, 0.2));
}

Motion part_of(const Motion& motion, double s0, double s1) {
  geometry::ScrewMotion screw = std::get<geometry::ScrewMotion>(motion.kind);
  screw.X0 = motion.pose(s0);
  screw.angle_deg *= s1 - s0;
  screw.slide *= s1 - s0;
  return Motion{screw};
}

std::vector<BodyPtr> site_bodies() {
  Random random(90);
  std::vector<BodyPtr> bodies = {box(Vec3(1.5, 0.05, 1)), box(Vec3(0.2, 0.2, 0.2)),
                                 box(Vec3(0.05, 0.05, 1.2)), mesh_body(l_mesh(1))};
  for (int i = 0; i < 8; ++i) bodies.push_back(random_body(random));
  return bodies;
}

}  // namespace rubicon::collision::test
