#pragma once

#include <cmath>
#include <limits>
#include <random>

#include "src/motion/collision/swept_query.hpp"
#include "src/motion/math/angles.hpp"

namespace rubicon::collision::test {

using math::Mat3;

/// Contact tolerance of most cases, and how far from it an answer must be to be judged (m).
inline constexpr double kTolerance = 1e-3;
inline constexpr double kBand = 1e-4;
/// By how much swept volumes may be larger than what they are to hold (m).
inline constexpr double kGrowth = 2.5e-4;

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Numbers from a seed, the same on every machine (std::uniform_real_distribution is not). `Engine`
/// gives 32 bits a call.
template <typename Engine>
class BasicRandom {
 public:
  explicit BasicRandom(typename Engine::result_type seed) : BasicRandom(Engine(seed)) {}
  explicit BasicRandom(const Engine& engine) : engine_(engine) {}

  double unit() { return static_cast<double>(engine_()) * 0x1p-32; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  int below(int count) { return static_cast<int>(unit() * count); }
  Vec3 vector(double size) {
    const double x = between(-size, size);
    const double y = between(-size, size);
    const double z = between(-size, size);
    return {x, y, z};
  }
  Vec3 direction() {
    for (;;) {
      const Vec3 v = vector(1);
      if (v.norm() > 0.1 && v.norm() < 1) return v.normalized();
    }
  }
  Mat3 rotation() {
    const Vec3 axis = direction();
    return math::rotation_about_deg(axis, between(-180, 180));
  }
  Pose pose(double size) {
    Pose X = Pose::Identity();
    X.linear() = rotation();
    X.translation() = vector(size);
    return X;
  }
  /// A multiple of 0.25 m in [-size, size].
  double lattice(double size) { return 0.25 * (below(static_cast<int>(8 * size) + 1) - 4 * size); }
  Vec3 lattice_vector(double size) {
    const double x = lattice(size);
    const double y = lattice(size);
    const double z = lattice(size);
    return {x, y, z};
  }

 private:
  Engine engine_;
};
using Random = BasicRandom<std::mt19937>;

inline Pose at(double x, double y, double z) { return math::translation(x, y, z); }

inline geometry::Shape box_shape(const Vec3& lower, const Vec3& upper) {
  return {geometry::Box{lower, upper}, Pose::Identity()};
}

/// A box with its centre at the origin.
inline BodyPtr box(const Vec3& half) { return prepare({box_shape(-half, half)}); }

inline Motion turning(const Pose& X0, const Vec3& axis, const Vec3& point, double angle_deg,
                      double slide = 0) {
  geometry::ScrewMotion screw;
  screw.X0 = X0;
  screw.axis = axis;
  screw.point = point;
  screw.angle_deg = angle_deg;
  screw.slide = slide * axis;
  return Motion{screw};
}

/// `body` moving, as one item of a query.
SweptQuery::Item item(const Body& body, const Motion& motion, bool against_world = true);

/// Whether `body` is blocked on its way by one obstacle.
bool blocked(const Body& body, const Motion& motion, const BodyPtr& obstacle, const Pose& X_WB,
             double tolerance);

/// Whether two moving bodies block each other.
bool pair_blocked(const Body& a, const Motion& motion_a, const Body& b, const Motion& motion_b,
                  double tolerance);

}  // namespace rubicon::collision::test
