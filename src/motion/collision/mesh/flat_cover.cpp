#include "src/motion/collision/mesh/flat_cover.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/motion/collision/base/polygon.hpp"

namespace rubicon::collision {
namespace {

/// Corners nearer to each other than this share of the margin are one; what sticks out by less is
/// dropped. Far above rounding, far below the margin.
constexpr double kNegligibleShare = 1e-3;
/// Sums of two unit vectors shorter than this have no direction.
constexpr double kOpposite = 1e-6;

Vec2 turned_right(const Vec2& a) { return {a.y(), -a.x()}; }

/// A few corners, on the stack. A triangle has no more than seven between two heights, twice
/// counted ones included.
struct FewCorners {
  std::array<Vec2, 8> at;
  std::size_t count = 0;

  void add(const Vec2& corner) { at[count++] = corner; }
  /// Unless one of them is as near as that.
  void add_new(const Vec2& corner, double same) {
    for (std::size_t i = 0; i < count; ++i) {
      if ((corner - at[i]).squaredNorm() < same * same) return;
    }
    add(corner);
  }
};

/// The corners of the part of a triangle between two heights, in the order of its rim.
FewCorners part_between(const SeenTriangle& triangle, double height, double same) {
  FewCorners corners;
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    const double from = triangle.height[k];
    const double to = triangle.height[next];
    if (std::fabs(from) <= height) corners.add_new(triangle.at[k], same);
    const double first = from < to ? -height : height;
    for (const double level : {first, -first}) {
      if ((from < level) == (to < level)) continue;
      const double share = (level - from) / (to - from);
      corners.add_new(triangle.at[k] + share * (triangle.at[next] - triangle.at[k]), same);
    }
  }
  return corners;
}

/// Andrew 1979.
FewCorners hull_of(FewCorners corners) {
  if (corners.count < 3) return corners;
  const auto before = [](const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  };
  for (std::size_t i = 1; i < corners.count; ++i) {
    for (std::size_t k = i; k > 0 && before(corners.at[k], corners.at[k - 1]); --k) {
      std::swap(corners.at[k], corners.at[k - 1]);
    }
  }
  FewCorners hull;
  const auto add_to_chain = [&](std::size_t first, const Vec2& corner) {
    while (hull.count >= first + 2 && cross(hull.at[hull.count - 1] - hull.at[hull.count - 2],
                                            corner - hull.at[hull.count - 1]) <= 0) {
      --hull.count;
    }
    hull.add(corner);
  };
  for (std::size_t i = 0; i < corners.count; ++i) add_to_chain(0, corners.at[i]);
  const std::size_t last = --hull.count;
  for (std::size_t i = corners.count; i-- > 0;) add_to_chain(last, corners.at[i]);
  --hull.count;
  return hull;
}

}  // namespace

FlatRegion::FlatRegion(const SeenTriangle& triangle, double height, double along, double fullness) {
  negligible_ = kNegligibleShare * along;
  const FewCorners hull = hull_of(part_between(triangle, height, negligible_));
  if (hull.count == 0) return;
  if (hull.count == 1) {
    const double half = std::sqrt(0.5) * along;
    for (const Vec2& normal : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)}) {
      add_side(normal, normal.dot(hull.at[0]) + half);
    }
    return;
  }
  // Sides are moved out by `fullness` of the margin and corners cut off where they would be farther
  // out than the margin: at a corner that turns by 2 t the cut passes through the points of the
  // sides at the margin's distance.
  const double rest = std::sqrt(1 - fullness * fullness);
  std::array<Vec2, 8> along_side;
  for (std::size_t i = 0; i < hull.count; ++i) {
    along_side[i] = (hull.at[(i + 1) % hull.count] - hull.at[i]).normalized();
  }
  for (std::size_t i = 0; i < hull.count; ++i) {
    const std::size_t next = (i + 1) % hull.count;
    const Vec2 normal = turned_right(along_side[i]);
    add_side(normal, normal.dot(hull.at[i]) + fullness * along);
    const Vec2 sum = normal + turned_right(along_side[next]);
    const double length = sum.norm();
    const Vec2 bisector = length > kOpposite ? Vec2(sum / length) : along_side[i];
    const double cosine = std::clamp(normal.dot(bisector), 0.0, 1.0);
    if (fullness <= cosine) continue;  // the corner of the sides is near enough
    const double sine = std::sqrt(1 - cosine * cosine);
    add_side(bisector, bisector.dot(hull.at[next]) + along * (fullness * cosine + rest * sine));
  }
}

void FlatRegion::cut_from(const FlatPolygon& polygon, std::vector<FlatPolygon>& rest) const {
  const auto beside = [&](const Side& side) {
    return std::all_of(polygon.begin(), polygon.end(),
                       [&](const Vec2& corner) { return side.normal.dot(corner) >= side.offset; });
  };
  const auto end = sides_.begin() + static_cast<std::ptrdiff_t>(count_);
  if (empty() || std::any_of(sides_.begin(), end, beside)) {
    rest.push_back(polygon);
    return;
  }
  const std::size_t first = rest.size();
  FlatPolygon inside = polygon;
  for (auto at = sides_.begin(); at != end; ++at) {
    const Side& side = *at;
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
