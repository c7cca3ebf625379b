#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_plan_parts.hpp"
#include "src/motion/geometry/volume.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

/// Densest thing on a site, in kg/m3: gold is 19300.
constexpr double kMaxDensity = 25000;
/// kLightestDensity of a mass and the volume of its shapes, which may be hollow.
constexpr double kLightestHollow = kLightestDensity / 5;

bool has_chart(const Subject& subject, int robot) {
  const RobotSpec& spec = subject.model.robots[static_cast<std::size_t>(robot)];
  return spec.robot && !spec.robot->model.capacity.empty();
}

/// What can turn must have a mass, so that forces can be balanced.
void check_equilibrium_masses(Subject& subject, std::map<int, Span>& said) {
  std::set<int> soils;
  for (const TaskSpec& task : subject.model.tasks) {
    if (task.dig) soils.insert(task.dig->soil);
    if (task.motion_dig) soils.insert(task.motion_dig->soil);
  }
  for (std::size_t i = 0; i < subject.model.components.size(); ++i) {
    const ComponentSpec& component = subject.model.components[i];
    const bool held_by_site = std::any_of(
        component.fixed_to.begin(), component.fixed_to.end(),
        [](const Fixing& each) { return each.to.kind == ThingRef::Kind::site && each.after < 0; });
    if (component.mass > 0 || held_by_site || component.shapes.empty() || component.name.empty() ||
        soils.contains(static_cast<int>(i))) {
      continue;
    }
    // A module's component is said once, however often it is placed.
    const auto first = static_cast<int>(component.span.begin);
    if (!said.emplace(first, component.span).second) continue;
    subject.error(
        "P32", component.span,
        fmt::format("component '{}' has no mass, which support equilibrium needs", component.name),
        "write mass 2.5 t; or density 2400 kg/m3; where its shapes are closed; or fixed "
        "to site;");
  }
}

}  // namespace

void warn_of_tons(Subject& subject, const syntax::Number& number, const std::string& what,
                  const char* unit) {
  if (number.unit != syntax::UnitKind::none) return;
  subject.diagnostics.warning(
      "P22", number.span,
      fmt::format("{0} is {1:g} without a unit, taken as {1:g} kg{2}: are tons meant?", what,
                  number.value, unit),
      fmt::format("write {0:g} t{1} or {0:g} kg{1}", number.value, unit));
}

void check_light_mass(Subject& subject, const syntax::Number& mass, const std::string& what,
                      const std::vector<geometry::Shape>& shapes) {
  if (mass.unit != syntax::UnitKind::none) return;
  const auto volume = geometry::volume_of(shapes);
  if (volume && mass.value < kLightestHollow * volume->volume) {
    warn_of_tons(subject, mass, what, "");
  }
}

std::optional<double> mass_by_density(Subject& subject, const syntax::ComponentItem& item,
                                      const std::vector<geometry::Shape>& shapes) {
  const auto number_span = [](const syntax::Number& number) { return number.span; };
  const std::string what = "the density of component '" + item.name.text + "'";
  const auto* density = only_one(subject, item.density, what, number_span);
  if (density == nullptr) return std::nullopt;
  if (!check_unit(*density, syntax::UnitKind::density, what, subject.diagnostics)) {
    return std::nullopt;
  }
  if (!(density->value > 0 && density->value <= kMaxDensity)) {
    subject.error("P09", density->span,
                  fmt::format("{} must be greater than 0 and at most {} kg/m3, found {}", what,
                              kMaxDensity, density->value));
    return std::nullopt;
  }
  if (density->value <= kLightestDensity) warn_of_tons(subject, *density, what, "/m3");
  // A shape that is wrong was reported where it stands.
  if (shapes.size() != item.shapes.size()) return std::nullopt;
  if (const auto volume = geometry::volume_of(shapes)) return volume->volume * density->value;
  subject.error("P31", density->span,
                fmt::format("{} gives no mass: it has {}", what,
                            shapes.empty() ? "no shape" : "a mesh that is not closed"),
                "write mass NUMBER kg;");
  return std::nullopt;
}

void check_masses(Subject& subject) {
  if (subject.model.short_form || subject.has_open_import) return;
  std::map<int, Span> said;
  for (const TaskSpec& task : subject.model.tasks) {
    // By a pool: the first of its machines that has a load chart.
    int lifts = task.robot;
    for (const TaskSpec& choice : task.choices) {
      if (lifts < 0 || !has_chart(subject, lifts)) lifts = choice.robot;
    }
    if (!task.move || lifts < 0) continue;
    const RobotSpec& robot = subject.model.robots[static_cast<std::size_t>(lifts)];
    const ComponentSpec& component = subject.model.components[static_cast<std::size_t>(*task.move)];
    if (!robot.robot || robot.robot->model.capacity.empty() || component.mass > 0) continue;
    // A module's component is said once, however often it is placed.
    const auto first = static_cast<int>(component.span.begin);
    if (component.name.empty() || !said.emplace(first, component.span).second) continue;
    Diagnostic diagnostic;
    diagnostic.code = "P32";
    diagnostic.span = component.span;
    diagnostic.message = fmt::format(
        "component '{}' has no mass, but task '{}' lifts it with '{}', which has a load chart",
        component.name, task.name, robot.name);
    diagnostic.notes.push_back({task.move_span, "lifted here"});
    diagnostic.hint = "write mass 2.5 t; or density 2400 kg/m3; where its shapes are closed";
    subject.diagnostics.add(std::move(diagnostic));
  }
  if (subject.model.support.equilibrium) check_equilibrium_masses(subject, said);
}

}  // namespace rubicon::interpreter::plan_check
