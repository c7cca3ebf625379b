#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "src/motion/collision/sweep/body.hpp"
#include "src/motion/math/angles.hpp"

namespace rubicon::collision {

/// A part [s0, s1] of the motion of one body: poses of its centred coordinates in the world, and
/// what is known of the way between them. Halves are made when first asked for.
class SweepSlice {
 public:
  SweepSlice(const Body& body, const Motion& motion, double s0, double s1);
  /// The same where the pose at s0 is known.
  SweepSlice(const Body& body, const Motion& motion, double s0, double s1, const Placement& start);

  double s0() const { return s0_; }
  double s1() const { return s1_; }
  const Placement& start() const { return start_; }
  const Placement& end() const { return end_; }
  const Placement& middle();
  /// Upper bound (m) of how far core points deviate from their chords, whatever the direction.
  double uniform_growth() const { return uniform_growth_; }
  /// For screws, also bounded by this times the radius about `axis()`, across it.
  double unit_sagitta() const { return unit_sagitta_; }
  const Vec3& axis() const { return axis_; }
  const Vec3& point() const { return point_; }

  SweepSlice& first_half();
  SweepSlice& second_half();

 private:
  Placement turned(const math::SineCosine& turn, const Vec3& slide) const;

  const Body* body_;
  const Motion* motion_;
  double s0_;
  double s1_;
  Placement start_;
  Placement end_;
  std::optional<Placement> middle_;
  double uniform_growth_ = 0;
  double unit_sagitta_ = 0;
  math::SineCosine half_turn_;
  Vec3 axis_ = Vec3::UnitZ();
  Vec3 point_ = Vec3::Zero();
  std::unique_ptr<SweepSlice> first_;
  std::unique_ptr<SweepSlice> second_;
};

/// One body's motion over a step as the world sees it: made once, looked at for every obstacle.
/// Body and motion must outlive it.
class Sweep {
 public:
  /// Throws std::invalid_argument as `RelativeMotion`.
  Sweep(const Body& body, const Motion& motion);
  /// Of a motion that `require_valid` has passed.
  struct Valid {};
  Sweep(const Body& body, const Motion& motion, Valid);

  const Body& body() const { return *body_; }
  const Motion& motion() const { return *motion_; }
  /// No rotation: each point moves along the straight line from start to end, in one slice.
  bool is_translation() const { return is_translation_; }
  bool moves() const { return moves_; }
  /// The box around everything the body sweeps, world.
  const Bounds& bounds() const { return bounds_; }
  /// The box around what it sweeps in the part [s0, s1] of its motion, world.
  Bounds bounds_between(double s0, double s1) const;
  /// Cut so that boxes around slices are useful; one for all but very large steps.
  int slice_count() const { return count_; }
  SweepSlice& slice(int i) { return i == 0 ? first_ : more_[static_cast<std::size_t>(i - 1)]; }

 private:
  const Body* body_;
  const Motion* motion_;
  bool is_translation_;
  bool moves_;
  int count_;
  SweepSlice first_;
  std::vector<SweepSlice> more_;
  Bounds bounds_;
};

}  // namespace rubicon::collision
