#pragma once

#include <memory>

#include "src/motion/collision/sweep/relative_motion.hpp"

namespace rubicon::collision {

/// A step cut into halves of halves: every pair of pieces of two bodies looks at the same slices,
/// so each is made once, when first asked for. Lives for one pair of bodies of one query, on one
/// thread.
class MotionTree {
 public:
  MotionTree(const RelativeMotion& motion, double s0, double s1);

  const Slice& slice() const { return slice_; }
  const RelativeMotion& motion() const { return *motion_; }
  MotionTree& first_half();
  MotionTree& second_half();

 private:
  const RelativeMotion* motion_;
  Slice slice_;
  std::unique_ptr<MotionTree> first_;
  std::unique_ptr<MotionTree> second_;
};

}  // namespace rubicon::collision
