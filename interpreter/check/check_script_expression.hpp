#pragma once

#include <functional>
#include <string>

#include "interpreter/syntax/syntax.hpp"

/// Looking at expressions without evaluating them. Safe for long flat sums: nothing here recurses
/// along them.
namespace rubicon::interpreter::script_check {

/// Calls `visit` for the expression and everything in it, in text order (an operator before its
/// operands).
void for_each_subexpression(const syntax::Expression& expression,
                            const std::function<void(const syntax::Expression&)>& visit);

/// Whether two names mean the same control parameter.
using SameName = std::function<bool(const syntax::QualifiedName&, const syntax::QualifiedName&)>;

/// Whether two expressions are written alike (parentheses and units aside).
bool same_expression(const syntax::Expression& a, const syntax::Expression& b,
                     const SameName& same_parameter);

/// The literal as written, but for spare digits: `2.5 mm`.
std::string number_text(const syntax::Number& number);

/// A move_to or move_dir as a user would write it, in units as written; the value is `...` where it
/// is long.
std::string command_text(const syntax::Statement& command);

}  // namespace rubicon::interpreter::script_check
