#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "src/exchange/urdf/limits.hpp"

namespace rubicon::urdf {

/// A value of xacro: what its expressions, which are Python, count with.
using Value = std::variant<bool, std::int64_t, double, std::string>;

/// Why an expression has no value; becomes a Fault where the place is known.
struct ExpressionError {
  std::string message;
};

/// Counts how deep a text is in itself while it lives: in parentheses, or by properties in each
/// other. Throws ExpressionError beyond kMaxExpressionDepth.
class Deeper {
 public:
  explicit Deeper(int& depth) : depth_(depth) {
    if (++depth_ > kMaxExpressionDepth) throw ExpressionError{"it is nested too deep"};
  }
  ~Deeper() { --depth_; }
  Deeper(const Deeper&) = delete;
  Deeper& operator=(const Deeper&) = delete;

 private:
  int& depth_;
};

/// As Python writes it: 2, 2.0, True.
std::string text_of(const Value& value);

/// A text that reads as a number or a truth value is one, as in xacro.
Value literal_value(const std::string& text);

/// As Python's bool(); for texts xacro's rule: true, false or a whole number. Throws.
bool truth(const Value& value);

/// `+ - * / // % **` and comparisons (`< <= > >= == !=`). Throws.
Value binary(std::string_view operation, const Value& left, const Value& right);
Value negative(const Value& value);

/// A function or constant of Python's math, or a built-in such as min. Throws.
bool is_function(std::string_view name);
Value call(std::string_view name, const std::vector<Value>& arguments);

}  // namespace rubicon::urdf
