#pragma once

#include <string>
#include <string_view>

namespace rubicon::film {

/// Compresses (gzip, RFC 1952), without a time and the name of a system: the same bytes on the same
/// library.
std::string gzip(std::string_view bytes);

}  // namespace rubicon::film
