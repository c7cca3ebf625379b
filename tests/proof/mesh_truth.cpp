#include "tests/proof/mesh_truth.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubicon::collision::proof {
namespace {

constexpr double kDegenerate = 1e-9;
/// Depths of pairs of pieces that one case is worth; more is near the boundary.
constexpr int kPairsACase = 400'000;

using PiecePair = std::pair<int, int>;

class PiecesTruth {
 public:
  PiecesTruth(const Pieces& a, const Path& path_a, const Pieces& b, const Path& path_b,
              double tolerance)
      : a_(a),
        path_a_(path_a),
        b_(b),
        path_b_(path_b),
        contact_tolerance_(tolerance),
        speed_(path_a.speed(a.reach) + path_b.speed(b.reach)) {}

  Truth translation() {
    const Pose X_BW = path_b_.pose(0).inverse();
    const Pose X_BA = X_BW * path_a_.pose(0);
    const Vec3 d = X_BW.linear() * (path_a_.displacement() - path_b_.displacement());
    Pose X_middle = X_BA;
    X_middle.translation() += 0.5 * d;
    Truth truth = Truth::kFree;
    int placed_piece = -1;
    for (const auto& [i, j] : near_pairs(X_middle, 0.5 * d.norm())) {
      if (i != placed_piece) place(a_.polytopes[i], X_BA, moved_);
      placed_piece = i;
      const double tolerance = tolerance_of(i, j);
      const double least = swept_depth(moved_, d, b_.polytopes[j], tolerance - 2 * kExactBand);
      if (std::fabs(least - tolerance) < kExactBand) {
        truth = Truth::kNearBoundary;
      } else if (least > tolerance) {
        return Truth::kHit;
      }
    }
    return truth;
  }

  Truth turning() {
    const Truth truth = over(0, 1, near_pairs(pose(0.5), 0.5 * speed_));
    return truth == Truth::kFree && looks_left_ <= 0 ? Truth::kNearBoundary : truth;
  }

 private:
  Pose pose(double s) const { return path_b_.pose(s).inverse() * path_a_.pose(s); }

  double tolerance_of(int i, int j) const {
    return pair_tolerance(contact_tolerance_, a_.polytopes[i].width, b_.polytopes[j].width);
  }

  /// Pairs whose balls come nearer than `loose` when A stands at X in B.
  std::vector<PiecePair> near_pairs(const Pose& X, double loose) const {
    std::vector<PiecePair> pairs;
    for (int i = 0; i < static_cast<int>(a_.centres.size()); ++i) {
      const Vec3 centre = X * a_.centres[i];
      if (centre.norm() > b_.reach + a_.radii[i] + loose) continue;
      for (int j = 0; j < static_cast<int>(b_.centres.size()); ++j) {
        const double distance = a_.radii[i] + b_.radii[j] + loose;
        if ((centre - b_.centres[j]).squaredNorm() <= distance * distance) pairs.emplace_back(i, j);
      }
    }
    return pairs;
  }

  /// Only `pairs` may meet on [s0, s1].
  Truth over(double s0, double s1, const std::vector<PiecePair>& pairs) {
    if (pairs.empty()) return Truth::kFree;
    const double middle = 0.5 * (s0 + s1);
    const double travel = 0.5 * speed_ * (s1 - s0);
    const Pose X = pose(middle);
    std::vector<PiecePair> left;
    int placed_piece = -1;
    Vec3 centre = Vec3::Zero();
    for (const auto& [i, j] : pairs) {
      if (i != placed_piece) {
        place(a_.polytopes[i], X, moved_);
        centre = X * a_.centres[i];
        placed_piece = i;
      }
      const double distance = a_.radii[i] + b_.radii[j] + travel;
      if ((centre - b_.centres[j]).squaredNorm() > distance * distance) continue;
      --looks_left_;
      const double shallow = tolerance_of(i, j) - kBand - travel;
      const double here = depth(moved_, b_.polytopes[j], shallow);
      if (here > tolerance_of(i, j) + kBand) return Truth::kHit;
      if (here > shallow) left.emplace_back(i, j);
    }
    if (left.empty()) return Truth::kFree;
    if (travel < 0.25 * kBand || looks_left_ < 0) return Truth::kNearBoundary;
    const Truth first = over(s0, middle, left);
    return first == Truth::kHit ? first : worse(first, over(middle, s1, left));
  }

  const Pieces& a_;
  const Path& path_a_;
  const Pieces& b_;
  const Path& path_b_;
  double contact_tolerance_;
  double speed_;
  Polytope moved_;
  int looks_left_ = kPairsACase;
};

double segment_distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 way = b - a;
  const double length = way.squaredNorm();
  const double share = length > 0 ? std::clamp((p - a).dot(way) / length, 0.0, 1.0) : 0;
  return (p - a - share * way).norm();
}

double triangle_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const double area = normal.norm();
  if (area > 0) {
    // Over the triangle itself: on the inner side of all three edges.
    const bool over = normal.dot((b - a).cross(p - a)) >= 0 &&
                      normal.dot((c - b).cross(p - b)) >= 0 &&
                      normal.dot((a - c).cross(p - c)) >= 0;
    if (over) return std::fabs(normal.dot(p - a)) / area;
  }
  return std::min(
      {segment_distance(p, a, b), segment_distance(p, b, c), segment_distance(p, c, a)});
}

/// Where a point stands: hit deep inside, near within the band, free otherwise.
Truth point_inside(const geometry::TriangleMesh& mesh, const Vec3& point, double tolerance,
                   const Vec3& direction) {
  if (!is_inside(mesh, point, direction)) return Truth::kFree;
  const double distance = distance_to_surface(mesh, point);
  if (distance > tolerance + kBand) return Truth::kHit;
  return distance > tolerance - kBand ? Truth::kNearBoundary : Truth::kFree;
}

}  // namespace

void Pieces::add(Polytope polytope) {
  Vec3 centre = Vec3::Zero();
  for (const Vec3& vertex : polytope.vertices)
    centre += vertex / static_cast<double>(polytope.vertices.size());
  double radius = 0;
  for (const Vec3& vertex : polytope.vertices) radius = std::max(radius, (vertex - centre).norm());
  reach = std::max(reach, reach_of(polytope));
  centres.push_back(centre);
  radii.push_back(radius * (1 + 1e-12) + 1e-9);
  polytopes.push_back(std::move(polytope));
}

Pieces pieces_of(const Polytope& polytope) {
  Pieces pieces;
  pieces.add(polytope);
  return pieces;
}

Pieces pieces_of(const geometry::TriangleMesh& mesh) {
  Pieces pieces;
  for (const auto& [a, b, c] : mesh.triangles) {
    Polytope triangle = triangle_polytope(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
    if (triangle.width >= kDegenerate) pieces.add(std::move(triangle));
  }
  return pieces;
}

Truth pieces_truth(const Pieces& a, const Path& path_a, const Pieces& b, const Path& path_b,
                   double contact_tolerance) {
  PiecesTruth truth(a, path_a, b, path_b, contact_tolerance);
  return path_a.translates() && path_b.translates() ? truth.translation() : truth.turning();
}

bool is_inside(const geometry::TriangleMesh& mesh, const Vec3& point, const Vec3& direction) {
  bool inside = false;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 p = mesh.vertices[a] - point;
    const Vec3 q = mesh.vertices[b] - point;
    const Vec3 r = mesh.vertices[c] - point;
    // Signed volumes with the ray: it passes within where all three have one sign.
    const double pq = direction.dot(p.cross(q));
    const double qr = direction.dot(q.cross(r));
    const double rp = direction.dot(r.cross(p));
    const bool passes = (pq > 0 && qr > 0 && rp > 0) || (pq < 0 && qr < 0 && rp < 0);
    if (!passes) continue;
    const double ahead = p.dot(q.cross(r)) / (pq + qr + rp);
    inside ^= ahead > 0;
  }
  return inside;
}

double distance_to_surface(const geometry::TriangleMesh& mesh, const Vec3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : mesh.triangles) {
    least = std::min(
        least, triangle_distance(point, mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]));
  }
  return least;
}

Truth any_inside(const geometry::TriangleMesh& mesh, const std::vector<Vec3>& points,
                 const Pose& X_MeshPoints, double tolerance, Random& random) {
  Truth truth = Truth::kFree;
  if (!mesh.closed) return truth;
  const Vec3 direction = random.direction();
  for (const Vec3& point : points) {
    truth = worse(truth, point_inside(mesh, X_MeshPoints * point, tolerance, direction));
    if (truth == Truth::kHit) break;
  }
  return truth;
}

Truth all_inside(const geometry::TriangleMesh& mesh, const std::vector<Vec3>& points,
                 const Pose& X_MeshPoints, double tolerance, Random& random) {
  if (!mesh.closed) return Truth::kFree;
  const Vec3 direction = random.direction();
  bool all = true;
  bool none = true;
  for (const Vec3& point : points) {
    const Truth one = point_inside(mesh, X_MeshPoints * point, tolerance, direction);
    all = all && one == Truth::kHit;
    none = none && one == Truth::kFree;
    if (!all && !none) return Truth::kNearBoundary;
  }
  return all ? Truth::kHit : Truth::kFree;
}

}  // namespace rubicon::collision::proof
