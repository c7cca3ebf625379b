#include "src/collision/flat_cover.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubicon::collision {
namespace {

/// Corners nearer to each other than this share of the margin are one; what sticks out by less is
/// dropped. Far above rounding, far below the margin.
constexpr double kNegligibleShare = 1e-3;
/// Sums of two unit vectors shorter than this have no direction.
constexpr double kOpposite = 1e-6;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }
Vec2 turned_right(const Vec2& a) { return {a.y(), -a.x()}; }

/// The corners of the part of a triangle between two heights.
std::vector<Vec2> part_between(const SeenTriangle& triangle, double height) {
  std::vector<Vec2> corners;
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    const double from = triangle.height[k];
    const double to = triangle.height[next];
    if (std::fabs(from) <= height) corners.push_back(triangle.at[k]);
    std::array<double, 2> shares{};
    int count = 0;
    for (const double level : {-height, height}) {
      if ((from < level) != (to < level)) shares[count++] = (level - from) / (to - from);
    }
    for (int i = 0; i < count; ++i) {
      corners.push_back(triangle.at[k] + shares[i] * (triangle.at[next] - triangle.at[k]));
    }
  }
  return corners;
}

/// Andrew 1979. Corners that nearly coincide are taken for one.
FlatPolygon hull_of(std::vector<Vec2> corners, double same) {
  std::sort(corners.begin(), corners.end(), [](const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  std::vector<Vec2> kept;
  for (const Vec2& corner : corners) {
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const Vec2& other) {
      return (corner - other).squaredNorm() < same * same;
    });
    if (!known) kept.push_back(corner);
  }
  if (kept.size() < 3) return kept;
  FlatPolygon hull;
  const auto add_chain = [&](auto begin, auto end) {
    const std::size_t first = hull.size();
    for (auto at = begin; at != end; ++at) {
      while (hull.size() >= first + 2 &&
             cross(hull.back() - hull[hull.size() - 2], *at - hull.back()) <= 0) {
        hull.pop_back();
      }
      hull.push_back(*at);
    }
    hull.pop_back();
  };
  add_chain(kept.begin(), kept.end());
  add_chain(kept.rbegin(), kept.rend());
  return hull;
}

}  // namespace

FlatRegion::FlatRegion(const SeenTriangle& triangle, double height, double along, double fullness) {
  negligible_ = kNegligibleShare * along;
  const FlatPolygon hull = hull_of(part_between(triangle, height), negligible_);
  if (hull.empty()) return;
  // Sides are moved out by `fullness` of the margin and corners cut off where they would be farther
  // out than the margin: at a corner that turns by 2 t the cut passes through the points of the
  // sides at the margin's distance.
  const double rest = std::sqrt(1 - fullness * fullness);
  if (hull.size() == 1) {
    const double half = std::sqrt(0.5) * along;
    for (const Vec2& normal : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)}) {
      sides_.push_back({normal, normal.dot(hull.front()) + half});
    }
    return;
  }
  const std::size_t count = hull.size();
  const auto direction = [&](std::size_t i) {
    return Vec2((hull[(i + 1) % count] - hull[i % count]).normalized());
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 along_side = direction(i);
    const Vec2 normal = turned_right(along_side);
    sides_.push_back({normal, normal.dot(hull[i]) + fullness * along});
    const Vec2 next = turned_right(direction(i + 1));
    const Vec2& corner = hull[(i + 1) % count];
    const Vec2 sum = normal + next;
    const Vec2 bisector = sum.norm() > kOpposite ? Vec2(sum.normalized()) : along_side;
    const double cosine = std::clamp(normal.dot(bisector), 0.0, 1.0);
    if (fullness <= cosine) continue;  // the corner of the sides is near enough
    const double sine = std::sqrt(1 - cosine * cosine);
    sides_.push_back({bisector, bisector.dot(corner) + along * (fullness * cosine + rest * sine)});
  }
}

void FlatRegion::cut_from(const FlatPolygon& polygon, std::vector<FlatPolygon>& rest) const {
  const auto beside = [&](const Side& side) {
    return std::all_of(polygon.begin(), polygon.end(),
                       [&](const Vec2& corner) { return side.normal.dot(corner) >= side.offset; });
  };
  if (sides_.empty() || std::any_of(sides_.begin(), sides_.end(), beside)) {
    rest.push_back(polygon);
    return;
  }
  const std::size_t first = rest.size();
  FlatPolygon inside = polygon;
  for (const Side& side : sides_) {
    double farthest = 0;
    for (const Vec2& corner : inside) {
      farthest = std::max(farthest, side.normal.dot(corner) - side.offset);
    }
    if (farthest <= negligible_) continue;
    FlatPolygon outside = part_below(inside, -side.normal, -side.offset);
    if (outside.size() >= 3) rest.push_back(std::move(outside));
    inside = part_below(inside, side.normal, side.offset);
    if (inside.size() >= 3) continue;
    // Near a corner of the region, but outside of it.
    rest.resize(first);
    rest.push_back(polygon);
    return;
  }
}

FlatPolygon part_below(const FlatPolygon& polygon, const Vec2& normal, double offset) {
  FlatPolygon result;
  result.reserve(polygon.size() + 1);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& from = polygon[i];
    const Vec2& to = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const double at_from = normal.dot(from) - offset;
    const double at_to = normal.dot(to) - offset;
    if (at_from <= 0) result.push_back(from);
    if ((at_from < 0 && at_to > 0) || (at_from > 0 && at_to < 0)) {
      result.push_back(from + at_from / (at_from - at_to) * (to - from));
    }
  }
  return result;
}

FlatPolygon common_part(const FlatPolygon& polygon, const std::array<Vec2, 3>& triangle) {
  const bool clockwise = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]) < 0;
  FlatPolygon result = polygon;
  for (int k = 0; k < 3 && result.size() >= 3; ++k) {
    Vec2 normal = turned_right(triangle[(k + 1) % 3] - triangle[k]);
    if (clockwise) normal = -normal;
    result = part_below(result, normal, normal.dot(triangle[k]));
  }
  return result;
}

double area_of(const FlatPolygon& polygon) {
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    twice += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  }
  return 0.5 * twice;
}

Vec2 mean_of(const FlatPolygon& polygon) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& corner : polygon) sum += corner;
  return sum / static_cast<double>(polygon.size());
}

}  // namespace rubicon::collision
