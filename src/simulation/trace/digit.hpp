#pragma once

namespace rubicon::trace {

/// Whatever the locale.
inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace rubicon::trace
