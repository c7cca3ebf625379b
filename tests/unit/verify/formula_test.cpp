#include "src/results/verify/input/formula.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/results/verify/input/fault.hpp"
#include "tests/unit/verify/random.hpp"

namespace rubicon::verify {
namespace {

const std::vector<std::string> kNames = {"jib.theta", "x", "z"};

double value(const char* text) {
  const std::vector<double> q = {30, 4, -2};
  const std::vector<double> steps = {0, 0.5, 0};
  const std::vector<double> starts = {0, 1, 7};
  return Formula::parse(text, kNames).value({q, steps, starts});
}

TEST(Formula, IsEvaluatedAsItIsWritten) {
  EXPECT_EQ(value("x"), 4);
  EXPECT_EQ(value("1 - 2 - 3"), -4);
  EXPECT_EQ(value("1 - (2 - 3)"), 2);
  EXPECT_EQ(value("12 / 2 / 3"), 2);
  EXPECT_EQ(value("2 + 3 * x"), 14);
  EXPECT_EQ(value("-x + z_c"), 3);
  EXPECT_EQ(value("-(-x)"), 4);
  EXPECT_EQ(value("x + x_s * cos(60)"), 4.25);
  EXPECT_EQ(value("sin(jib.theta)"), 0.5);
  EXPECT_DOUBLE_EQ(value("1e-05 * -3"), -3e-5);
  EXPECT_EQ(value("0"), 0);
}

TEST(Formula, OfOtherTextIsRefused) {
  for (const char* text :
       {"", "y", "x +", "(x", "x)", "x_t", "jib", "tan(x)", "x x", "1 2", "*x"}) {
    EXPECT_THROW(Formula::parse(text, kNames), UnreadableInput) << text;
  }
  const std::string deep(100000, '(');
  EXPECT_THROW(Formula::parse(deep, kNames), UnreadableInput);
  EXPECT_THROW(Formula::parse(std::string(100000, '-'), kNames), UnreadableInput);
}

TEST(Formula, FramesAreProducts) {
  const auto frame = parse_frame("trans(x, 0, z - 31.2) * rotz(jib.theta)", kNames);
  ASSERT_EQ(frame.size(), 2u);
  EXPECT_EQ(frame[0].kind, FrameElement::Kind::trans);
  EXPECT_EQ(frame[1].kind, FrameElement::Kind::rotz);
  EXPECT_TRUE(frame[0].c.uses(2));
  EXPECT_FALSE(frame[0].c.uses(1));
  for (const char* text :
       {"", "trans(x, 0)", "rot(x)", "rotz(x) *", "rotz(x, 0)", "rotz(x) rotz(x)"}) {
    EXPECT_THROW(parse_frame(text, kNames), UnreadableInput) << text;
  }
}

TEST(Formula, RangesEncloseAllValues) {
  Random random(1);
  const std::vector<double> starts = {0, 1, 7};
  for (const char* text : {"x * x - z", "sin(jib.theta) * x", "cos(2 * jib.theta) / (z + 100)",
                           "-(x - z) * (x + z)", "sin(jib.theta + x) * cos(z)"}) {
    const Formula formula = Formula::parse(text, kNames);
    for (int round = 0; round < 200; ++round) {
      std::vector<Range> ranges;
      for (int i = 0; i < 3; ++i) {
        const double lower = random.real(-90, 90);
        ranges.push_back({lower, lower + random.real(0, i == 0 ? 500 : 20)});
      }
      const Range range = formula.range(ranges, starts);
      for (int sample = 0; sample < 50; ++sample) {
        std::vector<double> q;
        for (const Range& each : ranges) q.push_back(random.real(each.lower, each.upper));
        const double found = formula.value({q, {}, starts});
        EXPECT_GE(found, range.lower - 1e-9 * std::fabs(found)) << text;
        EXPECT_LE(found, range.upper + 1e-9 * std::fabs(found)) << text;
      }
    }
  }
}

TEST(Formula, NarrowRangesAreNarrow) {
  const Formula formula = Formula::parse("sin(jib.theta) * x - z", kNames);
  const std::vector<double> starts = {0, 0, 0};
  const std::vector<Range> ranges = {{10, 10 + 1e-6}, {3, 3 + 1e-6}, {5, 5 + 1e-6}};
  const Range range = formula.range(ranges, starts);
  EXPECT_LT(range.upper - range.lower, 3e-6);
}

}  // namespace
}  // namespace rubicon::verify
