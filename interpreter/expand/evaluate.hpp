#pragma once

#include <optional>
#include <string>

#include "interpreter/expand/scope.hpp"
#include "interpreter/syntax/diagnostic.hpp"

namespace rubicon::interpreter::expansion {

/// The value of an expression; nothing after saying what is wrong: P23 (names), F06 (number of
/// arguments), F09 (kinds), F10 (what cannot stand there), F11 (no finite value).
///
/// A bare number takes the kind of what it is added to or compared with. Products and quotients
/// combine kinds.
std::optional<Value> evaluate(const syntax::Expression& expression, Scope& scope,
                              Diagnostics& diagnostics);

/// The same where a number is wanted (not a text, not a condition).
std::optional<Value> evaluate_number(const syntax::Expression& expression, Scope& scope,
                                     Diagnostics& diagnostics);

/// The same where a condition is wanted.
std::optional<bool> evaluate_condition(const syntax::Expression& expression, Scope& scope,
                                       Diagnostics& diagnostics);

/// The same where a whole bare number is wanted that `what` names: "the brackets of a name".
std::optional<std::int64_t> evaluate_whole(const syntax::Expression& expression,
                                           std::string_view what, Scope& scope,
                                           Diagnostics& diagnostics);

/// NAME_3_4 of NAME[i, j]; nothing after P23, P24 or another code.
std::optional<std::string> plain_name(const syntax::Name& name, Scope& scope,
                                      Diagnostics& diagnostics);

/// "a length"; "a text"; "a condition".
std::string kind_text(const Value& value);

/// A number as it stands in a text: 3, 2.5.
std::string number_text(double value);

}  // namespace rubicon::interpreter::expansion
