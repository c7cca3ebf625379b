#include "src/motion/collision/pair/surface_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "src/motion/collision/base/tolerances.hpp"
#include "src/motion/collision/convex/convex.hpp"
#include "src/motion/collision/mesh/winding.hpp"

namespace rubicon::collision {
namespace {

/// Steps (of some tenths of a microsecond) of one search; then the bodies are said to overlap.
constexpr std::int64_t kMostSteps = std::int64_t{1} << 23;
/// A piece with more triangles near it is halved first, so many times at most.
constexpr std::size_t kFewNear = 8;
constexpr int kMostHalvings = 24;
/// Halves that together have more of the triangles near them than this are not made.
constexpr double kUsefulHalves = 1.4;

/// How much of the points within the tolerance of a triangle is cut away at once: their part up to
/// this height, and the margin it leaves (its square and that of the height add up to 1), as shares
/// of the tolerance. Enough to see that two surfaces touch.
constexpr double kHeightShare = 0.8;
constexpr double kMarginShare = 0.6;
constexpr double kSideShare = 0.9;
/// Triangles that are lower than this share of the tolerance are cut away as a whole.
constexpr double kLowShare = 0.95;

/// All points within the tolerance of a triangle, up to some percent of it.
struct Level {
  double height;
  double margin;
  double fullness;
};
constexpr Level kLevels[] = {{0.9995, 0.0316, 0.9}, {0.966, 0.258, 0.9}, {0.866, 0.5, 0.9},
                             {0.6, 0.8, 0.9},       {0.6, 0.8, 0.99},    {0.259, 0.965, 0.9},
                             {0.259, 0.965, 0.99},  {0.03, 0.9995, 0.99}};

/// A point that is deep by this share of the tolerance more than it is not missed.
constexpr double kDeepResolution = 0.02;
constexpr int kMostDeepLooks = 4000;

/// A box is not under a plane if it is less under it than this share of what is allowed.
constexpr double kNotUnder = 0.1;
/// The product of unit normals of triangles of nearly one plane, and of planes that may be one.
constexpr double kNearlyOnePlane = 0.99;
constexpr double kPerhapsOnePlane = 0.8;

/// Where two surfaces lie in each other with both solids on one side, the point under them is
/// looked for at this share of what is allowed.
constexpr double kUnder = 1.01;
/// Faces are of one plane if the product of their unit normals is more than this.
constexpr double kOnePlane = 0.9;
/// Two triangles whose common part is narrower (m) have none.
constexpr double kNarrow = 1e-9;

struct FlatBounds {
  explicit FlatBounds(const FlatPolygon& polygon) : lower(polygon.front()), upper(lower) {
    for (const Vec2& corner : polygon) {
      lower = lower.cwiseMin(corner);
      upper = upper.cwiseMax(corner);
    }
  }
  Vec2 lower;
  Vec2 upper;
};

}  // namespace

SurfaceSearch::SurfaceSearch(const MeshInside& inner, const MeshInside& outer,
                             const Placement& to_outer, double contact_tolerance)
    : inner_(inner),
      outer_(outer),
      to_outer_(to_outer),
      to_inner_(to_outer.inverse()),
      contact_tolerance_(std::max(contact_tolerance, kRoundingDepth)) {}

std::optional<Vec3> SurfaceSearch::find() {
  collect_packs();
  look_at_node(0, 0);
  return found_;
}

/// A quick proof for faces that touch from outside: no point in the box of a node is deep.
///
/// Suppose one is, and some other point of the box is not. On the way between them a point x is
/// exactly as deep as allowed. The place of the surface nearest to x is on a triangle near the box
/// whose plane x is under by that depth (if it is on an edge, then still under one of its two
/// planes, by a share of the depth that depends on the angle there and is a tenth only if the solid
/// has a slit narrower than 12 degrees). So if the box is above all planes of triangles near it,
/// or a tenth under them, there is no x. All this is true only where surfaces have the solid on one
/// side.
bool SurfaceSearch::stays_outside(const TriangleSoup::Node& node, std::span<const int> packs) {
  if (!outer_.is_plain()) return false;
  const double least_allowed = inner_.least_allowed(contact_tolerance_);
  const Vec3 centre = to_outer_ * node.bounds.centre();
  const Vec3 half = node.bounds.half();
  Bounds around = placed(node.bounds, to_outer_);
  around.grow(Vec3::Constant(contact_tolerance_));
  int first = static_cast<int>(&node - inner_.soup().nodes().data());
  while (inner_.soup().nodes()[static_cast<std::size_t>(first)].count == 0) {
    first = inner_.soup().nodes()[static_cast<std::size_t>(first)].first;
  }
  first = inner_.soup().nodes()[static_cast<std::size_t>(first)].first;
  const Vec3 outwards = to_outer_.R * inner_.outwards(first);
  for (const int pack : packs) {
    const TrianglePack& four = outer_.soup().packs()[static_cast<std::size_t>(pack)];
    for (int i = four.first; i < four.first + four.count; ++i) {
      const Vec3& a = outer_.soup().corner(i, 0);
      const Vec3& b = outer_.soup().corner(i, 1);
      const Vec3& c = outer_.soup().corner(i, 2);
      Bounds bounds;
      bounds.add(a);
      bounds.add(b);
      bounds.add(c);
      if (around.disjoint(bounds)) continue;
      const Vec3& normal = outer_.outwards(i);
      if (normal.isZero()) return false;
      const double height = normal.dot(centre - a);
      const double reach = (to_outer_.R.transpose() * normal).cwiseAbs().dot(half);
      if (height - reach < -kNotUnder * least_allowed) return false;
      // Solids on the same side of a common plane are looked at more closely.
      if (normal.dot(outwards) > kPerhapsOnePlane) return false;
    }
  }
  if (!is_flat(node)) return false;
  const Vec3 point = to_outer_ * inner_.soup().corner(first, 0);
  return surface_within(outer_.soup(), point, least_allowed) || !outer_.holds(point);
}

/// Whether the normals of the triangles below a node are nearly the same.
bool SurfaceSearch::is_flat(const TriangleSoup::Node& node) const {
  std::vector<const TriangleSoup::Node*> open = {&node};
  std::optional<Vec3> normal;
  while (!open.empty()) {
    const TriangleSoup::Node& here = *open.back();
    open.pop_back();
    if (here.count == 0) {
      open.push_back(&inner_.soup().nodes()[static_cast<std::size_t>(here.first) + 1]);
      open.push_back(&inner_.soup().nodes()[static_cast<std::size_t>(here.first)]);
    }
    for (int i = here.first; i < here.first + here.count; ++i) {
      const Vec3 other = inner_.outwards(i);
      if (!normal) normal = other;
      if (!(normal->dot(other) > kNearlyOnePlane)) return false;
    }
  }
  return true;
}

/// The triangles below a node of the tree of `inner`; only the packs of `outer` from `begin` on
/// come near its parent.
bool SurfaceSearch::look_at_node(int node, std::size_t begin) {
  const TriangleSoup::Node& here = inner_.soup().nodes()[static_cast<std::size_t>(node)];
  if (placed(here.bounds, to_outer_).disjoint(outer_.soup().bounds())) return false;
  const std::size_t own = packs_.size();
  add_packs_near(here, begin);
  const bool result = look_at_packs(here, own);
  packs_.resize(own);
  return result;
}

/// The same; the packs from `own` on come near the node itself.
bool SurfaceSearch::look_at_packs(const TriangleSoup::Node& here, std::size_t own) {
  if (packs_.size() == own) {
    // No surface comes near: all of the node is inside, or nothing of it.
    const Vec3 point = to_outer_ * here.bounds.centre();
    return outer_.holds(point) && found(point);
  }
  if (stays_outside(here, std::span<const int>(packs_).subspan(own))) return false;
  if (here.count == 0) {
    return look_at_node(here.first, own) || look_at_node(here.first + 1, own);
  }
  for (int i = here.first; i < here.first + here.count; ++i) {
    if (look_at_triangle(i, std::span<const int>(packs_).subspan(own))) return true;
  }
  return false;
}

bool SurfaceSearch::look_at_triangle(int triangle, std::span<const int> packs) {
  Looked looked;
  looked.index = triangle;
  for (int k = 0; k < 3; ++k) looked.corners[k] = to_outer_ * inner_.soup().corner(triangle, k);
  looked.allowed = inner_.allowed(triangle, contact_tolerance_);
  const Vec3 ab = looked.corners[1] - looked.corners[0];
  const Vec3 ac = looked.corners[2] - looked.corners[0];
  looked.normal = ab.cross(ac).normalized();
  looked.u = ab.normalized();
  looked.v = looked.normal.cross(looked.u);
  const std::vector<Near> near = near_triangles(looked, packs);
  if (found_) return true;
  FlatPolygon whole;
  for (const Vec3& corner : looked.corners) whole.push_back(looked.flat(corner));
  return look_at_piece(looked, whole, near, kMostHalvings);
}

/// The triangles of `outer` that come nearer to one of `inner` than is allowed.
std::vector<SurfaceSearch::Near> SurfaceSearch::near_triangles(const Looked& looked,
                                                               std::span<const int> packs) {
  std::vector<Near> result;
  Bounds around;
  for (const Vec3& corner : looked.corners) around.add(corner);
  around.grow(Vec3::Constant(looked.allowed));
  const Vec3 outwards = to_outer_.R * inner_.outwards(looked.index);
  for (const int pack : packs) {
    if (around.disjoint(outer_.soup().pack_bounds()[static_cast<std::size_t>(pack)])) continue;
    const TrianglePack& four = outer_.soup().packs()[static_cast<std::size_t>(pack)];
    if (too_long(looked.corners[0])) return result;
    for (int i = four.first; i < four.first + four.count; ++i) {
      Bounds bounds;
      Near near;
      double lowest = std::numeric_limits<double>::infinity();
      double highest = -lowest;
      for (int k = 0; k < 3; ++k) {
        const Vec3& corner = outer_.soup().corner(i, k);
        bounds.add(corner);
        near.seen.height[k] = looked.normal.dot(corner - looked.corners[0]);
        lowest = std::min(lowest, near.seen.height[k]);
        highest = std::max(highest, near.seen.height[k]);
      }
      if (lowest > looked.allowed || highest < -looked.allowed) continue;
      if (around.disjoint(bounds)) continue;
      for (int k = 0; k < 3; ++k) near.seen.at[k] = looked.flat(outer_.soup().corner(i, k));
      near.lower = near.seen.at[0].cwiseMin(near.seen.at[1]).cwiseMin(near.seen.at[2]);
      near.upper = near.seen.at[0].cwiseMax(near.seen.at[1]).cwiseMax(near.seen.at[2]);
      near.highest = std::max(highest, -lowest);
      near.outwards = outer_.outwards(i);
      near.offset = near.outwards.dot(outer_.soup().corner(i, 0));
      near.same_side = near.outwards.dot(outwards) > kPerhapsOnePlane;
      if (solids_meet_under(looked, i, near)) return result;
      result.push_back(near);
    }
  }
  return result;
}

/// Where two triangles lie in each other and both solids on the same side of them, the solids
/// overlap, unless another surface is in between.
bool SurfaceSearch::solids_meet_under(const Looked& looked, int other, const Near& near) {
  if (!inner_.soup().closed()) return false;
  const double allowed = std::min(looked.allowed, outer_.allowed(other, contact_tolerance_));
  if (near.highest > looked.allowed) return false;
  const Vec3& a = outer_.soup().corner(other, 0);
  const Vec3 outwards = to_outer_.R * inner_.outwards(looked.index);
  const Vec3& normal = outer_.outwards(other);
  if (outwards.dot(normal) < kOnePlane) return false;
  FlatPolygon own;
  for (const Vec3& corner : looked.corners) own.push_back(looked.flat(corner));
  const FlatPolygon both = common_part(own, near.seen.at);
  if (both.size() < 3) return false;
  double around = 0;
  for (std::size_t i = 0; i < both.size(); ++i) {
    around += (both[(i + 1) % both.size()] - both[i]).norm();
  }
  if (area_of(both) <= kNarrow * around) return false;
  const Vec3 point = looked.solid(mean_of(both));
  const double gap = std::max(0.0, normal.dot(point - a) / normal.dot(outwards));
  const Vec3 under = point - (gap + kUnder * allowed) * outwards;
  if (too_long(under)) return true;
  const Vec3 under_inner = to_inner_ * under;
  const bool meet = outer_.holds(under) && inner_.holds(under_inner) &&
                    (!surface_within(outer_.soup(), under, allowed) ||
                     !surface_within(inner_.soup(), under_inner, allowed));
  return meet && found(under);
}

/// Those of some triangles that come nearer to a polygon than `reach` (m), along the plane.
std::vector<SurfaceSearch::Near> SurfaceSearch::near_to(const FlatPolygon& polygon,
                                                        const std::vector<Near>& near,
                                                        double reach) {
  std::vector<Near> result;
  if (polygon.size() < 3) return result;
  const FlatBounds bounds(polygon);
  for (const Near& one : near) {
    const bool beside = (one.lower.array() - reach > bounds.upper.array()).any() ||
                        (one.upper.array() + reach < bounds.lower.array()).any();
    if (!beside) result.push_back(one);
  }
  return result;
}

/// The proof of `stays_outside` for a piece of a triangle.
bool SurfaceSearch::touches_from_outside(const Looked& looked, const FlatPolygon& piece,
                                         const std::vector<Near>& near) const {
  if (!outer_.is_plain()) return false;
  for (const Near& one : near) {
    if (one.same_side || one.outwards.isZero()) return false;
    for (const Vec2& corner : piece) {
      const double height = one.outwards.dot(looked.solid(corner)) - one.offset;
      if (height < -kNotUnder * looked.allowed) return false;
    }
  }
  const Vec3 middle = looked.solid(mean_of(piece));
  return surface_within(outer_.soup(), middle, looked.allowed) || !outer_.holds(middle);
}

/// A convex piece of a triangle: what is farther from the other surface than allowed, is it inside?
bool SurfaceSearch::look_at_piece(const Looked& looked, const FlatPolygon& piece,
                                  const std::vector<Near>& near, int halvings) {
  const Vec3 middle = looked.solid(mean_of(piece));
  if (too_long(middle, static_cast<std::int64_t>(near.size()) + 1)) return true;
  if (near.empty()) return outer_.holds(middle) && found(middle);
  if (touches_from_outside(looked, piece, near)) return false;
  if (near.size() > kFewNear && halvings > 0) {
    const FlatBounds bounds(piece);
    int axis = 0;
    (bounds.upper - bounds.lower).maxCoeff(&axis);
    const double cut = 0.5 * (bounds.lower[axis] + bounds.upper[axis]);
    const Vec2 normal = Vec2::Unit(axis);
    std::array<FlatPolygon, 2> halves = {part_below(piece, normal, cut),
                                         part_below(piece, -normal, -cut)};
    std::array<std::vector<Near>, 2> left;
    for (int i = 0; i < 2; ++i) left[i] = near_to(halves[i], near, looked.allowed);
    // Where triangles meet in a corner or lie side by side as slivers halves do not help.
    if (static_cast<double>(left[0].size() + left[1].size()) <
        kUsefulHalves * static_cast<double>(near.size())) {
      for (int i = 0; i < 2; ++i) {
        if (halves[i].size() < 3) continue;
        if (look_at_piece(looked, halves[i], left[i], halvings - 1)) return true;
      }
      return false;
    }
  }
  std::vector<FlatPolygon> open = {piece};
  std::vector<FlatPolygon> rest;
  for (const Near& one : near) {
    const double allowed = looked.allowed;
    const bool low = one.highest <= kLowShare * allowed;
    const double height = low ? one.highest : kHeightShare * allowed;
    const double margin =
        low ? std::sqrt(allowed * allowed - one.highest * one.highest) : kMarginShare * allowed;
    const FlatRegion region(one.seen, height, margin, kSideShare);
    rest.clear();
    for (const FlatPolygon& polygon : open) region.cut_from(polygon, rest);
    if (too_long(middle, static_cast<std::int64_t>(open.size()))) return true;
    std::swap(open, rest);
    if (open.empty()) return false;
  }
  for (const FlatPolygon& polygon : open) {
    if (look_at_rest(looked, polygon, near)) return true;
  }
  return false;
}

/// A convex piece that no other surface crosses.
bool SurfaceSearch::look_at_rest(const Looked& looked, const FlatPolygon& rest,
                                 const std::vector<Near>& near) {
  const Vec3 middle = looked.solid(mean_of(rest));
  if (too_long(middle)) return true;
  if (!outer_.holds(middle)) return false;
  if (!surface_within(outer_.soup(), middle, looked.allowed)) return found(middle);
  std::vector<FlatPolygon> open = {rest};
  std::vector<FlatPolygon> left;
  for (const Near& one : near) {
    for (const Level& level : kLevels) {
      const FlatRegion region(one.seen, level.height * looked.allowed,
                              level.margin * looked.allowed, level.fullness);
      if (region.empty()) continue;
      left.clear();
      for (const FlatPolygon& polygon : open) region.cut_from(polygon, left);
      if (too_long(middle, static_cast<std::int64_t>(open.size()))) return true;
      std::swap(open, left);
      if (open.empty()) return false;
    }
  }
  return std::any_of(open.begin(), open.end(),
                     [&](const FlatPolygon& polygon) { return deep_somewhere(looked, polygon); });
}

/// Branch and bound for the point that is farthest from the surface around.
bool SurfaceSearch::deep_somewhere(const Looked& looked, const FlatPolygon& rest) {
  using Corners = std::array<Vec3, 3>;
  std::vector<Corners> open;
  for (std::size_t i = 2; i < rest.size(); ++i) {
    open.push_back({looked.solid(rest[0]), looked.solid(rest[i - 1]), looked.solid(rest[i])});
  }
  const double allowed = looked.allowed;
  for (int looks = 0; !open.empty(); ++looks) {
    const Corners corners = open.back();
    open.pop_back();
    const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    if (looks == kMostDeepLooks || too_long(middle)) return found(middle);
    double radius = 0;
    for (const Vec3& corner : corners) radius = std::max(radius, (corner - middle).norm());
    if (!surface_within(outer_.soup(), middle, allowed)) return found(middle);
    if (radius <= kDeepResolution * allowed) continue;
    if (radius < allowed && surface_within(outer_.soup(), middle, allowed - radius)) continue;
    int longest = 0;
    for (int k = 1; k < 3; ++k) {
      if ((corners[(k + 1) % 3] - corners[k]).squaredNorm() >
          (corners[(longest + 1) % 3] - corners[longest]).squaredNorm()) {
        longest = k;
      }
    }
    const Vec3 between = 0.5 * (corners[longest] + corners[(longest + 1) % 3]);
    const Vec3& opposite = corners[(longest + 2) % 3];
    open.push_back({corners[longest], between, opposite});
    open.push_back({between, corners[(longest + 1) % 3], opposite});
  }
  return false;
}

bool SurfaceSearch::found(const Vec3& point) {
  found_ = point;
  return true;
}

bool SurfaceSearch::too_long(const Vec3& point, std::int64_t steps) {
  steps_ += steps;
  return steps_ > kMostSteps && found(point);
}

}  // namespace rubicon::collision
