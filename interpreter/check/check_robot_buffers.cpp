#include <fmt/format.h>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_robot_parts.hpp"

namespace rubicon::interpreter::robot_check {

namespace {

using syntax::BufferItem;

/// m: a wider one is a slip of the unit.
constexpr double kMaxBuffer = 100;

bool check_distance(Subject& subject, const syntax::Number& distance) {
  if (!check_unit(distance, syntax::UnitKind::length, "a buffer", subject.diagnostics)) {
    return false;
  }
  if (distance.value >= 0 && distance.value <= kMaxBuffer) return true;
  subject.diagnostics.error(
      "R07", distance.span,
      fmt::format("a buffer must be between 0 and {} m, found {}", kMaxBuffer, distance.value));
  return false;
}

/// All bodies with shapes but the one that carries the tool: that one has to touch what it takes.
void give_all(Subject& subject, double distance) {
  robot::RobotModel& model = subject.model;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    robot::Body& body = model.bodies[i];
    if (static_cast<int>(i) != model.tool_body && !body.shapes.empty()) body.buffer = distance;
  }
}

void give(Subject& subject, const BufferItem& item, std::map<int, Span>& given) {
  for (const syntax::Name& name : item.bodies) {
    const int found = find_body(subject, name, "the buffer");
    if (found < 0) continue;
    const auto [place, is_new] = given.emplace(found, name.span);
    if (!is_new) {
      subject.twice(name.span, fmt::format("the buffer of '{}' is given twice", name.text),
                    place->second);
      continue;
    }
    robot::Body& body = subject.model.bodies[static_cast<std::size_t>(found)];
    if (body.shapes.empty() && subject.judges_names()) {
      subject.diagnostics.error(
          "R20", name.span,
          fmt::format("body '{}' has no shape, so there is nothing to keep a buffer around",
                      name.text));
      continue;
    }
    body.buffer = item.distance.value;
  }
}

}  // namespace

void check_buffers(Subject& subject) {
  const BufferItem* of_all = nullptr;
  std::vector<const BufferItem*> of_some;
  for (const syntax::RobotItem& each : subject.robot.items) {
    const auto* item = std::get_if<BufferItem>(&each);
    if (item == nullptr || !check_distance(subject, item->distance)) continue;
    if (!item->bodies.empty()) {
      of_some.push_back(item);
    } else if (of_all != nullptr) {
      subject.twice(item->span, "the buffer of all bodies is given twice", of_all->span);
    } else {
      of_all = item;
      give_all(subject, item->distance.value);
    }
  }
  std::map<int, Span> given;
  for (const BufferItem* item : of_some) give(subject, *item, given);
}

}  // namespace rubicon::interpreter::robot_check
