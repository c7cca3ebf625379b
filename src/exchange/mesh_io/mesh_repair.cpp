#include "src/exchange/mesh_io/mesh_repair.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

#include "src/motion/math/index.hpp"

namespace rubicon::mesh_io {

namespace {

using geometry::Vec3;
using Triangle = std::array<int, 3>;

using math::at;

double weld_tolerance(const std::vector<Vec3>& vertices) {
  double largest = 0;
  for (const Vec3& p : vertices) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return std::min(std::max(kWeldTolerance, kWeldPerMetre * largest), kLargestWeldTolerance);
}

/// Finds an earlier point within the tolerance through a grid of cells twice as wide.
class WeldGrid {
 public:
  /// For points with indices below `count`.
  WeldGrid(double tolerance, std::size_t count)
      : tolerance_(tolerance), first_(std::bit_ceil(count + 1), -1), next_(count, -1) {}

  /// The lowest index of a point inserted so far that is near enough.
  std::optional<int> find(const std::vector<Vec3>& points, const Vec3& p) const {
    const Cell low = cell(p - Vec3::Constant(tolerance_));
    const Cell high = cell(p + Vec3::Constant(tolerance_));
    std::optional<int> best;
    for (std::int64_t x = low[0]; x <= high[0]; ++x) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t z = low[2]; z <= high[2]; ++z) {
          for (int i = first_[list_of({x, y, z})]; i >= 0; i = next_[at(i)]) {
            const bool near = (points[at(i)] - p).norm() <= tolerance_;
            if (near && (!best || i < *best)) best = i;
          }
        }
      }
    }
    return best;
  }

  void insert(const Vec3& p, int index) {
    int& first = first_[list_of(cell(p))];
    next_[at(index)] = first;
    first = index;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;

  /// Several cells may share a list: their points are too far away to be taken.
  std::size_t list_of(const Cell& c) const {
    std::uint64_t h = 0;
    for (const std::int64_t v : c) {
      h = (h ^ static_cast<std::uint64_t>(v)) * 0x9E3779B97F4A7C15ULL;
      h ^= h >> 29;
    }
    return static_cast<std::size_t>(h) & (first_.size() - 1);
  }

  Cell cell(const Vec3& p) const {
    Cell c{};
    for (int k = 0; k < 3; ++k) {
      c[at(k)] = static_cast<std::int64_t>(std::floor(p[k] / (2 * tolerance_)));
    }
    return c;
  }

  double tolerance_;
  std::vector<int> first_;  // of the list of a cell; -1: empty
  std::vector<int> next_;   // by point
};

/// For every vertex the index of the one that stands for it.
std::vector<int> weld(const std::vector<Vec3>& vertices, double tolerance, int& welded) {
  WeldGrid grid(tolerance, vertices.size());
  std::vector<int> representative(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::optional<int> earlier = grid.find(vertices, vertices[i]);
    representative[i] = earlier.value_or(static_cast<int>(i));
    if (earlier) {
      ++welded;
    } else {
      grid.insert(vertices[i], static_cast<int>(i));
    }
  }
  return representative;
}

/// The triangles on the corners that stand for theirs, without those that lose one.
std::vector<Triangle> on_welded(const std::vector<Triangle>& triangles,
                                const std::vector<int>& representative) {
  std::vector<Triangle> kept;
  kept.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    const Triangle w{representative[at(t[0])], representative[at(t[1])], representative[at(t[2])]};
    if (w[0] != w[1] && w[1] != w[2] && w[2] != w[0]) kept.push_back(w);
  }
  return kept;
}

/// The triangle begun at its smallest index, orientation kept: equal for equal triangles.
Triangle canonical(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// Indices of triangles with their canonical form, equal ones side by side.
std::vector<std::pair<Triangle, int>> in_order(const std::vector<Triangle>& triangles) {
  std::vector<std::pair<Triangle, int>> order;
  order.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    order.emplace_back(canonical(triangles[i]), static_cast<int>(i));
  }
  std::sort(order.begin(), order.end());
  return order;
}

/// Without those that are marked. How many these were.
int drop(std::vector<Triangle>& triangles, const std::vector<char>& marked) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (marked[i] == 0) triangles[kept++] = triangles[i];
  }
  const auto dropped = static_cast<int>(triangles.size() - kept);
  triangles.resize(kept);
  return dropped;
}

int drop_duplicates(std::vector<Triangle>& triangles) {
  const std::vector<std::pair<Triangle, int>> order = in_order(triangles);
  std::vector<char> duplicate(triangles.size(), 0);
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (order[i].first == order[i - 1].first) duplicate[at(order[i].second)] = 1;
  }
  return drop(triangles, duplicate);
}

/// Strikes out pairs of a triangle and the same one seen from behind. Every edge of a closed
/// surface is still used equally often in both directions; without one of two equal triangles it
/// would not be.
int drop_opposite_pairs(std::vector<Triangle>& triangles) {
  const std::vector<std::pair<Triangle, int>> order = in_order(triangles);
  const auto less = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::vector<char> struck(triangles.size(), 0);
  for (std::size_t i = 0; i < order.size();) {
    const Triangle& front = order[i].first;
    const auto [first, last] = std::equal_range(order.begin(), order.end(), order[i], less);
    const std::pair<Triangle, int> behind{{front[0], front[2], front[1]}, 0};
    const auto [back, back_last] = std::equal_range(order.begin(), order.end(), behind, less);
    const auto pairs = std::min(last - first, back_last - back);
    for (auto k = first; k < first + pairs; ++k) struck[at(k->second)] = 1;
    i = static_cast<std::size_t>(last - order.begin());
  }
  return drop(triangles, struck);
}

/// Of triangles of the same corners, whichever side they show, the first stays: many programs write
/// a front and a back of each.
int drop_same_corners(std::vector<Triangle>& triangles) {
  std::vector<std::pair<Triangle, int>> order;
  order.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    Triangle corners = triangles[i];
    std::sort(corners.begin(), corners.end());
    order.emplace_back(corners, static_cast<int>(i));
  }
  std::sort(order.begin(), order.end());
  std::vector<char> same(triangles.size(), 0);
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (order[i].first == order[i - 1].first) same[at(order[i].second)] = 1;
  }
  return drop(triangles, same);
}

bool on_a_line(const std::vector<Vec3>& v, const Triangle& t, double tolerance) {
  const Vec3 a = v[at(t[1])] - v[at(t[0])];
  const Vec3 b = v[at(t[2])] - v[at(t[0])];
  const double longest = std::max({a.norm(), b.norm(), (b - a).norm()});
  return a.cross(b).norm() <= tolerance * longest;
}

struct EdgeUse {
  int low = 0;
  int high = 0;
  int triangle = 0;
  bool forward = false;  ///< from low to high
};

/// Uses of edges, those of the same edge side by side.
std::vector<EdgeUse> edge_uses(const std::vector<Triangle>& triangles) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = triangles[i][k];
      const int to = triangles[i][(k + 1) % 3];
      uses.push_back({std::min(from, to), std::max(from, to), static_cast<int>(i), from < to});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::array{a.low, a.high, a.triangle} < std::array{b.low, b.high, b.triangle};
  });
  return uses;
}

/// Calls f(first, last) for the uses of each edge; stops and returns false when f does.
template <class F>
bool for_each_edge(const std::vector<EdgeUse>& uses, F f) {
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t j = i + 1;
    while (j < uses.size() && uses[j].low == uses[i].low && uses[j].high == uses[i].high) ++j;
    if (!f(i, j)) return false;
    i = j;
  }
  return true;
}

bool balanced(const std::vector<EdgeUse>& uses) {
  return for_each_edge(uses, [&](std::size_t first, std::size_t last) {
    std::size_t forward = 0;
    for (std::size_t i = first; i < last; ++i) forward += uses[i].forward ? 1 : 0;
    return 2 * forward == last - first;
  });
}

/// Six times the signed volume, seen from the first corner so that distance from the origin does
/// not cost digits.
double volume6(const std::vector<Vec3>& v, const std::vector<Triangle>& triangles) {
  if (triangles.empty()) return 0;
  const Vec3& origin = v[at(triangles[0][0])];
  double sum = 0;
  for (const Triangle& t : triangles) {
    const Vec3 a = v[at(t[0])] - origin;
    const Vec3 b = v[at(t[1])] - origin;
    const Vec3 c = v[at(t[2])] - origin;
    sum += a.dot(b.cross(c));
  }
  return sum;
}

double area2(const std::vector<Vec3>& v, const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& t : triangles) {
    sum += (v[at(t[1])] - v[at(t[0])]).cross(v[at(t[2])] - v[at(t[0])]).norm();
  }
  return sum;
}

/// A sheet with a front and a back.
bool encloses_nothing(const std::vector<Vec3>& v, const std::vector<Triangle>& triangles,
                      double tolerance) {
  return std::fabs(volume6(v, triangles)) <= 3 * tolerance * area2(v, triangles);
}

void turn(Triangle& t) { std::swap(t[1], t[2]); }

/// Makes neighbours agree, component by component, where every edge has exactly two triangles; a
/// component that had to be changed is turned outwards. Empty when the surface is not of that kind
/// or cannot be oriented (a Klein bottle).
std::optional<std::vector<Triangle>> oriented(const std::vector<Vec3>& v,
                                              const std::vector<Triangle>& triangles,
                                              const std::vector<EdgeUse>& uses) {
  struct Neighbour {
    int triangle = -1;
    bool agrees = false;
  };
  std::vector<std::array<Neighbour, 3>> neighbours(triangles.size());
  std::vector<std::size_t> count(triangles.size(), 0);
  const auto link = [&](const EdgeUse& a, const EdgeUse& b) {
    const std::size_t i = at(a.triangle);
    neighbours[i][count[i]++] = {b.triangle, a.forward != b.forward};
  };
  const bool surface = for_each_edge(uses, [&](std::size_t first, std::size_t last) {
    if (last - first != 2) return false;
    link(uses[first], uses[first + 1]);
    link(uses[first + 1], uses[first]);
    return true;
  });
  if (!surface) return std::nullopt;

  std::vector<Triangle> result = triangles;
  std::vector<int> turned(triangles.size(), -1);  // -1: not yet reached
  for (std::size_t seed = 0; seed < triangles.size(); ++seed) {
    if (turned[seed] != -1) continue;
    std::vector<std::size_t> component{seed};
    bool changed = false;
    turned[seed] = 0;
    for (std::size_t next = 0; next < component.size(); ++next) {
      const std::size_t i = component[next];
      for (const Neighbour& n : neighbours[i]) {
        const int wanted = n.agrees ? turned[i] : 1 - turned[i];
        const std::size_t j = at(n.triangle);
        if (turned[j] == -1) {
          turned[j] = wanted;
          changed = changed || wanted == 1;
          component.push_back(j);
        } else if (turned[j] != wanted) {
          return std::nullopt;
        }
      }
    }
    if (!changed) continue;
    std::vector<Triangle> part;
    for (const std::size_t i : component) {
      if (turned[i] == 1) turn(result[i]);
      part.push_back(result[i]);
    }
    if (volume6(v, part) < 0) {
      for (const std::size_t i : component) turn(result[i]);
    }
  }
  return result;
}

/// Parts of a surface that have no corner in common.
struct Parts {
  std::vector<int> of;  ///< each triangle's
  std::vector<Eigen::AlignedBox3d> boxes;
};

Parts parts_of(const std::vector<Vec3>& v, const std::vector<Triangle>& triangles) {
  std::vector<int> parent(v.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int i) {
    while (parent[at(i)] != i) i = parent[at(i)] = parent[at(parent[at(i)])];
    return i;
  };
  for (const Triangle& t : triangles) {
    parent[at(root(t[1]))] = root(t[0]);
    parent[at(root(t[2]))] = root(t[0]);
  }
  Parts parts;
  std::vector<int> number(v.size(), -1);
  for (const Triangle& t : triangles) {
    int& part = number[at(root(t[0]))];
    if (part < 0) {
      part = static_cast<int>(parts.boxes.size());
      parts.boxes.emplace_back();
    }
    parts.of.push_back(part);
    for (const int corner : t) parts.boxes[at(part)].extend(v[at(corner)]);
  }
  return parts;
}

/// Whether a part lies in the box of another.
bool may_be_in_another(const Parts& parts, std::size_t part) {
  for (std::size_t other = 0; other < parts.boxes.size(); ++other) {
    if (other != part && parts.boxes[other].contains(parts.boxes[part])) return true;
  }
  return false;
}

/// So many parts of a surface are looked at beside all others.
constexpr std::size_t kMostParts = 1000;

/// Whether a part of the surface may lie in another: which of them shows outwards is not known
/// where all triangles have two sides.
bool may_be_nested(const std::vector<Vec3>& v, const std::vector<Triangle>& triangles) {
  const Parts parts = parts_of(v, triangles);
  if (parts.boxes.size() > kMostParts) return true;
  for (std::size_t part = 0; part < parts.boxes.size(); ++part) {
    if (may_be_in_another(parts, part)) return true;
  }
  return false;
}

/// Turns the parts of a closed surface that are inside out and lie in no other, so are no cavity.
void turn_outwards(const std::vector<Vec3>& v, std::vector<Triangle>& triangles, double tolerance) {
  const Parts parts = parts_of(v, triangles);
  if (parts.boxes.size() < 2 || parts.boxes.size() > kMostParts) return;
  std::vector<std::vector<Triangle>> members(parts.boxes.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    members[at(parts.of[i])].push_back(triangles[i]);
  }
  std::vector<char> turned(parts.boxes.size(), 0);
  for (std::size_t part = 0; part < parts.boxes.size(); ++part) {
    if (volume6(v, members[part]) < 0 && !encloses_nothing(v, members[part], tolerance) &&
        !may_be_in_another(parts, part)) {
      turned[part] = 1;
    }
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (turned[at(parts.of[i])] != 0) turn(triangles[i]);
  }
}

/// The triangles, oriented outwards, if they enclose a volume.
std::optional<std::vector<Triangle>> closed_surface(const std::vector<Vec3>& v,
                                                    const std::vector<Triangle>& triangles,
                                                    double tolerance) {
  const std::vector<EdgeUse> uses = edge_uses(triangles);
  std::vector<Triangle> result = triangles;
  if (!balanced(uses)) {
    std::optional<std::vector<Triangle>> agreed = oriented(v, triangles, uses);
    if (!agreed) return std::nullopt;
    result = std::move(*agreed);
  }
  if (volume6(v, result) < 0) {
    for (Triangle& t : result) turn(t);
  }
  turn_outwards(v, result, tolerance);
  if (encloses_nothing(v, result, tolerance)) return std::nullopt;
  return result;
}

geometry::TriangleMesh compacted(const std::vector<Vec3>& v, const std::vector<Triangle>& t) {
  geometry::TriangleMesh mesh;
  std::vector<int> place(v.size(), -1);
  mesh.triangles.reserve(t.size());
  for (const Triangle& triangle : t) {
    Triangle moved{};
    for (std::size_t k = 0; k < 3; ++k) {
      int& index = place[at(triangle[k])];
      if (index < 0) {
        index = static_cast<int>(mesh.vertices.size());
        mesh.vertices.push_back(v[at(triangle[k])]);
      }
      moved[k] = index;
    }
    mesh.triangles.push_back(moved);
  }
  return mesh;
}

}  // namespace

RepairedMesh repair(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles) {
  RepairedMesh result;
  RepairReport& report = result.report;
  const double tolerance = weld_tolerance(vertices);
  const std::vector<int> representative = weld(vertices, tolerance, report.welded_vertices);

  std::vector<Triangle> kept = on_welded(triangles, representative);
  report.degenerate_triangles = static_cast<int>(triangles.size() - kept.size());
  report.duplicate_triangles = drop_duplicates(kept);

  const auto thin = [&](const Triangle& t) { return on_a_line(vertices, t, tolerance); };
  const auto count_thin = [&] {
    return static_cast<int>(std::count_if(kept.begin(), kept.end(), thin));
  };
  std::optional<std::vector<Triangle>> closed = closed_surface(vertices, kept, tolerance);
  if (!closed && report.duplicate_triangles > 0) {
    // Where welding folds thin triangles onto each other, equal ones may belong to it.
    std::vector<Triangle> netted = on_welded(triangles, representative);
    const int struck = drop_opposite_pairs(netted);
    closed = closed_surface(vertices, netted, tolerance);
    if (closed) {
      kept = std::move(netted);
      report.duplicate_triangles = struck;
    }
  }
  if (!closed) {
    std::vector<Triangle> one_sided = on_welded(triangles, representative);
    const int same = drop_same_corners(one_sided);
    if (same > report.duplicate_triangles && !may_be_nested(vertices, one_sided)) {
      closed = closed_surface(vertices, one_sided, tolerance);
    }
    if (closed) {
      kept = std::move(one_sided);
      report.duplicate_triangles = same;
    }
  }
  if (closed) {
    // Without its thin triangles a closed surface would have slits.
    report.thin_triangles_kept = count_thin();
  } else if (const int thin_count = count_thin(); thin_count > 0) {
    kept.erase(std::remove_if(kept.begin(), kept.end(), thin), kept.end());
    report.degenerate_triangles += thin_count;
    closed = closed_surface(vertices, kept, tolerance);
  }
  if (closed) {
    for (std::size_t i = 0; i < kept.size(); ++i) {
      report.turned_triangles += kept[i] == (*closed)[i] ? 0 : 1;
    }
    kept = std::move(*closed);
  }
  result.mesh = compacted(vertices, kept);
  result.mesh.closed = closed.has_value();
  return result;
}

}  // namespace rubicon::mesh_io
