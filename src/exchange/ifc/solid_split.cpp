#include "src/exchange/ifc/solid_split.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <utility>

#include "src/motion/math/index.hpp"

namespace rubicon::ifc {

namespace {

using math::Vec3;

using math::at;

/// What a face far from the plane costs, and each edge of one near it, in steps of the budget.
constexpr std::uint64_t kStepsPerFace = 2;
constexpr std::uint64_t kStepsPerEdge = 12;

constexpr Edge kNoEdge{-1, -1};

}  // namespace

std::optional<SplitFaces> FaceSplitter::split(std::vector<Face> faces, const HalfSpace& plane,
                                              bool outside_too, WorkBudget& budget) {
  ++round_;
  plane_ = plane;
  outside_too_ = outside_too;
  crossings_.clear();
  missing_inside_.clear();
  missing_outside_.clear();
  SplitFaces result;
  if (!budget.spend(kStepsPerFace * faces.size())) return std::nullopt;
  std::vector<Face> cut;
  for (std::size_t i = 0; i < faces.size();) {
    // Rounding must not decide otherwise here than at the corners.
    const auto [least, most] = faces[i].extent.distances(plane);
    if (most < -2 * kOnPlane) {
      ++i;
      continue;
    }
    // Most faces stay: they are not moved.
    Face face = std::move(faces[i]);
    if (i + 1 < faces.size()) faces[i] = std::move(faces.back());
    faces.pop_back();
    if (least > 2 * kOnPlane) {
      if (outside_too) result.outside.push_back(std::move(face));
    } else if (!budget.spend(kStepsPerEdge * face.edges.size()) ||
               !sort_face(std::move(face), cut, result.outside, budget)) {
      return std::nullopt;
    }
  }
  result.inside = std::move(faces);
  result.inside.insert(result.inside.end(), std::make_move_iterator(cut.begin()),
                       std::make_move_iterator(cut.end()));
  cover(true, result.inside);
  if (outside_too) cover(false, result.outside);
  return result;
}

std::optional<Edge> FaceSplitter::edge_of(int corner) const {
  if (corner < base_ || edge_of_[at(corner - base_)] == kNoEdge) return std::nullopt;
  return edge_of_[at(corner - base_)];
}

int FaceSplitter::side(int corner) {
  if (marks_.size() < points_.size()) marks_.resize(points_.size());
  Mark& mark = marks_[at(corner)];
  if (mark.round != round_) {
    const double d = plane_.n.dot(points_[at(corner)]) - plane_.w;
    mark = {round_, d > kOnPlane ? 1 : d < -kOnPlane ? -1 : 0, d};
  }
  return mark.side;
}

/// Puts a face near the plane on its side, or its pieces.
bool FaceSplitter::sort_face(Face face, std::vector<Face>& inside, std::vector<Face>& outside,
                             WorkBudget& budget) {
  int low = 1;
  int high = -1;
  for (const Edge& edge : face.edges) {
    low = std::min(low, side(edge.first));
    high = std::max(high, side(edge.first));
  }
  if (low < 0 && high > 0) return cut_face(face, inside, outside, budget);
  const bool in_plane = low == 0 && high == 0;
  const bool is_inside = in_plane ? face.normal.dot(plane_.n) > 0 : high <= 0;
  put(std::move(face), is_inside, is_inside ? inside : outside);
  return true;
}

/// A face that reaches to both sides.
bool FaceSplitter::cut_face(const Face& face, std::vector<Face>& inside, std::vector<Face>& outside,
                            WorkBudget& budget) {
  std::vector<Edge> below;
  std::vector<Edge> above;
  on_plane_.clear();
  for (const auto& [a, b] : face.edges) {
    const int from = side(a);
    const int to = side(b);
    if (from == 0) on_plane_.push_back(a);
    if (from * to < 0) {
      const int c = crossing_of(a, b);
      on_plane_.push_back(c);
      (from < 0 ? below : above).emplace_back(a, c);
      (from < 0 ? above : below).emplace_back(c, b);
      continue;
    }
    if (from <= 0 && to <= 0) below.emplace_back(a, b);
    if (from >= 0 && to >= 0) above.emplace_back(a, b);
  }
  std::sort(on_plane_.begin(), on_plane_.end());
  on_plane_.erase(std::unique(on_plane_.begin(), on_plane_.end()), on_plane_.end());
  return close_face(std::move(below), face, true, inside, budget) &&
         (!outside_too_ || close_face(std::move(above), face, false, outside, budget));
}

/// Puts in the edges along the plane.
bool FaceSplitter::close_face(std::vector<Edge> edges, const Face& face, bool is_inside,
                              std::vector<Face>& to, WorkBudget& budget) {
  Vec3 way = face.normal.cross(plane_.n) * (is_inside ? 1 : -1);
  // How far corners on the plane may lie before one another that in truth lie beside one another.
  double reach = HUGE_VAL;
  if (const double sine = way.norm(); sine > 0) {
    constexpr double kLeastSine = 1e-3;
    reach = 4 * kOnPlane / std::max(sine, kLeastSine);
    way /= sine;
  } else {
    way = Vec3::UnitX();
    double longest = -1;
    for (const int corner : on_plane_) {
      const Vec3 line = points_[at(corner)] - points_[at(on_plane_.front())];
      if (line.norm() > longest) {
        longest = line.norm();
        way = line;
      }
    }
  }
  const std::vector<Stop> stops = stops_of(edges, way);
  int open = 0;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    if (open != 0) {
      if (open < 0 && stops[i].along - stops[i - 1].along > reach) return false;
      if (!budget.spend(at(std::abs(open)))) return false;
      const Edge line = open > 0 ? Edge(stops[i - 1].corner, stops[i].corner)
                                 : Edge(stops[i].corner, stops[i - 1].corner);
      edges.insert(edges.end(), at(std::abs(open)), line);
    }
    open += stops[i].surplus;
  }
  if (open != 0) return false;
  Face part;
  // Only edges along the plane may run both ways now.
  const auto on_plane = std::partition(edges.begin(), edges.end(), [&](const Edge& edge) {
    return marks_[at(edge.first)].side != 0 || marks_[at(edge.second)].side != 0;
  });
  const std::vector<Edge> left = net({on_plane, edges.end()});
  edges.erase(on_plane, edges.end());
  edges.insert(edges.end(), left.begin(), left.end());
  part.edges = std::move(edges);
  part.normal = face.normal;
  part.source = face.source;
  part.extent = extent_of(points_, part.edges);
  put(std::move(part), is_inside, to);
  return true;
}

std::vector<FaceSplitter::Stop> FaceSplitter::stops_of(const std::vector<Edge>& edges,
                                                       const Vec3& way) const {
  std::vector<Stop> stops;
  for (const int corner : on_plane_) stops.push_back({way.dot(points_[at(corner)]), corner, 0});
  const auto count = [&](int corner, int by) {
    if (marks_[at(corner)].side != 0) return;
    const auto found = std::lower_bound(on_plane_.begin(), on_plane_.end(), corner);
    stops[static_cast<std::size_t>(found - on_plane_.begin())].surplus += by;
  };
  for (const auto& [a, b] : edges) {
    count(a, -1);
    count(b, 1);
  }
  std::sort(stops.begin(), stops.end(), [](const Stop& a, const Stop& b) {
    if (a.along != b.along) return a.along < b.along;
    return a.surplus != b.surplus ? a.surplus > b.surplus : a.corner < b.corner;
  });
  return stops;
}

/// Adds a face to a part, and what of its border lies on the plane to what is missing there.
void FaceSplitter::put(Face face, bool is_inside, std::vector<Face>& to) {
  if (face.edges.empty() || (!is_inside && !outside_too_)) return;
  std::vector<Edge>& missing = is_inside ? missing_inside_ : missing_outside_;
  for (const auto& [a, b] : face.edges) {
    if (side(a) == 0 && side(b) == 0) missing.emplace_back(b, a);
  }
  to.push_back(std::move(face));
}

/// Closes a part on the plane.
void FaceSplitter::cover(bool is_inside, std::vector<Face>& to) {
  Face face;
  face.edges = net(std::move(is_inside ? missing_inside_ : missing_outside_));
  if (face.edges.empty()) return;
  face.normal = is_inside ? plane_.n : Vec3(-plane_.n);
  face.extent = extent_of(points_, face.edges);
  to.push_back(std::move(face));
}

/// The corner where an edge meets the plane, one for all faces of the edge.
int FaceSplitter::crossing_of(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  const auto [found, is_new] =
      crossings_.try_emplace({low, high}, static_cast<int>(points_.size()));
  if (is_new) {
    const double d = marks_[at(low)].distance;
    const double t = d / (d - marks_[at(high)].distance);
    const Vec3 p = points_[at(low)] + t * (points_[at(high)] - points_[at(low)]);
    points_.push_back(p);
    marks_.resize(points_.size());
    marks_.back() = {round_, 0, 0};
    edge_of_.push_back(edge_along(low, high).value_or(kNoEdge));
  }
  return found->second;
}

/// The edge of the body that the line between two corners may be a piece of. Decided by where they
/// come from, not where they are: narrow faces have three edges at one place.
std::optional<Edge> FaceSplitter::edge_along(int a, int b) const {
  const auto ends = [](const Edge& edge, int corner) {
    return edge.first == corner || edge.second == corner;
  };
  const bool is_new_a = a >= base_;
  const bool is_new_b = b >= base_;
  if (!is_new_a && !is_new_b) return Edge(std::min(a, b), std::max(a, b));
  const std::optional<Edge> of_a = edge_of(a);
  const std::optional<Edge> of_b = edge_of(b);
  if (is_new_a && is_new_b) {
    if (of_a && of_b && *of_a == *of_b) return of_a;
    return std::nullopt;
  }
  const std::optional<Edge>& edge = is_new_a ? of_a : of_b;
  if (edge && ends(*edge, is_new_a ? b : a)) return edge;
  return std::nullopt;
}

}  // namespace rubicon::ifc
