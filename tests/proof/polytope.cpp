#include "tests/proof/polytope.hpp"

#include <algorithm>
#include <cmath>

namespace rubicon::collision::proof {
namespace {

/// Cross products shorter than this (sine of the angle) are no direction.
constexpr double kParallel = 1e-9;

struct Span {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
};

Span span_of(const std::vector<Vec3>& points, const Vec3& n) {
  Span span;
  for (const Vec3& point : points) {
    const double along = n.dot(point);
    span.least = std::min(span.least, along);
    span.greatest = std::max(span.greatest, along);
  }
  return span;
}

/// Lowers a least overlap axis by axis.
class LeastOverlap {
 public:
  LeastOverlap(const Polytope& a, const Vec3& d, const Polytope& b, double enough)
      : a_(a), d_(d), b_(b), enough_(enough) {}

  /// True when there is no need to go on.
  bool settled_by(const Vec3& axis) {
    const double length = axis.norm();
    if (length < kParallel) return false;
    const Vec3 n = axis / length;
    Span a = span_of(a_.vertices, n);
    const Span b = span_of(b_.vertices, n);
    const double travel = n.dot(d_);
    a.greatest += std::max(travel, 0.0);
    a.least += std::min(travel, 0.0);
    least_ = std::min({least_, a.greatest - b.least, b.greatest - a.least});
    return least_ <= enough_;
  }
  double value() const { return least_; }

 private:
  const Polytope& a_;
  const Vec3& d_;
  const Polytope& b_;
  double enough_;
  double least_ = std::numeric_limits<double>::infinity();
};

}  // namespace

Polytope box_polytope(const Vec3& half) {
  Polytope box;
  for (int corner = 0; corner < 8; ++corner) {
    box.vertices.emplace_back((corner & 1 ? 1 : -1) * half.x(), (corner & 2 ? 1 : -1) * half.y(),
                              (corner & 4 ? 1 : -1) * half.z());
  }
  box.normals = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  box.edges = box.normals;
  box.width = 2 * half.minCoeff();
  return box;
}

Polytope prism_polytope(const std::vector<Eigen::Vector2d>& polygon, double z0, double z1) {
  Polytope prism;
  const std::size_t count = polygon.size();
  prism.normals = {Vec3::UnitZ()};
  prism.edges = {Vec3::UnitZ()};
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d& corner = polygon[i];
    const Eigen::Vector2d edge = (polygon[(i + 1) % count] - corner).normalized();
    prism.vertices.emplace_back(corner.x(), corner.y(), z0);
    prism.vertices.emplace_back(corner.x(), corner.y(), z1);
    prism.normals.emplace_back(edge.y(), -edge.x(), 0);
    prism.edges.emplace_back(edge.x(), edge.y(), 0);
  }
  prism.width = std::numeric_limits<double>::infinity();
  for (const Vec3& normal : prism.normals) {
    const Span span = span_of(prism.vertices, normal);
    prism.width = std::min(prism.width, span.greatest - span.least);
  }
  return prism;
}

Polytope triangle_polytope(const Vec3& a, const Vec3& b, const Vec3& c) {
  Polytope triangle;
  triangle.vertices = {a, b, c};
  const double area = (b - a).cross(c - a).norm();
  double longest = 0;
  for (const Vec3& edge : {Vec3(b - a), Vec3(c - b), Vec3(a - c)}) {
    longest = std::max(longest, edge.norm());
    if (edge.norm() > 0) triangle.edges.push_back(edge.normalized());
  }
  if (area > 0) {
    triangle.normals = {(b - a).cross(c - a) / area};
    triangle.width = area / longest;
  }
  return triangle;
}

double reach_of(const Polytope& polytope) {
  double reach = 0;
  for (const Vec3& vertex : polytope.vertices) reach = std::max(reach, vertex.norm());
  return reach;
}

void place(const Polytope& polytope, const Pose& X, Polytope& result) {
  const auto copy = [](const std::vector<Vec3>& from, std::vector<Vec3>& to, const auto& change) {
    to.resize(from.size());
    std::transform(from.begin(), from.end(), to.begin(), change);
  };
  const Mat3 R = X.linear();
  const Vec3 t = X.translation();
  copy(polytope.vertices, result.vertices, [&](const Vec3& p) { return Vec3(R * p + t); });
  copy(polytope.normals, result.normals, [&](const Vec3& n) { return Vec3(R * n); });
  copy(polytope.edges, result.edges, [&](const Vec3& e) { return Vec3(R * e); });
  result.width = polytope.width;
}

Polytope placed(const Polytope& polytope, const Pose& X) {
  Polytope result;
  place(polytope, X, result);
  return result;
}

double swept_depth(const Polytope& a, const Vec3& d, const Polytope& b, double enough) {
  LeastOverlap least(a, d, b, enough);
  for (const Vec3& normal : a.normals) {
    if (least.settled_by(normal)) return least.value();
  }
  for (const Vec3& normal : b.normals) {
    if (least.settled_by(normal)) return least.value();
  }
  for (const Vec3& edge_a : a.edges) {
    for (const Vec3& edge_b : b.edges) {
      if (least.settled_by(edge_a.cross(edge_b))) return least.value();
    }
  }
  if (d.isZero(0)) return least.value();
  const Vec3 way = d.normalized();
  for (const std::vector<Vec3>* edges : {&a.edges, &b.edges}) {
    for (const Vec3& edge : *edges) {
      if (least.settled_by(way.cross(edge))) return least.value();
    }
  }
  return least.value();
}

double depth(const Polytope& a, const Polytope& b, double enough) {
  return swept_depth(a, Vec3::Zero(), b, enough);
}

double pair_tolerance(double contact_tolerance, double width_a, double width_b) {
  const double thin = std::max(0.25 * std::min(width_a, width_b), 10e-6);
  return std::max(std::min(contact_tolerance, thin), 1e-9);
}

}  // namespace rubicon::collision::proof
