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

using math::at;

bool same_plane(const HalfSpace& a, const HalfSpace& b) {
  // Directions differ by less than kOnPlane over 20 m.
  constexpr double kParallel = 1e-7;
  return (a.n - b.n).norm() < kParallel && std::fabs(a.w - b.w) < kOnPlane;
}

/// The planes of the faces, each once.
std::vector<HalfSpace> face_planes(const std::vector<Vec3>& points, const std::vector<Face>& faces,
                                   WorkBudget& budget) {
  std::vector<HalfSpace> planes;
  for (const Face& face : faces) {
    const auto plane = plane_of(points, face);
    if (!plane || !budget.spend(planes.size() + face.edges.size())) continue;
    const bool known = std::any_of(planes.begin(), planes.end(),
                                   [&](const HalfSpace& p) { return same_plane(p, *plane); });
    if (!known) planes.push_back(*plane);
  }
  return planes;
}

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
    std::vector<Edge> edges;
    for (const Edge& edge : faces_[i].edges) put_along(edge, edges);
    if (share_[i] < 0) {
      if (edges.size() == faces_[i].edges.size()) return std::nullopt;
      return edges;
    }
    for (const auto& [a, b] : part_[at(share_[i])].edges) edges.emplace_back(b, a);
    return net(std::move(edges));
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

/// Area of a surface, for the bound of its volume's error.
double area_of(const std::vector<Vec3>& points, const std::vector<Face>& faces) {
  double sum = 0;
  for (const Face& face : faces) sum += area_vector(points, face.edges).norm() / 2;
  return sum;
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
  const bool done = part && budget.spend(faces_.size());
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
  Solid solid;
  solid.points = points_;
  for (const Face& face : faces_) {
    if (face.triangles.empty()) {
      Face filled = face;
      if (!fill(points_, filled, budget)) return std::nullopt;
      solid.triangles.insert(solid.triangles.end(), filled.triangles.begin(),
                             filled.triangles.end());
    } else {
      solid.triangles.insert(solid.triangles.end(), face.triangles.begin(), face.triangles.end());
    }
  }
  if (solid.triangles.empty()) return Solid{};
  // What rounding and kOnPlane make of a surface is allowed.
  const double expected = volume_of(points_, faces_);
  const double allowed = 1e-4 * std::fabs(expected) + kShift * area_of(points_, faces_);
  if (!is_closed(solid) || std::fabs(volume_of(solid) - expected) > allowed) return std::nullopt;
  return compact(solid);
}

std::optional<std::vector<Cell>> convex_cells(const Solid& body, WorkBudget& budget) {
  constexpr std::size_t kMostCells = 512;
  std::vector<Vec3> points = body.points;
  std::vector<Cell> cells;
  std::vector<std::vector<Face>> pending{plane_faces(body, false, budget)};
  while (!pending.empty()) {
    std::vector<Face> faces = std::move(pending.back());
    pending.pop_back();
    if (cells.size() + pending.size() > kMostCells) return std::nullopt;
    const std::vector<HalfSpace> planes = face_planes(points, faces, budget);
    const std::vector<int> corners = corners_of(faces);
    const HalfSpace* reflex = nullptr;
    for (const HalfSpace& plane : planes) {
      if (!budget.spend(corners.size())) return std::nullopt;
      const bool beyond = std::any_of(corners.begin(), corners.end(), [&](int i) {
        return plane.n.dot(points[at(i)]) > plane.w + 2 * kOnPlane;
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
    auto both = FaceSplitter(points).split(std::move(faces), *reflex, true, budget);
    if (!both || both->inside.empty() || both->outside.empty()) return std::nullopt;
    pending.push_back(std::move(both->outside));
    pending.push_back(std::move(both->inside));
  }
  if (budget.is_spent()) return std::nullopt;
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
