#pragma once

#include <optional>
#include <string_view>

#include "interpreter/check/check_script_values.hpp"
#include "interpreter/syntax/diagnostic.hpp"
#include "interpreter/syntax/syntax.hpp"
#include "src/motion/robot/formula.hpp"

namespace rubicon::interpreter {

/// A transform function and what its value measures.
struct ResolvedFormula {
  robot::Formula formula;
  script_check::ValueKind kind = script_check::ValueKind::unknown;
};

/// The names a transform function may use.
class FormulaNames {
 public:
  virtual ~FormulaNames() = default;
  /// What `name` stands for; nothing after reporting why it cannot stand there.
  virtual std::optional<ResolvedFormula> resolve(const syntax::QualifiedName& name,
                                                 Diagnostics& diagnostics) = 0;
  /// The place of a node in a plan; nothing after reporting why there is none.
  virtual std::optional<math::Pose> place_of(const syntax::QualifiedName& node,
                                             Diagnostics& diagnostics);
};

/// No names at all: the frames of plans.
class NoFormulaNames : public FormulaNames {
 public:
  /// F12 at the name.
  std::optional<ResolvedFormula> resolve(const syntax::QualifiedName& name,
                                         Diagnostics& diagnostics) override;
};

/// Compiles a transform function (1995 paper, 2.3; LANGUAGE 5.1): sums, products, negation, sin and
/// cos in degrees, division by constants. Constant parts are folded. Nothing after reporting F06,
/// F09-F12 at their places; mixed lengths and angles are warned of (F13).
std::optional<ResolvedFormula> resolve_formula(const syntax::Expression& expression,
                                               FormulaNames& names, Diagnostics& diagnostics);

/// The same where a value of one kind is wanted: a literal of another kind is an error (F09), other
/// values of another kind are warned of (F13). `what` names the value in messages.
std::optional<ResolvedFormula> resolve_formula(const syntax::Expression& expression,
                                               script_check::ValueKind wanted,
                                               std::string_view what, FormulaNames& names,
                                               Diagnostics& diagnostics);

/// The value of a formula that is folded to a constant; nothing for any other.
std::optional<double> folded_value(const robot::Formula& formula);

}  // namespace rubicon::interpreter
