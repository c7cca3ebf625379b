#pragma once

#include <cstddef>

namespace rubicon::math {

/// A place that is counted as an int, -1 for none, as containers want it.
constexpr std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace rubicon::math
