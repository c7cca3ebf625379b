#include "src/exchange/ifc/profile_regions.hpp"

#include <utility>

#include "src/exchange/ifc/ifc_placement.hpp"
#include "src/exchange/ifc/polygon_triangles.hpp"
#include "src/exchange/ifc/step_values.hpp"

namespace rubicon::ifc {

namespace {

using math::Vec3;
using Regions = std::vector<Region>;

/// Nearer than this (metres) two points of an outline are one.
constexpr double kSame = 1e-7;

/// Whether no two lines of a region cross.
bool is_simple(const Region& region, WorkBudget& budget) {
  std::vector<Vec3> points;
  std::vector<Loop> loops;
  const auto add = [&](const std::vector<Vec3>& line) {
    Loop loop;
    for (const Vec3& p : line) {
      loop.push_back(static_cast<int>(points.size()));
      points.push_back(p);
    }
    loops.push_back(std::move(loop));
  };
  add(region.outline);
  for (const auto& hole : region.holes) add(hole);
  return !lines_cross(points, loops, Vec3::UnitZ(), budget);
}

class ProfileReader {
 public:
  explicit ProfileReader(const ShapeTerms& terms) : terms_(terms) {}

  std::optional<Regions> read(std::uint64_t id, int depth) {
    const StepRecord* record = terms_.file.find(id);
    if (record == nullptr || depth > kDeepestProfile || !terms_.budget.spend(1)) {
      return std::nullopt;
    }
    const auto values = StepValues::read(record->arguments);
    if (!values) return std::nullopt;
    if (record->keyword.starts_with("IFCARBITRARY")) return by_curves(*record, *values);
    if (record->keyword == "IFCCOMPOSITEPROFILEDEF") return composed((*values)[2], depth);
    if (record->keyword == "IFCDERIVEDPROFILEDEF" || record->keyword == "IFCMIRROREDPROFILEDEF") {
      return derived(*record, *values, depth);
    }
    auto region = measured_profile(terms_.file, *record, terms_.metres_per_unit);
    if (!region) return std::nullopt;
    return Regions{std::move(*region)};
  }

 private:
  std::optional<Regions> by_curves(const StepRecord& record, const StepValues& values) {
    const bool has_holes = record.keyword == "IFCARBITRARYPROFILEDEFWITHVOIDS";
    if (!has_holes && record.keyword != "IFCARBITRARYCLOSEDPROFILEDEF") return std::nullopt;
    auto outline = closed_line(values[2].reference());
    if (!outline) return std::nullopt;
    Region region{std::move(*outline), {}};
    if (has_holes) {
      for (const StepItem each : values[3]) {
        auto hole = closed_line(each.reference());
        if (!hole) return std::nullopt;
        region.holes.push_back(std::move(*hole));
      }
    }
    if (!is_simple(region, terms_.budget)) return std::nullopt;
    return Regions{std::move(region)};
  }

  /// The points of a closed curve, each once.
  std::optional<std::vector<Vec3>> closed_line(std::uint64_t curve) {
    const auto line = curve_points(terms_, curve);
    if (!line) return std::nullopt;
    const double same = kSame / terms_.metres_per_unit;
    std::vector<Vec3> points;
    for (Vec3 p : line->points) {
      p.z() = 0;
      if (points.empty() || (p - points.back()).norm() > same) points.push_back(p);
    }
    while (points.size() > 1 && (points.back() - points.front()).norm() <= same) points.pop_back();
    if (points.size() < 3) return std::nullopt;
    return points;
  }

  std::optional<Regions> composed(const StepItem& profiles, int depth) {
    Regions all;
    for (const StepItem each : profiles) {
      auto regions = read(each.reference(), depth + 1);
      if (!regions) return std::nullopt;
      for (Region& region : *regions) all.push_back(std::move(region));
    }
    if (all.empty()) return std::nullopt;
    return all;
  }

  std::optional<Regions> derived(const StepRecord& record, const StepValues& values, int depth) {
    auto regions = read(values[2].reference(), depth + 1);
    if (!regions) return std::nullopt;
    math::Mat3 turn = math::Mat3::Identity();
    Vec3 origin = Vec3::Zero();
    if (record.keyword == "IFCMIRROREDPROFILEDEF") {
      turn(0, 0) = -1;
    } else {
      const auto found = transformation(terms_.file, values[3].reference());
      if (!found) return std::nullopt;
      turn = found->linear();
      origin = found->translation();
    }
    for (Region& region : *regions) {
      for (Vec3& p : region.outline) p = turn * p + origin;
      for (auto& hole : region.holes) {
        for (Vec3& p : hole) p = turn * p + origin;
      }
    }
    return regions;
  }

  const ShapeTerms& terms_;
};

}  // namespace

std::optional<Regions> profile_regions(const ShapeTerms& terms, std::uint64_t id) {
  return ProfileReader(terms).read(id, 0);
}

}  // namespace rubicon::ifc
