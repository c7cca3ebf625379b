#include "src/exchange/ifc/ifc_far_points.hpp"

#include <cmath>
#include <unordered_set>

#include "src/exchange/ifc/ifc_placement.hpp"
#include "src/exchange/ifc/step_values.hpp"

namespace rubicon::ifc {

namespace {

using math::Vec3;

/// Farther from the origin of its shape (metres) a point is far: single precision is 0.1 mm there.
constexpr double kFarMetres = 1000;
/// The offset lies on a grid of this size (metres), so that people can read it.
constexpr double kGridMetres = 100;

bool is_far_out(const Vec3& p, double limit) { return p.cwiseAbs().maxCoeff() > limit; }

/// Points of a file in three dimensions, as its records have them.
std::vector<Vec3> points_in(const StepFile& file, const StepRecord& record) {
  std::vector<Vec3> points;
  if (record.keyword == "IFCCARTESIANPOINT") {
    const auto values = StepValues::read(record.arguments);
    const auto point = cartesian_point(file, record.id);
    if (values && point && (*values)[0].size() == 3) points.push_back(*point);
  } else if (record.keyword == "IFCCARTESIANPOINTLIST3D") {
    const auto values = StepValues::read(record.arguments);
    if (!values) return points;
    for (const StepItem each : (*values)[0]) {
      Vec3 p = Vec3::Zero();
      int k = 0;
      for (const StepItem value : each) {
        if (k < 3) p[k++] = value.number().value_or(0);
      }
      points.push_back(p);
    }
  }
  return points;
}

/// What of a record is in the frame of the shape it belongs to.
std::vector<std::uint64_t> same_frame(const StepRecord& record) {
  const auto values = StepValues::read(record.arguments);
  if (!values) return {};
  if (record.keyword != "IFCMAPPEDITEM") return values->references();
  // What is mapped has a frame of its own; where it is mapped to stands in this one.
  constexpr std::size_t kTarget = 1;
  return {(*values)[kTarget].reference()};
}

/// Points near and far that a shape consists of.
struct Places {
  bool near = false;
  bool far = false;
  Vec3 first_far = Vec3::Zero();
};

Places places_of(const StepFile& file, std::uint64_t shape, double limit) {
  Places places;
  std::unordered_set<std::uint64_t> seen;
  std::vector<std::uint64_t> stack{shape};
  while (!stack.empty()) {
    const std::uint64_t id = stack.back();
    stack.pop_back();
    const StepRecord* record = file.find(id);
    // The context is no part of the shape.
    if (record == nullptr || !seen.insert(id).second ||
        record->keyword.find("CONTEXT") != std::string_view::npos) {
      continue;
    }
    for (const Vec3& p : points_in(file, *record)) {
      if (is_far_out(p, limit) && !places.far) places.first_far = p;
      (is_far_out(p, limit) ? places.far : places.near) = true;
    }
    for (const std::uint64_t child : same_frame(*record)) stack.push_back(child);
  }
  return places;
}

/// Most files have no such point; they need not be looked through shape by shape.
bool has_far_point(const StepFile& file, double limit) {
  for (const StepRecord& record : file.records()) {
    for (const Vec3& p : points_in(file, record)) {
      if (is_far_out(p, limit)) return true;
    }
  }
  return false;
}

}  // namespace

FarPoints::FarPoints(const StepFile& file, double metres_per_unit,
                     const std::vector<std::uint64_t>& shapes)
    : limit_(kFarMetres / metres_per_unit) {
  if (!has_far_point(file, limit_)) return;
  const double grid = kGridMetres / metres_per_unit;
  for (const std::uint64_t shape : shapes) {
    const Places places = places_of(file, shape, limit_);
    if (!places.far) continue;
    if (places.near) {
      far_shapes_.clear();
      return;
    }
    if (far_shapes_.empty()) offset_ = (places.first_far / grid).array().round().matrix() * grid;
    far_shapes_.insert(shape);
  }
}

std::optional<Vec3> FarPoints::moved(const Vec3& p) const {
  if (far_shapes_.empty() || !is_far_out(p, limit_)) return std::nullopt;
  return p - offset_;
}

}  // namespace rubicon::ifc
