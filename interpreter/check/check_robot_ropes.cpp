#include <fmt/format.h>

#include <cmath>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_robot_parts.hpp"

namespace rubicon::interpreter::robot_check {

namespace {

using syntax::RopeItem;
using syntax::UnitKind;

/// "rope", or the first of rope_2, rope_3, ... that nothing else is called.
std::string free_name(const Subject& subject) {
  std::string name = "rope";
  for (int i = 2; subject.body_index.count(name) != 0 || subject.ropes.count(name) != 0; ++i) {
    name = fmt::format("rope_{}", i);
  }
  return name;
}

/// Whether no body and no rope has the name yet.
bool is_new_name(Subject& subject, const syntax::Name& name) {
  if (const auto body = subject.body_index.find(name.text); body != subject.body_index.end()) {
    subject.twice(name.span, fmt::format("a body is called '{}' already", name.text),
                  subject.bodies[static_cast<std::size_t>(body->second)]->name.span);
    return false;
  }
  if (const auto rope = subject.ropes.find(name.text); rope != subject.ropes.end()) {
    subject.twice(name.span, fmt::format("rope '{}' is declared twice", name.text),
                  rope->second.span);
    return false;
  }
  return true;
}

/// A point in the frame of a body; nothing after reporting a wrong unit or size.
std::optional<math::Vec3> point_of(Subject& subject, const RopeItem::End& end) {
  math::Vec3 point = math::Vec3::Zero();
  bool fine = true;
  for (std::size_t i = 0; i < end.point.size() && i < 3; ++i) {
    const syntax::Number& number = end.point[i];
    if (!check_unit(number, UnitKind::length, "a point of a rope", subject.diagnostics)) {
      fine = false;
    } else if (!(std::fabs(number.value) <= kMaxLength)) {
      subject.diagnostics.error("R07", number.span,
                                fmt::format("a point of a rope is at most {} m from the body's "
                                            "origin along each axis, found {}",
                                            kMaxLength, number.value));
      fine = false;
    } else {
      point[static_cast<Eigen::Index>(i)] = number.value;
    }
  }
  return fine ? std::optional(point) : std::nullopt;
}

bool is_radius(Subject& subject, const syntax::Number& radius) {
  if (!check_unit(radius, UnitKind::length, "the radius of a rope", subject.diagnostics)) {
    return false;
  }
  if (radius.value >= kMinStep && radius.value <= kMaxLength) return true;
  subject.diagnostics.error(
      "R07", radius.span,
      fmt::format("the radius of a rope must be between {} and {} m, found {}", kMinStep,
                  kMaxLength, radius.value));
  return false;
}

void declare_rope(Subject& subject, const RopeItem& item) {
  const bool named = !item.name || is_new_name(subject, *item.name);
  robot::Rope rope;
  rope.from = find_body(subject, item.from.body, "the rope");
  const int to = find_body(subject, item.to.body, "the rope");
  const auto p_from = point_of(subject, item.from);
  const auto p_to = point_of(subject, item.to);
  const bool thick = is_radius(subject, item.radius);
  if (rope.from < 0 || to < 0) return;
  if (rope.from == to) {
    subject.diagnostics.error(
        "R20", item.to.body.span,
        fmt::format("a rope goes from one body to another, found '{}' twice", item.to.body.text),
        "a part that keeps its length is a shape of its body: shape capsule(...)");
    return;
  }
  if (!named || !p_from || !p_to || !thick) return;
  if (subject.model.bodies.size() >= kMaxBodies) {
    subject.diagnostics.error(
        "R18", item.span, fmt::format("this robot has more than {} bodies and ropes", kMaxBodies));
    return;
  }
  rope.radius = item.radius.value;
  rope.p_from = *p_from;
  rope.p_to = *p_to;
  robot::Body body;
  body.name = item.name ? item.name->text : free_name(subject);
  body.parent = to;
  body.rope = rope;
  const Span span = item.name ? item.name->span : item.span;
  subject.ropes.emplace(body.name,
                        DeclaredRope{static_cast<int>(subject.model.bodies.size()), span});
  subject.model.bodies.push_back(std::move(body));
}

}  // namespace

void declare_ropes(Subject& subject) {
  // Those with a name first: what the others are called must be free.
  for (const bool with_name : {true, false}) {
    for (const syntax::RobotItem& each : subject.robot.items) {
      const auto* item = std::get_if<RopeItem>(&each);
      if (item != nullptr && item->name.has_value() == with_name) declare_rope(subject, *item);
    }
  }
}

}  // namespace rubicon::interpreter::robot_check
