#pragma once

namespace rubicon::ifc {

/// The characters of a STEP file, whatever the locale.
inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f';
}
inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace rubicon::ifc
