#include "src/results/verify/geometry/footing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "src/motion/math/angles.hpp"
#include "src/results/verify/input/polygon_parts.hpp"

namespace rubicon::verify {

namespace {

using Vec2 = Eigen::Vector2d;

/// Corners of what is round.
constexpr int kRound = 120;
/// The upward part of a normal below which a face is a wall.
constexpr double kWall = 0.05;
/// Degrees: points are on one side of a line if an angle between two of them is larger than 180 and
/// this. Reason: rounding. Consequence: what rests on its edge is no fault.
constexpr double kAngleSlack = 1e-6;
/// m: corners nearer to each other are one, and points nearer to a plane, or a side, are on it. The
/// second also bounds how normals differ, the last is for corners of the polygon around them.
constexpr double kSameCorner = 1e-5;
constexpr double kSamePlane = 1e-5;
constexpr double kOnSide = 1e-9;
constexpr double kBeside = 1e-7;

class Triangles {
 public:
  Triangles(Hull& hull, const ShapeData& shape) : hull_(hull), X_(shape.X_BS) {}

  /// Both ends and the wall of what goes straight up over a polygon.
  void extrude(std::vector<Vec2> polygon, double z0, double z1) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2& a = polygon[i];
      const Vec2& b = polygon[(i + 1) % polygon.size()];
      twice += a.x() * b.y() - a.y() * b.x();
    }
    if (twice < 0) std::reverse(polygon.begin(), polygon.end());
    for (const Polygon& part : convex_parts(polygon)) {
      for (std::size_t i = 1; i + 1 < part.size(); ++i) {
        add(at(part[0], z1), at(part[i], z1), at(part[i + 1], z1));
        add(at(part[0], z0), at(part[i + 1], z0), at(part[i], z0));
      }
    }
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2& a = polygon[i];
      const Vec2& b = polygon[(i + 1) % polygon.size()];
      add(at(a, z0), at(b, z0), at(b, z1));
      add(at(a, z0), at(b, z1), at(a, z1));
    }
  }

  /// All points within the radius of the segment a-b: a globe whose northern half is at b.
  void globe(const Vec3& a, const Vec3& b, double radius) {
    const Vec3 axis = (b - a).norm() > 0 ? Vec3((b - a).normalized()) : Vec3(Vec3::UnitZ());
    const Vec3 side = axis.unitOrthogonal();
    const Vec3 other = axis.cross(side);
    const auto point = [&](int row, int column) -> Vec3 {
      const math::SineCosine up = math::sine_cosine_deg(360.0 * row / kRound - 90);
      const math::SineCosine turn = math::sine_cosine_deg(360.0 * column / kRound);
      return radius * (up.cosine * (turn.cosine * side + turn.sine * other) + up.sine * axis);
    };
    // The equator is there twice, at a and at b.
    const int half = kRound / 4;
    for (int row = 0; row <= 2 * half; ++row) {
      const bool is_middle = row == half;
      const Vec3& low = row <= half ? a : b;
      const Vec3& high = row < half ? a : b;
      const int lower = row <= half ? row : row - 1;
      const int upper = is_middle ? row : lower + 1;
      for (int column = 0; column < kRound; ++column) {
        const Vec3 p = low + point(lower, column);
        const Vec3 q = low + point(lower, column + 1);
        const Vec3 r = high + point(upper, column + 1);
        const Vec3 s = high + point(upper, column);
        add(p, q, r);
        add(p, r, s);
      }
    }
  }

  void mesh(const MeshData& mesh) {
    for (const std::array<int, 3>& each : mesh.triangles) {
      const auto corner = [&](std::size_t i) {
        return mesh.vertices[static_cast<std::size_t>(each[i])];
      };
      add(corner(0), corner(1), corner(2), !mesh.closed);
    }
  }

 private:
  static Vec3 at(const Vec2& p, double z) { return {p.x(), p.y(), z}; }
  void add(const Vec3& a, const Vec3& b, const Vec3& c, bool two_sided = false) {
    if (!((b - a).cross(c - a).norm() > 0)) return;
    hull_.triangles.push_back({{X_ * a, X_ * b, X_ * c}, two_sided});
  }

  Hull& hull_;
  Pose X_;
};

void add_shape(const ShapeData& shape, const std::vector<MeshData>& meshes, Hull& hull) {
  Triangles out(hull, shape);
  switch (shape.kind) {
    case ShapeData::Kind::box:
      return out.extrude({{shape.a.x(), shape.a.y()},
                          {shape.b.x(), shape.a.y()},
                          {shape.b.x(), shape.b.y()},
                          {shape.a.x(), shape.b.y()}},
                         shape.a.z(), shape.b.z());
    case ShapeData::Kind::cylinder: {
      std::vector<Vec2> circle;
      for (int i = 0; i < kRound; ++i) {
        const math::SineCosine turn = math::sine_cosine_deg(360.0 * i / kRound);
        circle.emplace_back(shape.radius * turn.cosine, shape.radius * turn.sine);
      }
      return out.extrude(std::move(circle), shape.z0, shape.z1);
    }
    case ShapeData::Kind::sphere:
      return out.globe(shape.a, shape.a, shape.radius);
    case ShapeData::Kind::capsule:
      return out.globe(shape.a, shape.b, shape.radius);
    case ShapeData::Kind::prism:
      return out.extrude(shape.polygon, shape.z0, shape.z1);
    case ShapeData::Kind::mesh:
      return out.mesh(meshes[static_cast<std::size_t>(shape.mesh)]);
  }
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The corners of the convex polygon around the points, counter-clockwise: a string that is wound
/// round them (R. A. Jarvis, 1973), from the farthest from their middle, which is a corner. It goes
/// straight to the end of a side: points that are beside it by rounding would lead it astray.
std::vector<Vec2> wound_round(const std::vector<Vec2>& points) {
  std::vector<Vec2> corners;
  if (points.empty()) return corners;
  Vec2 middle = Vec2::Zero();
  for (const Vec2& each : points) middle += (each - points[0]) / static_cast<double>(points.size());
  middle += points[0];
  const auto is_nearer = [&](const Vec2& a, const Vec2& b) {
    return (a - middle).squaredNorm() < (b - middle).squaredNorm();
  };
  const Vec2 start = *std::max_element(points.begin(), points.end(), is_nearer);
  Vec2 corner = start;
  do {
    corners.push_back(corner);
    Vec2 way = Vec2::Zero();
    for (const Vec2& point : points) {
      const Vec2 other = point - corner;
      const double longer = std::max(way.norm(), other.norm());
      const double beside = longer > 0 ? cross(way, other) / longer : 0;
      const bool is_straight_on = std::abs(beside) < kBeside;
      if (is_straight_on ? other.norm() > way.norm() : beside < 0) way = other;
    }
    corner += way;
  } while ((corner - start).norm() > kBeside && corners.size() <= points.size());
  return corners;
}

/// Where the sides of the polygon around the points, moved inwards, cross each other inside of all
/// of them.
std::vector<Vec2> corners_inside(const std::vector<Vec2>& points, double margin) {
  struct Line {
    Vec2 inwards;
    double from;  ///< along it
  };
  std::vector<Vec2> corners;
  for (const Vec2& each : wound_round(points)) {
    const auto is_same = [&](const Vec2& other) { return (each - other).norm() < kSameCorner; };
    if (std::none_of(corners.begin(), corners.end(), is_same)) corners.push_back(each);
  }
  std::vector<Line> lines;
  for (std::size_t i = 0; corners.size() > 2 && i < corners.size(); ++i) {
    const Vec2 way = (corners[(i + 1) % corners.size()] - corners[i]).normalized();
    const Vec2 inwards(-way.y(), way.x());
    lines.push_back({inwards, inwards.dot(corners[i] - corners[0]) + margin});
  }
  std::vector<Vec2> found;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t k = i + 1; k < lines.size(); ++k) {
      const double turn = cross(lines[i].inwards, lines[k].inwards);
      if (std::abs(turn) < kOnSide) continue;
      const Vec2 p = (lines[i].from * Vec2(lines[k].inwards.y(), -lines[k].inwards.x()) -
                      lines[k].from * Vec2(lines[i].inwards.y(), -lines[i].inwards.x())) /
                     turn;
      const auto is_inside = [&](const Line& line) {
        return line.inwards.dot(p) > line.from - kOnSide;
      };
      if (std::all_of(lines.begin(), lines.end(), is_inside)) found.push_back(corners[0] + p);
    }
  }
  return found;
}

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 way = b - a;
  const double square = way.squaredNorm();
  const double share = square > 0 ? std::clamp(way.dot(p - a) / square, 0.0, 1.0) : 0;
  return (p - a - share * way).norm();
}

/// The part of a segment where a linear value is not negative, as shares from..to of it.
void cut(double at_start, double at_end, double& from, double& to) {
  if (at_start < 0 && at_end < 0) {
    to = -1;
  } else if (at_start < 0) {
    from = std::max(from, at_start / (at_start - at_end));
  } else if (at_end < 0) {
    to = std::min(to, at_start / (at_start - at_end));
  }
}

/// The height of the plane of a triangle over p.
double height(const std::array<Vec3, 3>& face, const Vec2& p) {
  const Vec3 n = (face[1] - face[0]).cross(face[2] - face[0]);
  const Vec2 way = p - face[0].head<2>();
  return face[0].z() - (n.x() * way.x() + n.y() * way.y()) / n.z();
}

/// Ends of the sides of `face` where they are over or under the other by so much.
void add_sides(const std::array<Vec3, 3>& face, const std::array<Vec3, 3>& other, double least,
               double most, std::vector<Vec2>& points) {
  const Vec2 o = other[0].head<2>();
  const bool is_left = cross(other[1].head<2>() - o, other[2].head<2>() - o) > 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = face[i];
    const Vec3& b = face[(i + 1) % 3];
    double from = 0;
    double to = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 corner = other[k].head<2>();
      const Vec2 side = Vec2(other[(k + 1) % 3].head<2>() - corner) * (is_left ? 1 : -1);
      cut(cross(side, a.head<2>() - corner), cross(side, b.head<2>() - corner), from, to);
    }
    const double above_a = a.z() - height(other, a.head<2>());
    const double above_b = b.z() - height(other, b.head<2>());
    cut(above_a - least, above_b - least, from, to);
    cut(most - above_a, most - above_b, from, to);
    if (from > to) continue;
    const Vec2 way = b.head<2>() - a.head<2>();
    points.push_back(a.head<2>() + from * way);
    points.push_back(a.head<2>() + to * way);
  }
}

}  // namespace

Hull hull_of(const std::vector<ShapeData>& shapes, const std::vector<MeshData>& meshes) {
  Hull hull;
  for (const ShapeData& shape : shapes) {
    add_shape(shape, meshes, hull);
    hull.is_round = hull.is_round || shape.kind == ShapeData::Kind::cylinder ||
                    shape.kind == ShapeData::Kind::sphere || shape.kind == ShapeData::Kind::capsule;
  }
  if (hull.triangles.empty()) return hull;
  const bool open = std::any_of(hull.triangles.begin(), hull.triangles.end(),
                                [](const Hull::Triangle& each) { return each.two_sided; });
  const Vec3 origin = hull.triangles.front().corners[0];
  double sum = 0;
  Vec3 moment = Vec3::Zero();
  for (const auto& [corners, two_sided] : hull.triangles) {
    const Vec3 a = corners[0] - origin;
    const Vec3 b = corners[1] - origin;
    const Vec3 c = corners[2] - origin;
    // Tetrahedra with the origin; of an open surface its triangles themselves.
    const double part = open ? (b - a).cross(c - a).norm() : a.dot(b.cross(c));
    sum += part;
    moment += part * (a + b + c) / (open ? 3 : 4);
  }
  hull.centre_of_mass = sum > 0 ? Vec3(origin + moment / sum) : origin;
  return hull;
}

Faces faces_looking(const Hull& hull, const Pose& X_WS, bool up) {
  Faces faces;
  for (const auto& [corners, two_sided] : hull.triangles) {
    const std::array<Vec3, 3> face = {X_WS * corners[0], X_WS * corners[1], X_WS * corners[2]};
    const double rise = (face[1] - face[0]).cross(face[2] - face[0]).normalized().z();
    const double wanted = up ? rise : -rise;
    if (wanted > kWall || (two_sided && wanted < -kWall)) faces.push_back(face);
  }
  return faces;
}

std::vector<FootingPoint> footing_points(const Faces& over, const Faces& under, double gap,
                                         double depth) {
  struct Extent {
    double least_x, most_x, least_y, most_y;
  };
  const auto extent_of = [](const std::array<Vec3, 3>& face) {
    const auto [x0, x1] = std::minmax({face[0].x(), face[1].x(), face[2].x()});
    const auto [y0, y1] = std::minmax({face[0].y(), face[1].y(), face[2].y()});
    return Extent{x0, x1, y0, y1};
  };
  const auto are_apart = [](const Extent& a, const Extent& b) {
    return a.least_x > b.most_x || b.least_x > a.most_x || a.least_y > b.most_y ||
           b.least_y > a.most_y;
  };
  std::vector<Extent> extents;
  Extent all = {1e300, -1e300, 1e300, -1e300};
  for (const auto& face : over) {
    const Extent its = extent_of(face);
    extents.push_back(its);
    all = {std::min(all.least_x, its.least_x), std::max(all.most_x, its.most_x),
           std::min(all.least_y, its.least_y), std::max(all.most_y, its.most_y)};
  }
  std::vector<FootingPoint> found;
  for (const auto& face : under) {
    const Extent its = extent_of(face);
    if (are_apart(its, all)) continue;
    for (std::size_t i = 0; i < over.size(); ++i) {
      if (are_apart(its, extents[i])) continue;
      std::vector<Vec2> points;
      add_sides(over[i], face, -depth, gap, points);
      add_sides(face, over[i], -gap, depth, points);
      const Vec3 across = (face[1] - face[0]).cross(face[2] - face[0]).normalized();
      for (const Vec2& p : points) {
        found.push_back({{p.x(), p.y(), height(face, p)}, across.z() < 0 ? Vec3(-across) : across});
      }
    }
  }
  return found;
}

std::vector<Vec2> footing(const Faces& over, const Faces& under, double gap, double depth) {
  std::vector<Vec2> points;
  for (const FootingPoint& each : footing_points(over, under, gap, depth)) {
    points.push_back(each.point.head<2>());
  }
  return points;
}

std::vector<FootingPoint> drawn_in(const std::vector<FootingPoint>& points, double margin) {
  struct Plane {
    FootingPoint first;
    std::vector<Vec2> points;
  };
  std::vector<Plane> planes;
  for (const FootingPoint& each : points) {
    const auto is_in = [&](const Plane& plane) {
      return (plane.first.normal - each.normal).norm() < kSamePlane &&
             std::abs(plane.first.normal.dot(each.point - plane.first.point)) < kSamePlane;
    };
    auto plane = std::find_if(planes.begin(), planes.end(), is_in);
    if (plane == planes.end()) plane = planes.insert(plane, {each, {}});
    plane->points.push_back(each.point.head<2>());
  }
  std::vector<FootingPoint> left;
  for (const auto& [first, all] : planes) {
    const Vec3& n = first.normal;
    // Seen from above what is across a slope is shorter.
    double by = margin * n.z();
    std::vector<Vec2> inside = corners_inside(all, by);
    for (int i = 0; inside.empty() && i < 10; ++i) inside = corners_inside(all, by /= 2);
    for (const Vec2& p : inside.empty() ? all : inside) {
      const Vec2 way = p - first.point.head<2>();
      const double z = first.point.z() - (n.x() * way.x() + n.y() * way.y()) / n.z();
      left.push_back({{p.x(), p.y(), z}, n});
    }
  }
  return left;
}

bool is_as_wide(const std::vector<Vec2>& points, double margin) {
  return !points.empty() && (margin <= 0 || !corners_inside(points, margin).empty());
}

bool is_between(const Vec2& p, const std::vector<Vec2>& points, double margin) {
  const std::vector<Vec2> corners = wound_round(points);
  for (std::size_t i = 0; margin > 0 && i < corners.size(); ++i) {
    if (distance_to_segment(p, corners[i], corners[(i + 1) % corners.size()]) < margin)
      return false;
  }
  std::vector<double> angles;
  for (const Vec2& point : points) {
    const Vec2 way = point - p;
    if (way.norm() < 1e-9) return true;
    angles.push_back(math::atan2_deg(way.y(), way.x()));
  }
  if (angles.size() < 2) return false;
  std::sort(angles.begin(), angles.end());
  double widest = angles.front() + 360 - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) {
    widest = std::max(widest, angles[i] - angles[i - 1]);
  }
  return widest <= 180 + kAngleSlack;
}

}  // namespace rubicon::verify
