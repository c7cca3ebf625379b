#include "src/exchange/urdf/arithmetic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "src/exchange/urdf/limits.hpp"
#include "src/exchange/urdf/number_text.hpp"
#include "src/motion/math/angles.hpp"

namespace rubicon::urdf {

namespace {

using std::int64_t;

bool is_text(const Value& value) { return std::holds_alternative<std::string>(value); }

double real(const Value& value) {
  if (const auto* each = std::get_if<bool>(&value)) return *each ? 1 : 0;
  if (const auto* each = std::get_if<int64_t>(&value)) return static_cast<double>(*each);
  if (const auto* each = std::get_if<double>(&value)) return *each;
  throw ExpressionError{fmt::format("expected a number, found the text '{}'",
                                    std::get<std::string>(value).substr(0, 60))};
}

std::optional<int64_t> whole(const Value& value) {
  if (const auto* each = std::get_if<bool>(&value)) return *each ? 1 : 0;
  if (const auto* each = std::get_if<int64_t>(&value)) return *each;
  return std::nullopt;
}

Value finite(double value) {
  if (!std::isfinite(value)) throw ExpressionError{"the result is not a finite number"};
  return value;
}

Value rounded_whole(double value) {
  if (!(std::fabs(value) < 9e18)) throw ExpressionError{"the result is too large"};
  return static_cast<int64_t>(value);
}

template <typename T>
bool compare(std::string_view operation, const T& left, const T& right) {
  if (operation == "==") return left == right;
  if (operation == "!=") return left != right;
  if (operation == "<") return left < right;
  if (operation == "<=") return left <= right;
  if (operation == ">") return left > right;
  return left >= right;
}

bool is_comparison(std::string_view operation) {
  return operation == "==" || operation == "!=" || operation.front() == '<' ||
         operation.front() == '>';
}

Value divided(std::string_view operation, const Value& left, const Value& right) {
  const double divisor = real(right);
  if (divisor == 0) throw ExpressionError{"division by zero"};
  if (operation == "/") return finite(real(left) / divisor);
  const double floor = std::floor(real(left) / divisor);
  const auto a = whole(left), b = whole(right);
  if (a && b && *b != -1) {
    const int64_t rest = ((*a % *b) + *b) % *b;
    return operation == "%" ? rest : (*a - rest) / *b;
  }
  if (a && b) return operation == "%" ? Value(int64_t{0}) : negative(left);
  return finite(operation == "%" ? real(left) - divisor * floor : floor);
}

/// Whole powers by multiplication and roots by sqrt, which are the same everywhere.
Value power(const Value& base, const Value& exponent) {
  constexpr double kMaxPower = 4096;
  const double e = real(exponent);
  if (e == 0.5 && real(base) >= 0) return std::sqrt(real(base));
  if (e != std::floor(e) || std::fabs(e) > kMaxPower) {
    throw ExpressionError{"only whole powers and ** 0.5 are counted here"};
  }
  Value result = int64_t{1};
  for (int i = 0; i < static_cast<int>(std::fabs(e)); ++i) result = binary("*", result, base);
  return e < 0 ? binary("/", int64_t{1}, result) : result;
}

Value sum_or_product(char operation, const Value& left, const Value& right) {
  const auto a = whole(left), b = whole(right);
  if (a && b) {
    int64_t result = 0;
    const bool too_large = operation == '+'   ? __builtin_add_overflow(*a, *b, &result)
                           : operation == '-' ? __builtin_sub_overflow(*a, *b, &result)
                                              : __builtin_mul_overflow(*a, *b, &result);
    if (!too_large) return result;
  }
  const double x = real(left), y = real(right);
  return finite(operation == '+' ? x + y : operation == '-' ? x - y : x * y);
}

struct Function {
  std::string_view name;
  std::size_t fewest;
  std::size_t most;
};
constexpr std::size_t kAny = 1000;
constexpr std::array<Function, 27> kFunctions = {
    {{"radians", 1, 1}, {"degrees", 1, 1}, {"sin", 1, 1},    {"cos", 1, 1},   {"tan", 1, 1},
     {"asin", 1, 1},    {"acos", 1, 1},    {"atan", 1, 1},   {"atan2", 2, 2}, {"sqrt", 1, 1},
     {"pow", 2, 2},     {"hypot", 2, 2},   {"abs", 1, 1},    {"fabs", 1, 1},  {"floor", 1, 1},
     {"ceil", 1, 1},    {"min", 1, kAny},  {"max", 1, kAny}, {"round", 1, 2}, {"int", 1, 1},
     {"float", 1, 1},   {"str", 1, 1},     {"bool", 1, 1},   {"len", 1, 1},   {"trunc", 1, 1},
     {"fmod", 2, 2},    {"copysign", 2, 2}}};

const Function* find_function(std::string_view name) {
  const auto* found = std::find_if(kFunctions.begin(), kFunctions.end(),
                                   [&](const Function& each) { return each.name == name; });
  return found == kFunctions.end() ? nullptr : found;
}

double inverse_sine_deg(double value) {
  if (!(std::fabs(value) <= 1)) throw ExpressionError{"asin and acos take numbers from -1 to 1"};
  return math::atan2_deg(value, std::sqrt((1 - value) * (1 + value)));
}

/// Of one number.
Value function_of(std::string_view name, const Value& argument) {
  const double x = real(argument);
  if (name == "radians") return finite(math::radians(x));
  if (name == "degrees") return finite(math::degrees(x));
  const auto sine = [&] { return math::sin_deg(math::degrees(x)); };
  const auto cosine = [&] { return math::cos_deg(math::degrees(x)); };
  if (name == "sin") return finite(sine());
  if (name == "cos") return finite(cosine());
  if (name == "tan") return finite(sine() / cosine());
  if (name == "asin") return math::radians(inverse_sine_deg(x));
  if (name == "acos") return math::radians(90 - inverse_sine_deg(x));
  if (name == "atan") return math::radians(math::atan2_deg(x, 1));
  if (name == "sqrt") return finite(std::sqrt(x));
  if (name == "fabs") return std::fabs(x);
  if (name == "abs") return x < 0 ? negative(argument) : argument;
  if (name == "floor") return rounded_whole(std::floor(x));
  if (name == "ceil") return rounded_whole(std::ceil(x));
  return rounded_whole(std::trunc(x));  // int, trunc
}

Value rounded(const std::vector<Value>& arguments) {
  const double x = real(arguments[0]);
  if (arguments.size() == 1) return rounded_whole(std::nearbyint(x));
  const auto digits = whole(arguments[1]);
  if (!digits || *digits < 0 || *digits > 15) {
    throw ExpressionError{"round takes 0 to 15 digits"};
  }
  return finite(*number_of(fmt::format("{:.{}f}", x, *digits)));
}

Value of_text(std::string_view name, const std::string& text) {
  if (name == "len") return static_cast<int64_t>(text.size());
  Value value = literal_value(text);
  if (is_text(value)) {
    throw ExpressionError{
        fmt::format("expected a number, found the text '{}'", text.substr(0, 60))};
  }
  return value;
}

}  // namespace

std::string text_of(const Value& value) {
  if (const auto* each = std::get_if<bool>(&value)) return *each ? "True" : "False";
  if (const auto* each = std::get_if<int64_t>(&value)) return fmt::format("{}", *each);
  if (const auto* each = std::get_if<double>(&value)) {
    std::string text = fmt::format("{}", *each);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
  }
  return std::get<std::string>(value);
}

Value literal_value(const std::string& text) {
  if (text.size() >= 2 && text.front() == '\'' && text.back() == '\'') {
    return text.substr(1, text.size() - 2);
  }
  int64_t integer = 0;
  const char* end = text.data() + text.size();
  const char* begin = text.data() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0);
  const auto [stop, error] = std::from_chars(begin, end, integer);
  if (error == std::errc{} && stop == end && begin != end) return integer;
  if (const std::optional<double> number = number_of(text)) return *number;
  if (text == "true" || text == "True") return true;
  if (text == "false" || text == "False") return false;
  return text;
}

bool truth(const Value& value) {
  if (!is_text(value)) return real(value) != 0;
  const Value literal = literal_value(std::get<std::string>(value));
  if (!is_text(literal)) return real(literal) != 0;
  throw ExpressionError{fmt::format("expected true, false or a number, found '{}'",
                                    std::get<std::string>(value).substr(0, 60))};
}

Value negative(const Value& value) { return sum_or_product('-', int64_t{0}, value); }

Value binary(std::string_view operation, const Value& left, const Value& right) {
  if (is_comparison(operation)) {
    if (is_text(left) && is_text(right)) {
      return compare(operation, std::get<std::string>(left), std::get<std::string>(right));
    }
    if (is_text(left) || is_text(right)) {
      if (operation == "==") return false;
      if (operation == "!=") return true;
    }
    return compare(operation, real(left), real(right));
  }
  if (operation == "+" && is_text(left) && is_text(right)) {
    const std::string& a = std::get<std::string>(left);
    const std::string& b = std::get<std::string>(right);
    if (a.size() + b.size() > kMaxTextBytes) throw ExpressionError{"the text becomes too long"};
    return a + b;
  }
  if (operation == "**") return power(left, right);
  if (operation == "/" || operation == "//" || operation == "%") {
    return divided(operation, left, right);
  }
  return sum_or_product(operation.front(), left, right);
}

bool is_function(std::string_view name) { return find_function(name) != nullptr; }

Value call(std::string_view name, const std::vector<Value>& arguments) {
  const Function* function = find_function(name);
  if (arguments.size() < function->fewest || arguments.size() > function->most) {
    throw ExpressionError{fmt::format("{} does not take {} arguments", name, arguments.size())};
  }
  const Value& first = arguments.front();
  if (name == "str") return text_of(first);
  if (name == "bool") return truth(first);
  if (name == "round") return rounded(arguments);
  if (name == "float") {
    return real(is_text(first) ? of_text(name, std::get<std::string>(first)) : first);
  }
  if ((name == "len" || name == "int") && is_text(first)) {
    const Value value = of_text(name, std::get<std::string>(first));
    return name == "len" ? value : function_of(name, value);
  }
  if (name == "len") throw ExpressionError{"len takes a text"};
  if (name == "min" || name == "max") {
    Value best = first;
    for (const Value& each : arguments) {
      const bool better = name == "min" ? real(each) < real(best) : real(each) > real(best);
      if (better) best = each;
    }
    real(best);
    return best;
  }
  if (arguments.size() == 1) return function_of(name, first);
  const double x = real(first), y = real(arguments[1]);
  if (name == "atan2") return math::radians(math::atan2_deg(x, y));
  if (name == "hypot") return finite(std::sqrt(x * x + y * y));
  if (name == "copysign") return std::copysign(std::fabs(x), y);
  if (name == "fmod") return y == 0 ? finite(std::nan("")) : finite(std::fmod(x, y));
  return power(Value(x), arguments[1]);  // pow
}

}  // namespace rubicon::urdf
