#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "src/exchange/urdf/arithmetic.hpp"

namespace rubicon::urdf {

/// What the name of a property stands for; nothing if it is unknown.
using NameLookup = std::function<std::optional<Value>(const std::string& name)>;

/// The value of what stands in `${...}`: numbers, texts, names, the operators of Python, its
/// functions of numbers. `steps` counts down; throws ExpressionError when it is used up, too, and
/// names what it does not know (lists, indexes, methods).
Value evaluate(std::string_view expression, const NameLookup& lookup, std::size_t& steps);

}  // namespace rubicon::urdf
