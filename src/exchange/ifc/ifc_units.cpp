#include "src/exchange/ifc/ifc_units.hpp"

#include <array>
#include <string_view>
#include <utility>

#include "src/exchange/ifc/step_values.hpp"

namespace rubicon::ifc {

namespace {

/// Derived units of derived units: real files have one step.
constexpr int kLongestDerivation = 8;

/// Of IfcSIPrefix; "" stands for none.
std::optional<double> prefix_factor(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, double>, 17> kPrefixes = {{{"", 1},
                                                                              {"EXA", 1e18},
                                                                              {"PETA", 1e15},
                                                                              {"TERA", 1e12},
                                                                              {"GIGA", 1e9},
                                                                              {"MEGA", 1e6},
                                                                              {"KILO", 1e3},
                                                                              {"HECTO", 1e2},
                                                                              {"DECA", 10},
                                                                              {"DECI", 1e-1},
                                                                              {"CENTI", 1e-2},
                                                                              {"MILLI", 1e-3},
                                                                              {"MICRO", 1e-6},
                                                                              {"NANO", 1e-9},
                                                                              {"PICO", 1e-12},
                                                                              {"FEMTO", 1e-15},
                                                                              {"ATTO", 1e-18}}};
  for (const auto& [name, factor] : kPrefixes) {
    if (name == word) return factor;
  }
  return std::nullopt;
}

/// How many SI units (metre, radian) a unit stands for, if it is of this type.
std::optional<double> factor_of(const StepFile& file, std::uint64_t id, std::string_view type) {
  double factor = 1;
  for (int step = 0; step < kLongestDerivation; ++step) {
    const StepRecord* unit = file.find(id);
    if (unit == nullptr) return std::nullopt;
    const auto values = StepValues::read(unit->arguments);
    if (!values || !(*values)[1].is_enumeration(type)) return std::nullopt;
    if (unit->keyword == "IFCSIUNIT") {
      const StepItem prefix = (*values)[2];
      const auto power = prefix_factor(prefix.is_set() ? prefix.text() : std::string_view());
      if (!power) return std::nullopt;
      return factor * *power;
    }
    if (!unit->keyword.starts_with("IFCCONVERSIONBASEDUNIT")) return std::nullopt;
    const StepRecord* measure = file.find((*values)[3].reference());
    if (measure == nullptr || measure->keyword != "IFCMEASUREWITHUNIT") return std::nullopt;
    const auto measured = StepValues::read(measure->arguments);
    if (!measured || !(*measured)[0].number()) return std::nullopt;
    factor *= *(*measured)[0].number();
    id = (*measured)[1].reference();
  }
  return std::nullopt;
}

/// The units of the project; without a project that has any, the first that are assigned.
const StepRecord* unit_assignment(const StepFile& file) {
  const StepRecord* first = nullptr;
  for (const StepRecord& record : file.records()) {
    if (record.keyword == "IFCPROJECT") {
      constexpr std::size_t kUnitsInContext = 8;
      const auto values = StepValues::read(record.arguments);
      const StepRecord* units =
          values ? file.find((*values)[kUnitsInContext].reference()) : nullptr;
      if (units != nullptr && units->keyword == "IFCUNITASSIGNMENT") return units;
    } else if (record.keyword == "IFCUNITASSIGNMENT" && first == nullptr) {
      first = &record;
    }
  }
  return first;
}

std::optional<double> assigned(const StepFile& file, std::string_view type) {
  const StepRecord* units = unit_assignment(file);
  if (units == nullptr) return std::nullopt;
  const auto values = StepValues::read(units->arguments);
  if (!values) return std::nullopt;
  for (const StepItem each : (*values)[0]) {
    if (const auto factor = factor_of(file, each.reference(), type)) return factor;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> metres_per_unit(const StepFile& file) {
  const std::optional<double> factor = assigned(file, "LENGTHUNIT");
  // Nobody models in units beyond these; a file that says so is damaged.
  constexpr double kSmallest = 1e-9;
  constexpr double kLargest = 1e6;
  if (!factor || !(*factor >= kSmallest) || !(*factor <= kLargest)) return std::nullopt;
  return factor;
}

double radians_per_unit(const StepFile& file) {
  const double factor = assigned(file, "PLANEANGLEUNIT").value_or(1);
  return factor > 0 ? factor : 1;
}

}  // namespace rubicon::ifc
