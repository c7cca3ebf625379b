#include "src/results/debug/clean_text.hpp"

#include "interpreter/syntax/utf8_character.hpp"

namespace rubicon::debug {

namespace {

/// C0 and C1 controls, line and paragraph separators, marks and overrides of writing direction.
bool is_unsafe(char32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || (code >= 0x200E && code <= 0x200F) ||
         (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

}  // namespace

std::string clean_text(std::string_view text, std::size_t most) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const interpreter::Utf8Character character = interpreter::utf8_character(text.substr(i));
    const std::size_t length = character.length == 0 ? 1 : character.length;
    if (result.size() + length > most) return result + "...";
    if (text[i] == '\t') {
      result += ' ';
    } else if (character.length == 0 || is_unsafe(character.code)) {
      result += '?';
    } else {
      result.append(text.substr(i, length));
    }
    i += length;
  }
  return result;
}

}  // namespace rubicon::debug
