#include "src/ifc/ifc_profile.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "src/ifc/ifc_placement.hpp"
#include "src/ifc/step_values.hpp"

namespace rubicon::ifc {

namespace {

using math::Vec3;
using Points = std::vector<Vec3>;

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

Vec3 at(double x, double y) { return {x, y, 0}; }

/// All must be above zero.
bool are_lengths(std::initializer_list<double> lengths) {
  return std::all_of(lengths.begin(), lengths.end(), [](double length) { return length > 0; });
}

std::optional<Points> angle(const Measures& m) {
  const double y = m[0] / 2;
  const double x = m[1] > 0 ? m[1] / 2 : y;  // equal legs
  const double t = m[2];
  if (!are_lengths({x, y, t, 2 * x - t, 2 * y - t})) return std::nullopt;
  return Points{at(-x, -y), at(x, -y), at(x, t - y), at(t - x, t - y), at(t - x, y), at(-x, y)};
}

std::optional<Points> channel(const Measures& m) {
  const double y = m[0] / 2;
  const double x = m[1] / 2;
  const double web = m[2];
  const double flange = m[3];
  if (!are_lengths({x, y, web, flange, 2 * x - web, y - flange})) return std::nullopt;
  return Points{at(-x, -y),
                at(x, -y),
                at(x, flange - y),
                at(web - x, flange - y),
                at(web - x, y - flange),
                at(x, y - flange),
                at(x, y),
                at(-x, y)};
}

std::optional<Points> tee(const Measures& m) {
  const double y = m[0] / 2;
  const double x = m[1] / 2;
  const double web = m[2] / 2;
  const double flange = m[3];
  if (!are_lengths({x, y, web, flange, x - web, 2 * y - flange})) return std::nullopt;
  return Points{at(-web, -y), at(web, -y), at(web, y - flange), at(x, y - flange),
                at(x, y),     at(-x, y),   at(-x, y - flange),  at(-web, y - flange)};
}

std::optional<Points> lipped_channel(const Measures& m) {
  const double y = m[0] / 2;
  const double x = m[1] / 2;
  const double t = m[2];
  const double lip = m[3];
  if (!are_lengths({x, y, t, lip - t, x - t, y - lip})) return std::nullopt;
  return Points{at(-x, -y),         at(x, -y),        at(x, lip - y),   at(x - t, lip - y),
                at(x - t, t - y),   at(t - x, t - y), at(t - x, y - t), at(x - t, y - t),
                at(x - t, y - lip), at(x, y - lip),   at(x, y),         at(-x, y)};
}

std::optional<Points> zed(const Measures& m) {
  const double y = m[0] / 2;
  const double web = m[2] / 2;
  const double x = m[1] - web;  // the flanges point away from each other
  const double flange = m[3];
  if (!are_lengths({x, y, web, flange, x - web, y - flange})) return std::nullopt;
  return Points{at(-web, -y), at(x, -y), at(x, flange - y),  at(web, flange - y),
                at(web, y),   at(-x, y), at(-x, y - flange), at(-web, y - flange)};
}

std::optional<Points> unequal_i(const Measures& m) {
  const double bottom = m[0] / 2;
  const double y = m[1] / 2;
  const double web = m[2] / 2;
  const double low_flange = m[3];
  const double top = m[5] / 2;
  const double high_flange = m[6] > 0 ? m[6] : low_flange;
  if (!are_lengths({bottom, top, y, web, low_flange, bottom - web, top - web,
                    2 * y - low_flange - high_flange})) {
    return std::nullopt;
  }
  return Points{at(-bottom, -y),
                at(bottom, -y),
                at(bottom, low_flange - y),
                at(web, low_flange - y),
                at(web, y - high_flange),
                at(top, y - high_flange),
                at(top, y),
                at(-top, y),
                at(-top, y - high_flange),
                at(-web, y - high_flange),
                at(-web, low_flange - y),
                at(-bottom, low_flange - y)};
}

std::optional<Points> trapezium(const Measures& m) {
  const double bottom = m[0];
  const double top = m[1];
  const double y = m[2] / 2;
  if (!are_lengths({bottom, top, y})) return std::nullopt;
  // The offset of the upper side may be negative; a missing one would be a mistake of the file.
  const double left = m[3] - bottom / 2;
  return Points{at(-bottom / 2, -y), at(bottom / 2, -y), at(left + top, y), at(left, y)};
}

struct Kind {
  std::string_view keyword;
  std::optional<Points> (*outline)(const Measures&);
};

constexpr std::array<Kind, 7> kKinds = {{{"IFCLSHAPEPROFILEDEF", angle},
                                         {"IFCUSHAPEPROFILEDEF", channel},
                                         {"IFCTSHAPEPROFILEDEF", tee},
                                         {"IFCCSHAPEPROFILEDEF", lipped_channel},
                                         {"IFCZSHAPEPROFILEDEF", zed},
                                         {"IFCASYMMETRICISHAPEPROFILEDEF", unequal_i},
                                         {"IFCTRAPEZIUMPROFILEDEF", trapezium}}};

}  // namespace

std::optional<std::vector<Vec3>> profile_outline(const StepFile& file, const StepRecord& record) {
  const auto kind = std::find_if(kKinds.begin(), kKinds.end(),
                                 [&](const Kind& each) { return each.keyword == record.keyword; });
  if (kind == kKinds.end()) return std::nullopt;
  const auto values = StepValues::read(record.arguments);
  if (!values) return std::nullopt;
  std::optional<Points> outline = kind->outline(Measures(*values));
  const StepItem position = (*values)[kPosition];
  if (!outline || !position.is_set()) return outline;
  const std::optional<math::Pose> X = axis_placement(file, position.reference());
  if (!X) return std::nullopt;
  for (Vec3& p : *outline) p = *X * p;
  return outline;
}

}  // namespace rubicon::ifc
