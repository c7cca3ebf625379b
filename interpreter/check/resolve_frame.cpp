#include "interpreter/check/resolve_frame.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "interpreter/check/check_number.hpp"

namespace rubicon::interpreter {

namespace {

using robot::FrameElement;
using script_check::ValueKind;

struct ElementForm {
  std::string_view name;
  FrameElement::Kind kind;
};

constexpr std::array<ElementForm, 4> kForms = {{{"trans", FrameElement::Kind::trans},
                                                {"rotx", FrameElement::Kind::rotx},
                                                {"roty", FrameElement::Kind::roty},
                                                {"rotz", FrameElement::Kind::rotz}}};

std::optional<FrameElement> resolve_element(const syntax::FrameElement& element,
                                            FormulaNames& names, Diagnostics& diagnostics) {
  const ElementForm& form = kForms[static_cast<std::size_t>(element.kind)];
  const bool moves = form.kind == FrameElement::Kind::trans;
  const std::size_t wanted = moves ? 3 : 1;
  if (element.arguments.size() != wanted) {
    diagnostics.error(
        "F06", element.span,
        fmt::format("{} takes {}, found {}", form.name,
                    moves ? "3 arguments (x, y, z)" : "1 argument (an angle in degrees)",
                    element.arguments.size()));
    return std::nullopt;
  }
  FrameElement result;
  result.kind = form.kind;
  bool complete = true;
  robot::Formula* const targets[] = {&result.a, &result.b, &result.c};
  for (std::size_t i = 0; i < wanted; ++i) {
    const syntax::Expression& argument = *element.arguments[i];
    std::optional<ResolvedFormula> value = resolve_formula(
        argument, moves ? ValueKind::length : ValueKind::angle, form.name, names, diagnostics);
    if (!value) {
      complete = false;
      continue;
    }
    const std::optional<double> constant = folded_value(value->formula);
    if (constant && std::fabs(*constant) > kMaxLength) {
      diagnostics.error("F07", argument.span,
                        fmt::format("{} is too large; expected at most {}", *constant, kMaxLength));
      complete = false;
    }
    *targets[i] = std::move(value->formula);
  }
  if (!complete) return std::nullopt;
  return result;
}

}  // namespace

std::optional<robot::FrameFormula> resolve_frame(const syntax::Frame& frame, FormulaNames& names,
                                                 Diagnostics& diagnostics) {
  robot::FrameFormula result;
  bool complete = true;
  for (const syntax::FrameElement& element : frame.elements) {
    std::optional<FrameElement> resolved = resolve_element(element, names, diagnostics);
    complete = complete && resolved.has_value();
    if (complete) result.push_back(*std::move(resolved));
  }
  if (!complete) return std::nullopt;
  return result;
}

std::optional<math::Pose> resolve_constant_frame(const syntax::Frame& frame, FormulaNames& names,
                                                 Diagnostics& diagnostics) {
  const std::optional<robot::FrameFormula> elements = resolve_frame(frame, names, diagnostics);
  if (!elements) return std::nullopt;
  math::Pose X = math::Pose::Identity();
  for (std::size_t i = 0; i < elements->size(); ++i) {
    const FrameElement& element = (*elements)[i];
    const auto a = folded_value(element.a);
    const auto b = folded_value(element.b);
    const auto c = folded_value(element.c);
    if (!a || (element.kind == FrameElement::Kind::trans && (!b || !c))) {
      diagnostics.error("F12", frame.elements[i].span,
                        "this frame does not move: only numbers and constants can stand here");
      return std::nullopt;
    }
    switch (element.kind) {
      case FrameElement::Kind::trans:
        X = X * math::translation(*a, *b, *c);
        break;
      case FrameElement::Kind::rotx:
        X = X * math::rotation_x_deg(*a);
        break;
      case FrameElement::Kind::roty:
        X = X * math::rotation_y_deg(*a);
        break;
      case FrameElement::Kind::rotz:
        X = X * math::rotation_z_deg(*a);
        break;
    }
  }
  if (!(X.translation().norm() <= kMaxLength)) {
    diagnostics.error("F07", frame.span,
                      fmt::format("this frame is farther than {} m away", kMaxLength));
    return std::nullopt;
  }
  return X;
}

}  // namespace rubicon::interpreter
