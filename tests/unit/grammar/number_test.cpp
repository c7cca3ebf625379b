#include <gtest/gtest.h>

#include <numbers>

#include "tests/unit/grammar/parse_support.hpp"

namespace rubicon {
namespace {

using grammar_test::ParsedScript;
using syntax::Expression;
using syntax::Number;
using syntax::UnitKind;

Number literal(const std::string& text) {
  const ParsedScript parsed("var(a) = " + text + ";");
  EXPECT_FALSE(parsed.diagnostics.has_errors()) << text;
  if (parsed.script.statements.empty() || !parsed.script.statements[0].value) return {};
  EXPECT_EQ(parsed.script.statements[0].value->kind, Expression::Kind::number) << text;
  return parsed.script.statements[0].value->number;
}

TEST(Number, BareForms) {
  EXPECT_EQ(literal("30").value, 30);
  EXPECT_EQ(literal("2.5").value, 2.5);
  EXPECT_EQ(literal(".5").value, 0.5);
  EXPECT_EQ(literal("1e-3").value, 1e-3);
  EXPECT_EQ(literal("30").unit, UnitKind::none);
}

TEST(Number, UnitsAreConvertedToBaseUnits) {
  const struct {
    const char* text;
    double value;
    UnitKind kind;
  } cases[] = {{"3 mm", 0.003, UnitKind::length},
               {"3mm", 0.003, UnitKind::length},
               {"7 cm", 0.07, UnitKind::length},
               {"3 m", 3, UnitKind::length},
               {"90 deg", 90, UnitKind::angle},
               {"2 rad", 2 * (180 / std::numbers::pi), UnitKind::angle},
               {"4 min", 240, UnitKind::time},
               {"2 h", 7200, UnitKind::time},
               {"5 s", 5, UnitKind::time},
               {"4.1 t", 4100, UnitKind::mass},
               {"4 kg", 4, UnitKind::mass},
               {"2400 kg/m3", 2400, UnitKind::density},
               {"2.4 t/m3", 2400, UnitKind::density},
               {"2.4 t/m³", 2400, UnitKind::density},
               {"6 m/s", 6, UnitKind::speed},
               {"6m/s", 6, UnitKind::speed},
               {"500 mm/s", 0.5, UnitKind::speed},
               {"3 deg/s", 3, UnitKind::turn_rate},
               {"2 rpm", 12, UnitKind::turn_rate},
               {"36 km/h", 10, UnitKind::speed},
               {"1 rad/s", 57.29577951308232, UnitKind::turn_rate},
               {"0.3 m/s2", 0.3, UnitKind::acceleration},
               {"0.3 m/s²", 0.3, UnitKind::acceleration},
               {"250mm/s2", 0.25, UnitKind::acceleration},
               {"1.5 deg/s2", 1.5, UnitKind::turn_acceleration},
               {"1 rad/s2", 57.29577951308232, UnitKind::turn_acceleration},
               {"180 per h", 0.05, UnitKind::per_hour}};
  for (const auto& expected : cases) {
    const Number number = literal(expected.text);
    EXPECT_DOUBLE_EQ(number.value, expected.value) << expected.text;
    EXPECT_EQ(number.unit, expected.kind) << expected.text;
  }
}

TEST(Number, TheUnitIsOneLiteralWithItsNumber) {
  const ParsedScript parsed("var(a) = 6 m/s * 2;");
  const Expression& product = *parsed.script.statements[0].value;
  ASSERT_EQ(product.kind, Expression::Kind::binary);
  EXPECT_EQ(product.op, Expression::Operator::multiply);
  EXPECT_EQ(parsed.text(product.operands[0]->span), "6 m/s");
}

TEST(Number, AUnitIsAWholeWord) {
  const ParsedScript parsed("var(a) = 6 m/speed;");
  const Expression& quotient = *parsed.script.statements[0].value;
  ASSERT_EQ(quotient.kind, Expression::Kind::binary);
  EXPECT_EQ(parsed.text(quotient.operands[0]->span), "6 m");
}

TEST(Number, WordsOfTheLanguageAreNoUnits) {
  const ParsedScript parsed("chain {move_to(x, 1)} until (x > 3 and z < 4 or y > 2);");
  EXPECT_FALSE(parsed.diagnostics.has_errors());
}

TEST(Number, MistakesAreNamed) {
  using grammar_test::mistakes;
  using interpreter::TextKind;
  EXPECT_EQ(mistakes("var(a) = 3 foo;", TextKind::script),
            std::vector<std::string>{"1:12: error: unknown unit 'foo'"});
  EXPECT_EQ(mistakes("var(a) = 3 degg;", TextKind::script),
            std::vector<std::string>{"1:12: error: unknown unit 'degg'; did you mean deg?"});
  EXPECT_EQ(mistakes("var(a) = 3 tons;", TextKind::script),
            std::vector<std::string>{"1:12: error: unknown unit 'tons'; did you mean t?"});
  EXPECT_EQ(mistakes("var(a) = 3 feet;", TextKind::script),
            std::vector<std::string>{"1:12: error: unknown unit 'feet'"});
  EXPECT_EQ(mistakes("var(a) = 1e999;", TextKind::script),
            std::vector<std::string>{"1:10: error: number '1e999' is out of range"});
}

}  // namespace
}  // namespace rubicon
