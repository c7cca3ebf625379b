#include "src/simulation/trace/json_builder.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "src/simulation/trace/formula_text.hpp"

namespace rubicon::trace {
namespace {

std::string number_text(double value) {
  std::string out;
  append_number(out, value);
  return out;
}

std::string seconds_text(interpreter::Ticks ticks) {
  std::string out;
  append_seconds(out, ticks);
  return out;
}

std::string string_text(std::string_view text) {
  std::string out;
  append_string(out, text);
  return out;
}

TEST(JsonNumber, IsTheShortestThatReadsBack) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(2), "2");
  EXPECT_EQ(number_text(-0.0), "0");
  EXPECT_EQ(number_text(1.0 / 3), "0.3333333333333333");
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "null");
  EXPECT_EQ(number_text(std::numeric_limits<double>::quiet_NaN()), "null");
  for (const double value : {1e-300, 5e-324, 1.7976931348623157e308, -123456789.125, 1e21}) {
    EXPECT_EQ(nlohmann::json::parse(number_text(value)).get<double>(), value);
  }
}

TEST(JsonSeconds, AreExact) {
  EXPECT_EQ(seconds_text(0), "0");
  EXPECT_EQ(seconds_text(2'500'000'000), "2.5");
  EXPECT_EQ(seconds_text(333'333'333), "0.333333333");
  EXPECT_EQ(seconds_text(1), "0.000000001");
  EXPECT_EQ(seconds_text(-1'500'000'000), "-1.5");
  EXPECT_EQ(seconds_text(std::numeric_limits<interpreter::Ticks>::min()), "-9223372036.854775808");
}

TEST(JsonString, EscapesAndMendsWhatIsNotUtf8) {
  EXPECT_EQ(string_text("a\"b\\c\n\t\r"), R"("a\"b\\c\n\t\r")");
  EXPECT_EQ(string_text(std::string_view("\x01\0", 2)), R"("\u0001\u0000")");
  EXPECT_EQ(string_text("h\xc3\xb6he"), "\"h\xc3\xb6he\"");
  EXPECT_EQ(string_text("\xff\xc3"), R"("\ufffd\ufffd")");
  EXPECT_EQ(string_text("\xed\xa0\x80"), R"("\ufffd\ufffd\ufffd")");  // a surrogate
  EXPECT_EQ(string_text("\xc0\xaf"), R"("\ufffd\ufffd")");            // overlong
  EXPECT_EQ(string_text("\xf0\x9f\x8f\x97"), "\"\xf0\x9f\x8f\x97\"");
}

TEST(JsonBuilder, PutsCommasWhereTheyBelong) {
  JsonBuilder json;
  json.begin_object().key("a").begin_array().value(1).value(2.5).null().end_array();
  json.field("b", "x").key("c").begin_object().end_object().field("d", true).end_object();
  EXPECT_EQ(json.text(), R"({"a":[1,2.5,null],"b":"x","c":{},"d":true})");
}

TEST(FormulaText, WritesTheLanguagesNotation) {
  using Kind = robot::FormulaOp::Kind;
  robot::RobotModel model;
  model.parameters.resize(2);
  model.parameters[0].display_name = "x";
  model.parameters[1].display_name = "jib.theta";
  // x + x_s * cos(jib.theta) - (2 - x_c)
  const robot::Formula formula{{{Kind::parameter, 0, 0},
                                {Kind::step, 0, 0},
                                {Kind::parameter, 1, 0},
                                {Kind::cos, 0, 0},
                                {Kind::multiply, 0, 0},
                                {Kind::add, 0, 0},
                                {Kind::constant, 0, 2},
                                {Kind::start, 0, 0},
                                {Kind::subtract, 0, 0},
                                {Kind::subtract, 0, 0}}};
  EXPECT_EQ(formula_text(model, formula), "x + x_s * cos(jib.theta) - (2 - x_c)");
  EXPECT_EQ(formula_text(model, {}), "0");
  const robot::FrameFormula frame = {
      {robot::FrameElement::Kind::rotz, robot::parameter_formula(1), {}, {}},
      {robot::FrameElement::Kind::trans,
       robot::parameter_formula(0),
       {},
       robot::constant_formula(-1.5)}};
  EXPECT_EQ(frame_text(model, frame), "rotz(jib.theta) * trans(x, 0, -1.5)");
  EXPECT_EQ(frame_text(model, {}), "trans(0, 0, 0)");
}

}  // namespace
}  // namespace rubicon::trace
