#include <fmt/format.h>

#include <utility>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_robot_parts.hpp"
#include "interpreter/check/resolve_frame.hpp"
#include "interpreter/check/resolve_shape.hpp"

namespace rubicon::interpreter::robot_check {

namespace {

using syntax::UnitKind;

void check_frames(Subject& subject, int body) {
  const syntax::BodyItem& item = *subject.bodies[static_cast<std::size_t>(body)];
  BodyNames names(subject, body, BodyNames::Use::frame);
  for (std::size_t i = 0; i < item.frames.size(); ++i) {
    if (i > 0) {
      subject.twice(item.frames[i].span, fmt::format("body '{}' has two frames", item.name.text),
                    item.frames[0].span);
      break;
    }
    std::optional<robot::FrameFormula> frame =
        resolve_frame(item.frames[i].frame, names, subject.diagnostics);
    if (frame) subject.model.bodies[static_cast<std::size_t>(body)].frame = *std::move(frame);
  }
}

void check_shapes(Subject& subject, int body, const std::string& path, FileProvider& files) {
  const syntax::BodyItem& item = *subject.bodies[static_cast<std::size_t>(body)];
  BodyNames names(subject, body, BodyNames::Use::frame);
  ShapeResolver shapes(path, files, names, subject.diagnostics);
  for (const syntax::ShapeItem& each : item.shapes) {
    std::optional<geometry::Shape> shape = shapes.resolve(each.shape);
    if (shape) {
      subject.model.bodies[static_cast<std::size_t>(body)].shapes.push_back(*std::move(shape));
    }
  }
}

void check_tool(Subject& subject, const syntax::ToolItem& item) {
  const int body = find_body(subject, item.body, "tool");
  if (body < 0) return;
  subject.model.tool_body = body;
  if (!item.at) return;
  BodyNames names(subject, body, BodyNames::Use::frame);
  std::optional<robot::FrameFormula> frame = resolve_frame(*item.at, names, subject.diagnostics);
  if (frame) subject.model.tool_frame = *std::move(frame);
}

void check_touching(Subject& subject, const syntax::TouchingItem& item) {
  const auto find = [&](const syntax::Name& name) {
    const auto rope = subject.ropes.find(name.text);
    return rope != subject.ropes.end() ? rope->second.index : find_body(subject, name, "touching");
  };
  const int a = find(item.a);
  const int b = find(item.b);
  if (a < 0 || b < 0) return;
  if (a == b) {
    subject.diagnostics.error(
        "R20", item.b.span,
        fmt::format("touching needs two bodies, found '{}' twice", item.b.text));
    return;
  }
  subject.model.touching.emplace_back(a, b);
}

void check_capacity(Subject& subject, const syntax::CapacityItem& item) {
  double last = -1;
  for (const auto& [radius, mass] : item.points) {
    const bool fine =
        check_unit(radius, UnitKind::length, "a radius of the load chart", subject.diagnostics);
    if (!check_unit(mass, UnitKind::mass, "a load of the load chart", subject.diagnostics) ||
        !fine) {
      continue;
    }
    if (radius.value < 0) {
      subject.diagnostics.error(
          "R17", radius.span,
          fmt::format("a radius of the load chart cannot be negative, found {}", radius.value));
    } else if (radius.value <= last) {
      subject.diagnostics.error(
          "R17", radius.span,
          fmt::format("the radii of a load chart ascend: {} stands after {}", radius.value, last));
    } else if (!(mass.value > 0)) {
      subject.diagnostics.error(
          "R17", mass.span,
          fmt::format("a load of the load chart must be greater than 0, found {}", mass.value));
    } else {
      last = radius.value;
      subject.model.capacity.push_back({radius.value, mass.value});
    }
  }
}

}  // namespace

int find_body(Subject& subject, const syntax::Name& name, const char* who) {
  const auto found = subject.body_index.find(name.text);
  if (found != subject.body_index.end()) return found->second;
  if (subject.ropes.count(name.text) != 0) {
    subject.diagnostics.error(
        "R05", name.span,
        fmt::format("{} names '{}', which is a rope; expected a body", who, name.text));
  } else if (subject.judges_names()) {
    subject.diagnostics.error("R05", name.span,
                              fmt::format("{} names body '{}', which is not declared{}", who,
                                          name.text, subject.suggestions.ending(name.text, [&] {
                                            std::vector<std::string> names;
                                            for (const auto& [each, index] : subject.body_index)
                                              names.push_back(each);
                                            return names;
                                          })));
  }
  return -1;
}

void check_geometry(Subject& subject, const std::string& path, FileProvider& files) {
  for (std::size_t i = 0; i < subject.bodies.size(); ++i) {
    check_frames(subject, static_cast<int>(i));
    check_shapes(subject, static_cast<int>(i), path, files);
  }
  // Without a tool item the tool is the frame of the last body.
  subject.model.tool_body =
      subject.bodies.empty() ? 0 : static_cast<int>(subject.bodies.size()) - 1;
  declare_ropes(subject);
  const syntax::ToolItem* tool = nullptr;
  const syntax::CapacityItem* capacity = nullptr;
  for (const syntax::RobotItem& each : subject.robot.items) {
    if (const auto* item = std::get_if<syntax::ToolItem>(&each)) {
      if (tool != nullptr) {
        subject.twice(item->span, "the tool is given twice", tool->span);
        continue;
      }
      tool = item;
      check_tool(subject, *item);
    } else if (const auto* touching = std::get_if<syntax::TouchingItem>(&each)) {
      check_touching(subject, *touching);
    } else if (const auto* chart = std::get_if<syntax::CapacityItem>(&each)) {
      if (capacity != nullptr) {
        subject.twice(chart->span, "capacity is given twice", capacity->span);
        continue;
      }
      capacity = chart;
      check_capacity(subject, *chart);
    }
  }
  check_buffers(subject);
}

}  // namespace rubicon::interpreter::robot_check
