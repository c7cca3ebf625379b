#include <fmt/format.h>

#include <algorithm>

#include "interpreter/check/check_robot_parts.hpp"

namespace rubicon::interpreter::robot_check {

namespace {

using script_check::ValueKind;

/// Most derived parameters, each used by the one before, that are followed; bounds the recursion.
constexpr std::size_t kMaxChain = 64;

std::string qualified_name(const Subject& subject, int index) {
  const robot::Parameter& parameter = subject.model.parameters[static_cast<std::size_t>(index)];
  return subject.model.bodies[static_cast<std::size_t>(parameter.body)].name + "." + parameter.name;
}

void report_cycle(Subject& subject, int index) {
  const auto& path = subject.derived_path;
  auto at = std::find(path.begin(), path.end(), index);
  const Span span = subject.parameters[static_cast<std::size_t>(*at)]->name.span;
  std::string text;
  for (; at != path.end(); ++at) text += qualified_name(subject, *at) + " -> ";
  subject.diagnostics.error(
      "R15", span,
      fmt::format("derived parameters cannot be computed from each other: {}{}", text,
                  qualified_name(subject, index)));
}

std::optional<ResolvedFormula> compute(Subject& subject, int index) {
  const auto i = static_cast<std::size_t>(index);
  const robot::Parameter& parameter = subject.model.parameters[i];
  BodyNames names(subject, parameter.body, BodyNames::Use::derived);
  std::optional<ResolvedFormula> value = resolve_formula(
      *subject.parameters[i]->derived, parameter.rotation ? ValueKind::angle : ValueKind::length,
      "param " + parameter.name, names, subject.diagnostics);
  if (value && value->formula.code.size() > kMaxFormulaSize) {
    subject.diagnostics.error(
        "R15", subject.parameters[i]->name.span,
        fmt::format("'{}' has more than {} operations once the derived parameters it uses are put "
                    "in",
                    qualified_name(subject, index), kMaxFormulaSize));
    return std::nullopt;
  }
  if (value) value->kind = parameter.rotation ? ValueKind::angle : ValueKind::length;
  return value;
}

}  // namespace

std::optional<ResolvedFormula> derived_formula(Subject& subject, int index) {
  const auto i = static_cast<std::size_t>(index);
  if (subject.derived_done[i]) return subject.derived[i];
  auto& path = subject.derived_path;
  if (std::find(path.begin(), path.end(), index) != path.end()) {
    report_cycle(subject, index);
    return std::nullopt;
  }
  if (path.size() == kMaxChain) {
    subject.diagnostics.error(
        "R15", subject.parameters[i]->name.span,
        fmt::format("more than {} derived parameters need each other; declare '{}' before those "
                    "that use it",
                    kMaxChain, qualified_name(subject, index)));
    return std::nullopt;
  }
  path.push_back(index);
  subject.derived[i] = compute(subject, index);
  subject.derived_done[i] = true;
  path.pop_back();
  return subject.derived[i];
}

void check_derived(Subject& subject) {
  subject.derived.resize(subject.parameters.size());
  subject.derived_done.resize(subject.parameters.size());
  for (std::size_t i = 0; i < subject.parameters.size(); ++i) {
    robot::Parameter& parameter = subject.model.parameters[i];
    if (!parameter.derived) continue;
    const std::optional<ResolvedFormula> value = derived_formula(subject, static_cast<int>(i));
    if (value) parameter.derived_value = value->formula;
  }
}

}  // namespace rubicon::interpreter::robot_check
