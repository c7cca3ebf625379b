#include "src/exchange/ifc/ifc_curve.hpp"

#include <cstddef>

#include "src/exchange/ifc/chords.hpp"
#include "src/exchange/ifc/step_values.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/math/turns.hpp"

namespace rubicon::ifc {

namespace {

using math::Vec3;

std::optional<PointLine> point_list(const StepFile& file, std::uint64_t id) {
  const StepRecord* record = file.find(id);
  if (record == nullptr || !record->keyword.starts_with("IFCCARTESIANPOINTLIST")) {
    return std::nullopt;
  }
  PointLine line;
  line.flat = record->keyword == "IFCCARTESIANPOINTLIST2D";
  const auto values = StepValues::read(record->arguments);
  if (!values) return std::nullopt;
  for (const StepItem each : (*values)[0]) {
    Vec3 p = Vec3::Zero();
    int count = 0;
    for (const StepItem value : each) {
      const auto number = value.number();
      if (!number || count == 3) return std::nullopt;
      p[count++] = *number;
    }
    if (count != (line.flat ? 2 : 3)) return std::nullopt;
    line.points.push_back(p);
  }
  return line;
}

/// The points of the arc from a over b to c, without a.
void add_arc(const Vec3& a, const Vec3& b, const Vec3& c, double metres_per_unit,
             std::vector<Vec3>& out) {
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const Vec3 n = u.cross(v);
  // Nearly on a line: the chord is the arc.
  constexpr double kStraight = 1e-9;
  if (!(n.norm() > kStraight * u.norm() * v.norm())) {
    out.push_back(b);
    out.push_back(c);
    return;
  }
  // Centre of the circle through three points (Ericson, Real-Time Collision Detection, 3.8).
  const Vec3 centre =
      a + (v.squaredNorm() * n.cross(u) + u.squaredNorm() * v.cross(n)) / (2 * n.squaredNorm());
  const Vec3 x = (a - centre).normalized();
  const Vec3 y = n.normalized().cross(x);
  const double radius = (a - centre).norm();
  const double turn =
      math::turn_above_deg(math::atan2_deg((c - centre).dot(y), (c - centre).dot(x)), 0);
  add_chords({centre, radius * x, radius * y, 0, turn}, metres_per_unit, out);
  out.back() = c;
}

}  // namespace

std::optional<PointLine> indexed_curve(const StepFile& file, const StepRecord& record,
                                       double metres_per_unit) {
  if (record.keyword != "IFCINDEXEDPOLYCURVE") return std::nullopt;
  const auto values = StepValues::read(record.arguments);
  if (!values) return std::nullopt;
  std::optional<PointLine> list = point_list(file, (*values)[0].reference());
  if (!list || list->points.empty()) return std::nullopt;
  const StepItem segments = (*values)[1];
  if (!segments.is_set()) return list;
  PointLine line;
  line.flat = list->flat;
  for (const StepItem segment : segments) {
    std::vector<Vec3> corners;
    for (const StepItem each : segment[0]) {
      const auto index = whole_number(each.text());
      if (!index || *index == 0 || *index > list->points.size()) return std::nullopt;
      corners.push_back(list->points[static_cast<std::size_t>(*index - 1)]);
    }
    if (corners.size() < 2) return std::nullopt;
    if (line.points.empty()) line.points.push_back(corners.front());
    if (segment.text() == "IFCARCINDEX" && corners.size() == 3) {
      add_arc(corners[0], corners[1], corners[2], metres_per_unit, line.points);
    } else if (segment.text() == "IFCLINEINDEX") {
      line.points.insert(line.points.end(), corners.begin() + 1, corners.end());
    } else {
      return std::nullopt;
    }
  }
  if (line.points.empty()) return std::nullopt;
  return line;
}

}  // namespace rubicon::ifc
