#include "tests/unit/taskplan/crane_plan.hpp"

namespace rubicon::test {

namespace {

constexpr std::uint32_t kLineBytes = 10;

interpreter::Span at_line(int line) {
  const auto begin = static_cast<std::uint32_t>(line - 1) * kLineBytes + 2;
  return {0, begin, begin + 3};
}

/// "z" or "hook.theta".
syntax::QualifiedName qualified(const std::string& text) {
  syntax::QualifiedName name;
  const std::size_t dot = text.find('.');
  if (dot != std::string::npos) name.body = syntax::Name{text.substr(0, dot), {}};
  name.name.text = dot == std::string::npos ? text : text.substr(dot + 1);
  return name;
}

syntax::ExpressionPtr parameter(const std::string& name) {
  auto expression = std::make_unique<syntax::Expression>();
  expression->kind = syntax::Expression::Kind::parameter;
  expression->name = qualified(name);
  return expression;
}

template <typename... Operands>
syntax::ExpressionPtr call(const std::string& name, Operands... operands) {
  auto expression = std::make_unique<syntax::Expression>();
  expression->kind = syntax::Expression::Kind::call;
  expression->name = qualified(name);
  (expression->operands.push_back(std::move(operands)), ...);
  return expression;
}

syntax::ExpressionPtr plus(syntax::ExpressionPtr left, syntax::ExpressionPtr right) {
  auto expression = std::make_unique<syntax::Expression>();
  expression->kind = syntax::Expression::Kind::binary;
  expression->op = syntax::Expression::Operator::add;
  expression->operands.push_back(std::move(left));
  expression->operands.push_back(std::move(right));
  return expression;
}

syntax::Statement command(syntax::Statement::Kind kind, int line) {
  syntax::Statement statement;
  statement.kind = kind;
  statement.keyword = statement.span = at_line(line);
  return statement;
}

robot::Formula rule_of(int index) {
  using Kind = robot::FormulaOp::Kind;
  return {{{Kind::parameter, index, 0}, {Kind::step, index, 0}, {Kind::add, 0, 0}}};
}

robot::Parameter free_parameter(int index, const std::string& name, int body, double step,
                                double speed) {
  robot::Parameter p;
  p.name = p.display_name = name;
  p.body = body;
  p.step = p.quantum = step;
  p.speed = p.loaded_speed = speed;
  p.rule = rule_of(index);
  return p;
}

geometry::Shape box(const math::Vec3& lower, const math::Vec3& upper) {
  return {geometry::Box{lower, upper}, math::Pose::Identity()};
}

robot::RobotModel crane_model() {
  using Kind = robot::FrameElement::Kind;
  robot::RobotModel model;
  model.name = "crane";
  robot::Parameter turn = free_parameter(0, "theta", 1, 5, 5);
  turn.rotation = true;
  turn.lower = -180;
  turn.upper = 180;
  turn.display_name = "jib.theta";
  robot::Parameter travel = free_parameter(1, "x", 2, 1, 1);
  travel.lower = 4;
  travel.upper = 50;
  travel.start = 10;
  robot::Parameter lift = free_parameter(2, "z", 2, 1, 0.5);
  lift.lower = 0;
  lift.upper = 42;
  lift.start = 20;
  robot::Parameter twist = free_parameter(3, "theta", 2, 15, 15);
  twist.rotation = true;
  twist.cyclic = true;
  twist.display_name = "hook.theta";
  model.parameters = {turn, travel, lift, twist};
  const robot::Formula zero = robot::constant_formula(0);
  model.bodies = {
      {"mast", -1, {}, {}, {box({-1, -1, 0}, {1, 1, 44})}},
      {"jib",
       0,
       {0},
       {{Kind::rotz, robot::parameter_formula(0), {}, {}}},
       {box({-12, -0.8, 44}, {52, 0.8, 46})}},
      {"hook",
       1,
       {1, 2, 3},
       {{Kind::trans, robot::parameter_formula(1), zero, robot::parameter_formula(2)},
        {Kind::rotz, robot::parameter_formula(3), {}, {}}},
       {box({-0.5, -0.5, 0}, {0.5, 0.5, 1})}},
  };
  model.tool_body = 2;
  return model;
}

}  // namespace

syntax::ExpressionPtr number(double value) {
  auto expression = std::make_unique<syntax::Expression>();
  expression->number.value = value;
  return expression;
}

syntax::ExpressionPtr goal_of(const std::string& name) { return call("goal", parameter(name)); }

syntax::ExpressionPtr upwards() { return call("dir", parameter("z"), call("max", parameter("z"))); }

syntax::Statement move_to(const std::string& name, syntax::ExpressionPtr value, int line) {
  syntax::Statement statement = command(syntax::Statement::Kind::move_to, line);
  statement.name = qualified(name);
  statement.value = std::move(value);
  return statement;
}

syntax::Statement move_dir(const std::string& name, syntax::ExpressionPtr value, int line) {
  syntax::Statement statement = command(syntax::Statement::Kind::move_dir, line);
  statement.name = qualified(name);
  statement.value = std::move(value);
  return statement;
}

syntax::Statement together(std::vector<syntax::Statement> parts, int line) {
  syntax::Statement statement = command(syntax::Statement::Kind::together, line);
  statement.elements = std::move(parts);
  return statement;
}

syntax::Statement chain(std::vector<syntax::Statement> elements, int line) {
  syntax::Statement statement = command(syntax::Statement::Kind::chain, line);
  statement.elements = std::move(elements);
  return statement;
}

syntax::Statement which(const std::string& label, syntax::Statement then,
                        syntax::Statement otherwise, int line) {
  syntax::Statement statement = command(syntax::Statement::Kind::which, line);
  syntax::Label named;
  named.name.text = label;
  syntax::Label other;
  other.kind = syntax::Label::Kind::otherwise;
  other.name.text = "default";
  syntax::Module first;
  first.labels.push_back(std::move(named));
  first.statements.push_back(std::move(then));
  syntax::Module second;
  second.labels.push_back(std::move(other));
  second.statements.push_back(std::move(otherwise));
  statement.modules.push_back(std::move(first));
  statement.modules.push_back(std::move(second));
  return statement;
}

std::shared_ptr<interpreter::CheckedRobot> crane(std::vector<syntax::Statement> script) {
  auto robot = std::make_shared<interpreter::CheckedRobot>();
  robot->path = "crane.robot";
  robot->model = crane_model();
  robot->script.emplace();
  robot->script->statements = std::move(script);
  robot->body_scripts.resize(robot->model.bodies.size());
  robot->usable = true;
  return robot;
}

std::vector<syntax::Statement> lifting_script() {
  return list(
      chain(list(move_to("z", number(20), 1)), 1),
      chain(list(move_to("jib.theta", goal_of("jib.theta"), 2), move_dir("z", upwards(), 3)), 2),
      chain(list(move_to("x", goal_of("x"), 4)), 4),
      chain(list(move_to("hook.theta", goal_of("hook.theta"), 5)), 5),
      which("place", chain(list(move_to("z", goal_of("z"), 7)), 7),
            which("transport", chain(list(move_to("z", plus(goal_of("z"), number(2)), 9)), 9),
                  chain(list(move_to("z", goal_of("z"), 10)), 10), 8),
            6));
}

interpreter::SourceMap numbered_lines() {
  interpreter::SourceMap sources;
  std::string text;
  for (int i = 0; i < 40; ++i) text += std::string(kLineBytes - 1, '.') + "\n";
  sources.add("crane.motion", text);
  return sources;
}

interpreter::PlanModel crane_plan() {
  interpreter::PlanModel plan;
  plan.name = "site";
  plan.path = "site.plan";
  interpreter::RobotSpec robot;
  robot.name = "crane";
  robot.robot = crane(lifting_script());
  robot.start = {0, 10, 20, 0};
  plan.robots.push_back(robot);
  plan.crews.push_back({});
  plan.crews.back().name = "riggers";
  return plan;
}

interpreter::ComponentSpec box_component(const std::string& name, const math::Vec3& size,
                                         const math::Pose& X_WO) {
  interpreter::ComponentSpec component;
  component.name = name;
  component.shapes = {
      box({-size.x() / 2, -size.y() / 2, 0}, {size.x() / 2, size.y() / 2, size.z()})};
  component.X_WO = X_WO;
  component.X_OG = math::translation(0, 0, size.z());
  return component;
}

interpreter::TaskSpec move_task(const std::string& name, int component, const math::Pose& X_WO) {
  interpreter::TaskSpec task;
  task.name = name;
  task.robot = 0;
  task.crews = {0};
  task.move = component;
  task.X_WO_goal = X_WO;
  return task;
}

}  // namespace rubicon::test
