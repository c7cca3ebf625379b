#pragma once

#include <string>
#include <string_view>

namespace rubicon::project_io {

struct DecodedText {
  std::string text;      ///< UTF-8, no byte order mark
  bool guessed = false;  ///< it was neither UTF-8 nor UTF-16 and was read as Windows-1252
};

/// The text of a schedule file. Project writes UTF-8, sometimes UTF-16 with a byte order mark;
/// Primavera writes the code page of its machine, for western languages Windows-1252.
DecodedText decode_text(std::string_view bytes);

/// The text with everything that is not UTF-8, and every zero byte, replaced by U+FFFD, and with
/// line breaks as XML has them: a carriage return, alone or before a line feed, is a line feed.
std::string clean_text(std::string_view text);

}  // namespace rubicon::project_io
