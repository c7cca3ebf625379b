#include "interpreter/check/check.hpp"
#include "interpreter/check/check_script_parts.hpp"
#include "interpreter/check/meant_parameters.hpp"

namespace rubicon::interpreter {

namespace {

/// Whether a script can name it: a command moves it.
bool has_step(const robot::Parameter& parameter) {
  return !parameter.derived && parameter.step > 0;
}

}  // namespace

int resolve_parameter(const robot::RobotModel& robot, int body, const syntax::QualifiedName& name) {
  int found = -1;
  bool ambiguous = false;
  for (std::size_t i = 0; i < robot.parameters.size(); ++i) {
    const robot::Parameter& parameter = robot.parameters[i];
    if (parameter.name != name.name.text) continue;
    if (name.body) {
      if (robot.bodies[parameter.body].name == name.body->text) return static_cast<int>(i);
      continue;
    }
    if (parameter.body == body) return static_cast<int>(i);
    // What no command moves is not meant where something of that name can be moved.
    if (found >= 0 && has_step(robot.parameters[found]) != has_step(parameter)) {
      if (!has_step(parameter)) continue;
      ambiguous = false;
    } else {
      ambiguous = found >= 0;
    }
    found = static_cast<int>(i);
  }
  return ambiguous ? -2 : found;
}

std::vector<std::string> meant_parameters(const robot::RobotModel& robot, const std::string& name) {
  std::vector<std::string> movable, others;
  for (const robot::Parameter& parameter : robot.parameters) {
    if (parameter.name != name) continue;
    (has_step(parameter) ? movable : others).push_back(parameter.display_name);
  }
  return movable.empty() ? others : movable;
}

namespace script_check {

void collect_targets(const std::vector<syntax::Statement>& statements,
                     std::set<std::string>& targets) {
  for (const syntax::Statement& statement : statements) {
    if (statement.kind == syntax::Statement::Kind::assignment) {
      targets.insert(statement.name.text());
    }
    collect_targets(statement.elements, targets);
    for (const syntax::Module& module : statement.modules) {
      collect_targets(module.statements, targets);
    }
  }
}

}  // namespace script_check

void check_script(const syntax::Script& script, const ScriptContext& context,
                  Diagnostics& diagnostics) {
  const script_check::Behaviours behaviours =
      script_check::check_behaviours(script, context, diagnostics);
  const script_check::Subject subject{script, context, behaviours, diagnostics};
  script_check::check_kinds(subject);
  script_check::check_assignment(subject);
  script_check::check_structure(subject);
}

}  // namespace rubicon::interpreter
