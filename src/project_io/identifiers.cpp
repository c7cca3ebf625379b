#include "src/project_io/identifiers.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>

#include "interpreter/token.hpp"

namespace rubicon::project_io {

namespace {

constexpr std::size_t kMaxLength = 48;

/// Plain letters for U+00C0 to U+017F (Latin-1 and Latin Extended-A); '_' where there is none.
constexpr std::string_view kPlainLetters =
    "aaaaaaaceeeeiiiidnooooo_ouuuuytsaaaaaaaceeeeiiiidnooooo_ouuuuyty"   // from U+00C0
    "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkklllllll"   // from U+0100
    "lllnnnnnnnnnoooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";  // from U+0140
static_assert(kPlainLetters.size() == 192);

std::uint32_t code_point(const char* at, std::size_t length) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(at[i]); };
  if (length == 1) return byte(0);
  if (length == 2) return (byte(0) & 0x1fu) << 6 | (byte(1) & 0x3fu);
  return 0;
}

char plain(std::uint32_t code) {
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
  const char* const end = name.data() + name.size();
  for (const char* at = name.data(); at != end && result.size() < kMaxLength;) {
    const std::size_t length = interpreter::utf8_length(at, end);
    const char c = length == 0 ? '_' : plain(code_point(at, length));
    at += length == 0 ? 1 : length;
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
