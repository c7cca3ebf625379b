#pragma once

#include <string_view>

namespace rubicon::interpreter {

/// One token of a script, robot or plan, as messages, recovery and the formatter see it.
struct Token {
  enum class Kind { end, name, number, string, symbol, comment, invalid };
  Kind kind = Kind::end;
  const char* begin = nullptr;
  const char* end = nullptr;
  bool first_on_line = false;  ///< nothing but space and comments before it on its line
  int blank_lines = 0;         ///< empty lines before it

  std::string_view text() const { return {begin, static_cast<std::size_t>(end - begin)}; }
  bool is(std::string_view wanted) const { return text() == wanted; }
  bool is_symbol(char wanted) const {
    return kind == Kind::symbol && end - begin == 1 && *begin == wanted;
  }
};

enum class Comments { skip, keep };

/// The next token at or behind `at`. A number does not include its unit. Kind::invalid is one code
/// point (or one byte that is not UTF-8) that starts no token.
Token next_token(const char* at, const char* end, Comments comments = Comments::skip);

/// A reserved word of the language (LANGUAGE section 2).
bool is_reserved(std::string_view word);
/// Whether the word, at the start of a statement, can only be a command or structure.
bool starts_command(std::string_view word);

/// Length of the UTF-8 code point at `at`; 0 if there is none (overlong forms, surrogates, cut
/// off).
std::size_t utf8_length(const char* at, const char* end);

}  // namespace rubicon::interpreter
