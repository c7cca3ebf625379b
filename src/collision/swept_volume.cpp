#include "src/collision/swept_volume.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "src/collision/sweep.hpp"
#include "src/collision/swept_piece.hpp"
#include "src/collision/tolerances.hpp"

namespace rubicon::collision {
namespace {

/// Triangles of a mesh that are swept together, as one body: few enough to be near each other.
constexpr int kTrianglesTogether = 32;

/// What of a body is cut into the same slices.
struct Group {
  std::vector<const Convex*> pieces;
};

class SweptVolume {
 public:
  SweptVolume(const Body& body, const Motion& motion, double growth)
      : body_(body), motion_(motion), growth_(growth) {}

  std::vector<StandingPart> parts() {
    for (const Convex& piece : body_.convexes()) add({{&piece}});
    for (const TriangleSoup& soup : body_.soups()) add(soup);
    return std::move(parts_);
  }

 private:
  /// The triangles of a soup are sorted: neighbours in the list are neighbours in space.
  void add(const TriangleSoup& soup) {
    const int count = static_cast<int>(soup.triangles().size());
    for (int first = 0; first < count; first += kTrianglesTogether) {
      std::vector<std::unique_ptr<TrianglePiece>> triangles;
      Group group;
      for (int i = first; i < std::min(count, first + kTrianglesTogether); ++i) {
        triangles.push_back(std::make_unique<TrianglePiece>(soup.corner(i, 0), soup.corner(i, 1),
                                                            soup.corner(i, 2)));
        group.pieces.push_back(&triangles.back()->view());
      }
      add(group);
    }
  }

  void add(const Group& group) { cover(group, 0, 1, kMaxSlices); }

  /// Halves of halves, until the volume is close enough or there are no slices left.
  void cover(const Group& group, double s0, double s1, int slices) {
    const PieceSlice slice(body_, motion_, s0, s1);
    StandingPart part;
    part.X_WB.translation() = slice.origin();
    std::vector<ConvexPiece> swept;
    double excess = 0;
    for (const Convex* piece : group.pieces) {
      SweptPiece one = slice.sweep(*piece, growth_);
      excess = std::max(excess, one.excess);
      swept.push_back(std::move(one.piece));
    }
    if (excess > growth_ && slices > 1) {
      const double middle = 0.5 * (s0 + s1);
      cover(group, s0, middle, slices / 2);
      cover(group, middle, s1, slices / 2);
      return;
    }
    part.body = std::make_shared<const Body>(std::move(swept), std::vector<TriangleSoup>(),
                                             Vec3(Vec3::Zero()));
    parts_.push_back(std::move(part));
  }

  const Body& body_;
  const Motion& motion_;
  double growth_;
  std::vector<StandingPart> parts_;
};

}  // namespace

std::vector<StandingPart> swept_volume(const Body& body, const Motion& motion, double growth) {
  require_valid(motion);
  const BodyPtr itself = body.shared_from_this();
  if (!motion.moves()) return {{itself, motion.pose(0)}};
  std::vector<StandingPart> parts = SweptVolume(body, motion, growth).parts();
  // What is inside a closed mesh crosses no surface: its inside at both ends. Whoever is inside it
  // only in between has crossed what the surface sweeps.
  if (body.has_closed_soup()) {
    parts.push_back({itself, motion.pose(0)});
    parts.push_back({itself, motion.pose(1)});
  }
  return parts;
}

Bounds swept_bounds(const Body& body, const Motion& motion) { return Sweep(body, motion).bounds(); }

}  // namespace rubicon::collision
