#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_plan_parts.hpp"
#include "interpreter/check/solid_box.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

/// Largest mass, in kg: a thousand times what any crane lifts.
constexpr double kMaxMass = 1e8;

/// m: slings and chains as they are sold reach so far; longer ones are made to order.
constexpr double kLongestSling = 10;

/// A grip far from its component is a slip more often than a long sling.
void check_reach_of_slings(Subject& subject, const ComponentSpec& component, Span span) {
  double distance = std::numeric_limits<double>::infinity();
  for (const geometry::Shape& shape : component.shapes) {
    const math::Vec3 p_SG =
        shape.X_BS.inverse(Eigen::Isometry) * math::Vec3(component.X_OG.translation());
    distance = std::min(distance, box_around(shape.solid).exteriorDistance(p_SG));
  }
  if (component.shapes.empty() || distance <= kLongestSling) return;
  subject.diagnostics.warning(
      "P35", span,
      fmt::format("the grip of component '{}' is {:.1f} m from it, farther than a sling is long",
                  component.name, distance),
      "a grip stands in the component's own frame");
}

ComponentSpec resolve_component(Subject& subject, const syntax::ComponentItem& item) {
  ComponentSpec component;
  component.name = item.name.text;
  component.span = item.name.span;
  component.people = item.people;
  const std::string who = "component '" + component.name + "'";
  for (const syntax::Shape& each : item.shapes) {
    std::optional<geometry::Shape> shape = subject.shapes.resolve(each);
    if (shape) component.shapes.push_back(*std::move(shape));
  }
  if (item.shapes.empty() && subject.judges_names()) {
    subject.diagnostics.warning("P16", item.name.span,
                                fmt::format("{} has no shape: nothing will ever touch it", who));
  }
  std::map<std::string, Span> keys;
  for (const syntax::AttributeItem& each : item.attributes) {
    add_attribute(subject, each, who, keys, component.attributes);
  }
  const auto frame_span = [](const syntax::Frame& frame) { return frame.span; };
  if (const auto* at = only_one(subject, item.at, "the place of " + who, frame_span)) {
    component.X_WO = resolve_frame_or_identity(subject, *at);
  }
  if (const auto* grip = only_one(subject, item.grip, "the grip of " + who, frame_span)) {
    component.X_OG = resolve_frame_or_identity(subject, *grip);
    check_reach_of_slings(subject, component, grip->span);
  }
  if (item.grip.empty()) subject.without_grip.insert(item.name.span.begin);
  const auto number_span = [](const syntax::Number& number) { return number.span; };
  if (const auto* cost = only_one(subject, item.cost, "the cost of " + who, number_span)) {
    component.cost = resolve_money(subject, *cost, "the cost of " + who);
  }
  const auto* mass = only_one(subject, item.mass, "the mass of " + who, number_span);
  if (mass == nullptr) {
    component.mass = mass_by_density(subject, item, component.shapes).value_or(0);
    return component;
  }
  if (!item.density.empty()) {
    subject.error("P31", item.density.front().span,
                  who + " has a mass and a density; expected one of them");
  }
  const std::string what = "the mass of " + who;
  if (!check_unit(*mass, syntax::UnitKind::mass, what, subject.diagnostics)) return component;
  if (mass->value > 0 && mass->value <= kMaxMass) {
    component.mass = mass->value;
    check_light_mass(subject, *mass, what, component.shapes);
  } else {
    subject.error("P09", mass->span,
                  fmt::format("{} must be greater than 0 and at most {} kg, found {}", what,
                              kMaxMass, mass->value));
  }
  return component;
}

}  // namespace

void check_components(Subject& subject) {
  for (const syntax::PlanItem& each : subject.plan.items) {
    const auto* item = std::get_if<syntax::ComponentItem>(&each);
    if (item == nullptr) continue;
    ComponentSpec component = resolve_component(subject, *item);
    if (subject.component_spans.at(item->name.text) != item->name.span) continue;
    const int index = subject.components.at(item->name.text);
    subject.model.components[static_cast<std::size_t>(index)] = std::move(component);
  }
  for (ModuleInfo& module : subject.module_infos) {
    for (const syntax::ComponentItem* item : module.components) {
      module.checked_components.push_back(resolve_component(subject, *item));
    }
    if (!module.placed && subject.judges_names()) {
      subject.diagnostics.warning(
          "P17", module.item->name.span,
          fmt::format("module '{}' is never placed", module.item->name.text),
          "write place " + module.item->name.text + " at FRAME as NAME;");
    }
  }
  for (const PlaceInfo& place : subject.place_infos) {
    if (place.module < 0) continue;
    auto index = static_cast<std::size_t>(place.first_component);
    const ModuleInfo& module = subject.module_infos[static_cast<std::size_t>(place.module)];
    for (const ComponentSpec& each : module.checked_components) {
      ComponentSpec& component = subject.model.components[index++];
      component = each;
      component.name = place.item->as.text + "." + each.name;
      component.X_WO = place.X_WS * each.X_WO;
    }
  }
}

}  // namespace rubicon::interpreter::plan_check
