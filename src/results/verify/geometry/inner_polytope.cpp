#include "src/results/verify/geometry/inner_polytope.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace rubicon::verify {

namespace {

/// A polytope is expanded no more where the solid is nearer to it than this share of the band
/// between alarm and limit; the answer is then known to the same share.
constexpr double kPrecisionShare = 0.05;

/// m: a point is outside of a face if it is farther from its plane than this. Smaller differences
/// give faces whose normals are noise; larger ones would count against the precision.
constexpr double kOutside = 1e-8;

/// m: what is thinner than this is flat, and nothing is deep in it.
constexpr double kFlat = 1e-9;

/// Expansions before the question is given up as unsure. Round solids need some tens.
constexpr int kMostExpansions = 400;

struct Face {
  std::array<int, 3> corners{};
  Vec3 n = Vec3::UnitZ();  ///< unit, outwards
  double offset = 0;       ///< of its plane from the origin along n
};

/// The solid of the differences p_A - p_B, by its farthest points.
class Difference {
 public:
  Difference(const Convex& a, const Pose& X_BA, const Convex& b) : a_(a), X_BA_(X_BA), b_(b) {}
  Vec3 support(const Vec3& n) const {
    return X_BA_ * a_.support(X_BA_.linear().transpose() * n) - b_.support(-n);
  }

 private:
  const Convex& a_;
  const Pose& X_BA_;
  const Convex& b_;
};

class Expansion {
 public:
  Expansion(const Difference& solid, const DepthQuery& query) : solid_(solid), query_(query) {}

  DepthResult run() {
    if (begin()) return {Nearness::free, 0};
    if (flat_) return {Nearness::unsure, 0};
    const double precision =
        std::max(kPrecisionShare * (query_.limit - query_.alarm), 4 * kOutside);
    for (int i = 0; i < kMostExpansions; ++i) {
      const Face face = *std::min_element(
          faces_.begin(), faces_.end(),
          [](const Face& one, const Face& other) { return one.offset < other.offset; });
      if (face.offset > query_.alarm) return {Nearness::deep, face.offset};
      const Vec3 farthest = solid_.support(face.n);
      if (frees(face.n, farthest)) return {Nearness::free, 0};
      if (farthest.dot(face.n) - face.offset < precision) break;
      if (!expand(face, farthest)) break;
    }
    return {Nearness::unsure, 0};
  }

 private:
  bool frees(const Vec3& n, const Vec3& farthest) const {
    return farthest.dot(n) + query_.reach.along(n) <= query_.limit;
  }

  /// Tries a direction for the first tetrahedron; whether it proves freedom.
  bool look(const Vec3& n, Vec3& farthest) const {
    farthest = solid_.support(n);
    return frees(n, farthest);
  }

  /// Four points of the solid that are not in one plane; true if a direction proves freedom on the
  /// way.
  bool begin() {
    std::array<Vec3, 6> far;
    for (int i = 0; i < 6; ++i) {
      const Vec3 n = i % 2 == 0 ? Vec3(Vec3::Unit(i / 2)) : Vec3(-Vec3::Unit(i / 2));
      if (look(n, far[static_cast<std::size_t>(i)])) return true;
    }
    std::size_t widest = 0;
    for (std::size_t i = 2; i < 6; i += 2) {
      if ((far[i] - far[i + 1]).norm() > (far[widest] - far[widest + 1]).norm()) widest = i;
    }
    const Vec3 a = far[widest];
    const Vec3 b = far[widest + 1];
    flat_ = !((b - a).norm() > kFlat);
    if (flat_) return false;
    const Vec3 line = (b - a).normalized();
    Vec3 c = a;
    double off_line = 0;
    const Vec3 across = line.unitOrthogonal();
    for (const Vec3& n :
         {across, Vec3(-across), Vec3(line.cross(across)), Vec3(across.cross(line))}) {
      Vec3 p;
      if (look(n, p)) return true;
      const double off = (p - a).cross(line).norm();
      if (off > off_line) {
        off_line = off;
        c = p;
      }
    }
    flat_ = !(off_line > kFlat);
    return !flat_ && close(a, b, c);
  }

  /// The fourth point, and the tetrahedron.
  bool close(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 n = (b - a).cross(c - a).normalized();
    Vec3 above;
    Vec3 below;
    if (look(n, above) || look(-n, below)) return true;
    const bool up = n.dot(above - a) > -n.dot(below - a);
    const Vec3 d = up ? above : below;
    flat_ = !(std::max(n.dot(above - a), -n.dot(below - a)) > kFlat);
    if (flat_) return false;
    points_ = {a, b, c, d};
    // Seen from outside the corners of a face run anticlockwise.
    const auto add = [&](int i, int j, int k) { up ? add_face(i, k, j) : add_face(i, j, k); };
    add(0, 1, 2);
    add(1, 0, 3);
    add(2, 1, 3);
    add(0, 2, 3);
    return false;
  }

  void add_face(int i, int j, int k) {
    const auto at = [&](int index) { return points_[static_cast<std::size_t>(index)]; };
    Face face;
    face.corners = {i, j, k};
    const Vec3 n = (at(j) - at(i)).cross(at(k) - at(i));
    const double length = n.norm();
    face.n = length > 0 ? Vec3(n / length) : Vec3(Vec3::Zero());
    face.offset = length > 0 ? face.n.dot(at(i)) : std::numeric_limits<double>::infinity();
    faces_.push_back(face);
  }

  /// Puts a point outside of `from` into the polytope: all faces that see it are replaced by a
  /// cone.
  bool expand(const Face& from, const Vec3& p) {
    const int apex = static_cast<int>(points_.size());
    points_.push_back(p);
    std::map<std::pair<int, int>, int> horizon;  // edges of one face that goes only
    std::vector<Face> kept;
    for (const Face& face : faces_) {
      if (face.corners != from.corners && !(face.n.dot(p) - face.offset > kOutside)) {
        kept.push_back(face);
        continue;
      }
      for (std::size_t i = 0; i < 3; ++i) {
        const std::pair edge(face.corners[i], face.corners[(i + 1) % 3]);
        const auto opposite = horizon.find({edge.second, edge.first});
        if (opposite != horizon.end()) {
          horizon.erase(opposite);
        } else {
          ++horizon[edge];
        }
      }
    }
    faces_ = std::move(kept);
    for (const auto& [edge, count] : horizon) add_face(edge.first, edge.second, apex);
    return !faces_.empty() && horizon.size() >= 3;
  }

  const Difference& solid_;
  const DepthQuery& query_;
  bool flat_ = false;
  std::vector<Vec3> points_;
  std::vector<Face> faces_;
};

}  // namespace

DepthResult test_by_inner_polytope(const Convex& a, const Pose& X_BA, const Convex& b,
                                   const DepthQuery& query) {
  const Difference solid(a, X_BA, b);
  return Expansion(solid, query).run();
}

}  // namespace rubicon::verify
