#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "interpreter/parse/parse.hpp"
#include "interpreter/syntax/token.hpp"

namespace rubicon::interpreter {

/// A token as the formatter prints it.
struct FormatToken {
  Token::Kind kind = Token::Kind::end;
  std::string text;            ///< a number with its unit, one blank between
  bool first_on_line = false;  ///< in the text as it was
  int blank_lines = 0;         ///< before it
  bool space_before = false;   ///< a blank parts it from the token before, where they share a line
  bool multi_line = false;     ///< a comment across lines

  bool is(std::string_view wanted) const {
    return kind != Token::Kind::comment && kind != Token::Kind::string && text == wanted;
  }
  bool is_comment() const { return kind == Token::Kind::comment; }
  bool ends_line() const { return is_comment() && text[1] != '*'; }
};

/// The tokens and comments of a text that parses, with the blanks between them decided.
std::vector<FormatToken> format_tokens(std::string_view text, TextKind kind);

}  // namespace rubicon::interpreter
