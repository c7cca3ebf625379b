#include "src/motion/travel/vision.hpp"

#include <algorithm>
#include <cmath>

namespace rubicon::travel {
namespace {

/// m; see the header.
constexpr double kSamePoint = 1e-7;

double cross_of(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

View::View(const Outline& outline, const Vec2& eye, double radius)
    : outline_(outline), eye_(eye), radius_(radius) {
  for (const Composite& composite : outline.composites()) {
    if (composite.pieces.empty()) continue;
    for (const Edge& edge : composite.edges) {
      const auto& from = composite.nodes[static_cast<std::size_t>(edge.from)];
      const auto& to = composite.nodes[static_cast<std::size_t>(edge.to)];
      const double along = std::clamp((eye - from.p).dot(edge.heading), 0.0, edge.length);
      if ((from.p + along * edge.heading - eye).norm() > radius + kSamePoint) continue;
      walls_.push_back({from.p, to.p, edge.heading});
      if (!composite.pinch[static_cast<std::size_t>(edge.from)]) continue;
      const Edge& in = composite.edges[static_cast<std::size_t>(edge.previous)];
      pinches_.push_back({from.p, in.heading, edge.heading,
                          turn(in.line_a, in.line_b, edge.line_a, edge.line_b) > 0});
    }
  }
}

bool View::blocks(const Wall& wall, const Vec2& p, const Vec2& along, double length) const {
  if (std::max(wall.from.x(), wall.to.x()) < std::min(eye_.x(), p.x()) - kSamePoint ||
      std::min(wall.from.x(), wall.to.x()) > std::max(eye_.x(), p.x()) + kSamePoint ||
      std::max(wall.from.y(), wall.to.y()) < std::min(eye_.y(), p.y()) - kSamePoint ||
      std::min(wall.from.y(), wall.to.y()) > std::max(eye_.y(), p.y()) + kSamePoint) {
    return false;
  }
  const double at_from = cross_of(along, wall.from - eye_);
  const double at_to = cross_of(along, wall.to - eye_);
  if (std::fabs(at_from) <= kSamePoint || std::fabs(at_to) <= kSamePoint) return false;
  if ((at_from > 0) == (at_to > 0)) return false;
  const double at_eye = cross_of(wall.heading, eye_ - wall.from);
  const double at_p = cross_of(wall.heading, p - wall.from);
  return std::fabs(at_eye) > kSamePoint && std::fabs(at_p) > kSamePoint && length > kSamePoint &&
         (at_eye > 0) != (at_p > 0);
}

bool View::passes_pinches(const Vec2& along, double length) const {
  const auto admits = [](const Pinch& pinch, const Vec2& way) {
    constexpr double kAlong = -1e-9;
    const bool left_of_in = cross_of(pinch.in, way) >= kAlong;
    const bool left_of_out = cross_of(pinch.out, way) >= kAlong;
    return pinch.turns_left ? left_of_in && left_of_out : left_of_in || left_of_out;
  };
  for (const Pinch& pinch : pinches_) {
    const Vec2 way = pinch.point - eye_;
    const double distance = way.dot(along);
    if (distance <= kSamePoint || distance >= length - kSamePoint) continue;
    if (std::fabs(cross_of(along, way)) > kSamePoint) continue;
    const bool open = std::any_of(pinches_.begin(), pinches_.end(), [&](const Pinch& corner) {
      return corner.point == pinch.point && admits(corner, along) && admits(corner, -along);
    });
    if (!open) return false;
  }
  return true;
}

bool View::in_the_open(const Vec2& p) const {
  if (!outline_.covers(nearby(p))) return true;
  // On an edge, but for rounding?
  return std::any_of(walls_.begin(), walls_.end(), [&p](const Wall& wall) {
    const double along =
        std::clamp((p - wall.from).dot(wall.heading), 0.0, (wall.to - wall.from).norm());
    return (wall.from + along * wall.heading - p).norm() <= kSamePoint;
  });
}

bool View::sees(const Vec2& p) const {
  const Vec2 way = p - eye_;
  const double length = way.norm();
  if (length > radius_ + kSamePoint) return false;
  if (length <= kSamePoint) return true;
  const Vec2 along = way / length;
  std::vector<double> touched{0, length};
  for (const Wall& wall : walls_) {
    if (blocks(wall, p, along, length)) return false;
    const Vec2 corner = wall.from - eye_;
    const double distance = corner.dot(along);
    if (distance > 0 && distance < length && std::fabs(cross_of(along, corner)) <= kSamePoint) {
      touched.push_back(distance);
    }
  }
  if (!passes_pinches(along, length)) return false;
  std::sort(touched.begin(), touched.end());
  for (std::size_t i = 0; i + 1 < touched.size(); ++i) {
    if (touched[i + 1] - touched[i] <= 2 * kSamePoint) continue;
    if (!in_the_open(eye_ + (touched[i] + touched[i + 1]) / 2 * along)) return false;
  }
  return true;
}

std::vector<double> View::breaks(const Vec2& a, const Vec2& b) const {
  std::vector<double> shares{0, 1};
  const auto add = [&shares](double share) {
    if (share > 0 && share < 1) shares.push_back(share);
  };
  const Vec2 way = b - a;
  const double square = way.squaredNorm();
  if (square == 0) return {0, 1};
  const Vec2 from_eye = a - eye_;
  const double half = from_eye.dot(way) / square;
  const double root = half * half - (from_eye.squaredNorm() - radius_ * radius_) / square;
  if (root > 0) {
    add(-half - std::sqrt(root));
    add(-half + std::sqrt(root));
  }
  for (const Wall& wall : walls_) {
    // Where the line of sight past the corner, and the wall itself, meet the way.
    const Vec2 sight = wall.from - eye_;
    const double across = cross_of(way, sight);
    if (std::fabs(across) > 1e-12) add(-cross_of(from_eye, sight) / across);
    const double across_wall = cross_of(way, wall.heading);
    if (std::fabs(across_wall) > 1e-12) add(cross_of(wall.from - a, wall.heading) / across_wall);
  }
  std::sort(shares.begin(), shares.end());
  return shares;
}

double View::seen_up_to(const Vec2& a, const Vec2& b) const {
  const std::vector<double> shares = breaks(a, b);
  const double length = (b - a).norm();
  for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
    if ((shares[i + 1] - shares[i]) * length <= kSamePoint) continue;
    if (!sees(a + (shares[i] + shares[i + 1]) / 2 * (b - a))) return shares[i];
  }
  return 1;
}

std::optional<SeenPart> View::last_seen(const Vec2& a, const Vec2& b) const {
  const std::vector<double> shares = breaks(a, b);
  const double length = (b - a).norm();
  for (std::size_t i = shares.size() - 1; i > 0; --i) {
    if ((shares[i] - shares[i - 1]) * length <= kSamePoint) continue;
    const double middle = (shares[i] + shares[i - 1]) / 2;
    const Vec2 p = a + middle * (b - a);
    if (sees(p) && !outline_.covers(nearby(p))) return SeenPart{middle, shares[i]};
  }
  return std::nullopt;
}

}  // namespace rubicon::travel
