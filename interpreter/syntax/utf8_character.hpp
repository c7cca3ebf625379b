#pragma once

#include <cstddef>
#include <string_view>

namespace rubicon::interpreter {

/// A code point and how many bytes of UTF-8 it takes.
struct Utf8Character {
  char32_t code = 0;
  std::size_t length = 0;  ///< 0: no code point begins here (overlong forms, surrogates, cut off)
};

/// The code point at the begin of a text (The Unicode Standard, table 3-7).
Utf8Character utf8_character(std::string_view text);

/// Where the first byte is that is not UTF-8; npos: all is.
std::size_t first_not_utf8(std::string_view text);

}  // namespace rubicon::interpreter
