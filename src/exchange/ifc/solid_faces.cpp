#include "src/exchange/ifc/solid_faces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "src/motion/math/index.hpp"

namespace rubicon::ifc {

namespace {

using math::Vec3;

using math::at;

/// Metres. Corners nearer to the plane of a triangle may lie in one face with it: above what
/// rounding leaves of coordinates, and a tenth of kOnPlane.
constexpr double kOneFace = 1e-6;

/// Metres. Farther out volumes, and in the end squares, are no numbers to reckon with.
constexpr double kFarthest = 1e12;

/// What one look at a triangle or an edge costs, in steps of the budget.
constexpr std::uint64_t kStepsToMerge = 40;

/// Whether an area is narrower than what tells the direction of its plane.
bool is_narrow(const Vec3& area_vector, double length) {
  return !(area_vector.norm() > 4 * kOnPlane * length);
}

/// Joins triangles to faces, the largest first.
class FaceMerger {
 public:
  explicit FaceMerger(const Solid& body) : body_(body), taken_(body.triangles.size(), 0) {
    for (const auto& t : body.triangles) {
      const Vec3& a = body.points[at(t[0])];
      const Vec3& b = body.points[at(t[1])];
      const Vec3& c = body.points[at(t[2])];
      areas_.emplace_back((b - a).cross(c - a));
      narrow_.push_back(
          is_narrow(areas_.back(), std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()})));
    }
    for (std::size_t i = 0; i < body.triangles.size(); ++i) {
      const auto& t = body.triangles[i];
      for (std::size_t k = 0; k < 3; ++k) {
        sides_.push_back({std::minmax(t[k], t[(k + 1) % 3]), static_cast<int>(i)});
      }
    }
    std::sort(sides_.begin(), sides_.end());
  }

  std::vector<Face> merge(bool apart) {
    std::vector<int> order(body_.triangles.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
      return areas_[at(a)].squaredNorm() > areas_[at(b)].squaredNorm();
    });
    std::vector<Face> faces;
    for (const int seed : order) {
      if (taken_[at(seed)] != 0) continue;
      Face face = face_of(apart ? std::vector<int>{seed} : around(seed));
      if (!face.edges.empty()) faces.push_back(std::move(face));
    }
    return faces;
  }

 private:
  using Side = std::pair<Edge, int>;

  /// The triangles that lie in one plane with the seed and are reached over their sides.
  std::vector<int> around(int seed) {
    taken_[at(seed)] = 1;
    std::vector<int> found{seed};
    if (narrow_[at(seed)] != 0) return found;
    const Vec3 n = areas_[at(seed)].normalized();
    const double w = n.dot(body_.points[at(body_.triangles[at(seed)][0])]);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const auto& t = body_.triangles[at(found[i])];
      for (std::size_t k = 0; k < 3; ++k) {
        const int other = beyond(std::minmax(t[k], t[(k + 1) % 3]), found[i]);
        if (other < 0 || taken_[at(other)] != 0 || !lies_in(other, n, w)) continue;
        taken_[at(other)] = 1;
        found.push_back(other);
      }
    }
    return found;
  }

  /// The other triangle at a side; -1 where there is not exactly one.
  int beyond(const Edge& side, int triangle) const {
    const auto first = std::lower_bound(sides_.begin(), sides_.end(), Side(side, -1));
    auto last = first;
    while (last != sides_.end() && last->first == side) ++last;
    if (last - first != 2) return -1;
    return first->second == triangle ? (first + 1)->second : first->second;
  }

  bool lies_in(int triangle, const Vec3& n, double w) const {
    const Vec3& area = areas_[at(triangle)];
    const double turn = n.dot(area);
    constexpr double kSameWay = 0.999;
    if (narrow_[at(triangle)] != 0 ? turn < 0 : turn < kSameWay * area.norm()) return false;
    const auto& t = body_.triangles[at(triangle)];
    return std::all_of(t.begin(), t.end(), [&](int corner) {
      return std::fabs(n.dot(body_.points[at(corner)]) - w) <= kOneFace;
    });
  }

  Face face_of(const std::vector<int>& triangles) {
    Face face;
    for (const int i : triangles) {
      taken_[at(i)] = 1;
      const auto& t = body_.triangles[at(i)];
      face.triangles.push_back(t);
      for (std::size_t k = 0; k < 3; ++k) face.edges.emplace_back(t[k], t[(k + 1) % 3]);
    }
    if (triangles.size() > 1) face.edges = net(std::move(face.edges));
    const Vec3 area = area_vector(body_.points, face.edges);
    face.extent = extent_of(body_.points, face.edges);
    if (narrow_[at(triangles.front())] == 0) face.normal = area.normalized();
    return face;
  }

  const Solid& body_;
  std::vector<Vec3> areas_;
  std::vector<char> narrow_, taken_;
  std::vector<Side> sides_;
};

}  // namespace

void Extent::add(const Vec3& p) {
  low = low.cwiseMin(p);
  high = high.cwiseMax(p);
}

void Extent::add(const Extent& other) {
  low = low.cwiseMin(other.low);
  high = high.cwiseMax(other.high);
}

bool Extent::meets(const Extent& other, double margin) const {
  return ((low.array() <= other.high.array() + margin) &&
          (other.low.array() <= high.array() + margin))
      .all();
}

std::pair<double, double> Extent::distances(const HalfSpace& plane) const {
  const double middle = plane.n.dot(low + high) / 2 - plane.w;
  const double reach = plane.n.cwiseAbs().dot(high - low) / 2;
  return {middle - reach, middle + reach};
}

Extent extent_of(const std::vector<Vec3>& points, const std::vector<Edge>& edges) {
  Extent extent;
  for (const Edge& edge : edges) extent.add(points[at(edge.first)]);
  return extent;
}

Vec3 area_vector(const std::vector<Vec3>& points, const std::vector<Edge>& edges) {
  Vec3 sum = Vec3::Zero();
  if (edges.empty()) return sum;
  const Vec3 origin = points[at(edges.front().first)];
  for (const auto& [a, b] : edges) sum += (points[at(a)] - origin).cross(points[at(b)] - origin);
  return sum;
}

std::vector<Face> plane_faces(const Solid& body, bool apart, WorkBudget& budget) {
  if (!budget.spend(kStepsToMerge * body.triangles.size())) return {};
  const bool is_near = std::all_of(body.points.begin(), body.points.end(), [](const Vec3& p) {
    return p.cwiseAbs().maxCoeff() < kFarthest;
  });
  if (!is_near) return {};
  return FaceMerger(body).merge(apart);
}

std::optional<HalfSpace> plane_of(const std::vector<Vec3>& points, const Face& face) {
  if (face.edges.empty() || face.normal.isZero(0)) return std::nullopt;
  const double length = (face.extent.high - face.extent.low).norm();
  if (is_narrow(area_vector(points, face.edges), length)) return std::nullopt;
  double sum = 0;
  for (const Edge& edge : face.edges) sum += face.normal.dot(points[at(edge.first)]);
  return HalfSpace{face.normal, sum / static_cast<double>(face.edges.size())};
}

double volume_of(const std::vector<Vec3>& points, const std::vector<Face>& faces) {
  if (faces.empty() || faces.front().edges.empty()) return 0;
  const Vec3 origin = points[at(faces.front().edges.front().first)];
  double sum = 0;
  for (const Face& face : faces) {
    if (face.edges.empty()) continue;
    const Vec3& first = points[at(face.edges.front().first)];
    sum += (first - origin).dot(area_vector(points, face.edges));
  }
  return sum / 6;
}

bool fill(const std::vector<Vec3>& points, Face& face, WorkBudget& budget) {
  if (!face.triangles.empty() || face.edges.empty()) return true;
  if (!budget.spend(kStepsToMerge * face.edges.size())) return false;
  Vec3 normal = face.normal;
  if (normal.isZero(0)) normal = area_vector(points, face.edges);
  const auto loops = border_loops(points, face.edges, normal);
  if (!loops) return false;
  if (loops->empty()) return true;
  auto triangles = triangulate(points, *loops, normal, budget, 2 * kOnPlane);
  if (!triangles) return false;
  face.triangles = std::move(*triangles);
  return true;
}

std::vector<int> corners_of(const std::vector<Face>& faces) {
  std::vector<int> corners;
  for (const Face& face : faces) {
    for (const Edge& edge : face.edges) corners.push_back(edge.first);
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

}  // namespace rubicon::ifc
