#include <fmt/format.h>
#include <fmt/ranges.h>

#include "interpreter/check/check_robot_parts.hpp"

namespace rubicon::interpreter::robot_check {

namespace {

using robot::Formula;
using robot::FormulaOp;
using script_check::kind_of_parameter;
using script_check::ValueKind;

ValueKind kind_of(const std::string& parameter) {
  return kind_of_parameter(parameter).value_or(ValueKind::unknown);
}

}  // namespace

const char* BodyNames::use_text() const {
  switch (use_) {
    case Use::rule:
      return "a motion rule";
    case Use::frame:
      return "a frame";
    case Use::derived:
      return "a derived parameter";
  }
  return "";
}

std::optional<ResolvedFormula> BodyNames::resolve(const syntax::QualifiedName& name, Diagnostics&) {
  const std::optional<int> body = find_body(name);
  if (!body) return std::nullopt;
  const auto& parameters = subject_.body_parameters[static_cast<std::size_t>(*body)];
  const auto found = parameters.find(name.name.text);
  if (found != parameters.end()) return parameter(found->second, name);
  if (!name.body) {
    const auto constant = subject_.constants.find(name.name.text);
    if (constant != subject_.constants.end()) return constant->second;
    // A constant that could not be folded was reported where it stands.
    if (subject_.constant_spans.count(name.name.text) != 0) return std::nullopt;
  }
  return step_or_start(*body, name);
}

std::optional<int> BodyNames::find_body(const syntax::QualifiedName& name) {
  if (!name.body) return body_;
  const auto found = subject_.body_index.find(name.body->text);
  if (found == subject_.body_index.end()) {
    if (subject_.judges_names()) {
      subject_.diagnostics.error("R04", name.body->span,
                                 fmt::format("unknown body '{}'{}", name.body->text,
                                             subject_.suggestions.ending(name.body->text, [&] {
                                               std::vector<std::string> names;
                                               for (const auto& [each, index] : subject_.body_index)
                                                 names.push_back(each);
                                               return names;
                                             })));
    }
    return std::nullopt;
  }
  if (found->second != body_ && use_ != Use::derived) {
    subject_.diagnostics.error(
        "R04", name.span,
        fmt::format("{} of body '{}' uses only its own parameters, not '{}'", use_text(),
                    subject_.model.bodies[static_cast<std::size_t>(body_)].name, name.text()));
    return std::nullopt;
  }
  return found->second;
}

std::optional<ResolvedFormula> BodyNames::parameter(int index, const syntax::QualifiedName& name) {
  if (use_ == Use::derived && subject_.model.parameters[static_cast<std::size_t>(index)].derived) {
    return derived_formula(subject_, index);
  }
  return ResolvedFormula{robot::parameter_formula(index), kind_of(name.name.text)};
}

std::optional<ResolvedFormula> BodyNames::step_or_start(int body,
                                                        const syntax::QualifiedName& name) {
  const std::string& text = name.name.text;
  const bool step = text.ends_with("_s");
  if (!step && !text.ends_with("_c")) {
    report_unknown(body, name);
    return std::nullopt;
  }
  const std::string base = text.substr(0, text.size() - 2);
  const auto& parameters = subject_.body_parameters[static_cast<std::size_t>(body)];
  const auto found = parameters.find(base);
  if (found == parameters.end()) {
    report_unknown(body, name);
    return std::nullopt;
  }
  const auto index = static_cast<std::size_t>(found->second);
  if (subject_.model.parameters[index].derived) {
    subject_.diagnostics.error("R04", name.span,
                               fmt::format("'{}' is computed from other parameters: it has no {}",
                                           base, step ? "step" : "start value"));
    return std::nullopt;
  }
  if (step && use_ != Use::rule) {
    subject_.diagnostics.error(
        "R04", name.span,
        fmt::format("the step '{}' has a value only while a rule is applied; {} cannot use it",
                    name.text(), use_text()));
    return std::nullopt;
  }
  FormulaOp op;
  op.kind = step ? FormulaOp::Kind::step : FormulaOp::Kind::start;
  op.index = found->second;
  return ResolvedFormula{Formula{{op}}, kind_of(base)};
}

void BodyNames::report_unknown(int body, const syntax::QualifiedName& name) {
  if (!subject_.judges_names()) return;
  const auto& parameters = subject_.body_parameters[static_cast<std::size_t>(body)];
  const std::string& body_name = subject_.model.bodies[static_cast<std::size_t>(body)].name;
  for (std::size_t other = 0; !name.body && other < subject_.body_parameters.size(); ++other) {
    if (subject_.body_parameters[other].count(name.name.text) == 0) continue;
    const std::string owner = subject_.model.bodies[other].name;
    subject_.diagnostics.error(
        "R04", name.span,
        use_ == Use::derived
            ? fmt::format("'{}' is not a parameter of body '{}'; write {}.{}", name.name.text,
                          body_name, owner, name.name.text)
            : fmt::format("'{}' is a parameter of body '{}'; {} of body '{}' uses only its own "
                          "parameters",
                          name.name.text, owner, use_text(), body_name));
    return;
  }
  std::vector<std::string> candidates;
  for (const auto& [each, index] : parameters) {
    candidates.push_back(each);
    if (use_ == Use::rule) candidates.push_back(each + "_s");
    candidates.push_back(each + "_c");
  }
  std::string ending = subject_.suggestions.ending(name.name.text, [&] {
    std::vector<std::string> all = candidates;
    for (const auto& [each, value] : subject_.constants) all.push_back(each);
    return all;
  });
  if (ending.empty() && !candidates.empty()) {
    ending = fmt::format(" (it has {})", fmt::join(candidates, ", "));
  }
  subject_.diagnostics.error(
      "R04", name.span,
      fmt::format("'{}' is not a parameter, {}start value or constant of body '{}'{}", name.text(),
                  use_ == Use::rule ? "step, " : "", body_name, ending));
}

}  // namespace rubicon::interpreter::robot_check
