#include "interpreter/syntax/attribute_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "interpreter/syntax/utf8_character.hpp"

namespace rubicon::interpreter {

namespace {

/// Longest text of an attribute, in characters: it is a name or a value, not a document.
constexpr std::size_t kMaxCharacters = 1000;

/// Of XML, as in import blocks.
constexpr std::array<std::pair<std::string_view, char>, 3> kWords = {
    {{"&quot;", '"'}, {"&amp;", '&'}, {"&lbrace;", '{'}}};

const std::pair<std::string_view, char>* word_at(std::string_view text) {
  for (const auto& word : kWords) {
    if (text.starts_with(word.first)) return &word;
  }
  return nullptr;
}

/// U+0000 to U+001F, U+007F to U+009F, and the two that end a line.
bool is_control(char32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x2028 || code == 0x2029;
}

/// The two that XML does not allow, so that no exported schedule could hold them.
bool is_no_character(char32_t code) { return code == 0xfffe || code == 0xffff; }

bool is_blank(std::string_view text) {
  return text.find_first_not_of(' ') == std::string_view::npos;
}

}  // namespace

std::string plain_attribute(std::string_view written) {
  std::string text;
  while (!written.empty()) {
    const auto* word = word_at(written);
    text += word != nullptr ? word->second : written.front();
    written.remove_prefix(word != nullptr ? word->first.size() : 1);
  }
  return text;
}

std::string written_attribute(std::string_view text) {
  std::string written;
  for (std::size_t count = 0; !text.empty() && count < kMaxCharacters; ++count) {
    const Utf8Character next = utf8_character(text);
    const std::size_t length = std::max<std::size_t>(next.length, 1);
    if (next.length == 0 || is_control(next.code) || is_no_character(next.code)) {
      written += ' ';
    } else if (text.front() == '"') {
      written += "&quot;";
    } else if (text.front() == '{') {
      written += "&lbrace;";
    } else if (word_at(text) != nullptr) {
      written += "&amp;";
    } else {
      written += text.substr(0, length);
    }
    text.remove_prefix(length);
  }
  return is_blank(written) ? std::string() : written;
}

std::string attribute_mistake(std::string_view text) {
  if (is_blank(text)) return "is empty";
  std::size_t count = 0;
  for (; !text.empty(); ++count) {
    const Utf8Character next = utf8_character(text);
    if (is_control(next.code)) {
      return fmt::format("has the control character U+{:04X}", static_cast<unsigned>(next.code));
    }
    if (is_no_character(next.code)) {
      return fmt::format("has U+{:04X}, which is no character", static_cast<unsigned>(next.code));
    }
    text.remove_prefix(std::max<std::size_t>(next.length, 1));
  }
  if (count > kMaxCharacters) {
    return fmt::format("has {} characters; expected at most {}", count, kMaxCharacters);
  }
  return {};
}

}  // namespace rubicon::interpreter
