#pragma once

#include <string>

#include "interpreter/syntax/syntax.hpp"

namespace rubicon::interpreter {

/// How an operator is written: "+", "<=", "and".
const char* symbol_of(syntax::Expression::Operator op);

/// The text of an expression in one canonical form: one space round operators, every binary
/// operation in parentheses, numbers in base units and shortest digits. For messages and traces.
std::string unparse(const syntax::Expression& expression);

/// The same for a command: `move_to(z, max(z, (var(height) + goal(z))))`, `together { ... }`,
/// `wait`.
std::string unparse(const syntax::Statement& command);

}  // namespace rubicon::interpreter
