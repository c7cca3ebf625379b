#pragma once

#include <string_view>

namespace rubicon::building_io {

/// Whether `text` is what `pattern` means: * stands for anything, ? for one character; capital and
/// small letters (of ASCII) are the same. Takes time in proportion to the product of the lengths.
bool matches_glob(std::string_view pattern, std::string_view text);

}  // namespace rubicon::building_io
