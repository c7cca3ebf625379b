#include "src/results/report/exact_json.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace rubicon::report {
namespace {

std::string refusal(const std::string& text) {
  try {
    ExactJson::parse(text).at("a").ticks();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing";
}

TEST(ExactJson, KeepsNanosecondsOverAHundredYears) {
  const ExactJson json = ExactJson::parse(
      R"({"a": 3999999999.000000001, "b": -0.5, "c": 12, "d": 26000000.123456789, "e": 0.0000000019})");
  EXPECT_EQ(json.at("a").ticks(), 3'999'999'999'000'000'001);
  EXPECT_EQ(json.at("b").ticks(), -500'000'000);
  EXPECT_EQ(json.at("c").ticks(), 12'000'000'000);
  EXPECT_EQ(json.at("d").ticks(), 26'000'000'123'456'789);
  EXPECT_EQ(json.at("e").ticks(), 1);
}

TEST(ExactJson, TakesTheLastOfEqualNames) {
  EXPECT_EQ(ExactJson::parse(R"({"a": 1, "b": 2, "a": 3})").at("a").integer(), 3);
}

TEST(ExactJson, KnowsNullFromNothing) {
  const ExactJson json = ExactJson::parse(R"({"a": null, "b": 0})");
  EXPECT_FALSE(json.has("a"));
  EXPECT_TRUE(json.has("b"));
  EXPECT_FALSE(json.has("c"));
}

TEST(ExactJson, SaysWhatWasExpected) {
  EXPECT_EQ(refusal(R"({"b": 1})"), "expected 'a'");
  EXPECT_EQ(refusal(R"({"a": "1"})"), "expected a time as 'a'");
  EXPECT_EQ(refusal(R"({"a": 1e5})"), "expected a time as 'a'");
  EXPECT_EQ(refusal(R"({"a": 4000000001})"), "expected a time as 'a'");
  EXPECT_EQ(refusal(R"({"a": 99999999999999999999999})"), "expected a time as 'a'");
  EXPECT_EQ(refusal("[1]"), "expected an object");
  EXPECT_TRUE(refusal("").starts_with("expected JSON: "));
  EXPECT_TRUE(refusal("{").starts_with("expected JSON: "));
  EXPECT_TRUE(refusal("{\"a\": 1}}").starts_with("expected JSON: "));
  EXPECT_EQ(refusal(std::string(100'000, '[')), "expected JSON, found too many brackets");
  EXPECT_THROW(ExactJson::parse(R"({"a": 1.5})").at("a").integer(), std::invalid_argument);
  EXPECT_THROW(ExactJson::parse(R"({"a": 5000000000})").at("a").integer(), std::invalid_argument);
  EXPECT_THROW(ExactJson::parse(R"({"a": 1})").at("a").text(), std::invalid_argument);
  EXPECT_THROW(ExactJson::parse(R"({"a": 1})").at("a").truth(), std::invalid_argument);
  EXPECT_THROW(ExactJson::parse(R"({"a": 1})").at("a").elements(), std::invalid_argument);
}

}  // namespace
}  // namespace rubicon::report
