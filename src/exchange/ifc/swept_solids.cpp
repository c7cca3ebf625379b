#include "src/exchange/ifc/swept_solids.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "src/exchange/ifc/chords.hpp"
#include "src/motion/math/angles.hpp"

namespace rubicon::ifc {

namespace {

using math::Vec3;

/// Copies of a region, one behind the other, that make a body.
class Sweep {
 public:
  /// The outline runs counterclockwise about `normal`, holes clockwise, whatever they were.
  Sweep(const Region& region, const Vec3& normal) : normal_(normal) {
    add(region.outline, true);
    for (const auto& hole : region.holes) add(hole, false);
  }

  std::size_t size() const { return section_.size(); }
  const std::vector<Vec3>& section() const { return section_; }

  void put_section(const std::vector<Vec3>& points) {
    solid_.points.insert(solid_.points.end(), points.begin(), points.end());
    ++sections_;
  }

  /// With `ring` the last section joins the first and there are no ends.
  std::optional<Solid> finish(bool ring, WorkBudget& budget) {
    if (!budget.spend(solid_.points.size())) return std::nullopt;
    const std::size_t steps = ring ? sections_ : sections_ - 1;
    for (std::size_t s = 0; s < steps; ++s) put_sides(s, (s + 1) % sections_);
    if (!ring) {
      const auto ends = triangulate(section_, loops_, normal_, budget);
      if (!ends) return std::nullopt;
      const auto last = static_cast<int>((sections_ - 1) * size());
      for (const auto& t : *ends) {
        solid_.triangles.push_back({t[0], t[2], t[1]});
        solid_.triangles.push_back({t[0] + last, t[1] + last, t[2] + last});
      }
    }
    const double volume = volume_of(solid_);
    if (!(std::fabs(volume) > 0) || !std::isfinite(volume)) return std::nullopt;
    if (volume < 0) {
      for (auto& t : solid_.triangles) std::swap(t[1], t[2]);
    }
    return std::move(solid_);
  }

 private:
  void add(std::vector<Vec3> line, bool counterclockwise) {
    Loop loop;
    for (std::size_t i = 0; i < line.size(); ++i) loop.push_back(static_cast<int>(i));
    if ((loop_normal(line, loop).dot(normal_) > 0) != counterclockwise) {
      std::reverse(line.begin(), line.end());
    }
    for (int& index : loop) index += static_cast<int>(section_.size());
    loops_.push_back(std::move(loop));
    section_.insert(section_.end(), line.begin(), line.end());
  }

  void put_sides(std::size_t from, std::size_t to) {
    const auto a = static_cast<int>(from * size());
    const auto b = static_cast<int>(to * size());
    for (const Loop& loop : loops_) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const int p = loop[i];
        const int q = loop[(i + 1) % loop.size()];
        solid_.triangles.push_back({a + p, a + q, b + q});
        solid_.triangles.push_back({a + p, b + q, b + p});
      }
    }
  }

  Vec3 normal_;
  std::vector<Vec3> section_;
  std::vector<Loop> loops_;
  Solid solid_;
  std::size_t sections_ = 0;
};

std::vector<Vec3> circle(const Vec3& centre, const Vec3& x, const Vec3& y, double radius,
                         double metres_per_unit) {
  std::vector<Vec3> points;
  if (radius > 0) add_chords({centre, radius * x, radius * y, 0, 360}, metres_per_unit, points);
  return points;
}

/// Points without those that follow at the same place.
std::vector<Vec3> distinct(const std::vector<Vec3>& line, double same) {
  std::vector<Vec3> points;
  for (const Vec3& p : line) {
    if (points.empty() || (p - points.back()).norm() > same) points.push_back(p);
  }
  return points;
}

}  // namespace

std::optional<Solid> extruded(const Region& region, const Vec3& way, WorkBudget& budget) {
  Sweep sweep(region, Vec3::UnitZ());
  std::vector<Vec3> end = sweep.section();
  for (Vec3& p : end) p += way;
  sweep.put_section(sweep.section());
  sweep.put_section(end);
  return sweep.finish(false, budget);
}

std::optional<Solid> revolved(const Region& region, const Axis& axis, double turn_deg,
                              double metres_per_unit, WorkBudget& budget) {
  constexpr double kWhole = 360 - 1e-6;
  const bool ring = std::fabs(turn_deg) >= kWhole;
  if (ring) turn_deg = 360;
  double radius = 0;
  double left = 0;
  double right = 0;
  const Vec3 across = Vec3::UnitZ().cross(axis.direction);
  for (const Vec3& p : region.outline) {
    radius = std::max(radius, axis.direction.cross(p - axis.point).norm());
    left = std::max(left, across.dot(p - axis.point));
    right = std::max(right, -across.dot(p - axis.point));
  }
  // An area on both sides of its axis would run through itself.
  const double same = kOnPlane / metres_per_unit;
  if (std::min(left, right) > same || !(std::fabs(turn_deg) > 0)) return std::nullopt;
  const double most = chord_turn_deg(radius * metres_per_unit);
  int steps = std::max(1, static_cast<int>(std::ceil(std::fabs(turn_deg) / most - 1e-9)));
  if (ring) steps = (steps + 3) / 4 * 4;
  Sweep sweep(region, Vec3::UnitZ());
  for (int s = 0; s <= steps - (ring ? 1 : 0); ++s) {
    if (!budget.spend(sweep.size())) return std::nullopt;
    const math::Mat3 turn = math::rotation_about_deg(axis.direction, turn_deg * s / steps);
    std::vector<Vec3> section;
    for (const Vec3& p : sweep.section()) {
      const Vec3 from = p - axis.point;
      const Vec3 foot = axis.direction * axis.direction.dot(from);
      // What lies on the axis stays, so that it can be joined.
      const bool on_axis = (from - foot).norm() < same;
      section.push_back(axis.point + (on_axis ? foot : Vec3(turn * from)));
    }
    sweep.put_section(section);
  }
  const auto solid = sweep.finish(ring, budget);
  if (!solid) return std::nullopt;
  return welded(*solid);
}

std::optional<Solid> swept_disk(const std::vector<Vec3>& line, double radius, double inner,
                                double metres_per_unit, WorkBudget& budget) {
  const std::vector<Vec3> path = distinct(line, kOnPlane / metres_per_unit);
  if (path.size() < 2 || !(radius > 0) || inner >= radius) return std::nullopt;
  const auto direction = [&](std::size_t i) { return Vec3((path[i + 1] - path[i]).normalized()); };
  const Vec3 first = direction(0);
  const Vec3 x = first.unitOrthogonal();
  const Vec3 y = first.cross(x);
  Region region{circle(path[0], x, y, radius, metres_per_unit), {}};
  if (inner > 0) region.holes.push_back(circle(path[0], x, y, inner, metres_per_unit));
  Sweep sweep(region, first);
  std::vector<Vec3> section = sweep.section();
  sweep.put_section(section);
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!budget.spend(section.size())) return std::nullopt;
    const Vec3 way = direction(i - 1);
    const Vec3 next = i + 1 < path.size() ? direction(i) : way;
    // Turns of more than 150 degrees make spikes.
    constexpr double kSharpest = -0.866;
    if (way.dot(next) < kSharpest) return std::nullopt;
    const Vec3 mitre = (way + next).normalized();
    for (Vec3& p : section) {
      const double length = mitre.dot(path[i] - p) / mitre.dot(way);
      if (!(length > 0)) return std::nullopt;
      p += length * way;
    }
    sweep.put_section(section);
  }
  return sweep.finish(false, budget);
}

}  // namespace rubicon::ifc
