#include "src/motion/collision/sweep/motion_tree.hpp"

namespace rubicon::collision {

MotionTree::MotionTree(const RelativeMotion& motion, double s0, double s1)
    : motion_(&motion), slice_(motion.slice(s0, s1)) {}

MotionTree& MotionTree::first_half() {
  if (!first_) {
    first_ = std::make_unique<MotionTree>(*motion_, slice_.s0, 0.5 * (slice_.s0 + slice_.s1));
  }
  return *first_;
}

MotionTree& MotionTree::second_half() {
  if (!second_) {
    second_ = std::make_unique<MotionTree>(*motion_, 0.5 * (slice_.s0 + slice_.s1), slice_.s1);
  }
  return *second_;
}

}  // namespace rubicon::collision
