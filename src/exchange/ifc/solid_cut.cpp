#include "src/exchange/ifc/solid_cut.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "src/exchange/ifc/solid_split.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::ifc {

namespace {

using math::Vec3;
using Triangle = std::array<int, 3>;
using Edge = std::pair<int, int>;

using math::at;

std::optional<HalfSpace> plane_of(const Solid& solid, const Triangle& t) {
  const Vec3& a = solid.points[at(t[0])];
  const Vec3& b = solid.points[at(t[1])];
  const Vec3& c = solid.points[at(t[2])];
  const Vec3 n = (b - a).cross(c - a);
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  // Narrower than this a triangle says nothing about the direction of its plane.
  if (!(n.norm() > 4 * kOnPlane * longest)) return std::nullopt;
  const Vec3 unit = n.normalized();
  return HalfSpace{unit, unit.dot((a + b + c) / 3)};
}

bool same_plane(const HalfSpace& a, const HalfSpace& b) {
  // Directions differ by less than kOnPlane over 20 m.
  constexpr double kParallel = 1e-7;
  return (a.n - b.n).norm() < kParallel && std::fabs(a.w - b.w) < kOnPlane;
}

/// The planes of the faces, each once.
std::vector<HalfSpace> face_planes(const Solid& solid, WorkBudget& budget) {
  std::vector<HalfSpace> planes;
  for (const Triangle& t : solid.triangles) {
    const auto plane = plane_of(solid, t);
    if (!plane || !budget.spend(planes.size() + 1)) continue;
    const bool known = std::any_of(planes.begin(), planes.end(),
                                   [&](const HalfSpace& p) { return same_plane(p, *plane); });
    if (!known) planes.push_back(*plane);
  }
  return planes;
}

/// The corners that triangles use.
std::vector<int> used_corners(const Solid& solid) {
  std::vector<int> used;
  for (const Triangle& t : solid.triangles) used.insert(used.end(), t.begin(), t.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

bool is_beyond(const Solid& solid, const std::vector<int>& corners, const HalfSpace& plane) {
  return std::all_of(corners.begin(), corners.end(),
                     [&](int i) { return plane.n.dot(solid.points[at(i)]) >= plane.w - kOnPlane; });
}

/// The part of a body inside of a cell. Nothing if it cannot be cut.
std::optional<SolidPart> part_inside(const Solid& body, const Cell& cell, WorkBudget& budget) {
  SolidPart part = whole(body);
  const std::vector<int> corners = used_corners(body);
  for (const HalfSpace& plane : cell) {
    if (!budget.spend(corners.size())) return std::nullopt;
    if (is_beyond(body, corners, plane)) return SolidPart{};
  }
  for (const HalfSpace& plane : cell) {
    std::optional<SplitSolid> both = split(part, plane, budget);
    if (!both) return std::nullopt;
    part = std::move(both->inside);
    if (part.solid.triangles.empty()) return part;
  }
  return part;
}

/// Takes a part that split() made of a body away from it. Triangles of the body that the part has
/// a share of are cut anew; corners of the part on their edges are put in on both sides of an edge.
class PartRemover {
 public:
  PartRemover(const Solid& body, const SolidPart& part) : body_(body), part_(part) {}

  std::optional<Solid> remove(WorkBudget& budget) {
    sort_part();
    find_edge_corners();
    Solid result;
    result.points = part_.solid.points;
    for (std::size_t i = 0; i < body_.triangles.size(); ++i) {
      if (!put_rest(static_cast<int>(i), result, budget)) return std::nullopt;
    }
    for (const Triangle& t : cut_) result.triangles.push_back({t[0], t[2], t[1]});
    return result;
  }

 private:
  void sort_part() {
    for (std::size_t i = 0; i < part_.source.size(); ++i) {
      const Triangle& t = part_.solid.triangles[i];
      if (part_.source[i] == kFromCut) {
        cut_.push_back(t);
      } else {
        of_triangle_[part_.source[i]].push_back(t);
      }
    }
  }

  void find_edge_corners() {
    for (const auto& [face, parts] : of_triangle_) {
      for (const Triangle& t : parts) {
        for (const int corner : t) {
          const auto edge = part_.edge_of.find(corner);
          if (edge == part_.edge_of.end()) continue;
          std::vector<int>& list = on_edge_[edge->second];
          if (std::find(list.begin(), list.end(), corner) == list.end()) list.push_back(corner);
        }
      }
    }
  }

  bool put_rest(int face, Solid& result, WorkBudget& budget) const {
    const Triangle& t = body_.triangles[at(face)];
    std::vector<Edge> edges;
    bool plain = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const Loop line = along(t[k], t[(k + 1) % 3]);
      plain = plain && line.size() == 2;
      for (std::size_t i = 1; i < line.size(); ++i) edges.emplace_back(line[i - 1], line[i]);
    }
    const auto taken = of_triangle_.find(face);
    if (taken == of_triangle_.end() && plain) {
      result.triangles.push_back(t);
      return true;
    }
    if (taken != of_triangle_.end()) {
      for (const Triangle& each : taken->second) {
        for (std::size_t k = 0; k < 3; ++k) edges.emplace_back(each[(k + 1) % 3], each[k]);
      }
    }
    const Vec3 normal = loop_normal(body_.points, {t[0], t[1], t[2]});
    const auto loops = border_loops(result.points, std::move(edges), normal);
    if (!loops) return false;
    if (loops->empty()) return true;
    const auto rest = triangulate(result.points, *loops, normal, budget, 2 * kOnPlane);
    if (!rest) return false;
    result.triangles.insert(result.triangles.end(), rest->begin(), rest->end());
    return true;
  }

  /// From a to b over the corners between.
  Loop along(int a, int b) const {
    Loop line{a};
    const auto found = on_edge_.find(std::minmax(a, b));
    if (found != on_edge_.end()) {
      line.insert(line.end(), found->second.begin(), found->second.end());
      const Vec3 from = body_.points[at(a)];
      std::sort(line.begin() + 1, line.end(), [&](int i, int k) {
        return (part_.solid.points[at(i)] - from).squaredNorm() <
               (part_.solid.points[at(k)] - from).squaredNorm();
      });
    }
    line.push_back(b);
    return line;
  }

  const Solid& body_;
  const SolidPart& part_;
  std::vector<Triangle> cut_;
  std::map<int, std::vector<Triangle>> of_triangle_;
  std::map<Edge, std::vector<int>> on_edge_;  ///< corners between the ends
};

/// Without corners that nothing uses.
Solid compact(const Solid& solid) {
  Solid result;
  std::map<int, int> place;
  for (const Triangle& t : solid.triangles) {
    Triangle moved{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [found, is_new] = place.try_emplace(t[k], static_cast<int>(result.points.size()));
      if (is_new) result.points.push_back(solid.points[at(t[k])]);
      moved[k] = found->second;
    }
    result.triangles.push_back(moved);
  }
  return result;
}

/// Whether a volume is as it must be: what rounding and kOnPlane make of a surface is allowed.
bool agrees(const Solid& solid, double expected, double size) {
  return std::fabs(volume_of(solid) - expected) <= 1e-4 * std::fabs(expected) + kShift * size;
}

/// Area of a body's surface, for the bound of its volume's error.
double area_of(const Solid& solid) {
  double sum = 0;
  for (const Triangle& t : solid.triangles) {
    sum += loop_normal(solid.points, {t[0], t[1], t[2]}).norm() / 2;
  }
  return sum;
}

std::optional<Solid> subtract_once(const Solid& body, const Cell& cell, WorkBudget& budget) {
  if (cell.size() == 1) {
    const auto both = split(whole(body), cell.front(), budget);
    if (!both) return std::nullopt;
    return compact(both->outside.solid);
  }
  const std::optional<SolidPart> inside = part_inside(body, cell, budget);
  if (!inside) return std::nullopt;
  if (inside->solid.triangles.empty()) return body;
  const std::optional<Solid> rest = PartRemover(body, *inside).remove(budget);
  if (!rest || (!rest->triangles.empty() && !is_closed(*rest))) return std::nullopt;
  const double expected = volume_of(body) - volume_of(inside->solid);
  if (!agrees(*rest, expected, area_of(body))) return std::nullopt;
  return compact(*rest);
}

std::optional<Solid> intersect_once(const Solid& body, const Cell& cell, WorkBudget& budget) {
  const std::optional<SolidPart> inside = part_inside(body, cell, budget);
  if (!inside) return std::nullopt;
  return compact(inside->solid);
}

/// Tries with the planes as they are, then a little farther out and in.
template <class F>
std::optional<Solid> with_shifts(const Cell& cell, F f) {
  for (const double shift : {0.0, kShift / 3, -kShift / 3, kShift}) {
    Cell moved = cell;
    for (HalfSpace& plane : moved) plane.w += shift;
    if (std::optional<Solid> done = f(moved)) return done;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::vector<Cell>> convex_cells(const Solid& body, WorkBudget& budget) {
  constexpr std::size_t kMostCells = 512;
  std::vector<Cell> cells;
  std::vector<Solid> pending{body};
  while (!pending.empty()) {
    const Solid solid = std::move(pending.back());
    pending.pop_back();
    if (cells.size() + pending.size() > kMostCells) return std::nullopt;
    const std::vector<HalfSpace> planes = face_planes(solid, budget);
    const std::vector<int> corners = used_corners(solid);
    const HalfSpace* reflex = nullptr;
    for (const HalfSpace& plane : planes) {
      if (!budget.spend(corners.size())) return std::nullopt;
      const bool beyond = std::any_of(corners.begin(), corners.end(), [&](int i) {
        return plane.n.dot(solid.points[at(i)]) > plane.w + 2 * kOnPlane;
      });
      if (beyond) {
        reflex = &plane;
        break;
      }
    }
    if (reflex == nullptr) {
      if (planes.size() > 3) cells.push_back(planes);
      continue;
    }
    const auto both = split(whole(solid), *reflex, budget);
    if (!both || both->inside.solid.triangles.empty() || both->outside.solid.triangles.empty()) {
      return std::nullopt;
    }
    pending.push_back(compact(both->outside.solid));
    pending.push_back(compact(both->inside.solid));
  }
  return cells;
}

std::optional<Solid> subtract(const Solid& body, const Cell& cell, WorkBudget& budget) {
  return with_shifts(cell, [&](const Cell& moved) { return subtract_once(body, moved, budget); });
}

std::optional<Solid> intersect(const Solid& body, const Cell& cell, WorkBudget& budget) {
  return with_shifts(cell, [&](const Cell& moved) { return intersect_once(body, moved, budget); });
}

}  // namespace rubicon::ifc
