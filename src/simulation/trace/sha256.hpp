#pragma once

#include <string>
#include <string_view>

namespace rubicon::trace {

/// SHA-256 of the bytes (FIPS 180-4) as 64 lower-case hexadecimal digits: tells readers of a trace
/// whether a file on disk is the one that ran.
std::string sha256_hex(std::string_view bytes);

}  // namespace rubicon::trace
