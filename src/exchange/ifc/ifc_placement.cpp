#include "src/exchange/ifc/ifc_placement.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "src/exchange/ifc/ifc_class_names.hpp"
#include "src/exchange/ifc/step_values.hpp"

namespace rubicon::ifc {

namespace {

using math::Pose;
using math::Vec3;

/// Shorter directions are none.
constexpr double kShortest = 1e-9;

/// Three numbers of the list that is the first argument; two make the third zero.
std::optional<Vec3> coordinates(const StepFile& file, std::uint64_t id, const char* keyword) {
  const StepRecord* record = file.find(id);
  if (record == nullptr || record->keyword != keyword) return std::nullopt;
  const auto values = StepValues::read(record->arguments);
  if (!values) return std::nullopt;
  Vec3 result = Vec3::Zero();
  int count = 0;
  for (const StepItem each : (*values)[0]) {
    const std::optional<double> number = each.number();
    if (!number || count == 3) return std::nullopt;
    result[count++] = *number;
  }
  if (count < 2) return std::nullopt;
  return result;
}

/// x as near to `wanted` as a right angle to z allows (IfcFirstProjAxis).
Vec3 first_axis(const Vec3& z, const std::optional<Vec3>& wanted) {
  for (const Vec3& each : {wanted.value_or(Vec3::UnitX()), Vec3(Vec3::UnitX())}) {
    const Vec3 across = each - z * each.dot(z);
    if (across.norm() > kShortest) return across.normalized();
  }
  return (Vec3::UnitY() - z * z.y()).normalized();
}

}  // namespace

std::optional<Vec3> cartesian_point(const StepFile& file, std::uint64_t id) {
  return coordinates(file, id, "IFCCARTESIANPOINT");
}

std::optional<Vec3> unit_direction(const StepFile& file, std::uint64_t id) {
  const std::optional<Vec3> found = coordinates(file, id, "IFCDIRECTION");
  if (!found || !(found->norm() > kShortest)) return std::nullopt;
  return found->normalized();
}

std::optional<Pose> axis_placement(const StepFile& file, std::uint64_t id) {
  const StepRecord* record = file.find(id);
  if (record == nullptr) return std::nullopt;
  const bool flat = record->keyword == "IFCAXIS2PLACEMENT2D";
  if (!flat && record->keyword != "IFCAXIS2PLACEMENT3D") return std::nullopt;
  const auto values = StepValues::read(record->arguments);
  if (!values) return std::nullopt;
  const std::optional<Vec3> origin = cartesian_point(file, (*values)[0].reference());
  if (!origin) return std::nullopt;
  const Vec3 z = flat
                     ? Vec3(Vec3::UnitZ())
                     : unit_direction(file, (*values)[1].reference()).value_or(Vec3(Vec3::UnitZ()));
  const Vec3 x = first_axis(z, unit_direction(file, (*values)[flat ? 1 : 2].reference()));
  Pose pose = Pose::Identity();
  pose.linear() << x, z.cross(x), z;
  pose.translation() = *origin;
  return pose;
}

std::optional<Transformation> transformation(const StepFile& file, std::uint64_t id) {
  constexpr std::string_view kOperator = "IFCCARTESIANTRANSFORMATIONOPERATOR";
  const StepRecord* record = file.find(id);
  if (record == nullptr || !record->keyword.starts_with(kOperator)) return std::nullopt;
  const auto values = StepValues::read(record->arguments);
  const auto origin = values ? cartesian_point(file, (*values)[2].reference()) : std::nullopt;
  if (!origin) return std::nullopt;
  const bool flat = record->keyword.starts_with("IFCCARTESIANTRANSFORMATIONOPERATOR2D");
  const bool uneven = record->keyword.ends_with("NONUNIFORM");
  const auto axis = [&](std::size_t i) { return unit_direction(file, (*values)[i].reference()); };
  // IfcBaseAxis: the second may point either way.
  const Vec3 z = flat ? Vec3(Vec3::UnitZ()) : axis(4).value_or(Vec3(Vec3::UnitZ()));
  const Vec3 x = first_axis(z, axis(0));
  Vec3 y = z.cross(x);
  if (axis(1).value_or(y).dot(y) < 0) y = -y;
  const double first = (*values)[3].number().value_or(1);
  const auto scale = [&](std::size_t i) {
    return uneven ? (*values)[i].number().value_or(first) : first;
  };
  Transformation result = Transformation::Identity();
  result.linear() << first * x, scale(flat ? 4 : 5) * y, (flat ? 1 : scale(6)) * z;
  result.translation() = *origin;
  const double size = std::fabs(result.linear().determinant());
  if (!(size > 0) || !std::isfinite(size)) return std::nullopt;
  return result;
}

std::optional<Pose> IfcPlacements::world(std::uint64_t id) {
  // Up to the first that is known, then down again: no recursion, the file chooses how deep it is.
  struct Step {
    std::uint64_t id;
    Pose relative;
  };
  std::vector<Step> steps;
  std::optional<Pose> above = Pose::Identity();
  while (true) {
    const auto [place, is_new] = known_.try_emplace(id);
    // One on the way up is not known yet: that would be a ring.
    if (!is_new) {
      above = place->second.X_W;
      fault_ = place->second.fault.empty() ? "the placements it hangs on lead in a ring"
                                           : place->second.fault;
      break;
    }
    const StepRecord* record = file_->find(id);
    const auto values = record != nullptr && record->keyword == "IFCLOCALPLACEMENT"
                            ? StepValues::read(record->arguments)
                            : std::nullopt;
    const std::optional<Pose> relative =
        values ? axis_placement(*file_, (*values)[1].reference()) : std::nullopt;
    if (!relative) {
      above = std::nullopt;
      fault_ = place->second.fault = fault_of(id);
      break;
    }
    steps.push_back({id, *relative});
    const StepItem parent = (*values)[0];
    if (!parent.is_set()) break;
    id = parent.reference();
  }
  for (; !steps.empty(); steps.pop_back()) {
    if (above) above = *above * steps.back().relative;
    known_[steps.back().id] = {above, above ? std::string() : fault_};
  }
  return above;
}

std::string IfcPlacements::fault_of(std::uint64_t id) const {
  const StepRecord* record = file_->find(id);
  if (record == nullptr) return fmt::format("there is no placement #{}", id);
  if (record->keyword == "IFCLOCALPLACEMENT") {
    return fmt::format("its placement #{} leads nowhere", id);
  }
  return fmt::format("it is placed by #{}, an {}, which is not read", id,
                     class_name(record->keyword));
}

std::optional<math::Pose> IfcPlacements::of_product(std::uint64_t product) {
  constexpr std::size_t kPlacement = 5;
  const StepRecord* record = file_->find(product);
  const auto values = record == nullptr ? std::nullopt : StepValues::read(record->arguments);
  if (!values) return std::nullopt;
  const StepItem placement = (*values)[kPlacement];
  if (!placement.is_set()) return math::Pose::Identity();
  return world(placement.reference());
}

}  // namespace rubicon::ifc
