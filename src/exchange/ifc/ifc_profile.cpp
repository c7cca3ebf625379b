#include "src/exchange/ifc/ifc_profile.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "src/exchange/ifc/chords.hpp"
#include "src/exchange/ifc/ifc_placement.hpp"
#include "src/exchange/ifc/step_values.hpp"

namespace rubicon::ifc {

namespace {

using math::Vec3;
using Corners = std::vector<RoundCorner>;

// Measures follow the position, which is the third argument.
constexpr std::size_t kPosition = 2;
constexpr std::size_t kMeasures = 3;

/// The measures of a profile, those that are there.
class Measures {
 public:
  explicit Measures(const StepValues& values) : values_(values) {}
  /// Nothing is -1: no measure is negative.
  double operator[](std::size_t index) const {
    return values_[kMeasures + index].number().value_or(-1);
  }

 private:
  const StepValues& values_;
};

RoundCorner at(double x, double y, double radius = 0) { return {{x, y, 0}, radius}; }

/// All must be above zero.
bool are_lengths(std::initializer_list<double> lengths) {
  return std::all_of(lengths.begin(), lengths.end(), [](double length) { return length > 0; });
}

/// What measures make: one outline, and one hole at most.
struct Shape {
  Corners outline;
  Corners hole;
};

Corners rectangle(double x, double y, double radius) {
  return {at(-x, -y, radius), at(x, -y, radius), at(x, y, radius), at(-x, y, radius)};
}

std::optional<Shape> plain_rectangle(const Measures& m) {
  if (!are_lengths({m[0], m[1]})) return std::nullopt;
  return Shape{rectangle(m[0] / 2, m[1] / 2, 0), {}};
}

std::optional<Shape> rounded_rectangle(const Measures& m) {
  if (!are_lengths({m[0], m[1]})) return std::nullopt;
  return Shape{rectangle(m[0] / 2, m[1] / 2, m[2]), {}};
}

std::optional<Shape> hollow_rectangle(const Measures& m) {
  const double x = m[0] / 2;
  const double y = m[1] / 2;
  const double wall = m[2];
  if (!are_lengths({x, y, wall, x - wall, y - wall})) return std::nullopt;
  return Shape{rectangle(x, y, m[4]), rectangle(x - wall, y - wall, m[3])};
}

std::optional<Shape> angle(const Measures& m) {
  const double y = m[0] / 2;
  const double x = m[1] > 0 ? m[1] / 2 : y;  // equal legs
  const double t = m[2];
  const double edge = m[4];
  if (!are_lengths({x, y, t, 2 * x - t, 2 * y - t})) return std::nullopt;
  return Shape{{at(-x, -y), at(x, -y), at(x, t - y, edge), at(t - x, t - y, m[3]),
                at(t - x, y, edge), at(-x, y)},
               {}};
}

std::optional<Shape> channel(const Measures& m) {
  const double y = m[0] / 2;
  const double x = m[1] / 2;
  const double web = m[2];
  const double flange = m[3];
  const double fillet = m[4];
  const double edge = m[5];
  if (!are_lengths({x, y, web, flange, 2 * x - web, y - flange})) return std::nullopt;
  return Shape{{at(-x, -y), at(x, -y), at(x, flange - y, edge), at(web - x, flange - y, fillet),
                at(web - x, y - flange, fillet), at(x, y - flange, edge), at(x, y), at(-x, y)},
               {}};
}

std::optional<Shape> tee(const Measures& m) {
  const double y = m[0] / 2;
  const double x = m[1] / 2;
  const double web = m[2] / 2;
  const double flange = m[3];
  const double fillet = m[4];
  if (!are_lengths({x, y, web, flange, x - web, 2 * y - flange})) return std::nullopt;
  return Shape{
      {at(-web, -y, m[6]), at(web, -y, m[6]), at(web, y - flange, fillet), at(x, y - flange, m[5]),
       at(x, y), at(-x, y), at(-x, y - flange, m[5]), at(-web, y - flange, fillet)},
      {}};
}

std::optional<Shape> lipped_channel(const Measures& m) {
  const double y = m[0] / 2;
  const double x = m[1] / 2;
  const double t = m[2];
  const double lip = m[3];
  const double inner = m[4];
  const double outer = inner > 0 ? inner + t : 0;  // the wall is as thick in the bend
  if (!are_lengths({x, y, t, lip - t, x - t, y - lip})) return std::nullopt;
  return Shape{{at(-x, -y, outer), at(x, -y, outer), at(x, lip - y), at(x - t, lip - y),
                at(x - t, t - y, inner), at(t - x, t - y, inner), at(t - x, y - t, inner),
                at(x - t, y - t, inner), at(x - t, y - lip), at(x, y - lip), at(x, y, outer),
                at(-x, y, outer)},
               {}};
}

std::optional<Shape> zed(const Measures& m) {
  const double y = m[0] / 2;
  const double web = m[2] / 2;
  const double x = m[1] - web;  // the flanges point away from each other
  const double flange = m[3];
  const double fillet = m[4];
  const double edge = m[5];
  if (!are_lengths({x, y, web, flange, x - web, y - flange})) return std::nullopt;
  return Shape{{at(-web, -y), at(x, -y), at(x, flange - y, edge), at(web, flange - y, fillet),
                at(web, y), at(-x, y), at(-x, y - flange, edge), at(-web, y - flange, fillet)},
               {}};
}

/// Of an I: half of the width, thickness and radii of one flange.
struct Flange {
  double half = 0, thickness = 0, fillet = 0, edge = 0;
};

std::optional<Shape> double_tee(double y, double web, const Flange& low, const Flange& high) {
  if (!are_lengths({low.half, high.half, y, web, low.thickness, high.thickness, low.half - web,
                    high.half - web, 2 * y - low.thickness - high.thickness})) {
    return std::nullopt;
  }
  const double under = y - high.thickness;
  const double over = low.thickness - y;
  return Shape{
      {at(-low.half, -y), at(low.half, -y), at(low.half, over, low.edge), at(web, over, low.fillet),
       at(web, under, high.fillet), at(high.half, under, high.edge), at(high.half, y),
       at(-high.half, y), at(-high.half, under, high.edge), at(-web, under, high.fillet),
       at(-web, over, low.fillet), at(-low.half, over, low.edge)},
      {}};
}

std::optional<Shape> equal_i(const Measures& m) {
  const Flange flange{m[0] / 2, m[3], m[4], m[5]};
  return double_tee(m[1] / 2, m[2] / 2, flange, flange);
}

std::optional<Shape> unequal_i(const Measures& m) {
  // IFC 4 goes on with the edges of flanges, 2x3 with the centre of gravity.
  const Flange low{m[0] / 2, m[3], m[4], 0};
  const Flange high{m[5] / 2, m[6] > 0 ? m[6] : m[3], m[7], 0};
  return double_tee(m[1] / 2, m[2] / 2, low, high);
}

std::optional<Shape> trapezium(const Measures& m) {
  const double bottom = m[0];
  const double top = m[1];
  const double y = m[2] / 2;
  if (!are_lengths({bottom, top, y})) return std::nullopt;
  // The offset of the upper side may be negative; a missing one would be a mistake of the file.
  const double left = m[3] - bottom / 2;
  return Shape{{at(-bottom / 2, -y), at(bottom / 2, -y), at(left + top, y), at(left, y)}, {}};
}

struct Kind {
  std::string_view keyword;
  std::optional<Shape> (*shape)(const Measures&);
};

constexpr std::array<Kind, 11> kKinds = {{{"IFCRECTANGLEPROFILEDEF", plain_rectangle},
                                          {"IFCROUNDEDRECTANGLEPROFILEDEF", rounded_rectangle},
                                          {"IFCRECTANGLEHOLLOWPROFILEDEF", hollow_rectangle},
                                          {"IFCISHAPEPROFILEDEF", equal_i},
                                          {"IFCLSHAPEPROFILEDEF", angle},
                                          {"IFCUSHAPEPROFILEDEF", channel},
                                          {"IFCTSHAPEPROFILEDEF", tee},
                                          {"IFCCSHAPEPROFILEDEF", lipped_channel},
                                          {"IFCZSHAPEPROFILEDEF", zed},
                                          {"IFCASYMMETRICISHAPEPROFILEDEF", unequal_i},
                                          {"IFCTRAPEZIUMPROFILEDEF", trapezium}}};

std::vector<Vec3> ellipse(double x, double y, double metres_per_unit) {
  std::vector<Vec3> points;
  add_chords({Vec3::Zero(), {x, 0, 0}, {0, y, 0}, 0, 360}, metres_per_unit, points);
  return points;
}

/// Circles, pipes and ellipses.
std::optional<Region> round_profile(std::string_view keyword, const Measures& m,
                                    double metres_per_unit) {
  if (keyword == "IFCCIRCLEPROFILEDEF" && m[0] > 0) {
    return Region{ellipse(m[0], m[0], metres_per_unit), {}};
  }
  if (keyword == "IFCCIRCLEHOLLOWPROFILEDEF" && are_lengths({m[1], m[0] - m[1]})) {
    const double inner = m[0] - m[1];
    return Region{ellipse(m[0], m[0], metres_per_unit), {ellipse(inner, inner, metres_per_unit)}};
  }
  if (keyword == "IFCELLIPSEPROFILEDEF" && are_lengths({m[0], m[1]})) {
    return Region{ellipse(m[0], m[1], metres_per_unit), {}};
  }
  return std::nullopt;
}

std::optional<Region> about_origin(const StepRecord& record, const Measures& measures,
                                   double metres_per_unit) {
  const auto kind = std::find_if(kKinds.begin(), kKinds.end(),
                                 [&](const Kind& each) { return each.keyword == record.keyword; });
  if (kind == kKinds.end()) return round_profile(record.keyword, measures, metres_per_unit);
  const std::optional<Shape> shape = kind->shape(measures);
  if (!shape) return std::nullopt;
  Region region{rounded(shape->outline, metres_per_unit), {}};
  if (!shape->hole.empty()) region.holes.push_back(rounded(shape->hole, metres_per_unit));
  return region;
}

}  // namespace

std::optional<Region> measured_profile(const StepFile& file, const StepRecord& record,
                                       double metres_per_unit) {
  const auto values = StepValues::read(record.arguments);
  if (!values) return std::nullopt;
  std::optional<Region> region = about_origin(record, Measures(*values), metres_per_unit);
  const StepItem position = (*values)[kPosition];
  if (!region || !position.is_set()) return region;
  const std::optional<math::Pose> X = axis_placement(file, position.reference());
  if (!X) return std::nullopt;
  for (Vec3& p : region->outline) p = *X * p;
  for (auto& hole : region->holes) {
    for (Vec3& p : hole) p = *X * p;
  }
  return region;
}

}  // namespace rubicon::ifc
