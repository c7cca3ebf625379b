#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <string_view>

namespace rubicon::debug {

using TextId = std::uint32_t;
/// No text, no place, no row.
inline constexpr std::uint32_t kNone = 0xFFFFFFFF;

/// Texts by number: each is kept once, fit to be shown (clean_text).
class StringTable {
 public:
  TextId add(std::string_view text);
  /// kNone if it was never added.
  TextId find(std::string_view text) const;
  /// "" for kNone.
  const std::string& operator[](TextId id) const;

 private:
  std::map<std::string, TextId, std::less<>> ids_;
  std::deque<std::string> texts_;
};

}  // namespace rubicon::debug
