#include "src/exchange/ifc/curve_points.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/exchange/ifc/chords.hpp"
#include "src/exchange/ifc/ifc_placement.hpp"
#include "src/exchange/ifc/step_values.hpp"
#include "src/motion/math/angles.hpp"
#include "src/motion/math/turns.hpp"

namespace rubicon::ifc {

namespace {

using math::Pose;
using math::Vec3;

/// Nearer than this (metres) two pieces of a curve meet.
constexpr double kMeet = 1e-5;

bool is_flat(const StepFile& file, std::uint64_t placement) {
  const StepRecord* record = file.find(placement);
  return record != nullptr && record->keyword == "IFCAXIS2PLACEMENT2D";
}

/// A circle or ellipse in its own frame.
struct Conic {
  Pose X = Pose::Identity();
  double a = 0, b = 0;
  bool flat = false;

  Arc arc(double from_deg, double turn_deg) const {
    return {X.translation(), a * X.linear().col(0), b * X.linear().col(1), from_deg, turn_deg};
  }
};

std::optional<Conic> conic(const StepFile& file, const StepRecord& record) {
  const bool circle = record.keyword == "IFCCIRCLE";
  if (!circle && record.keyword != "IFCELLIPSE") return std::nullopt;
  const auto values = StepValues::read(record.arguments);
  if (!values) return std::nullopt;
  const auto X = axis_placement(file, (*values)[0].reference());
  const double a = (*values)[1].number().value_or(0);
  const double b = circle ? a : (*values)[2].number().value_or(0);
  if (!X || !(a > 0) || !(b > 0)) return std::nullopt;
  return Conic{*X, a, b, is_flat(file, (*values)[0].reference())};
}

class CurveReader {
 public:
  explicit CurveReader(const ShapeTerms& terms) : terms_(terms) {}

  std::optional<PointLine> read(std::uint64_t id, int depth) {
    const StepRecord* record = terms_.file.find(id);
    if (record == nullptr || depth > kDeepestCurve || !terms_.budget.spend(1)) return std::nullopt;
    if (record->keyword == "IFCINDEXEDPOLYCURVE") {
      return indexed_curve(terms_.file, *record, terms_.metres_per_unit);
    }
    const auto values = StepValues::read(record->arguments);
    if (!values) return std::nullopt;
    if (record->keyword == "IFCPOLYLINE") return polyline(*values);
    if (record->keyword == "IFCTRIMMEDCURVE") return trimmed(*values);
    if (record->keyword == "IFCCOMPOSITECURVE") return composite(*values, depth);
    return whole_conic(*record);
  }

 private:
  std::optional<PointLine> polyline(const StepValues& values) {
    PointLine line;
    for (const StepItem each : values[0]) {
      const auto point = point_of(each.reference());
      if (!point) return std::nullopt;
      line.flat = point->second;
      line.points.push_back(point->first);
    }
    if (line.points.empty()) return std::nullopt;
    return line;
  }

  /// A point, and whether it has two coordinates.
  std::optional<std::pair<Vec3, bool>> point_of(std::uint64_t id) {
    const auto point = cartesian_point(terms_.file, id);
    if (!point || !terms_.budget.spend(1)) return std::nullopt;
    const auto values = StepValues::read(terms_.file.find(id)->arguments);
    return std::pair(*point, values && (*values)[0].size() == 2);
  }

  std::optional<PointLine> whole_conic(const StepRecord& record) {
    const auto shape = conic(terms_.file, record);
    if (!shape) return std::nullopt;
    return along(*shape, 0, 360);
  }

  PointLine along(const Conic& shape, double from_deg, double turn_deg) {
    const Arc arc = shape.arc(from_deg, turn_deg);
    PointLine line{{arc_start(arc)}, shape.flat};
    add_chords(arc, terms_.metres_per_unit, line.points);
    return line;
  }

  std::optional<PointLine> trimmed(const StepValues& values) {
    const StepRecord* basis = terms_.file.find(values[0].reference());
    if (basis == nullptr) return std::nullopt;
    if (basis->keyword == "IFCLINE") return trimmed_line(*basis, values);
    const auto shape = conic(terms_.file, *basis);
    const auto from = shape ? angle_of(*shape, values[1]) : std::nullopt;
    const auto to = shape ? angle_of(*shape, values[2]) : std::nullopt;
    if (!from || !to) return std::nullopt;
    const bool forward = !values[3].is_enumeration("F");
    // A whole circle may come out as nearly none.
    constexpr double kNone = 1e-9;
    const double turn = math::turn_above_deg(forward ? *to - *from : *from - *to, kNone);
    return along(*shape, *from, forward ? turn : -turn);
  }

  /// The angle in degrees at which a conic is trimmed: its parameter, else that of the point.
  std::optional<double> angle_of(const Conic& shape, const StepItem& trim) {
    for (const StepItem each : trim) {
      const auto parameter = each.kind() == StepKind::typed ? each.number() : std::nullopt;
      if (parameter) return math::degrees(*parameter * terms_.radians_per_unit);
    }
    for (const StepItem each : trim) {
      const auto point = cartesian_point(terms_.file, each.reference());
      if (!point) continue;
      const Vec3 p = shape.X.inverse(Eigen::Isometry) * *point;
      return math::atan2_deg(p.y() / shape.b, p.x() / shape.a);
    }
    return std::nullopt;
  }

  std::optional<PointLine> trimmed_line(const StepRecord& basis, const StepValues& values) {
    const auto line = StepValues::read(basis.arguments);
    if (!line) return std::nullopt;
    const auto origin = point_of((*line)[0].reference());
    const auto along = vector_of((*line)[1].reference());
    if (!origin || !along) return std::nullopt;
    PointLine result{{}, origin->second};
    for (const std::size_t end : {std::size_t{1}, std::size_t{2}}) {
      std::optional<Vec3> at;
      for (const StepItem each : values[end]) {
        if (at) continue;
        const auto parameter = each.kind() == StepKind::typed ? each.number() : std::nullopt;
        at = parameter ? std::optional<Vec3>(origin->first + *parameter * *along)
                       : cartesian_point(terms_.file, each.reference());
      }
      if (!at) return std::nullopt;
      result.points.push_back(*at);
    }
    return result;
  }

  /// An IfcVector.
  std::optional<Vec3> vector_of(std::uint64_t id) const {
    const StepRecord* record = terms_.file.find(id);
    if (record == nullptr || record->keyword != "IFCVECTOR") return std::nullopt;
    const auto values = StepValues::read(record->arguments);
    const auto length = values ? (*values)[1].number() : std::nullopt;
    const auto way = values ? unit_direction(terms_.file, (*values)[0].reference()) : std::nullopt;
    if (!length || !way) return std::nullopt;
    return Vec3(*length * *way);
  }

  std::optional<PointLine> composite(const StepValues& values, int depth) {
    PointLine whole;
    for (const StepItem each : values[0]) {
      const StepRecord* segment = terms_.file.find(each.reference());
      if (segment == nullptr || segment->keyword != "IFCCOMPOSITECURVESEGMENT") {
        return std::nullopt;
      }
      const auto parts = StepValues::read(segment->arguments);
      auto piece = parts ? read((*parts)[2].reference(), depth + 1) : std::nullopt;
      if (!piece) return std::nullopt;
      if ((*parts)[1].is_enumeration("F")) std::reverse(piece->points.begin(), piece->points.end());
      if (!terms_.budget.spend(piece->points.size())) return std::nullopt;
      whole.flat = piece->flat;
      const bool meets =
          !whole.points.empty() &&
          (whole.points.back() - piece->points.front()).norm() * terms_.metres_per_unit < kMeet;
      whole.points.insert(whole.points.end(), piece->points.begin() + (meets ? 1 : 0),
                          piece->points.end());
    }
    if (whole.points.empty()) return std::nullopt;
    return whole;
  }

  const ShapeTerms& terms_;
};

}  // namespace

std::optional<PointLine> curve_points(const ShapeTerms& terms, std::uint64_t id) {
  return CurveReader(terms).read(id, 0);
}

}  // namespace rubicon::ifc
