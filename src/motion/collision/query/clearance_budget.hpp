#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "src/motion/collision/sweep/body.hpp"
#include "src/motion/collision/tree/wide_tree.hpp"

namespace rubicon::collision {

/// A state of a world: which one, and after how many changes.
struct WorldState {
  std::shared_ptr<const int> world;  // shared: no other world can be taken for one that is gone
  std::uint64_t changes = 0;

  bool operator==(const WorldState&) const = default;
};

/// Upper bound (m) of how far a point of the body is from where `X` (of its centred coordinates)
/// has it, at any moment of a valid motion; not finite where no bound is known.
double greatest_displacement(const Body& body, const Motion& motion, const Placement& X);

/// Free space around the bodies of a series of queries, by the index of the item.
struct ClearanceBudget::Impl {
  /// Nothing is nearer than `clear` (m) to the body's box at `X`.
  struct Known {
    BodyPtr body;  // shared: no other body can be taken for one that is gone
    Placement X;
    Pose pose = Pose::Identity();  ///< of the body's own frame, where X is
    double clear = 0;
    Pose slid = Pose::Identity();  ///< how the body was turned when it slid last, far from all
    int pause = 0;                 ///< queries to wait before free space is measured again
    int futile = 0;                ///< times it was measured and was too small to be of use
  };
  WorldState state;
  std::vector<Known> items;

  /// Forgets everything if the world is another one or has changed.
  void look_at(const WorldState& now) {
    if (!(state == now)) forget(now);
  }
  void forget(const WorldState& now);
  /// Whether the item, which does not turn, slides turned as it was when the space was measured and
  /// stays in space known to be free; then the motion is valid, too.
  bool covers_slide(std::size_t item, const Body& body, const geometry::ScrewMotion& slide) const;
  /// Whether the item stays in space known to be free all the time of a valid motion.
  bool covers(std::size_t item, const Body& body, const Motion& motion) const;
  /// After a step of the item was found free: measures the space where it ends, if that is likely
  /// to be of use.
  void measure(std::size_t item, const Body& body, const Motion& motion, const WideTree& obstacles);
  /// After a valid slide of the item that stayed far from all obstacles: measures likewise, if it
  /// is turned as in the slide before. Turns are seen to be far as soon as this would tell.
  void measure_slide(std::size_t item, const Body& body, const Motion& motion,
                     const WideTree& obstacles);
};

}  // namespace rubicon::collision
