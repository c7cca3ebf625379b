#include "src/debug/clean_text.hpp"

#include <cstdint>

namespace rubicon::debug {

namespace {

struct Character {
  std::size_t length = 0;  ///< 0: no well-formed UTF-8 begins here
  std::uint32_t code = 0;
};

Character character_at(std::string_view text, std::size_t i) {
  const auto byte = static_cast<unsigned char>(text[i]);
  if (byte < 0x80) return {1, byte};
  const std::size_t length = byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : 2;
  if (byte < 0xC2 || byte > 0xF4 || i + length > text.size()) return {};
  std::uint32_t code = byte & (0xFFu >> (length + 1));
  for (std::size_t k = 1; k < length; ++k) {
    const auto next = static_cast<unsigned char>(text[i + k]);
    if ((next & 0xC0) != 0x80) return {};
    code = code << 6 | (next & 0x3Fu);
  }
  return {length, code};
}

/// C0 and C1 controls, line and paragraph separators, marks and overrides of writing direction.
bool is_unsafe(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || (code >= 0x200E && code <= 0x200F) ||
         (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

}  // namespace

std::string clean_text(std::string_view text, std::size_t most) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const Character character = character_at(text, i);
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
