#include "interpreter/expand/evaluate.hpp"

#include <gtest/gtest.h>

#include "interpreter/expand/parameters.hpp"
#include "interpreter/parse/parse.hpp"

namespace rubicon::test {

namespace {

using interpreter::Diagnostics;
using interpreter::SourceMap;
using interpreter::expansion::Parameter;
using interpreter::expansion::Scope;

/// The parameters of a plan, evaluated.
struct Parameters {
  explicit Parameters(const std::string& text, const interpreter::ParameterTexts& set = {}) {
    const interpreter::FileId file = sources.add("p.plan", "plan p { " + text + " }");
    const syntax::Plan plan = parse_plan(sources, file, diagnostics);
    evaluate_parameters(plan, set, scope, diagnostics, [](const auto&, const auto&) {});
  }
  /// "3.6 a length"; "?" of what is wrong.
  std::string value(const std::string& name) {
    const auto found = scope.parameters.find(name);
    if (found == scope.parameters.end() || !found->second.value) return "?";
    const auto& value = *found->second.value;
    return (value.kind == interpreter::expansion::Value::Kind::text
                ? value.text
                : interpreter::expansion::number_text(value.number)) +
           " " + interpreter::expansion::kind_text(value);
  }
  std::string said() const {
    std::string text;
    for (const auto& each : diagnostics.sorted()) text += each.code + " " + each.message + "\n";
    return text;
  }

  SourceMap sources;
  Diagnostics diagnostics;
  Scope scope;
};

std::string value_of(const std::string& expression) {
  Parameters parameters("parameter x = " + expression + ";");
  return parameters.said() + parameters.value("x");
}

TEST(Evaluate, CountsAsAPlannerDoes) {
  EXPECT_EQ(value_of("1 + 2 * 3 - 4 / 8"), "6.5 a plain number");
  EXPECT_EQ(value_of("-(1 + 2)"), "-3 a plain number");
  EXPECT_EQ(value_of("min(3, 2) + max(3, 2) + abs(-1)"), "6 a plain number");
  EXPECT_EQ(value_of("floor(7 / 2) * 10 + mod(7, 2) + mod(-1, 4)"), "34 a plain number");
  EXPECT_EQ(value_of("sin(30) + cos(60 deg)"), "1 a plain number");
}

/// Lengths over the pitches of bays: quotients that rounding leaves below whole numbers.
TEST(Evaluate, CountsBaysAsConditionsDo) {
  for (const auto& [quotient, bays] :
       std::vector<std::pair<std::string, std::string>>{{"4.8 m / 1.6 m", "3"},
                                                        {"9.6 / 1.6", "6"},
                                                        {"16.2 / 5.4", "3"},
                                                        {"11.2 / 1.6", "7"},
                                                        {"29.4 / 4.2", "7"},
                                                        {"46.8 / 3.6", "13"},
                                                        {"93.6 / 7.2", "13"}}) {
    EXPECT_EQ(value_of("floor(" + quotient + ")"), bays + " a plain number");
    EXPECT_EQ(value_of("floor(-" + quotient + ")"), "-" + bays + " a plain number");
  }
  EXPECT_EQ(value_of("floor(2.9999991)"), "3 a plain number");
  EXPECT_EQ(value_of("floor(2.999998)"), "2 a plain number");
  EXPECT_EQ(value_of("floor(-2.0000009)"), "-2 a plain number");
  EXPECT_EQ(value_of("floor(0 - 1e-7)"), "0 a plain number");
  EXPECT_EQ(value_of("floor(999999999.999)"), "999999999 a plain number");
}

TEST(Evaluate, LeavesNoRestOfRounding) {
  EXPECT_EQ(value_of("mod(4.8 m, 1.6 m)"), "0 a length");
  EXPECT_EQ(value_of("mod(0.3, 0.1)"), "0 a plain number");
  EXPECT_EQ(value_of("mod(-4.8, 1.6)"), "0 a plain number");
  EXPECT_EQ(value_of("mod(4.8, -1.6)"), "0 a plain number");
  // of a long divisor, and of a short one
  EXPECT_EQ(value_of("mod(100000.0625, 100000)"), "0.0625 a plain number");
  EXPECT_EQ(value_of("mod(1.5 / 65536, 1 / 65536) * 65536"), "0.5 a plain number");
}

TEST(Evaluate, CarriesUnits) {
  EXPECT_EQ(value_of("3600 mm"), "3.6 a length");
  EXPECT_EQ(value_of("2 m + 50 cm"), "2.5 a length");
  EXPECT_EQ(value_of("2 m + 1"), "3 a length");
  EXPECT_EQ(value_of("1 + 2 m"), "3 a length");
  EXPECT_EQ(value_of("3 * 2 m"), "6 a length");
  EXPECT_EQ(value_of("2 m * 3 m"), "6 an area");
  EXPECT_EQ(value_of("6 m2 / 2 m"), "3 a length");
  EXPECT_EQ(value_of("6 m / 2 m"), "3 a plain number");
  EXPECT_EQ(value_of("2.5 t per m3 * 2 m3"), "5000 a mass");
  EXPECT_EQ(value_of("12 m3 / 40 m3 per h"), "1080 a time");
  EXPECT_EQ(value_of("90 per h * 2 h"), "180 a plain number");
  EXPECT_EQ(value_of("3 kg per m"), "3 a value in kg per m");
  EXPECT_EQ(value_of("max(2 m, 300 cm)"), "3 a length");
}

TEST(Evaluate, SaysWhichKindsDoNotFit) {
  EXPECT_EQ(value_of("2 m + 3 s"), "F09 a length and a time cannot be added or compared\n?");
  EXPECT_EQ(value_of("max(2 m, 3 kg)"), "F09 a length and a mass cannot be added or compared\n?");
  EXPECT_EQ(value_of("2 per h + 3"),
            "F09 a plain number stands beside an hourly rate: write its unit\n?");
  EXPECT_EQ(value_of("sin(3 m)"), "F09 sin(...) needs an angle, but the value is a length\n?");
  EXPECT_EQ(value_of("1 < 2"), "F09 expected a number, found a condition\n?");
  EXPECT_EQ(value_of("1 + (1 < 2)"), "F09 expected a number, found a condition\n?");
}

TEST(Evaluate, NeverOverflowsOrDividesByZero) {
  EXPECT_EQ(value_of("1 / 0"), "F11 division by zero\n?");
  EXPECT_EQ(value_of("mod(1, 0)"), "F11 division by zero\n?");
  EXPECT_EQ(value_of("1e308 * 10"), "F11 the value is too large to be computed\n?");
  EXPECT_EQ(value_of("0 * (0 - 1e308 - 1e308)"), "F11 the value is too large to be computed\n?");
  std::string power = "1 m";
  for (int i = 0; i < 500; ++i) power += " * 1 m";
  EXPECT_EQ(value_of(power), "1 a value in m100");
}

TEST(Evaluate, RefusesWhatHasNoValue) {
  EXPECT_EQ(value_of("y"), "P23 there is no parameter 'y'\n?");
  EXPECT_EQ(value_of("goal(x)"),
            "F10 function 'goal' cannot stand here; abs, min, max, floor, mod, sin and cos can\n?");
  EXPECT_EQ(value_of("min(1)"), "F06 min takes 2 arguments, found 1\n?");
  EXPECT_EQ(value_of("var(a)"), "F10 variables belong to behaviours and cannot stand here\n?");
}

TEST(Parameters, KnowThoseAboveThem) {
  Parameters plan(
      "parameter bays = 4; parameter pitch = 3.6 m; parameter length = bays * pitch; "
      "parameter crane = \"tower\";");
  EXPECT_EQ(plan.said(), "");
  EXPECT_EQ(plan.value("length"), "14.4 a length");
  EXPECT_EQ(plan.value("crane"), "tower a text");
  Parameters wrong("parameter a = b; parameter b = 1; parameter b = 2; ");
  EXPECT_EQ(wrong.said(),
            "P23 parameter 'b' is declared further down; a parameter knows those above it\n"
            "P02 parameter 'b' is declared twice\n");
}

TEST(Parameters, AreSetFromOutside) {
  const std::string text =
      "parameter bays = 4; parameter pitch = 3.6 m; parameter length = bays * pitch; "
      "parameter crane = \"tower\"; parameter rate = 90 per h;";
  Parameters plan(text,
                  {{"bays", "6"}, {"pitch", "4"}, {"crane", "big \"one\""}, {"rate", "2 per h"}});
  EXPECT_EQ(plan.said(), "");
  EXPECT_EQ(plan.value("length"), "24 a length");
  EXPECT_EQ(plan.value("crane"), "big \"one\" a text");
  EXPECT_EQ(Parameters(text, {{"pitch", "4 m / 2"}}).value("pitch"), "2 a length");
  const auto said = [&](const std::string& name, const std::string& value) {
    return Parameters(text, {{name, value}}).said();
  };
  EXPECT_EQ(said("bay", "6"),
            "P27 --set bay=6: the plan has no parameter 'bay'; did you mean bays?\n");
  EXPECT_EQ(said("bays", "six"), "P27 --set bays=six: expected a number, such as 6 or \"3.5 m\"\n");
  EXPECT_EQ(said("bays", "6; crew c"),
            "P27 --set bays=6; crew c: expected a number, such as 6 or \"3.5 m\"\n");
  EXPECT_EQ(said("bays", "6 m"),
            "P27 --set bays=6 m: the parameter is a plain number, found a length\n");
  EXPECT_EQ(said("pitch", "6 s"), "P27 --set pitch=6 s: the parameter is a length, found a time\n");
  EXPECT_EQ(said("rate", "6"),
            "P27 --set rate=6: the parameter is an hourly rate, found a plain number\n");
  EXPECT_EQ(Parameters(text, {{"bays", "5"}, {"bays", "6"}}).said(),
            "P27 --set bays is given twice\n");
}

TEST(Parameters, AreSetByNamesWithBrackets) {
  const std::string text = "parameter stock[1] = 3; parameter stock[2, 15] = 4;";
  Parameters plan(text, {{"stock[1]", "7"}, {"stock[2, 15]", "8"}});
  EXPECT_EQ(plan.said(), "");
  EXPECT_EQ(plan.value("stock_1") + plan.value("stock_2_15"), "7 a plain number8 a plain number");
  const auto said = [&](const std::string& name) { return Parameters(text, {{name, "1"}}).said(); };
  EXPECT_EQ(said("stock[3]"),
            "P27 --set stock_3=1: the plan has no parameter 'stock_3'; did you mean stock_1?\n");
  EXPECT_NE(said("stock[1"), "");
  EXPECT_NE(said("stock[1]]"), "");
  EXPECT_NE(said("stock[i]"), "");
  EXPECT_NE(said("stock[]"), "");
  EXPECT_EQ(Parameters(text, {{"stock[1]", "5"}, {"stock_1", "6"}}).said(),
            "P27 --set stock_1 is given twice\n");
}

TEST(Parameters, AreWrittenInTextsOfOthers) {
  Parameters plan(
      "parameter lot = \"A\"; parameter n = 3; parameter label = \"Lot {lot}{n}\"; "
      "parameter sign = \"{label}: {} {1}\";",
      {{"lot", "{B}"}});
  EXPECT_EQ(plan.said(), "");
  EXPECT_EQ(plan.value("label"), "Lot {B}3 a text");
  EXPECT_EQ(plan.value("sign"), "Lot {B}3: {} {1} a text");
  EXPECT_EQ(Parameters("parameter a = \"{b}\"; parameter b = 1;").said(),
            "P23 there is no parameter 'b' for this text\n");
}

}  // namespace

}  // namespace rubicon::test
