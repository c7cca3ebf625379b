#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "interpreter/check/check_script_expression.hpp"
#include "interpreter/check/check_script_parts.hpp"
#include "interpreter/functions/function_table.hpp"

namespace rubicon::interpreter::script_check {

namespace {

using syntax::Expression;
using syntax::Statement;
using StatementKind = Statement::Kind;

bool is_loop(const Statement& statement) {
  return statement.kind == StatementKind::chain || statement.kind == StatementKind::cycle ||
         statement.kind == StatementKind::first;
}

/// Not what is done in passing: an assignment, or stop(unreachable).
bool is_command(const Statement& statement) {
  const bool stops = statement.kind == StatementKind::use && statement.value;
  return statement.kind != StatementKind::assignment && !stops;
}

bool has_commands(const Statement& statement) {
  return std::any_of(statement.elements.begin(), statement.elements.end(), is_command);
}

const char* name_of(const Statement& statement) {
  switch (statement.kind) {
    case StatementKind::chain:
      return "chain";
    case StatementKind::cycle:
      return "cycle";
    case StatementKind::first:
      return "first";
    case StatementKind::each:
      return "each";
    default:
      return "";
  }
}

/// The move_to that make the goal of a loop: its elements, also within together.
std::vector<const Statement*> own_move_to(const Statement& loop) {
  std::vector<const Statement*> found;
  for (const Statement& element : loop.elements) {
    if (element.kind == StatementKind::move_to) found.push_back(&element);
    if (element.kind != StatementKind::together) continue;
    for (const Statement& part : element.elements) {
      if (part.kind == StatementKind::move_to) found.push_back(&part);
    }
  }
  return found;
}

class StructureChecker {
 public:
  explicit StructureChecker(const Subject& subject) : subject_(subject) {
    situations_.assign(std::begin(kBuiltInSituations), std::end(kBuiltInSituations));
    const auto& set_by_plan = subject.context.plan_situations;
    situations_.insert(situations_.end(), set_by_plan.begin(), set_by_plan.end());
  }

  void run() {
    for (std::size_t i = 0; i < subject_.script.behaviours.size(); ++i) {
      check_sequence(subject_.script.behaviours[i].statements, subject_.behaviours.on_its_own[i]);
    }
    check_sequence(subject_.script.statements, true);
  }

 private:
  // `on_its_own`: nothing around the statements repeats them.
  void check_sequence(const std::vector<Statement>& statements, bool on_its_own) {
    for (const Statement& statement : statements) {
      if (on_its_own) check_on_its_own(statement);
      check(statement, on_its_own);
    }
  }

  void check(const Statement& statement, bool on_its_own) {
    if (is_loop(statement)) check_loop(statement);
    if (statement.kind == StatementKind::together) check_together(statement);
    if (statement.kind == StatementKind::which) check_which(statement, on_its_own);
    if (is_loop(statement) || statement.kind == StatementKind::each) {
      check_commands(statement);
      check_after_wait(statement);
      for (const Statement& element : statement.elements) check(element, false);
    }
  }

  void warn(const char* code, const Statement& statement, std::string message) {
    subject_.diagnostics.warning(code, statement.keyword, std::move(message));
  }

  void check_on_its_own(const Statement& statement) {
    if (statement.kind == StatementKind::move_to) {
      warn("W05", statement,
           "a move_to on its own makes a single step; write chain {move_to(...)} to repeat it");
    } else if (statement.kind == StatementKind::each && has_commands(statement)) {
      warn("W05", statement,
           "each on its own performs one command; put it in a chain to repeat it");
    } else if (statement.kind == StatementKind::together &&
               std::any_of(
                   statement.elements.begin(), statement.elements.end(),
                   [](const Statement& part) { return part.kind == StatementKind::move_to; })) {
      warn("W05", statement,
           "a together on its own makes a single step; write chain {together {...}} to repeat it");
    }
  }

  static bool has_broken(const Statement& statement) {
    return std::any_of(
        statement.elements.begin(), statement.elements.end(),
        [](const Statement& element) { return element.kind == StatementKind::broken; });
  }

  void check_commands(const Statement& statement) {
    if (has_commands(statement)) return;
    subject_.diagnostics.error("S14", statement.keyword,
                               fmt::format("this {} has no commands", name_of(statement)));
  }

  void check_after_wait(const Statement& statement) {
    if (statement.kind == StatementKind::cycle)
      return;  // going back from its first element leads to its last
    for (std::size_t i = 0; i + 1 < statement.elements.size(); ++i) {
      if (statement.elements[i].kind != StatementKind::wait) continue;
      warn("W07", statement.elements[i], "nothing after wait is ever tried (wait always succeeds)");
      return;
    }
  }

  // ---- loops ----

  void check_loop(const Statement& loop) {
    const std::vector<const Statement*> goals = own_move_to(loop);
    check_goals(loop, goals);
    if (has_broken(loop)) return;
    if (loop.kind == StatementKind::cycle && has_commands(loop) && goals.empty() && !loop.until) {
      warn("W06", loop,
           "this cycle has no until and no move_to: it only ends when nothing can move");
    }
    if (loop.kind == StatementKind::chain) check_no_way_back(loop);
  }

  bool same_parameter(const syntax::QualifiedName& a, const syntax::QualifiedName& b) const {
    if (a.text() == b.text()) return true;
    if (subject_.context.robot == nullptr) return false;
    const int first = resolve_parameter(*subject_.context.robot, subject_.context.body, a);
    return first >= 0 &&
           first == resolve_parameter(*subject_.context.robot, subject_.context.body, b);
  }

  // The same parameter under another name has the same key.
  std::string key_of(const syntax::QualifiedName& name) const {
    if (subject_.context.robot == nullptr) return name.text();
    const int index = resolve_parameter(*subject_.context.robot, subject_.context.body, name);
    return index >= 0 ? std::to_string(index) : name.text();
  }

  void check_goals(const Statement& loop, const std::vector<const Statement*>& goals) {
    std::map<std::string, const Statement*> first_of;
    std::set<std::string> reported;
    for (const Statement* goal : goals) {
      const std::string key = key_of(goal->name);
      const auto [place, is_new] = first_of.emplace(key, goal);
      if (is_new || !goal->value || !place->second->value) continue;
      const bool same =
          same_expression(*place->second->value, *goal->value,
                          [this](const auto& a, const auto& b) { return same_parameter(a, b); });
      if (same || !reported.insert(key).second) continue;
      Diagnostic conflict;
      conflict.severity = Severity::warning;
      conflict.code = "W04";
      conflict.span = goal->keyword;
      conflict.message = fmt::format(
          "two move_to on '{}' with different targets: the goal of this {} is that both hold, "
          "which may be impossible; use move_dir for the fallback",
          goal->name.text(), name_of(loop));
      conflict.notes.push_back({place->second->keyword, "the other target"});
      subject_.diagnostics.add(std::move(conflict));
    }
  }

  // LANGUAGE 17.1: an element that has nothing to do fails, so control never passes back over it.
  void check_no_way_back(const Statement& chain) {
    std::vector<const Statement*> commands;
    for (const Statement& element : chain.elements) {
      if (is_command(element)) commands.push_back(&element);
    }
    std::set<std::string> assigned;
    collect_targets(chain.elements, assigned);
    for (std::size_t i = 1; i + 1 < commands.size(); ++i) {
      const Statement& command = *commands[i];
      const StatementKind next = commands[i + 1]->kind;
      if (command.kind != StatementKind::move_to || !command.value) continue;
      if (next != StatementKind::move_dir && next != StatementKind::each) continue;
      if (depends_on_configuration(*command.value, assigned)) continue;
      warn("N02", command,
           fmt::format("once '{}' has nothing to do, elements after it cannot return to those "
                       "before it",
                       command_text(command)));
    }
  }

  // Whether the value may be another one after the robot has moved (or time has passed);
  // `assigned`: variables that the chain itself sets.
  static bool depends_on_configuration(const Expression& value,
                                       const std::set<std::string>& assigned) {
    int plain_parameters = 0;
    bool depends = false;
    for_each_subexpression(value, [&](const Expression& part) {
      if (part.kind == Expression::Kind::parameter) ++plain_parameters;
      if (part.kind == Expression::Kind::variable) {
        depends = depends || assigned.count(part.name.text()) > 0;
      }
      if (part.kind != Expression::Kind::call) return;
      const Function* function = find_function(part.name.text(), part.operands.size());
      if (function == nullptr) {
        depends = true;
        return;
      }
      if (function->takes_parameter()) --plain_parameters;
      depends = depends || function->reads != Reads::fixed;
    });
    return depends || plain_parameters > 0;
  }

  // ---- together ----

  void check_together(const Statement& together) {
    std::map<std::string, const Statement*> parts;
    for (const Statement& part : together.elements) {
      if (part.kind == StatementKind::broken) continue;
      const auto [place, is_new] = parts.emplace(key_of(part.name), &part);
      if (is_new) continue;
      Diagnostic twice;
      twice.code = "S14";
      twice.span = part.keyword;
      twice.message =
          fmt::format("'{}' is moved twice in this together; give it one part", part.name.text());
      twice.notes.push_back({place->second->keyword, "the first part"});
      subject_.diagnostics.add(std::move(twice));
    }
  }

  // ---- which ----

  void check_which(const Statement& which, bool on_its_own) {
    std::set<std::string> seen;
    bool has_default = false, default_twice = false, after_default = false;
    for (const syntax::Module& module : which.modules) {
      for (const syntax::Label& label : module.labels) {
        after_default = after_default || has_default;
        if (label.kind == syntax::Label::Kind::when) continue;
        const bool is_default = label.kind == syntax::Label::Kind::otherwise;
        const std::string name = is_default ? "default" : label.name.text;
        if (!seen.insert(name).second) {
          default_twice = default_twice || is_default;
          subject_.diagnostics.error("S13", label.span,
                                     fmt::format("label '{}' appears twice", name));
          continue;
        }
        has_default = has_default || is_default;
        if (!is_default) check_situation(label);
      }
      check_sequence(module.statements, on_its_own);
    }
    if (after_default && !default_twice) {
      subject_.diagnostics.error("S13", which.keyword, "default must be the last label of a which");
    }
    if (!has_default) {
      subject_.diagnostics.note("N01", which.keyword,
                                "which without default: nothing is done in any other situation");
    }
  }

  void check_situation(const syntax::Label& label) {
    if (!subject_.context.has_plan) return;
    const std::string& name = label.name.text;
    if (std::find(situations_.begin(), situations_.end(), name) != situations_.end()) return;
    const std::string near = suggester_.nearest(name, [this] { return situations_; });
    if (near.empty()) return;  // a situation that this plan does not use
    subject_.diagnostics.warning(
        "W08", label.name.span,
        fmt::format("situation '{}' is never set by the plan; did you mean {}?", name, near));
  }

  const Subject& subject_;
  std::vector<std::string> situations_;  // built in or set by the plan
  Suggester suggester_;
};

}  // namespace

void check_structure(const Subject& subject) { StructureChecker(subject).run(); }

}  // namespace rubicon::interpreter::script_check
