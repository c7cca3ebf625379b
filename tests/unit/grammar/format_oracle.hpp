#pragma once

#include <string_view>

#include "interpreter/parse/parse.hpp"

namespace rubicon::grammar_test {

/// What must hold for any text, the empty string if it does: parsing does not throw; formatting
/// twice is formatting once; a text that parses keeps its meaning when it is formatted.
std::string check_formatting(std::string_view text, interpreter::TextKind kind);

/// The tree of a text without places, or the empty string if it has mistakes.
std::string parsed_tree(std::string_view text, interpreter::TextKind kind);

}  // namespace rubicon::grammar_test
