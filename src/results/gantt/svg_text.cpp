#include "src/results/gantt/svg_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "interpreter/syntax/utf8_character.hpp"

namespace rubicon::gantt {

namespace {

constexpr std::string_view kReplacement = "\uFFFD";
constexpr std::string_view kEllipsis = "\u2026";

/// A character of a text: its code point (U+FFFD if it is none that XML allows) and its bytes.
struct Character {
  char32_t code = 0xFFFD;
  std::string_view bytes;
};

bool is_allowed(char32_t code) {
  if (code < 0x20) return code == '\t' || code == '\n' || code == '\r';
  if (code >= 0x7F && code <= 0x9F) return false;
  const bool none = (code & 0xFFFE) == 0xFFFE || (code >= 0xFDD0 && code <= 0xFDEF);
  const bool turning = code == 0x200E || code == 0x200F || code == 0x061C ||
                       (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
  return !none && !turning;
}

/// The character at the begin of a text that is not empty.
Character first_of(std::string_view text) {
  const auto [code, length] = interpreter::utf8_character(text);
  return {length > 0 && is_allowed(code) ? code : 0xFFFD,
          text.substr(0, std::max<std::size_t>(length, 1))};
}

template <typename Take>
void each_character(std::string_view text, const Take& take) {
  while (!text.empty()) {
    const Character character = first_of(text);
    if (!take(character)) return;
    text.remove_prefix(character.bytes.size());
  }
}

/// Width of a character, in sizes of the font; of the widest usual fonts.
double width_of(char32_t code) {
  constexpr std::string_view kNarrow = "iljtfrI.,:;'|!()[] ";
  if (code < 0x80) {
    const char c = static_cast<char>(code);
    if (kNarrow.find(c) != std::string_view::npos) return 0.36;
    if (c == 'm' || c == 'w' || c == 'M' || c == 'W' || c == '@' || c == '%') return 0.92;
    return (c >= 'A' && c <= 'Z') ? 0.72 : 0.6;
  }
  return code < 0x1100 ? 0.72 : 1.05;
}

}  // namespace

std::string xml_text(std::string_view text) {
  std::string result;
  each_character(text, [&](const Character& character) {
    switch (character.code) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      case '\r':
        result += ' ';
        break;
      case 0xFFFD:
        result += kReplacement;
        break;
      default:
        result += character.bytes;
    }
    return true;
  });
  return result;
}

double text_width(std::string_view text, double size) {
  double width = 0;
  each_character(text, [&](const Character& character) {
    width += width_of(character.code);
    return true;
  });
  return width * size;
}

std::string clipped(std::string_view text, double width, double size) {
  constexpr std::size_t kLeastShown = 3;  // fewer characters of a longer text tell nothing
  const double room = width - width_of(0x2026) * size;
  std::string result;
  std::size_t shown = 0;
  std::size_t fitting = 0;  // bytes of `result` that leave room for the ellipsis
  double used = 0;
  bool whole = true;
  each_character(text, [&](const Character& character) {
    used += width_of(character.code) * size;
    whole = used <= width;
    if (!whole) return false;
    const bool blank = character.code == '\n' || character.code == '\t' || character.code == '\r';
    result += blank ? std::string_view(" ") : character.bytes;
    if (used <= room) {
      fitting = result.size();
      ++shown;
    }
    return true;
  });
  if (whole) return result;
  if (shown < kLeastShown) return {};
  return result.substr(0, fitting).append(kEllipsis);
}

std::vector<std::string> wrapped(std::string_view text, double width, double size,
                                 std::size_t most) {
  std::vector<std::string> lines;
  while (!text.empty() && lines.size() + 1 < most && text_width(text, size) > width) {
    double used = 0;
    std::size_t end = 0;
    std::size_t blank = 0;
    each_character(text, [&](const Character& character) {
      used += width_of(character.code) * size;
      if (used > width) return false;
      if (character.code == ' ' || character.code == '\n') blank = end;
      end += character.bytes.size();
      return true;
    });
    const bool at_blank = blank > end / 2;
    lines.push_back(clipped(text.substr(0, at_blank ? blank : end), width * 2, size));
    text.remove_prefix(std::max<std::size_t>(at_blank ? blank + 1 : end, 1));
  }
  if (!text.empty()) lines.push_back(clipped(text, width, size));
  return lines;
}

std::string length_text(double length) {
  std::string text = fmt::format("{:.2f}", length);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace rubicon::gantt
