#include "src/exchange/project_io/identifiers.hpp"

#include <fmt/format.h>

#include <array>

#include "interpreter/syntax/token.hpp"
#include "interpreter/syntax/utf8_character.hpp"

namespace rubicon::project_io {

namespace {

constexpr std::size_t kMaxLength = 48;

/// Plain letters for U+00C0 to U+017F (Latin-1 and Latin Extended-A); '_' where there is none.
constexpr std::string_view kPlainLetters =
    "aaaaaaaceeeeiiiidnooooo_ouuuuytsaaaaaaaceeeeiiiidnooooo_ouuuuyty"   // from U+00C0
    "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkklllllll"   // from U+0100
    "lllnnnnnnnnnoooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";  // from U+0140
static_assert(kPlainLetters.size() == 192);

char plain(char32_t code) {
  if ((code >= 'a' && code <= 'z') || (code >= '0' && code <= '9')) return static_cast<char>(code);
  if (code >= 'A' && code <= 'Z') return static_cast<char>(code - 'A' + 'a');
  if (code >= 0xc0 && code < 0x180) return kPlainLetters[code - 0xc0];
  return '_';
}

/// Words that mean something where a name may stand.
bool is_special(std::string_view word) {
  constexpr std::array<std::string_view, 9> kWords = {"at",  "by",  "as",         "after", "to",
                                                      "per", "off", "carry_over", "task"};
  for (const std::string_view each : kWords) {
    if (word == each) return true;
  }
  return interpreter::is_reserved(word);
}

std::string identifier(std::string_view name) {
  std::string result;
  while (!name.empty() && result.size() < kMaxLength) {
    const auto [code, length] = interpreter::utf8_character(name);
    const char c = length == 0 ? '_' : plain(code);
    name.remove_prefix(length == 0 ? 1 : length);
    if (c != '_' || (!result.empty() && result.back() != '_')) result += c;
  }
  while (!result.empty() && result.back() == '_') result.pop_back();
  return result;
}

}  // namespace

std::string Identifiers::make(std::string_view name, const std::string& fallback,
                              const std::string& prefix) {
  std::string result = identifier(name);
  if (result.empty()) result = fallback;
  if (result.front() >= '0' && result.front() <= '9') result = "_" + result;
  if (is_special(result)) result += "_";
  if (taken_.contains(result) && !prefix.empty())
    result = prefix.substr(0, kMaxLength) + "_" + result;
  const std::string stem = result;
  while (!taken_.insert(result).second) {
    int& next = next_.emplace(stem, 2).first->second;
    result = fmt::format("{}_{}", stem, next++);
  }
  return result;
}

}  // namespace rubicon::project_io
