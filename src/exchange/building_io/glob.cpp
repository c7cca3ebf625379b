#include "src/exchange/building_io/glob.hpp"

#include <algorithm>
#include <cstddef>

#include "interpreter/syntax/token.hpp"

namespace rubicon::building_io {

namespace {

char small(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Bytes of the first character; 1 where it is no UTF-8.
std::size_t character(std::string_view text) {
  return std::max<std::size_t>(interpreter::utf8_length(text.data(), text.data() + text.size()), 1);
}

}  // namespace

bool matches_glob(std::string_view pattern, std::string_view text) {
  // Behind the last *, and the text it was tried with: one step back is enough.
  std::string_view after_star;
  std::string_view tried;
  bool star = false;
  while (!text.empty()) {
    if (!pattern.empty() && pattern.front() == '*') {
      pattern.remove_prefix(1);
      after_star = pattern;
      tried = text;
      star = true;
    } else if (!pattern.empty() && pattern.front() == '?') {
      pattern.remove_prefix(1);
      text.remove_prefix(character(text));
    } else if (!pattern.empty() && small(pattern.front()) == small(text.front())) {
      pattern.remove_prefix(1);
      text.remove_prefix(1);
    } else if (star) {
      tried.remove_prefix(character(tried));
      pattern = after_star;
      text = tried;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*') == std::string_view::npos;
}

}  // namespace rubicon::building_io
