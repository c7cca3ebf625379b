#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "interpreter/check/check.hpp"
#include "interpreter/program/events.hpp"

namespace rubicon::interpreter {

/// One operation of a compiled expression, in postfix order. `index` is a parameter, a variable or
/// a jump target.
struct ExpressionOp {
  enum class Kind : std::uint8_t {
    constant,
    parameter,
    variable,
    call,  ///< of functions()[function]; `index` is the parameter it names, if any
    negate,
    plus,
    logical_not,
    add,
    subtract,
    multiply,
    divide,
    equal,
    not_equal,
    less,
    less_equal,
    greater,
    greater_equal,
    skip_if_false,  ///< and: leaves 0 and jumps to `index` when the top is false, else pops it
    skip_if_true    ///< or
  };
  Kind kind = Kind::constant;
  std::uint8_t function = 0;
  std::int32_t index = 0;
  double value = 0;
  Span span;  ///< where a run-time error points
};

/// A piece of Program::code.
struct Code {
  std::int32_t begin = 0;
  std::int32_t end = 0;
  bool empty() const { return begin == end; }
};

/// One node of the flat program.
struct Node {
  enum class Kind : std::uint8_t {
    assignment,
    move_to,
    move_dir,
    together,
    follow,
    line,
    wait,
    stop,  ///< ends the motion: unreachable
    loop,
    each,
    which,
    use,
    sequence
  };
  Kind kind = Kind::sequence;
  LoopKind loop = LoopKind::chain;
  Span span;                 ///< the keyword; what traces point at
  std::int32_t target = -1;  ///< variable, parameter, or for use the sequence node
  Code value;                ///< argument; for loops the until
  std::int32_t first = 0;    ///< children: Program::children[first, first + count)
  std::int32_t count = 0;
  std::int32_t commands = 0;  ///< loop: elements that are commands
  std::int32_t goals_first =
      0;  ///< loop: own move_to nodes: Program::children[goals_first, +goals_count)
  std::int32_t goals_count = 0;
  std::int32_t each_index = -1;  ///< each: its number in the program
};

/// Whether it is done in passing: no command, tries nothing, and moves nothing.
constexpr bool is_passed(Node::Kind kind) {
  return kind == Node::Kind::assignment || kind == Node::Kind::stop;
}

/// `which`: each child is a sequence; its labels stand in Program::labels[first_label, +count) of
/// its module.
struct Label {
  enum class Kind : std::uint8_t { situation, otherwise, when };
  Kind kind = Kind::otherwise;
  std::int32_t situation = -1;  ///< index into Program::situations
  Code condition;
};
struct ModuleLabels {
  std::int32_t first = 0;
  std::int32_t count = 0;
};

/// A robot's behaviour, compiled: flat, immutable, without pointers into the syntax tree.
struct Program {
  std::shared_ptr<const CheckedRobot> robot;
  std::vector<Node> nodes;
  std::vector<std::int32_t> children;
  std::vector<ExpressionOp> code;
  std::vector<Label> labels;
  std::vector<ModuleLabels>
      modules;  ///< parallel to the children of which nodes: by child sequence node
  std::vector<std::string> variables;
  std::vector<std::string> situations;  ///< those that labels name
  std::vector<std::vector<std::string>>
      parameter_names;  ///< per node: display names for traces (commands only)
  std::vector<std::string>
      command_texts;       ///< per node: the command in canonical form (commands only)
  std::int32_t main = -1;  ///< the sequence that is the script
  int each_count = 0;
  bool uses_time = false;
  bool uses_way = false;  ///< it asks for places on the way
};

/// Compiles the behaviour of a usable robot; without a script of its own, its bodies' behaviours
/// from base to tool.
Program compile(std::shared_ptr<const CheckedRobot> robot);

}  // namespace rubicon::interpreter
