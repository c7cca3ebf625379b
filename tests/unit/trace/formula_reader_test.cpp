#include "src/simulation/trace/formula_reader.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "src/simulation/trace/formula_text.hpp"

namespace rubicon::trace {
namespace {

const std::vector<std::string> kNames = {"x", "jib.theta"};

robot::RobotModel model() {
  robot::RobotModel model;
  for (const std::string& name : kNames) {
    model.parameters.emplace_back();
    model.parameters.back().display_name = name;
  }
  return model;
}

TEST(FormulaReader, ReadsWhatIsWritten) {
  for (const char* text :
       {"0", "x + x_s * cos(jib.theta) - (2 - x_c)", "-x / (2 * 3)", "-(x + 1) * sin(-jib.theta_c)",
        "1e-05 - -2.5", "x / 2 / jib.theta", "x / (2 / jib.theta)"}) {
    EXPECT_EQ(formula_text(model(), read_formula(text, kNames)), text);
  }
  for (const char* text :
       {"trans(0, 0, 0)", "trans(x, 2 * x, -1) * rotz(jib.theta / 2) * rotx(90)", "roty(-x)"}) {
    EXPECT_EQ(frame_text(model(), read_frame(text, kNames)), text);
  }
}

TEST(FormulaReader, KeepsTheOrderOfOperators) {
  const std::vector<double> q = {8, 30}, steps = {3, 0}, starts = {5, 0};
  const auto value = [&](const char* text) {
    return read_formula(text, kNames).evaluate({q, steps, starts});
  };
  EXPECT_EQ(value("x - 2 - 1"), 5);
  EXPECT_EQ(value("x / 2 * 4"), 16);
  EXPECT_EQ(value("2 + x * -2"), -14);
  EXPECT_EQ(value("x_c - x_s"), 2);
  EXPECT_EQ(value("x * sin(jib.theta)"), 4);
}

TEST(FormulaReader, RefusesWhatIsNone) {
  for (const char* text : {"", "x +", "y", "x_t", "(x", "x)", "sin x", "2 x", "1e999", "x ^ 2"}) {
    EXPECT_THROW(read_formula(text, kNames), std::invalid_argument) << text;
  }
  for (const char* text :
       {"", "rotz()", "rotw(x)", "trans(1, 2)", "rotx(1) *", "rotx(1) rotx(2)"}) {
    EXPECT_THROW(read_frame(text, kNames), std::invalid_argument) << text;
  }
  EXPECT_THROW(read_formula(std::string(100'000, '('), kNames), std::invalid_argument);
  EXPECT_THROW(read_formula(std::string(100'000, '-'), kNames), std::invalid_argument);
}

}  // namespace
}  // namespace rubicon::trace
