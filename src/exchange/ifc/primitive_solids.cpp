#include "src/exchange/ifc/primitive_solids.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "src/exchange/ifc/chords.hpp"
#include "src/exchange/ifc/ifc_placement.hpp"
#include "src/exchange/ifc/step_values.hpp"
#include "src/exchange/ifc/swept_solids.hpp"
#include "src/motion/math/angles.hpp"

namespace rubicon::ifc {

namespace {

using math::Vec3;

std::optional<Solid> block(double x, double y, double z, WorkBudget& budget) {
  if (!(x > 0) || !(y > 0) || !(z > 0)) return std::nullopt;
  return extruded({{{0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0}}, {}}, {0, 0, z}, budget);
}

std::optional<Solid> pyramid(double x, double y, double z) {
  if (!(x > 0) || !(y > 0) || !(z > 0)) return std::nullopt;
  return Solid{{{0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0}, {x / 2, y / 2, z}},
               {{0, 3, 2}, {0, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
}

std::vector<Vec3> circle(double radius, double metres_per_unit) {
  std::vector<Vec3> points;
  add_chords({Vec3::Zero(), {radius, 0, 0}, {0, radius, 0}, 0, 360}, metres_per_unit, points);
  return points;
}

std::optional<Solid> cone(double height, double radius, double metres_per_unit) {
  if (!(height > 0) || !(radius > 0)) return std::nullopt;
  Solid solid{circle(radius, metres_per_unit), {}};
  const auto count = static_cast<int>(solid.points.size());
  solid.points.push_back(Vec3::Zero());
  solid.points.emplace_back(0, 0, height);
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    solid.triangles.push_back({next, i, count});
    solid.triangles.push_back({i, next, count + 1});
  }
  return solid;
}

/// Half a circle turned about its diameter.
std::optional<Solid> sphere(double radius, double metres_per_unit, WorkBudget& budget) {
  if (!(radius > 0)) return std::nullopt;
  Region half{{{0, -radius, 0}}, {}};
  add_chords({Vec3::Zero(), {radius, 0, 0}, {0, radius, 0}, -90, 180}, metres_per_unit,
             half.outline);
  return revolved(half, {Vec3::Zero(), Vec3::UnitY()}, 360, metres_per_unit, budget);
}

}  // namespace

std::optional<Solid> primitive_solid(const StepFile& file, const StepRecord& record,
                                     double metres_per_unit, WorkBudget& budget) {
  const auto values = StepValues::read(record.arguments);
  if (!values) return std::nullopt;
  const auto measure = [&](std::size_t i) { return (*values)[i].number().value_or(0); };
  std::optional<Solid> solid;
  if (record.keyword == "IFCBLOCK") {
    solid = block(measure(1), measure(2), measure(3), budget);
  } else if (record.keyword == "IFCRECTANGULARPYRAMID") {
    solid = pyramid(measure(1), measure(2), measure(3));
  } else if (record.keyword == "IFCRIGHTCIRCULARCYLINDER" && measure(1) > 0 && measure(2) > 0) {
    solid = extruded({circle(measure(2), metres_per_unit), {}}, {0, 0, measure(1)}, budget);
  } else if (record.keyword == "IFCRIGHTCIRCULARCONE") {
    solid = cone(measure(1), measure(2), metres_per_unit);
  } else if (record.keyword == "IFCSPHERE") {
    solid = sphere(measure(1), metres_per_unit, budget);
  }
  const auto X = axis_placement(file, (*values)[0].reference());
  if (!solid || !X) return std::nullopt;
  for (Vec3& p : solid->points) p = *X * p;
  return solid;
}

}  // namespace rubicon::ifc
