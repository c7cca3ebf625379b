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
  if (element.kind == syntax::FrameElement::Kind::node) {
    diagnostics.error("F12", element.span, "the place of a node stands in plans only");
    return std::nullopt;
  }
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

namespace {

/// What an element that does not move does; nothing after reporting F12.
std::optional<math::Pose> constant_pose(const FrameElement& element, Span span,
                                        Diagnostics& diagnostics) {
  const auto a = folded_value(element.a);
  const auto b = folded_value(element.b);
  const auto c = folded_value(element.c);
  if (!a || (element.kind == FrameElement::Kind::trans && (!b || !c))) {
    diagnostics.error("F12", span,
                      "this frame does not move: only numbers and constants can stand here");
    return std::nullopt;
  }
  switch (element.kind) {
    case FrameElement::Kind::rotx:
      return math::rotation_x_deg(*a);
    case FrameElement::Kind::roty:
      return math::rotation_y_deg(*a);
    case FrameElement::Kind::rotz:
      return math::rotation_z_deg(*a);
    case FrameElement::Kind::trans:
      break;
  }
  return math::translation(*a, *b, *c);
}

}  // namespace

std::optional<math::Pose> resolve_constant_frame(const syntax::Frame& frame, FormulaNames& names,
                                                 Diagnostics& diagnostics) {
  math::Pose X = math::Pose::Identity();
  bool complete = true;
  for (const syntax::FrameElement& element : frame.elements) {
    std::optional<math::Pose> factor;
    if (element.kind == syntax::FrameElement::Kind::node) {
      factor = names.place_of(element.node, diagnostics);
      if (&element != &frame.elements.front()) {
        diagnostics.error("F12", element.span, "the place of a node stands first in a frame",
                          "write NETWORK.NODE * trans(...)");
        complete = false;
      }
    } else if (const auto resolved = resolve_element(element, names, diagnostics)) {
      factor = constant_pose(*resolved, element.span, diagnostics);
    }
    complete = complete && factor.has_value();
    if (complete) X = X * *factor;
  }
  if (!complete) return std::nullopt;
  if (!(X.translation().norm() <= kMaxLength)) {
    diagnostics.error("F07", frame.span,
                      fmt::format("this frame is farther than {} m away", kMaxLength));
    return std::nullopt;
  }
  return X;
}

}  // namespace rubicon::interpreter
