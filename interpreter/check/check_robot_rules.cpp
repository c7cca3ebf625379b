#include <fmt/format.h>

#include <algorithm>

#include "interpreter/check/check_robot_parts.hpp"

namespace rubicon::interpreter::robot_check {

namespace {

using robot::FormulaOp;
using script_check::ValueKind;

ValueKind wanted_kind(const robot::Parameter& parameter) {
  return parameter.rotation ? ValueKind::angle : ValueKind::length;
}

robot::Formula default_rule(int index) {
  FormulaOp value, step, add;
  value.kind = FormulaOp::Kind::parameter;
  value.index = index;
  step.kind = FormulaOp::Kind::step;
  step.index = index;
  add.kind = FormulaOp::Kind::add;
  return {{value, step, add}};
}

/// p + p_s or p_s + p.
bool is_default_rule(const robot::Formula& rule, int index) {
  if (rule.code.size() != 3 || rule.code[2].kind != FormulaOp::Kind::add) return false;
  const FormulaOp &a = rule.code[0], &b = rule.code[1];
  if (a.index != index || b.index != index) return false;
  return (a.kind == FormulaOp::Kind::parameter && b.kind == FormulaOp::Kind::step) ||
         (a.kind == FormulaOp::Kind::step && b.kind == FormulaOp::Kind::parameter);
}

class BodyRules {
 public:
  BodyRules(Subject& subject, int body)
      : subject_(subject),
        item_(*subject.bodies[static_cast<std::size_t>(body)]),
        body_(body),
        names_(subject.body_parameters[static_cast<std::size_t>(body)]) {}

  void check() {
    for (const syntax::RuleItem& rule : item_.rules) check_rule(rule);
    classify();
    for (const auto& index : own()) warn_without_effect(index);
  }

 private:
  const std::vector<int>& own() const {
    return subject_.model.bodies[static_cast<std::size_t>(body_)].parameters;
  }
  robot::Parameter& parameter(int index) {
    return subject_.model.parameters[static_cast<std::size_t>(index)];
  }

  void check_rule(const syntax::RuleItem& rule) {
    const std::string& name = rule.parameter.text;
    const auto found = names_.find(name);
    if (found == names_.end()) {
      report_undeclared(rule);
      return;
    }
    const auto [place, is_new] = rules_.emplace(found->second, &rule);
    if (!is_new) {
      subject_.twice(rule.parameter.span,
                     fmt::format("'{}' of body '{}' has two rules", name, item_.name.text),
                     place->second->parameter.span);
      return;
    }
    robot::Parameter& target = parameter(found->second);
    if (target.derived) {
      subject_.diagnostics.error(
          "R14", rule.parameter.span,
          fmt::format("'{}' is computed from other parameters and cannot have a rule", name));
      return;
    }
    if (!rule.value) return;
    warn_of_step(rule);
    BodyNames names(subject_, body_, BodyNames::Use::rule);
    std::optional<ResolvedFormula> value = resolve_formula(
        *rule.value, wanted_kind(target), "rule " + name, names, subject_.diagnostics);
    if (value) {
      target.rule = std::move(value->formula);
    } else {
      failed_ = true;
    }
  }

  void report_undeclared(const syntax::RuleItem& rule) {
    if (!subject_.judges_names()) return;
    const std::string& name = rule.parameter.text;
    subject_.diagnostics.error(
        "R14", rule.parameter.span,
        fmt::format("rule for '{}', which is not a parameter of body '{}'{}", name, item_.name.text,
                    subject_.suggestions.ending(name, [&] {
                      std::vector<std::string> names;
                      for (const auto& [each, index] : names_) names.push_back(each);
                      return names;
                    })));
  }

  /// `rule z <- z_s` was meant to keep z (the paper misprints it) or to add the step.
  void warn_of_step(const syntax::RuleItem& rule) {
    const std::string& name = rule.parameter.text;
    const syntax::Expression& value = *rule.value;
    if (value.kind != syntax::Expression::Kind::parameter || value.name.body) return;
    if (value.name.name.text != name + "_s") return;
    subject_.diagnostics.warning(
        "R13", value.span,
        fmt::format("sets {0} to its step; did you mean {0}_c or {0} + {0}_s?", name));
  }

  /// Fills in missing rules; a parameter is direct if it alone feels its step, and free if some
  /// command can change it.
  void classify() {
    for (const int p : own()) {
      robot::Parameter& target = parameter(p);
      if (target.derived) {
        target.direct = target.free = false;
      } else if (target.rule.code.empty()) {
        target.rule = default_rule(p);
      }
    }
    // What every rule depends on: one pass over its code, for long rules of many parameters.
    std::map<int, int> readers;  // of each step: how many rules read it
    for (const int p : own()) {
      robot::Parameter& target = parameter(p);
      if (target.derived) continue;
      target.free = false;
      std::map<int, bool> seen;
      for (const FormulaOp& op : target.rule.code) {
        if (op.kind != FormulaOp::Kind::step) continue;
        if (parameter(op.index).step > 0) target.free = true;
        if (!seen[op.index]) ++readers[op.index];
        seen[op.index] = true;
      }
    }
    for (const int p : own()) {
      robot::Parameter& target = parameter(p);
      if (!target.derived) target.direct = is_default_rule(target.rule, p) && readers[p] == 1;
    }
    readers_ = std::move(readers);
  }

  void warn_without_effect(int index) {
    const robot::Parameter& target = parameter(index);
    if (failed_ || target.derived || target.step <= 0 || readers_.count(index) != 0) return;
    subject_.diagnostics.warning(
        "R21", subject_.parameters[static_cast<std::size_t>(index)]->name.span,
        fmt::format("no rule of body '{}' uses {}_s: steps of '{}' change nothing", item_.name.text,
                    target.name, target.name));
  }

  Subject& subject_;
  const syntax::BodyItem& item_;
  int body_;
  const std::map<std::string, int>& names_;
  std::map<int, const syntax::RuleItem*> rules_;
  std::map<int, int> readers_;
  bool failed_ = false;
};

}  // namespace

void check_rules(Subject& subject) {
  for (std::size_t i = 0; i < subject.bodies.size(); ++i) {
    BodyRules(subject, static_cast<int>(i)).check();
  }
}

}  // namespace rubicon::interpreter::robot_check
