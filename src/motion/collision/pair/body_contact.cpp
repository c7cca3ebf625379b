#include "src/motion/collision/pair/body_contact.hpp"

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/collision/convex/closest_points.hpp"
#include "src/motion/collision/pair/containment.hpp"
#include "src/motion/collision/pair/convex_narrow_phase.hpp"
#include "src/motion/collision/pair/part_pairs.hpp"

namespace rubicon::collision {
namespace {

/// A point of both pieces, or between them, with A at `a_in_b`; in the frame of B.
Vec3 witness(const Convex& a, const Convex& b, const Placement& a_in_b) {
  SweptPair pair;
  pair.moving = a;
  pair.fixed = b;
  pair.stand_at(a_in_b);
  const ClosestPoints points = closest_points(pair);
  return 0.5 * (points.moving + points.fixed);
}

/// The first contact of surfaces and solids within one slice, the point in the frame of B.
std::optional<Contact> contact_on(const PartPairs& pairs, MotionTree& tree,
                                  double contact_tolerance) {
  std::optional<Contact> first;
  const auto look = [&](const Convex& piece_a, const Convex& piece_b) {
    const double tolerance = pair_tolerance(piece_a.width, piece_b.width, contact_tolerance);
    const std::optional<double> found =
        first_contact(piece_a, piece_b, tree, tolerance, first ? first->fraction : tree.slice().s1);
    if (!found || (first && first->fraction <= *found)) return false;
    const Placement pose = tree.motion().slice(*found, *found).a_in_b.start;
    first = Contact{*found, witness(piece_a, piece_b, pose)};
    return *found <= tree.slice().s0;  // none can be earlier
  };
  pairs.any(tree.slice(), 0, look);
  return first;
}

}  // namespace

std::optional<Contact> body_contact(const Body& a, const Motion& motion_a, const Body& b,
                                    const Motion& motion_b, double contact_tolerance) {
  const RelativeMotion motion(motion_a, a.extent(), motion_b, b.extent());
  const auto in_world = [&](Contact contact) {
    contact.point_W = centred(motion_b, b.extent(), contact.fraction) * contact.point_W;
    return contact;
  };
  const int count = useful_slices(motion, a.extent().radius + b.extent().radius);
  const PartPairs pairs(a, b, motion);
  for (int i = 0; i < count; ++i) {
    MotionTree tree(motion, static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
    const View& view = tree.slice().a_in_b;
    if (i == 0) {
      if (const auto point = contained_point(a, b, view.start, contact_tolerance)) {
        return in_world({0, *point});
      }
    }
    if (const auto found = contact_on(pairs, tree, contact_tolerance)) return in_world(*found);
    if (i + 1 == count && motion.kind() != RelativeMotion::Kind::kStill) {
      if (const auto point = contained_point(a, b, view.end, contact_tolerance)) {
        return in_world({1, *point});
      }
    }
  }
  return std::nullopt;
}

}  // namespace rubicon::collision
