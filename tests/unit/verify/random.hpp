#pragma once

#include <cstdint>
#include <random>

#include "src/motion/math/angles.hpp"
#include "src/results/verify/input/convex.hpp"

namespace rubicon::verify {

/// Random numbers that are the same with every standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double real(double lower, double upper) {
    return lower + (upper - lower) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  int whole(int lower, int upper) {
    return lower + static_cast<int>(engine_() % static_cast<std::uint64_t>(upper - lower + 1));
  }
  Vec3 point(double size) { return {real(-size, size), real(-size, size), real(-size, size)}; }
  Vec3 direction() {
    for (;;) {
      const Vec3 p = point(1);
      if (p.norm() > 0.1 && p.norm() <= 1) return p.normalized();
    }
  }
  Pose pose(double size) {
    Pose X = math::translation(0, 0, 0);
    X.translation() = point(size);
    X.linear() = math::rotation_about_deg(direction(), real(-180, 180));
    return X;
  }

 private:
  std::mt19937_64 engine_;
};

/// A convex solid of any kind, about a metre across; `round` also cylinders, spheres, capsules.
inline Convex random_piece(Random& random, bool round) {
  const double a = random.real(0.05, 1);
  const double b = random.real(0.05, 1);
  switch (random.whole(0, round ? 5 : 2)) {
    case 0:
      return box_piece(Vec3(-a, -b, -random.real(0.02, 1)), Vec3(a, b, random.real(0.02, 1)));
    case 1:
      return triangle_piece(random.point(1), random.point(1), random.point(1));
    case 2: {
      std::vector<Eigen::Vector2d> polygon;
      const int corners = random.whole(3, 7);
      for (int i = 0; i < corners; ++i) {
        const double angle = 360.0 * (i + random.real(0, 0.8)) / corners;
        polygon.emplace_back(a * math::cos_deg(angle), a * math::sin_deg(angle));
      }
      return prism_piece(polygon, -b, b);
    }
    case 3:
      return cylinder_piece(a, -b, b);
    case 4:
      return capsule_piece(random.point(0.5), random.point(0.5), b / 2);
    default:
      return capsule_piece(Vec3::Zero(), Vec3::Zero(), a);
  }
}

}  // namespace rubicon::verify
