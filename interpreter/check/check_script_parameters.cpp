#include "interpreter/check/check_script_parameters.hpp"

#include <fmt/format.h>

#include "interpreter/check/meant_parameters.hpp"

namespace rubicon::interpreter::script_check {

namespace {

// A message that lists more is not read.
constexpr int kMaxListedParameters = 16;

template <typename Wanted>
std::string list_of(const robot::RobotModel& robot, const Wanted& wanted) {
  std::string text;
  int count = 0;
  for (const robot::Parameter& parameter : robot.parameters) {
    if (!wanted(parameter)) continue;
    if (count++ == kMaxListedParameters) return text + ", ...";
    text += (text.empty() ? "" : ", ") + parameter.display_name;
  }
  return text.empty() ? "none" : text;
}

}  // namespace

ParameterNames::ParameterNames(const Subject& subject, Diagnostics& diagnostics)
    : context_(subject.context), diagnostics_(diagnostics) {
  for (const auto& behaviour : subject.script.behaviours) {
    collect_targets(behaviour.statements, variables_);
  }
  collect_targets(subject.script.statements, variables_);
}

const robot::Parameter* ParameterNames::find(const syntax::QualifiedName& name) const {
  if (context_.robot == nullptr) return nullptr;
  const int index = resolve_parameter(*context_.robot, context_.body, name);
  return index < 0 ? nullptr : &context_.robot->parameters[index];
}

Parameter ParameterNames::resolve(const syntax::QualifiedName& name, Span place) {
  const robot::Parameter* model = find(name);
  const std::optional<ValueKind> kind = kind_of_parameter(name.name.text);
  if (model != nullptr) return {kind.value_or(ValueKind::unknown), model};
  if (context_.robot == nullptr && kind) return {*kind, nullptr};
  if (wrong_names_.insert(name.text()).second) {
    diagnostics_.error("S08", place, wrong_name_text(name, kind.has_value()));
  }
  return {};
}

std::string ParameterNames::wrong_name_text(const syntax::QualifiedName& name,
                                            bool is_parameter_name) {
  const std::string text = name.text();
  if (context_.robot == nullptr) {
    return fmt::format("'{}' is not a control parameter; {}", text,
                       other_way(text, {"psi", "phi", "theta"}));
  }
  const robot::RobotModel& robot = *context_.robot;
  if (resolve_parameter(robot, context_.body, name) == -2) {
    std::vector<std::string> owners = meant_parameters(robot, name.name.text);
    if (owners.size() > kMaxListedParameters) {
      owners.resize(kMaxListedParameters);
      owners.emplace_back("...");
    }
    return fmt::format("'{}' is ambiguous: {}", text, fmt::join(owners, ", "));
  }
  if (name.body) return wrong_body_text(name);
  const std::string all = list_of(robot, [](const auto&) { return true; });
  if (is_parameter_name) {
    return fmt::format("robot '{}' has no control parameter '{}' (it has {})", robot.name, text,
                       all);
  }
  std::vector<std::string> names;
  for (const auto& parameter : robot.parameters) names.push_back(parameter.display_name);
  return fmt::format("'{}' is not a control parameter of robot '{}' (it has {}); {}", text,
                     robot.name, all, other_way(text, names));
}

std::string ParameterNames::wrong_body_text(const syntax::QualifiedName& name) {
  const robot::RobotModel& robot = *context_.robot;
  for (std::size_t i = 0; i < robot.bodies.size(); ++i) {
    if (robot.bodies[i].name != name.body->text) continue;
    return fmt::format("body '{}' of robot '{}' has no control parameter '{}' (it has {})",
                       name.body->text, robot.name, name.name.text,
                       list_of(robot, [&](const auto& parameter) {
                         return parameter.body == static_cast<int>(i);
                       }));
  }
  const std::string near = bodies_.nearest(name.body->text, [&] {
    std::vector<std::string> names;
    for (const auto& body : robot.bodies) names.push_back(body.name);
    return names;
  });
  return fmt::format("robot '{}' has no body '{}'", robot.name, name.body->text) +
         (near.empty() ? "" : fmt::format("; did you mean {}.{}?", near, name.name.text));
}

// A variable of that name is likelier meant than a parameter that is spelt a little like it.
std::string ParameterNames::other_way(const std::string& name,
                                      const std::vector<std::string>& parameters) const {
  if (variables_.count(name) == 0) {
    const std::string near = did_you_mean(name, parameters);
    if (!near.empty()) return fmt::format("did you mean {}?", near);
  }
  return fmt::format("for a variable write var({})", name);
}

bool ParameterNames::check_movable(const Parameter& parameter, Span place) {
  if (parameter.model == nullptr) return true;
  const bool derived = parameter.model->derived;
  if (!derived && parameter.model->step > 0) return true;
  diagnostics_.error("S09", place,
                     fmt::format("parameter '{}' of robot '{}' {}, it cannot be moved",
                                 parameter.model->display_name, context_.robot->name,
                                 derived ? "is computed from others" : "has no motion step"));
  return false;
}

}  // namespace rubicon::interpreter::script_check
