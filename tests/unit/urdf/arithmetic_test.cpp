#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/exchange/urdf/expression.hpp"

namespace rubicon::urdf {
namespace {

/// The value as Python prints it, or "! MESSAGE".
std::string value_of(const std::string& expression) {
  std::size_t steps = 10'000;
  try {
    return text_of(evaluate(
        expression,
        [](const std::string& name) -> std::optional<Value> {
          if (name == "width") return 2.5;
          if (name == "count") return std::int64_t{4};
          if (name == "side") return std::string("left");
          return std::nullopt;
        },
        steps));
  } catch (const ExpressionError& error) {
    return "! " + error.message;
  }
}

struct Case {
  const char* expression;
  const char* value;  ///< as CPython 3 prints it
};

TEST(Arithmetic, CountsAsPythonDoes) {
  constexpr Case kCases[] = {
      {"1 + 2 * 3", "7"},
      {"7 / 2", "3.5"},
      {"6 / 2", "3.0"},
      {"7 // 2", "3"},
      {"-7 // 2", "-4"},
      {"-7 % 3", "2"},
      {"7 % -3", "-2"},
      {"7.5 % 2", "1.5"},
      {"2 ** 3 ** 2", "512"},
      {"-2 ** 2", "-4"},
      {"2 ** -1", "0.5"},
      {"9 ** 0.5", "3.0"},
      {"1e-3 + .5", "0.501"},
      {"(1 + 2) * -(3 - 1)", "-6"},
      {"width / 2", "1.25"},
      {"-count", "-4"},
      {"1 < 2 <= 2", "True"},
      {"1 == 1.0", "True"},
      {"'a' == 'b'", "False"},
      {"side == 'left'", "True"},
      {"side == 4", "False"},
      {"not side", "False"},
      {"1 if count > 3 else 2", "1"},
      {"1 / 0 if count < 3 else 2", "2"},
      {"1 if count < 3 else 2 if count == 4 else 3", "2"},
      {"count == 4 or 1 / 0", "True"},
      {"count == 3 and 1 / 0", "False"},
      {"0 or 5", "5"},
      {"side + '_wheel'", "left_wheel"},
      {"radians(180) == pi", "True"},
      {"math.pi / 2", "1.5707963267948966"},
      {"degrees(pi)", "180.0"},
      {"round(sin(pi / 6), 12)", "0.5"},
      {"round(cos(radians(60)), 12)", "0.5"},
      {"round(degrees(acos(0.5)), 9)", "60.0"},
      {"round(degrees(asin(-1)), 9)", "-90.0"},
      {"round(degrees(atan2(1, -1)), 9)", "135.0"},
      {"sqrt(16)", "4.0"},
      {"abs(-3)", "3"},
      {"max(1, 2.5, 2)", "2.5"},
      {"min(1, 2.5)", "1"},
      {"floor(2.7)", "2"},
      {"ceil(2.1)", "3"},
      {"int('12') + 1", "13"},
      {"int(-2.7)", "-2"},
      {"float('1.5')", "1.5"},
      {"str(2) + 'x'", "2x"},
      {"len(side)", "4"},
      {"9223372036854775807 + 1", "9.223372036854776e+18"},
      {"True and False", "False"},
  };
  for (const Case& each : kCases)
    EXPECT_EQ(value_of(each.expression), each.value) << each.expression;
}

TEST(Arithmetic, SaysWhatItDoesNotKnow) {
  constexpr Case kCases[] = {
      {"1 +", "! it ends where a value is expected"},
      {"(1", "! expected ')' before its end"},
      {"1 2", "! '2' is not expected there"},
      {"[1, 2]", "! lists, tables and indexes are not read here"},
      {"side[0]", "! lists, tables, indexes and methods are not read here"},
      {"limits.lower", "! 'limits.lower': lists, tables, indexes and methods are not read here"},
      {"xacro.load_yaml('a')", "! the function 'xacro.load_yaml' is not known here"},
      {"__import__('os')", "! the function '__import__' is not known here"},
      {"height", "! the property 'height' is not known"},
      {"'a' * 3", "! expected a number, found the text 'a'"},
      {"1 / 0", "! division by zero"},
      {"5 % 0", "! division by zero"},
      {"1e308 * 10", "! the result is not a finite number"},
      {"sqrt(-1)", "! the result is not a finite number"},
      {"acos(2)", "! asin and acos take numbers from -1 to 1"},
      {"2 ** 0.3", "! only whole powers and ** 0.5 are counted here"},
      {"sin(1, 2)", "! sin does not take 2 arguments"},
      {"'abc", "! a text in it has no end"},
      {"1.2.3", "! '1.2.3' is not a number"},
      {"1 if 2", "! expected 'else' before its end"},
  };
  for (const Case& each : kCases)
    EXPECT_EQ(value_of(each.expression), each.value) << each.expression;
}

TEST(Arithmetic, DepthAndStepsAreCounted) {
  EXPECT_EQ(value_of(std::string(100, '(') + "1" + std::string(100, ')')),
            "! it is nested too deep");
  EXPECT_EQ(value_of(std::string(20, '(') + "1" + std::string(20, ')')), "1");
  std::string chain = "1";
  for (int i = 0; i < 200; ++i) chain += " if 0 else 1";
  EXPECT_EQ(value_of(chain), "! it is nested too deep");
  std::string sum = "1";
  for (int i = 0; i < 20'000; ++i) sum += "+1";
  EXPECT_EQ(value_of(sum), "! the expressions of this file take too many steps");
  std::string power = "2";
  for (int i = 0; i < 200; ++i) power += "**1";
  EXPECT_EQ(value_of(power), "! it is nested too deep");
}

}  // namespace
}  // namespace rubicon::urdf
