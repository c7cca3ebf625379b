#pragma once

#include <span>
#include <string_view>

namespace rubicon::trace {

/// The value of a control parameter (m or degrees) by its name.
struct ParameterValue {
  std::string_view name;
  double value = 0;
};
using Configuration = std::span<const ParameterValue>;

}  // namespace rubicon::trace
