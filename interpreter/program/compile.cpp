#include <cassert>
#include <map>
#include <utility>

#include "interpreter/functions/function_table.hpp"
#include "interpreter/program/program.hpp"
#include "interpreter/syntax/unparse.hpp"
#include "src/motion/guides/leg.hpp"
#include "src/motion/robot/tool_line.hpp"

namespace rubicon::interpreter {

namespace {

using syntax::Expression;
using syntax::Statement;
using OpKind = ExpressionOp::Kind;

OpKind operation(Expression::Operator op) {
  using Operator = Expression::Operator;
  switch (op) {
    case Operator::add:
      return OpKind::add;
    case Operator::subtract:
      return OpKind::subtract;
    case Operator::multiply:
      return OpKind::multiply;
    case Operator::divide:
      return OpKind::divide;
    case Operator::equal:
      return OpKind::equal;
    case Operator::not_equal:
      return OpKind::not_equal;
    case Operator::less:
      return OpKind::less;
    case Operator::less_equal:
      return OpKind::less_equal;
    case Operator::greater:
      return OpKind::greater;
    case Operator::greater_equal:
      return OpKind::greater_equal;
    case Operator::logical_and:
      return OpKind::skip_if_false;
    case Operator::logical_or:
      return OpKind::skip_if_true;
  }
  return OpKind::add;
}

class Compiler {
 public:
  explicit Compiler(std::shared_ptr<const CheckedRobot> robot) : robot_(std::move(robot)) {
    program_.robot = robot_;
  }

  Program compile() {
    const auto bodies = static_cast<int>(robot_->body_scripts.size());
    body_nodes_.assign(model().bodies.size(), -1);  // ropes have none
    for (int b = 0; b < bodies; ++b) {
      if (robot_->body_scripts[static_cast<std::size_t>(b)]) {
        body_nodes_[static_cast<std::size_t>(b)] = add_node(Node::Kind::sequence, {});
      }
    }
    for (int b = 0; b < bodies; ++b) {
      const auto& script = robot_->body_scripts[static_cast<std::size_t>(b)];
      if (script) compile_script(*script, b, body_nodes_[static_cast<std::size_t>(b)]);
    }
    program_.main = add_node(Node::Kind::sequence, {});
    if (robot_->script) {
      compile_script(*robot_->script, -1, program_.main);
    } else {
      // A robot without a script runs its bodies' behaviours from base to tool.
      std::vector<std::int32_t> uses;
      for (const std::int32_t node : body_nodes_) {
        if (node < 0) continue;
        const std::int32_t use = add_node(Node::Kind::use, {});
        at(use).target = node;
        uses.push_back(use);
      }
      set_children(program_.main, uses);
    }
    program_.parameter_names.resize(program_.nodes.size());
    program_.command_texts.resize(program_.nodes.size());
    return std::move(program_);
  }

 private:
  Node& at(std::int32_t node) { return program_.nodes[static_cast<std::size_t>(node)]; }

  std::int32_t add_node(Node::Kind kind, Span span) {
    Node node;
    node.kind = kind;
    node.span = span;
    program_.nodes.push_back(node);
    return static_cast<std::int32_t>(program_.nodes.size()) - 1;
  }

  void set_children(std::int32_t node, const std::vector<std::int32_t>& children) {
    at(node).first = static_cast<std::int32_t>(program_.children.size());
    at(node).count = static_cast<std::int32_t>(children.size());
    program_.children.insert(program_.children.end(), children.begin(), children.end());
  }

  void compile_script(const syntax::Script& script, int body, std::int32_t node) {
    body_ = body;
    behaviours_.clear();
    for (const auto& behaviour : script.behaviours) {
      behaviours_.emplace(behaviour.name.text, add_node(Node::Kind::sequence, behaviour.name.span));
    }
    for (const auto& behaviour : script.behaviours) {
      set_children(behaviours_.at(behaviour.name.text), statements(behaviour.statements));
    }
    set_children(node, statements(script.statements));
  }

  std::vector<std::int32_t> statements(const std::vector<Statement>& list) {
    std::vector<std::int32_t> nodes;
    nodes.reserve(list.size());
    for (const Statement& statement : list) nodes.push_back(compile_statement(statement));
    return nodes;
  }

  std::int32_t compile_statement(const Statement& statement) {
    switch (statement.kind) {
      case Statement::Kind::assignment: {
        const std::int32_t node = add_node(Node::Kind::assignment, statement.keyword);
        at(node).target = variable(statement.name.text());
        at(node).value = compile_code(*statement.value);
        return node;
      }
      case Statement::Kind::move_to:
      case Statement::Kind::move_dir:
        return compile_command(statement);
      case Statement::Kind::together: {
        const std::int32_t node = add_node(Node::Kind::together, statement.keyword);
        std::vector<std::string> names;
        std::vector<std::int32_t> parts;
        for (const Statement& part : statement.elements) {
          parts.push_back(compile_command(part));
          names.push_back(
              model().parameters[static_cast<std::size_t>(at(parts.back()).target)].display_name);
        }
        set_children(node, parts);
        describe(node, unparse(statement), std::move(names));
        return node;
      }
      case Statement::Kind::wait: {
        const std::int32_t node = add_node(Node::Kind::wait, statement.keyword);
        describe(node, unparse(statement), {});
        return node;
      }
      case Statement::Kind::use: {
        const auto found = behaviours_.find(statement.name.text());
        const std::string name = statement.name.text();
        if (statement.value) return add_node(Node::Kind::stop, statement.keyword);
        if (found == behaviours_.end() && (name == kFollow || name == kLine) &&
            !has_body_behaviour(name)) {
          return compile_built_in(statement, name);
        }
        const std::int32_t node = add_node(Node::Kind::use, statement.keyword);
        at(node).target =
            found != behaviours_.end() ? found->second : body_behaviour(statement.name.text());
        return node;
      }
      case Statement::Kind::chain:
        return compile_loop(statement, LoopKind::chain);
      case Statement::Kind::cycle:
        return compile_loop(statement, LoopKind::cycle);
      case Statement::Kind::first:
        return compile_loop(statement, LoopKind::first);
      case Statement::Kind::each: {
        const std::int32_t node = add_node(Node::Kind::each, statement.keyword);
        at(node).each_index = program_.each_count++;
        set_children(node, statements(statement.elements));
        return node;
      }
      case Statement::Kind::which:
        return compile_which(statement);
      case Statement::Kind::broken:
        break;
    }
    assert(false && "only scripts without errors are compiled");
    return add_node(Node::Kind::sequence, statement.keyword);
  }

  std::int32_t compile_command(const Statement& statement) {
    const std::int32_t node = add_node(
        statement.kind == Statement::Kind::move_to ? Node::Kind::move_to : Node::Kind::move_dir,
        statement.keyword);
    const std::int32_t target = parameter(statement.name);
    at(node).target = target;
    at(node).value = compile_code(*statement.value);
    describe(node, unparse(statement),
             {model().parameters[static_cast<std::size_t>(target)].display_name});
    return node;
  }

  std::int32_t compile_built_in(const Statement& statement, const std::string& name) {
    const bool follows = name == kFollow;
    const std::int32_t node =
        add_node(follows ? Node::Kind::follow : Node::Kind::line, statement.keyword);
    const robot::Mounting mounting{math::Pose::Identity(), model().start_values()};
    const std::vector<int> stepped = follows ? guides::Leg(model(), mounting).stepped()
                                             : robot::ToolLine(model(), mounting, {}, {}).stepped();
    std::vector<std::string> names;
    for (const int i : stepped) {
      names.push_back(model().parameters[static_cast<std::size_t>(i)].display_name);
    }
    describe(node, name, std::move(names));
    return node;
  }

  bool has_body_behaviour(const std::string& name) const {
    const int body = model().find_body(name);
    return body >= 0 && body_nodes_[static_cast<std::size_t>(body)] >= 0;
  }

  void describe(std::int32_t node, std::string text, std::vector<std::string> names) {
    const auto index = static_cast<std::size_t>(node);
    program_.parameter_names.resize(std::max(program_.parameter_names.size(), index + 1));
    program_.command_texts.resize(std::max(program_.command_texts.size(), index + 1));
    program_.parameter_names[index] = std::move(names);
    program_.command_texts[index] = std::move(text);
  }

  std::int32_t compile_loop(const Statement& statement, LoopKind kind) {
    const std::int32_t node = add_node(Node::Kind::loop, statement.keyword);
    const std::vector<std::int32_t> elements = statements(statement.elements);
    set_children(node, elements);
    std::vector<std::int32_t> goals;
    for (const std::int32_t element : elements) {
      const Node& child = at(element);
      if (child.kind == Node::Kind::move_to || child.kind == Node::Kind::follow ||
          child.kind == Node::Kind::line) {
        goals.push_back(element);
      }
      if (child.kind == Node::Kind::together) {
        for (std::int32_t i = 0; i < child.count; ++i) {
          const std::int32_t part = program_.children[static_cast<std::size_t>(child.first + i)];
          if (at(part).kind == Node::Kind::move_to) goals.push_back(part);
        }
      }
    }
    Node& loop = at(node);
    loop.loop = kind;
    for (const std::int32_t element : elements) {
      if (!is_passed(at(element).kind)) ++loop.commands;
    }
    loop.goals_first = static_cast<std::int32_t>(program_.children.size());
    loop.goals_count = static_cast<std::int32_t>(goals.size());
    program_.children.insert(program_.children.end(), goals.begin(), goals.end());
    if (statement.until) {
      const Code until = compile_code(*statement.until);
      at(node).value = until;
    }
    return node;
  }

  std::int32_t compile_which(const Statement& statement) {
    const std::int32_t node = add_node(Node::Kind::which, statement.keyword);
    std::vector<std::int32_t> sequences;
    std::vector<ModuleLabels> modules;
    for (const syntax::Module& module : statement.modules) {
      std::vector<Label> labels;
      for (const syntax::Label& label : module.labels) {
        Label compiled;
        switch (label.kind) {
          case syntax::Label::Kind::situation:
            compiled.kind = Label::Kind::situation;
            compiled.situation = situation(label.name.text);
            break;
          case syntax::Label::Kind::otherwise:
            compiled.kind = Label::Kind::otherwise;
            break;
          case syntax::Label::Kind::when:
            compiled.kind = Label::Kind::when;
            compiled.condition = compile_code(*label.condition);
            break;
        }
        labels.push_back(compiled);
      }
      modules.push_back({static_cast<std::int32_t>(program_.labels.size()),
                         static_cast<std::int32_t>(labels.size())});
      program_.labels.insert(program_.labels.end(), labels.begin(), labels.end());
      const std::int32_t sequence = add_node(Node::Kind::sequence, statement.keyword);
      sequences.push_back(sequence);
      set_children(sequence, statements(module.statements));
    }
    set_children(node, sequences);
    at(node).target = static_cast<std::int32_t>(program_.modules.size());
    program_.modules.insert(program_.modules.end(), modules.begin(), modules.end());
    return node;
  }

  Code compile_code(const Expression& expression) {
    Code code;
    code.begin = static_cast<std::int32_t>(program_.code.size());
    emit(expression);
    code.end = static_cast<std::int32_t>(program_.code.size());
    return code;
  }

  void emit(const Expression& expression) {
    switch (expression.kind) {
      case Expression::Kind::number:
        add_op(OpKind::constant, 0, expression.span).value = expression.number.value;
        return;
      case Expression::Kind::parameter:
        add_op(OpKind::parameter, parameter(expression.name), expression.span);
        return;
      case Expression::Kind::variable:
        add_op(OpKind::variable, variable(expression.name.text()), expression.span);
        return;
      case Expression::Kind::call:
        emit_call(expression);
        return;
      case Expression::Kind::negate:
      case Expression::Kind::plus:
      case Expression::Kind::logical_not:
        emit(*expression.operands[0]);
        add_op(expression.kind == Expression::Kind::negate ? OpKind::negate
               : expression.kind == Expression::Kind::plus ? OpKind::plus
                                                           : OpKind::logical_not,
               0, expression.span);
        return;
      case Expression::Kind::binary: {
        emit(*expression.operands[0]);
        const OpKind kind = operation(expression.op);
        if (kind == OpKind::skip_if_false || kind == OpKind::skip_if_true) {
          const std::size_t skip = program_.code.size();
          add_op(kind, 0, expression.op_span);
          emit(*expression.operands[1]);
          program_.code[skip].index = static_cast<std::int32_t>(program_.code.size());
        } else {
          emit(*expression.operands[1]);
          add_op(kind, 0, expression.op_span);
        }
        return;
      }
      case Expression::Kind::command:
        break;
    }
    assert(false && "only scripts without errors are compiled");
  }

  void emit_call(const Expression& call) {
    const Function* function = find_function(call.name.text(), call.operands.size());
    assert(function != nullptr && "only scripts without errors are compiled");
    const bool takes_parameter = function->takes_parameter();
    const std::int32_t index = takes_parameter ? parameter(call.operands[0]->name) : 0;
    for (std::size_t i = takes_parameter ? 1 : 0; i < call.operands.size(); ++i) {
      emit(*call.operands[i]);
    }
    add_op(OpKind::call, index, call.span).function =
        static_cast<std::uint8_t>(function - functions().data());
    if (function->reads == Reads::clock) program_.uses_time = true;
    if (function->result == Result::place) program_.uses_way = true;
  }

  ExpressionOp& add_op(OpKind kind, std::int32_t index, Span span) {
    ExpressionOp op;
    op.kind = kind;
    op.index = index;
    op.span = span;
    program_.code.push_back(op);
    return program_.code.back();
  }

  std::int32_t parameter(const syntax::QualifiedName& name) const {
    const int index = resolve_parameter(model(), body_, name);
    assert(index >= 0 && "only scripts without errors are compiled");
    return index;
  }

  std::int32_t variable(const std::string& name) {
    return intern(name, program_.variables, variables_);
  }
  std::int32_t situation(const std::string& name) {
    return intern(name, program_.situations, situations_);
  }

  static std::int32_t intern(const std::string& name, std::vector<std::string>& names,
                             std::map<std::string, std::int32_t>& indices) {
    const auto [found, inserted] = indices.emplace(name, static_cast<std::int32_t>(names.size()));
    if (inserted) names.push_back(name);
    return found->second;
  }

  std::int32_t body_behaviour(const std::string& name) const {
    const int body = model().find_body(name);
    assert(body >= 0 && body_nodes_[static_cast<std::size_t>(body)] >= 0);
    return body_nodes_[static_cast<std::size_t>(body)];
  }

  const robot::RobotModel& model() const { return robot_->model; }

  std::shared_ptr<const CheckedRobot> robot_;
  Program program_;
  int body_ = -1;
  std::map<std::string, std::int32_t> behaviours_;
  std::vector<std::int32_t> body_nodes_;
  std::map<std::string, std::int32_t> variables_;
  std::map<std::string, std::int32_t> situations_;
};

}  // namespace

Program compile(std::shared_ptr<const CheckedRobot> robot) {
  return Compiler(std::move(robot)).compile();
}

}  // namespace rubicon::interpreter
