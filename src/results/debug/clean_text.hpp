#pragma once

#include <string>
#include <string_view>

namespace rubicon::debug {

/// Longest name or message that is shown, in bytes.
inline constexpr std::size_t kLongestName = 300;
/// Longest line of a script that is shown, in bytes.
inline constexpr std::size_t kLongestLine = 400;

/// What a terminal may safely show of `text`: control characters (a tab becomes a blank),
/// characters that turn the direction of writing and broken UTF-8 become '?'; what is longer than
/// `most` bytes ends in "...".
std::string clean_text(std::string_view text, std::size_t most = kLongestName);

}  // namespace rubicon::debug
