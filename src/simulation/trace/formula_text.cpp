#include "src/simulation/trace/formula_text.hpp"

#include <vector>

#include "src/simulation/trace/json_builder.hpp"

namespace rubicon::trace {

namespace {

/// A piece of the text, and how tightly its outermost operator binds.
struct Piece {
  std::string text;
  int binding = 0;
};

constexpr int kSum = 1;
constexpr int kProduct = 2;
constexpr int kSign = 3;
constexpr int kAtom = 4;

std::string bracketed(const Piece& piece, int at_least) {
  return piece.binding < at_least ? "(" + piece.text + ")" : piece.text;
}

Piece pop(std::vector<Piece>& stack) {
  if (stack.empty()) return {"0", kAtom};
  Piece top = std::move(stack.back());
  stack.pop_back();
  return top;
}

Piece binary(std::vector<Piece>& stack, const char* sign, int binding, bool associative) {
  const Piece right = pop(stack);
  const Piece left = pop(stack);
  return {bracketed(left, binding) + sign + bracketed(right, associative ? binding : binding + 1),
          binding};
}

Piece number(double value) {
  std::string text;
  append_number(text, value);
  return {text, value < 0 ? kSign : kAtom};
}

}  // namespace

std::string formula_text(const robot::RobotModel& model, const robot::Formula& formula) {
  using Kind = robot::FormulaOp::Kind;
  std::vector<Piece> stack;
  for (const robot::FormulaOp& op : formula.code) {
    const auto name = [&] {
      return model.parameters[static_cast<std::size_t>(op.index)].display_name;
    };
    switch (op.kind) {
      case Kind::constant:
        stack.push_back(number(op.value));
        break;
      case Kind::parameter:
        stack.push_back({name(), kAtom});
        break;
      case Kind::step:
        stack.push_back({name() + "_s", kAtom});
        break;
      case Kind::start:
        stack.push_back({name() + "_c", kAtom});
        break;
      case Kind::add:
        stack.push_back(binary(stack, " + ", kSum, true));
        break;
      case Kind::subtract:
        stack.push_back(binary(stack, " - ", kSum, false));
        break;
      case Kind::multiply:
        stack.push_back(binary(stack, " * ", kProduct, true));
        break;
      case Kind::divide:
        stack.push_back(binary(stack, " / ", kProduct, false));
        break;
      case Kind::negate:
        stack.push_back({"-" + bracketed(pop(stack), kAtom), kSign});
        break;
      case Kind::sin:
        stack.push_back({"sin(" + pop(stack).text + ")", kAtom});
        break;
      case Kind::cos:
        stack.push_back({"cos(" + pop(stack).text + ")", kAtom});
        break;
    }
  }
  return pop(stack).text;
}

std::string frame_text(const robot::RobotModel& model, const robot::FrameFormula& frame) {
  using Kind = robot::FrameElement::Kind;
  std::string text;
  for (const robot::FrameElement& element : frame) {
    if (!text.empty()) text += " * ";
    const std::string a = formula_text(model, element.a);
    switch (element.kind) {
      case Kind::trans:
        text += "trans(" + a + ", " + formula_text(model, element.b) + ", " +
                formula_text(model, element.c) + ")";
        break;
      case Kind::rotx:
        text += "rotx(" + a + ")";
        break;
      case Kind::roty:
        text += "roty(" + a + ")";
        break;
      case Kind::rotz:
        text += "rotz(" + a + ")";
        break;
    }
  }
  return text.empty() ? "trans(0, 0, 0)" : text;
}

}  // namespace rubicon::trace
