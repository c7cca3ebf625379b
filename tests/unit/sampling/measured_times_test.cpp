#include "src/simulation/sampling/measured_times.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>

#include "src/simulation/sampling/duration_law.hpp"

namespace rubicon::sampling {
namespace {

MeasuredTimes times_of(std::string_view text, const MeasuredColumn& column = {}) {
  auto read = read_measured(text, column);
  if (const auto* fault = std::get_if<MeasuredFault>(&read)) {
    ADD_FAILURE() << fault->message;
    return {};
  }
  return std::get<MeasuredTimes>(std::move(read));
}

/// The message, and what the place of the fault says in the text.
std::pair<std::string, std::string> fault_of(std::string_view text,
                                             const MeasuredColumn& column = {}) {
  const auto read = read_measured(text, column);
  const auto* fault = std::get_if<MeasuredFault>(&read);
  if (fault == nullptr) return {"nothing is wrong", ""};
  return {fault->message, std::string(text.substr(fault->begin, fault->end - fault->begin))};
}

TEST(MeasuredTimes, ReadsOneColumnWithAndWithoutHeading) {
  const std::vector<double> expected = {120, 150, 30};
  const MeasuredColumn minutes{{}, {}, 60};
  EXPECT_EQ(times_of("2\n2.5\n0.5\n", minutes).times, expected);
  EXPECT_EQ(times_of("hook (min)\r\n2\r\n2.5\r\n\r\n0.5", minutes).times, expected);
  EXPECT_EQ(times_of("\xEF\xBB\xBF# by hand\n 2 \n\"2.5\"\n+5e-1\n", minutes).times, expected);
}

TEST(MeasuredTimes, FindsAColumnByNameOrNumber) {
  const std::string_view table = "lift;hook time;release\n1;2.5;7\n2;;8\n3;3.5;\n\"a;b\";1;9\n";
  EXPECT_EQ(times_of(table, {"hook time", {}, 1}).times, (std::vector<double>{2.5, 3.5, 1}));
  EXPECT_EQ(times_of(table, {{}, 3, 1}).times, (std::vector<double>{7, 8, 9}));
  EXPECT_EQ(times_of("1,2\n3,4\n", {{}, 2, 1}).times, (std::vector<double>{2, 4}));
  EXPECT_EQ(times_of("a\tb\n3\t4\n", {"b", {}, 1}).column, 2);
  // Lines may end sooner; what stands behind the last column is no time unless commas part fields.
  EXPECT_EQ(times_of("a,b\n3\n4,5,\n", {"a", {}, 1}).times, (std::vector<double>{3, 4}));
  EXPECT_EQ(times_of("a;b\n3;4;late\n", {"b", {}, 1}).times, (std::vector<double>{4}));
}

TEST(MeasuredTimes, SaysWhatIsWrongAndWhere) {
  using Fault = std::pair<std::string, std::string>;
  EXPECT_EQ(fault_of(""), Fault("there is no time in this file", ""));
  EXPECT_EQ(fault_of("minutes\n\n# none\n"), Fault("there is no time in this file", ""));
  EXPECT_EQ(fault_of("1\n-2\n"), Fault("a time is not below 0, found -2", "-2"));
  EXPECT_EQ(fault_of("1\nnan\n"), Fault("expected a time, found 'nan'", "nan"));
  EXPECT_EQ(fault_of("nan\n1\n"), Fault("expected a time, found 'nan'", "nan"));
  EXPECT_EQ(fault_of("1\n1e400\n"), Fault("a time is up to 126 years, found 1e400", "1e400"));
  EXPECT_EQ(fault_of("1\ninf\n").first, "a time is up to 126 years, found inf");
  EXPECT_EQ(fault_of("1\n2 min\n"), Fault("expected a time, found '2 min'", "2 min"));
  EXPECT_EQ(fault_of("2min\n"), Fault("expected a time, found '2min'", "2min"));
  EXPECT_EQ(fault_of("1,5\n2,5\n").first, "this line has 2 fields; expected one time");
  EXPECT_EQ(fault_of("a;b\n1;2,5\n", {"b", {}, 1}), Fault("expected a time, found '2,5'", "2,5"));
  // One field more than there are columns: a decimal comma.
  EXPECT_EQ(fault_of("hook time\n2,9\n3,9\n", {"hook time", {}, 1}),
            Fault("this line has 2 fields, the first line has 1", "2,9"));
  EXPECT_EQ(fault_of("hook time\r\n3\r\n2,9\r\n", {{}, 1, 1}),
            Fault("this line has 2 fields, the first line has 1", "2,9"));
  EXPECT_EQ(fault_of("lift,hook\n1,2,9\n", {"hook", {}, 1}),
            Fault("this line has 3 fields, the first line has 2", "1,2,9"));
  EXPECT_EQ(fault_of("3\n2,9\n", {{}, 1, 1}),
            Fault("this line has 2 fields, the first line has 1", "2,9"));
  EXPECT_EQ(fault_of("a,b\n1,2\n", {{}, 3, 1}).first, "there is no column 3; the first line has 2");
  EXPECT_EQ(fault_of("a,b\n1,2\n", {"c", {}, 1}).first,
            "there is no column 'c'; the first line has: a, b");
  EXPECT_EQ(fault_of("a,a\n1,2\n", {"a", {}, 1}).first, "two columns are called 'a'");
  std::string many;
  for (std::size_t i = 0; i <= kMostMeasured; ++i) many += "1\n";
  EXPECT_EQ(fault_of(many).first, "there are more than 1000000 times");
}

/// Each time is drawn as often as any other, and nothing between them: a chi-squared test with 4
/// degrees of freedom, beyond whose bound one sample in a thousand lies.
TEST(MeasuredTimes, AreDrawnEvenly) {
  DurationLaw law;
  law.law = Law::measured;
  law.measured = std::make_shared<MeasuredTimes>(times_of("2\n4\n8\n16\n2.5\n"));
  EXPECT_EQ(law.fault(), "");
  EXPECT_DOUBLE_EQ(law.mean(), 6.5);
  EXPECT_EQ(law.least(), 2);
  EXPECT_EQ(law.most(), 16);
  constexpr int kDraws = 50'000;
  std::map<double, int> counts;
  double sum = 0;
  for (int run = 0; run < kDraws; ++run) {
    const double drawn = draw(law, {3, static_cast<std::uint64_t>(run), "set.hook"});
    ++counts[drawn];
    sum += drawn;
  }
  ASSERT_EQ(counts.size(), 5u);
  double chi = 0;
  for (const auto& [time, count] : counts) {
    chi += std::pow(count - kDraws / 5., 2) / (kDraws / 5.);
  }
  EXPECT_LT(chi, 18.47);
  const double deviation = std::sqrt((4 + 16 + 64 + 256 + 6.25) / 5 - 6.5 * 6.5);
  EXPECT_NEAR(sum / kDraws, 6.5, 4 * deviation / std::sqrt(kDraws));
}

}  // namespace
}  // namespace rubicon::sampling
