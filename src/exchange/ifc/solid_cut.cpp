#include "src/exchange/ifc/solid_cut.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "src/exchange/ifc/solid_split.hpp"
#include "src/motion/math/index.hpp"

namespace rubicon::ifc {

namespace {

using math::Vec3;

using math::at;

/// Directions that differ by less than kOnPlane over 20 m.
constexpr double kParallel = 1e-7;

bool same_plane(const HalfSpace& a, const HalfSpace& b) {
  return (a.n - b.n).norm() < kParallel && std::fabs(a.w - b.w) < kOnPlane;
}

/// Metres and a direction's difference: faces that cuts of one plane have left lie in one plane.
constexpr double kOnePlane = 1e-7;

/// The planes of the faces, each once.
std::vector<HalfSpace> face_planes(const std::vector<Vec3>& points, const std::vector<Face>& faces,
                                   WorkBudget& budget) {
  std::vector<HalfSpace> planes;
  std::multimap<double, std::size_t> by_x;  // of the normal
  for (const Face& face : faces) {
    const auto plane = plane_of(points, face);
    if (!plane || !budget.spend(face.edges.size())) continue;
    const auto first = by_x.lower_bound(plane->n.x() - kParallel);
    const auto last = by_x.upper_bound(plane->n.x() + kParallel);
    const bool known = std::any_of(first, last, [&](const auto& each) {
      return !budget.spend(1) || same_plane(planes[each.second], *plane);
    });
    if (known) continue;
    by_x.emplace(plane->n.x(), planes.size());
    planes.push_back(*plane);
  }
  return planes;
}

/// Corners in groups, to tell soon which side of a plane they are all on.
class CornerGroups {
 public:
  CornerGroups(const std::vector<Vec3>& points, std::vector<int> corners)
      : points_(points), corners_(std::move(corners)) {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (i % kGroup == 0) extents_.emplace_back();
      extents_.back().add(points_[at(corners_[i])]);
    }
  }

  bool any_beyond(const HalfSpace& plane, WorkBudget& budget) const {
    const double most = 2 * kOnPlane;
    for (std::size_t g = 0; g < extents_.size(); ++g) {
      if (!budget.spend(2)) return false;
      if (extents_[g].distances(plane).second <= most) continue;
      const std::size_t end = std::min(corners_.size(), (g + 1) * kGroup);
      if (!budget.spend(end - g * kGroup)) return false;
      for (std::size_t i = g * kGroup; i < end; ++i) {
        if (plane.n.dot(points_[at(corners_[i])]) > plane.w + most) return true;
      }
    }
    return false;
  }

 private:
  static constexpr std::size_t kGroup = 32;

  const std::vector<Vec3>& points_;
  std::vector<int> corners_;
  std::vector<Extent> extents_;
};

/// A face of a body as one of a part of it.
Face share_of(const std::vector<Face>& faces, std::size_t i) {
  Face share;
  share.edges = faces[i].edges;
  share.normal = faces[i].normal;
  share.source = static_cast<int>(i);
  share.extent = faces[i].extent;
  return share;
}

/// Finds what of a body lies inside of a cell.
class PartFinder {
 public:
  PartFinder(std::vector<Vec3>& points, const std::vector<Face>& faces)
      : splitter_(points), faces_(faces) {
    for (std::size_t i = 0; i < faces.size(); ++i) whole_.push_back(i);
  }

  /// Its faces. Nothing if the body cannot be cut.
  std::optional<std::vector<Face>> inside(const Cell& cell, WorkBudget& budget) {
    for (const std::size_t i : order_of(cell)) {
      if (!budget.spend(kStepsPerSample * kSamples + 2 * whole_.size())) return std::nullopt;
      sort_whole(cell[i]);
      auto both = splitter_.split(std::move(cut_), cell[i], false, budget);
      if (!both) return std::nullopt;
      cut_ = std::move(both->inside);
      if (cut_.empty() && whole_.empty()) return std::vector<Face>();
    }
    for (const std::size_t i : whole_) {
      cut_.push_back(share_of(faces_, i));
      cut_.back().triangles = faces_[i].triangles;
    }
    return std::move(cut_);
  }

  const FaceSplitter& splitter() const { return splitter_; }

 private:
  static constexpr std::size_t kSamples = 256;
  static constexpr std::uint64_t kStepsPerSample = 4;

  /// The order of planes: first those that together leave the fewest of the body's faces to look
  /// at, judged by a sample of them.
  std::vector<std::size_t> order_of(const Cell& cell) const {
    std::vector<std::size_t> sample;
    const std::size_t step = 1 + faces_.size() / kSamples;
    for (std::size_t i = 0; i < faces_.size(); i += step) sample.push_back(i);
    std::vector<std::size_t> order;
    std::vector<char> taken(cell.size(), 0);
    constexpr std::size_t kChosen = 4;
    while (order.size() < std::min(kChosen, cell.size())) {
      std::size_t best = cell.size();
      std::size_t most = 0;
      for (std::size_t k = 0; k < cell.size(); ++k) {
        if (taken[k] != 0) continue;
        std::size_t count = 0;
        for (const std::size_t i : sample) {
          if (is_outside(i, cell[k])) ++count;
        }
        if (best == cell.size() || count > most) {
          best = k;
          most = count;
        }
      }
      taken[best] = 1;
      order.push_back(best);
      std::erase_if(sample, [&](std::size_t i) { return is_outside(i, cell[best]); });
    }
    for (std::size_t k = 0; k < cell.size(); ++k) {
      if (taken[k] == 0) order.push_back(k);
    }
    return order;
  }

  bool is_outside(std::size_t face, const HalfSpace& plane) const {
    return faces_[face].extent.distances(plane).first > 2 * kOnPlane;
  }

  /// Takes a copy of the faces that a plane comes near to, and drops those outside.
  void sort_whole(const HalfSpace& plane) {
    std::vector<std::size_t> left;
    for (const std::size_t i : whole_) {
      const auto [least, most] = faces_[i].extent.distances(plane);
      if (most < -2 * kOnPlane) {
        left.push_back(i);
      } else if (least <= 2 * kOnPlane) {
        cut_.push_back(share_of(faces_, i));
      }
    }
    whole_ = std::move(left);
  }

  FaceSplitter splitter_;
  const std::vector<Face>& faces_;
  std::vector<std::size_t> whole_;  ///< faces that no plane has come near to
  std::vector<Face> cut_;           ///< pieces of the others
};

/// Works out what is left of a body's faces when a part is taken away. New corners of the part on
/// edges of the body are put in on all faces of an edge.
class RestFinder {
 public:
  RestFinder(const std::vector<Vec3>& points, const std::vector<Face>& faces,
             const std::vector<Face>& part, const FaceSplitter& splitter)
      : points_(points), faces_(faces), part_(part), share_(faces.size(), -1) {
    for (std::size_t i = 0; i < part.size(); ++i) {
      extent_.add(part[i].extent);
      if (part[i].source == kFromCut) continue;
      share_[at(part[i].source)] = static_cast<int>(i);
      for (const Edge& each : part[i].edges) {
        if (const auto edge = splitter.edge_of(each.first)) on_edge_[*edge].push_back(each.first);
      }
    }
    for (auto& [edge, corners] : on_edge_) {
      const Vec3 from = points[at(edge.first)];
      const auto distance = [&](int i) { return (points[at(i)] - from).squaredNorm(); };
      std::sort(corners.begin(), corners.end(), [&](int a, int b) {
        return std::pair(distance(a), a) < std::pair(distance(b), b);
      });
      corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    }
  }

  bool may_change(std::size_t i) const {
    return share_[i] >= 0 || (!on_edge_.empty() && faces_[i].extent.meets(extent_, kShift));
  }

  /// The new border of a face; nothing if it stays.
  std::optional<std::vector<Edge>> border(std::size_t i) const {
    // Far from the part edges stay as they are.
    std::vector<Edge> edges;
    std::vector<Edge> near;
    std::size_t count = 0;
    for (const Edge& edge : faces_[i].edges) {
      Extent extent;
      extent.add(points_[at(edge.first)]);
      extent.add(points_[at(edge.second)]);
      if (extent.meets(extent_, kShift)) {
        put_along(edge, near);
        ++count;
      } else {
        edges.push_back(edge);
      }
    }
    if (share_[i] < 0 && near.size() == count) return std::nullopt;
    if (share_[i] >= 0) {
      for (const auto& [a, b] : part_[at(share_[i])].edges) near.emplace_back(b, a);
      near = net(std::move(near));
    }
    edges.insert(edges.end(), near.begin(), near.end());
    return edges;
  }

 private:
  void put_along(const Edge& edge, std::vector<Edge>& to) const {
    const auto [a, b] = edge;
    const auto found = on_edge_.find(std::minmax(a, b));
    if (found == on_edge_.end()) {
      to.push_back(edge);
      return;
    }
    std::vector<int> line = found->second;
    if (a > b) std::reverse(line.begin(), line.end());
    line.push_back(b);
    int from = a;
    for (const int corner : line) {
      to.emplace_back(from, corner);
      from = corner;
    }
  }

  const std::vector<Vec3>& points_;
  const std::vector<Face>& faces_;
  const std::vector<Face>& part_;
  std::vector<int> share_;  ///< by face of the body: its piece in the part, or -1
  std::map<Edge, std::vector<int>> on_edge_;
  Extent extent_;
};

/// Numbers corners behind `base` anew, as they are used; drops the others.
void renumber(std::vector<Face*> faces, std::size_t base, std::vector<Vec3>& points) {
  std::vector<int> place(points.size() - base, -1);
  std::vector<Vec3> used;
  const auto move = [&](int& corner) {
    if (at(corner) < base) return;
    int& to = place[at(corner) - base];
    if (to < 0) {
      to = static_cast<int>(base + used.size());
      used.push_back(points[at(corner)]);
    }
    corner = to;
  };
  for (Face* face : faces) {
    for (auto& [a, b] : face->edges) {
      move(a);
      move(b);
    }
  }
  points.resize(base);
  points.insert(points.end(), used.begin(), used.end());
}

/// Joins faces that cuts have left in one plane, and takes corners out that cuts have left within
/// straight sides.
class FaceTidier {
 public:
  /// Corners before `base` stay.
  FaceTidier(const std::vector<Vec3>& points, std::vector<Face> faces, std::size_t base)
      : points_(points), faces_(std::move(faces)), base_(base), root_(faces_.size()) {
    std::iota(root_.begin(), root_.end(), 0);
  }

  std::vector<Face> tidy() {
    join();
    straighten();
    std::erase_if(faces_, [](const Face& face) { return face.edges.empty(); });
    return std::move(faces_);
  }

 private:
  std::size_t root(std::size_t i) {
    while (root_[i] != i) i = root_[i] = root_[root_[i]];
    return i;
  }

  void join() {
    std::vector<std::pair<Edge, std::size_t>> sides;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      for (const auto& [a, b] : faces_[i].edges) sides.emplace_back(std::minmax(a, b), i);
    }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0; i < sides.size();) {
      std::size_t end = i + 1;
      while (end < sides.size() && sides[end].first == sides[i].first) ++end;
      if (end - i == 2 && in_one_plane(sides[i].second, sides[i + 1].second)) {
        root_[root(sides[i + 1].second)] = root(sides[i].second);
      }
      i = end;
    }
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const std::size_t to = root(i);
      if (to == i) continue;
      Face& face = faces_[to];
      face.edges.insert(face.edges.end(), faces_[i].edges.begin(), faces_[i].edges.end());
      faces_[i].edges.clear();
      face.triangles.clear();
      changed_.insert(to);
    }
    for (const std::size_t i : changed_) faces_[i].edges = net(std::move(faces_[i].edges));
  }

  bool in_one_plane(std::size_t i, std::size_t k) const {
    const Face& a = faces_[i];
    const Face& b = faces_[k];
    if (i == k || a.normal.isZero(0) || (a.normal - b.normal).norm() > kOnePlane) return false;
    const Vec3 p = points_[at(a.edges.front().first)];
    return std::all_of(b.edges.begin(), b.edges.end(), [&](const Edge& edge) {
      return std::fabs(a.normal.dot(points_[at(edge.first)] - p)) <= kOnePlane;
    });
  }

  void straighten() {
    // Each end of each edge: the corner and the other end.
    std::vector<Edge> ends;
    for (const Face& face : faces_) {
      for (const auto& [a, b] : face.edges) {
        if (at(a) >= base_) ends.emplace_back(a, b);
        if (at(b) >= base_) ends.emplace_back(b, a);
      }
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::map<int, Edge> between;  // of corners that may go: their neighbours
    for (std::size_t i = 0; i < ends.size();) {
      std::size_t end = i + 1;
      while (end < ends.size() && ends[end].first == ends[i].first) ++end;
      const int corner = ends[i].first;
      if (end - i == 2 && is_between(corner, ends[i].second, ends[i + 1].second)) {
        between.emplace(corner, Edge(ends[i].second, ends[i + 1].second));
      }
      i = end;
    }
    if (between.empty()) return;
    for (Face& face : faces_) straighten(between, face);
  }

  bool is_between(int corner, int a, int b) const {
    const Vec3 line = points_[at(b)] - points_[at(a)];
    const Vec3 way = points_[at(corner)] - points_[at(a)];
    const double length = line.norm();
    if (!(length > kOnPlane)) return false;
    const double along = way.dot(line) / length;
    return along > 0 && along < length && way.cross(line).norm() <= kOnePlane * length;
  }

  /// Edges that begin where none that goes begins before, on to the next corner that stays. Rings
  /// of corners that all go are left: that cannot be.
  static void straighten(const std::map<int, Edge>& between, Face& face) {
    const bool any = std::any_of(face.edges.begin(), face.edges.end(),
                                 [&](const Edge& edge) { return between.contains(edge.first); });
    if (!any) return;
    std::vector<Edge> edges;
    for (auto [a, b] : face.edges) {
      if (between.contains(a)) continue;
      int before = a;
      for (auto each = between.find(b); each != between.end(); each = between.find(b)) {
        const int next = each->second.first == before ? each->second.second : each->second.first;
        before = b;
        b = next;
        if (b == a) break;
      }
      if (a != b) edges.emplace_back(a, b);
    }
    face.edges = net(std::move(edges));
    face.triangles.clear();
  }

  const std::vector<Vec3>& points_;
  std::vector<Face> faces_;
  std::size_t base_;
  std::vector<std::size_t> root_;
  std::set<std::size_t> changed_;
};

/// Area of a surface, for the bound of its volume's error.
double area_of(const std::vector<Vec3>& points, const std::vector<Face>& faces) {
  double sum = 0;
  for (const Face& face : faces) sum += area_vector(points, face.edges).norm() / 2;
  return sum;
}

/// The triangles of faces; nothing if they do not close.
std::optional<Solid> surface(const std::vector<Vec3>& points, std::vector<Face> faces,
                             WorkBudget& budget) {
  Solid solid;
  solid.points = points;
  for (Face& face : faces) {
    if (!fill(points, face, budget)) return std::nullopt;
    solid.triangles.insert(solid.triangles.end(), face.triangles.begin(), face.triangles.end());
  }
  if (solid.triangles.empty()) return Solid{};
  // What rounding and kOnPlane make of a surface is allowed.
  const double expected = volume_of(points, faces);
  const double allowed = 1e-4 * std::fabs(expected) + kShift * area_of(points, faces);
  if (!is_closed(solid) || std::fabs(volume_of(solid) - expected) > allowed) return std::nullopt;
  return compact(solid);
}

/// Tries with the planes as they are, then a little farther out and in.
template <class F>
bool with_shifts(const Cell& cell, F f) {
  for (const double shift : {0.0, kShift / 3, -kShift / 3, kShift}) {
    Cell moved = cell;
    for (HalfSpace& plane : moved) plane.w += shift;
    if (f(moved)) return true;
  }
  return false;
}

/// A cut on the plane faces of a body, and if that fails on its triangles.
template <class F>
std::optional<Solid> cut_once(const Solid& body, WorkBudget& budget, F cut) {
  for (const bool apart : {false, true}) {
    std::optional<FaceSolid> faces = FaceSolid::of(body, apart, budget);
    if (!faces || !cut(*faces)) continue;
    if (!faces->is_changed()) return body;
    if (auto solid = faces->triangles(budget)) return solid;
  }
  return std::nullopt;
}

}  // namespace

std::optional<FaceSolid> FaceSolid::of(const Solid& body, bool apart, WorkBudget& budget) {
  FaceSolid result;
  result.points_ = body.points;
  result.given_ = body.points.size();
  result.faces_ = plane_faces(body, apart, budget);
  if (result.faces_.empty()) return std::nullopt;
  return result;
}

bool FaceSolid::subtract(const Cell& cell, bool fill_now, WorkBudget& budget) {
  return with_shifts(cell,
                     [&](const Cell& moved) { return subtract_once(moved, fill_now, budget); });
}

bool FaceSolid::intersect(const Cell& cell, bool fill_now, WorkBudget& budget) {
  return with_shifts(cell,
                     [&](const Cell& moved) { return intersect_once(moved, fill_now, budget); });
}

std::size_t FaceSolid::corners() const {
  std::size_t sum = 0;
  for (const Face& face : faces_) sum += face.edges.size();
  return sum;
}

bool FaceSolid::subtract_once(const Cell& cell, bool fill_now, WorkBudget& budget) {
  const std::size_t base = points_.size();
  PartFinder finder(points_, faces_);
  const auto part = finder.inside(cell, budget);
  const bool done = part && budget.spend(12 * faces_.size());
  const bool turned = done && volume_of(points_, *part) < -kOnPlane * area_of(points_, *part);
  if (!done || turned || part->empty()) {
    points_.resize(base);
    return done && !turned;
  }
  const RestFinder rest(points_, faces_, *part, finder.splitter());
  std::vector<Face> changed;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    if (!rest.may_change(i)) continue;
    auto border = rest.border(i);
    if (!border) continue;
    Face face;
    face.edges = std::move(*border);
    face.normal = faces_[i].normal;
    face.source = static_cast<int>(i);
    changed.push_back(std::move(face));
  }
  for (const Face& face : *part) {
    if (face.source != kFromCut) continue;
    changed.push_back(face);
    changed.back().normal = -face.normal;
    for (auto& [a, b] : changed.back().edges) std::swap(a, b);
  }
  std::vector<Face*> all;
  for (Face& face : changed) all.push_back(&face);
  renumber(all, base, points_);
  for (Face& face : changed) {
    face.extent = extent_of(points_, face.edges);
    if (fill_now && !fill(points_, face, budget)) {
      points_.resize(base);
      return false;
    }
  }
  for (Face& face : changed) {
    if (face.source == kFromCut) {
      faces_.push_back(std::move(face));
    } else {
      faces_[at(face.source)] = std::move(face);
    }
  }
  std::erase_if(faces_, [](const Face& face) { return face.edges.empty(); });
  is_changed_ = true;
  return true;
}

bool FaceSolid::intersect_once(const Cell& cell, bool fill_now, WorkBudget& budget) {
  const std::size_t base = points_.size();
  PartFinder finder(points_, faces_);
  auto part = finder.inside(cell, budget);
  bool done = part.has_value();
  if (done && fill_now) {
    done = std::all_of(part->begin(), part->end(),
                       [&](Face& face) { return fill(points_, face, budget); });
  }
  if (!done) {
    points_.resize(base);
    return false;
  }
  faces_ = std::move(*part);
  is_changed_ = true;
  return true;
}

std::optional<Solid> FaceSolid::triangles(WorkBudget& budget) const {
  constexpr std::uint64_t kStepsToTidy = 40;
  if (!budget.spend(kStepsToTidy * corners())) return std::nullopt;
  if (auto solid = surface(points_, FaceTidier(points_, faces_, given_).tidy(), budget)) {
    return solid;
  }
  return surface(points_, faces_, budget);
}

std::optional<std::vector<Cell>> convex_cells(const Solid& body, WorkBudget& budget) {
  constexpr std::size_t kMostCells = 512;
  std::vector<Vec3> points = body.points;
  std::vector<Cell> cells;
  std::vector<std::vector<Face>> pending{plane_faces(body, false, budget)};
  if (pending.front().empty()) return std::nullopt;
  while (!pending.empty()) {
    std::vector<Face> faces = std::move(pending.back());
    pending.pop_back();
    if (cells.size() + pending.size() > kMostCells) return std::nullopt;
    const std::vector<HalfSpace> planes = face_planes(points, faces, budget);
    const CornerGroups corners(points, corners_of(faces));
    const auto reflex = std::find_if(planes.begin(), planes.end(), [&](const HalfSpace& plane) {
      return corners.any_beyond(plane, budget);
    });
    if (budget.is_spent()) return std::nullopt;
    if (reflex == planes.end()) {
      if (planes.size() > 3) cells.push_back(planes);
      continue;
    }
    auto both = FaceSplitter(points).split(std::move(faces), *reflex, true, budget);
    if (!both || both->inside.empty() || both->outside.empty()) return std::nullopt;
    pending.push_back(std::move(both->outside));
    pending.push_back(std::move(both->inside));
  }
  return cells;
}

std::optional<Solid> subtract(const Solid& body, const Cell& cell, WorkBudget& budget) {
  return cut_once(body, budget,
                  [&](FaceSolid& faces) { return faces.subtract(cell, true, budget); });
}

std::optional<Solid> intersect(const Solid& body, const Cell& cell, WorkBudget& budget) {
  return cut_once(body, budget,
                  [&](FaceSolid& faces) { return faces.intersect(cell, true, budget); });
}

}  // namespace rubicon::ifc
