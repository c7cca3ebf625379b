#include <fmt/format.h>

#include <algorithm>

#include "interpreter/check/check_robot_parts.hpp"

namespace rubicon::interpreter::robot_check {

namespace {

std::vector<std::string> names_of(const std::map<std::string, int>& index) {
  std::vector<std::string> names;
  for (const auto& [name, i] : index) names.push_back(name);
  return names;
}

const syntax::BodyItem* find_later(const Subject& subject, const std::string& name) {
  for (const syntax::RobotItem& each : subject.robot.items) {
    const auto* body = std::get_if<syntax::BodyItem>(&each);
    if (body != nullptr && body->name.text == name) return body;
  }
  return nullptr;
}

int find_parent(Subject& subject, const syntax::BodyItem& item) {
  if (!item.on) return -1;
  const std::string& name = item.on->text;
  const auto found = subject.body_index.find(name);
  if (found != subject.body_index.end()) return found->second;
  if (name == item.name.text) {
    subject.diagnostics.error("R05", item.on->span,
                              fmt::format("body '{}' cannot stand on itself", name));
  } else if (const syntax::BodyItem* later = find_later(subject, name)) {
    Diagnostic diagnostic;
    diagnostic.code = "R05";
    diagnostic.span = item.on->span;
    diagnostic.message =
        fmt::format("body '{}' stands on '{}', which is declared later", item.name.text, name);
    diagnostic.notes.push_back({later->name.span, "declared here"});
    diagnostic.hint = "declare a body before those that stand on it";
    subject.diagnostics.add(std::move(diagnostic));
  } else if (subject.judges_names()) {
    subject.diagnostics.error(
        "R05", item.on->span,
        fmt::format(
            "body '{}' stands on '{}', which is not declared{}", item.name.text, name,
            subject.suggestions.ending(name, [&] { return names_of(subject.body_index); })));
  }
  return -1;
}

/// Of a parameter with a wrong name: whether what stands behind it speaks of angles.
bool looks_like_a_rotation(const syntax::ParameterItem& item) {
  return std::any_of(item.attributes.begin(), item.attributes.end(),
                     [](const syntax::Attribute& attribute) {
                       return attribute.name.text == "cyclic" ||
                              std::any_of(attribute.numbers.begin(), attribute.numbers.end(),
                                          [](const syntax::Number& number) {
                                            return number.unit == syntax::UnitKind::angle ||
                                                   number.unit == syntax::UnitKind::turn_rate;
                                          });
                     });
}

void declare_parameters(Subject& subject, int body, const syntax::BodyItem& item) {
  auto& index = subject.body_parameters[static_cast<std::size_t>(body)];
  for (const syntax::ParameterItem& each : item.parameters) {
    const std::string& name = each.name.text;
    const auto kind = script_check::kind_of_parameter(name);
    if (!kind) {
      const std::string nearest = did_you_mean(name, {"x", "y", "z", "psi", "phi", "theta"});
      subject.diagnostics.error(
          "R02", each.name.span,
          fmt::format("a control parameter is x, y, z, psi, phi or theta, found '{}'{}", name,
                      nearest.empty() ? "" : "; did you mean " + nearest + "?"));
      // It is declared all the same: whoever uses the name makes no second mistake.
    }
    const auto [place, is_new] = index.emplace(name, static_cast<int>(subject.parameters.size()));
    if (!is_new) {
      const auto first = static_cast<std::size_t>(place->second);
      subject.twice(
          each.name.span,
          fmt::format("parameter '{}' of body '{}' is declared twice", name, item.name.text),
          subject.parameters[first]->name.span);
      continue;
    }
    robot::Parameter parameter;
    parameter.name = name;
    parameter.body = body;
    parameter.rotation =
        kind ? *kind == script_check::ValueKind::angle : looks_like_a_rotation(each);
    parameter.derived = each.derived != nullptr;
    subject.model.bodies[static_cast<std::size_t>(body)].parameters.push_back(place->second);
    subject.model.parameters.push_back(std::move(parameter));
    subject.parameters.push_back(&each);
  }
}

}  // namespace

void declare_bodies(Subject& subject) {
  for (syntax::RobotItem& each : subject.robot.items) {
    auto* item = std::get_if<syntax::BodyItem>(&each);
    if (item == nullptr) continue;
    const auto known = subject.body_index.find(item->name.text);
    if (known != subject.body_index.end()) {
      subject.twice(item->name.span, fmt::format("body '{}' is declared twice", item->name.text),
                    subject.bodies[static_cast<std::size_t>(known->second)]->name.span);
      continue;
    }
    if (subject.bodies.size() == kMaxBodies) {
      subject.diagnostics.error("R18", item->name.span,
                                fmt::format("this robot has more than {} bodies", kMaxBodies));
      break;
    }
    const int index = static_cast<int>(subject.bodies.size());
    robot::Body body;
    body.name = item->name.text;
    body.parent = find_parent(subject, *item);
    subject.body_index.emplace(body.name, index);
    subject.bodies.push_back(item);
    subject.body_parameters.emplace_back();
    subject.model.bodies.push_back(std::move(body));
    declare_parameters(subject, index, *item);
  }
  if (subject.bodies.empty() && subject.judges_names()) {
    subject.diagnostics.error(
        "R18", subject.robot.name.span,
        fmt::format("robot '{}' has no body: nothing of it can move", subject.robot.name.text),
        "write body NAME { ... }");
  }
}

}  // namespace rubicon::interpreter::robot_check
