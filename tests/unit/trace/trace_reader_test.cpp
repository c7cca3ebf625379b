#include "src/simulation/trace/trace_reader.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <stdexcept>

#include "src/simulation/trace/header.hpp"
#include "src/simulation/trace/json_builder.hpp"
#include "src/simulation/trace/record.hpp"
#include "tests/support/header_json.hpp"
#include "tests/unit/trace/written_records.hpp"

namespace rubicon::trace {
namespace {

using testing::HasSubstr;

const std::string kHeader = test::whole_header({}).dump();

/// Calls `look` with the record of a line behind a good header.
template <typename Look>
void read(const std::string& line, Look look, RecordKinds wanted = RecordKinds::all()) {
  TraceReader reader(wanted);
  const auto ignore = [](const auto&) {};
  reader.read(kHeader, ignore, ignore);
  reader.read(line, ignore, look);
}

/// What a line is answered with; "" if it is read.
std::string answer(const std::string& line) {
  try {
    read(line, [](const Record&) {});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(TraceReader, ReadsAnAttempt) {
  read(test::written_records()[7], [](const Record& record) {
    EXPECT_EQ(record.task, "set_slab");
    EXPECT_EQ(record.robot, "crane");
    const auto& attempt = std::get<Attempt>(record.what);
    EXPECT_EQ(attempt.n, 12);
    EXPECT_THAT(attempt.parameters, testing::ElementsAre("x", "z"));
    ASSERT_NE(record.place(), nullptr);
    EXPECT_EQ(record.place()->file, "crane.motion");
    EXPECT_EQ(attempt.line, 3);
    EXPECT_FALSE(attempt.ok);
    EXPECT_EQ(attempt.reason, "hit");
    EXPECT_EQ(attempt.hit.value().met, "wall");
    EXPECT_THAT(attempt.step, testing::ElementsAre(5, -0.5));
    EXPECT_EQ(record.time(), 333'333'333);
    ASSERT_EQ(attempt.q.size(), 4u);
    EXPECT_EQ(attempt.q[2].name, "z");
    EXPECT_EQ(attempt.q[2].value, 20.5);
  });
}

TEST(TraceReader, ReadsTheEndOfAMotion) {
  const std::vector<std::string> records = test::written_records();
  const auto written = std::find_if(records.begin(), records.end(), [](const std::string& line) {
    return line.find(R"("type":"end")") != std::string::npos;
  });
  ASSERT_NE(written, records.end());
  read(*written, [](const Record& record) {
    const auto& end = std::get<MotionEnd>(record.what);
    EXPECT_EQ(end.status, "livelock");
    EXPECT_EQ(end.period, 2);
    EXPECT_EQ(end.rejected.at_goal, 1);
    EXPECT_EQ(end.rejected.hit, 3);
    ASSERT_EQ(end.residual.size(), 1u);
    EXPECT_EQ(end.residual[0].value, 2.5);
    EXPECT_EQ(end.position_error, 0.25);
    ASSERT_EQ(end.variables.size(), 1u);
    EXPECT_EQ(end.variables[0].name, "height");
    EXPECT_EQ(end.message, "livelock: again");
    EXPECT_EQ(record.place()->line, 3);
  });
}

TEST(TraceReader, ListsOfNumbersOfARecordAreKeptApart) {
  int looked_at = 0;
  read(R"({"type":"soil","task":"a","robot":"r","component":"ground","cells":[7,8,9],)"
       R"("heights":[-100,-200,-300],"volume":5,"from":0,"t":1})",
       [&](const Record& record) {
         const auto& soil = std::get<Soil>(record.what);
         EXPECT_THAT(soil.cells, testing::ElementsAre(7, 8, 9));
         EXPECT_THAT(soil.heights, testing::ElementsAre(-100, -200, -300));
         ++looked_at;
       });
  EXPECT_EQ(looked_at, 1);
}

TEST(TraceReader, TimesAreExact) {
  const auto time = [](const std::string& text) {
    std::optional<Ticks> t;
    read(fmt::format(R"({{"type":"wait","task":"a","robot":"r","n":1,"t":{}}})", text),
         [&](const Record& record) { t = record.time(); });
    return t;
  };
  EXPECT_EQ(time("0"), 0);
  EXPECT_EQ(time("26000000.000000001"), 26'000'000'000'000'001);  // more digits than a double has
  EXPECT_EQ(time("2.5"), 2'500'000'000);
  EXPECT_EQ(time("-0.25"), -250'000'000);
  EXPECT_EQ(time("0.0000000019"), 1);
  EXPECT_EQ(time("1.5e-3"), 1'500'000);
  EXPECT_EQ(time("4e9"), 4'000'000'000'000'000'000);
  for (const char* wrong : {"4000000001", "5e9", "1e999", "\"1\"", "null", "true", "[1]"}) {
    const std::string line =
        fmt::format(R"({{"type":"wait","task":"a","robot":"r","n":1,"t":{}}})", wrong);
    EXPECT_FALSE(answer(line).empty()) << line;
  }
  for (const char* damaged : {"01", "1.", ".5", "-", "1.5.5", "1x", "1 2", "+1"}) {
    const std::string line =
        fmt::format(R"({{"type":"wait","task":"a","robot":"r","n":1,"t":{}}})", damaged);
    EXPECT_THAT(answer(line), HasSubstr("damaged")) << line;
  }
}

TEST(TraceReader, SecondsAreTheNearestDouble) {
  for (const Ticks ticks :
       {Ticks{0}, Ticks{1}, Ticks{333'333'333}, Ticks{9'007'199'254'740'993},
        Ticks{26'000'000'000'000'001}, Ticks{-1'500'000'000}, Ticks{3'999'999'999'999'999'999}}) {
    std::string text;
    append_seconds(text, ticks);
    EXPECT_EQ(seconds(ticks), std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(TraceReader, MembersMayComeInAnyOrder) {
  read(
      R"({ "n": 2, "robot": "r", "k": 1, "\u0074ask": "a", "more": [1, {"k": 3}], "type": "goal" })",
      [](const Record& record) {
        EXPECT_EQ(record.task, "a");
        EXPECT_EQ(std::get<GoalStart>(record.what).k, 1);
        EXPECT_EQ(std::get<GoalStart>(record.what).n, 2);
      });
}

TEST(TraceReader, WhatIsNotWantedIsNotLookedAt) {
  int seen = 0;
  const auto count = [&](const Record&) { ++seen; };
  read(R"({"type":"try","this is":"not looked at})", count, {RecordKind::wait});
  read(R"({"n":1,"type":"goal"})", count, {RecordKind::wait});
  EXPECT_EQ(seen, 0);
  read(R"({"type":"wait","task":"a","robot":"r","n":1,"t":1})", count, {RecordKind::wait});
  EXPECT_EQ(seen, 1);
  EXPECT_THROW(read(R"({"type":"try","task":"a","rob)", count, {RecordKind::wait}),
               std::invalid_argument);
}

TEST(TraceReader, SaysWhatIsWrongWithALine) {
  const std::string goal = R"({"type":"goal","task":"a","robot":"r","k":1,"n":1})";
  EXPECT_EQ(answer(goal), "");
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "it is empty"},
      {"nonsense", "expected JSON"},
      {"[1, 2]", "the line should be an object, found a list"},
      {"7", "the line should be an object, found 7"},
      {goal.substr(0, 40), "it is cut off"},
      {goal + goal, "damaged text"},
      {goal + "x", "it is cut off"},
      {"{}", "it has no 'type'"},
      {R"({"type":7})", "'type' should be a text, found 7"},
      {R"({"type":"dance\u001b","task":"a","robot":"r"})", "there is no type 'dance?'"},
      {kHeader, "a second header"},
      {R"({"type":"goal","task":"a","robot":"r","n":1})", "it has no 'k', which every 'goal' has"},
      {R"({"type":"goal","task":"a","robot":"r","k":1,"k":2,"n":1})", "it has two 'k'"},
      {R"({"type":"goal","task":"a","task":"b","robot":"r","k":1,"n":1})", "it has two 'task'"},
      {R"({"type":"goal","task":"a","robot":"r","k":1.5,"n":1})",
       "'k' should be a whole number, found 1.5"},
      {R"({"type":"goal","task":"a","robot":"r","k":-1,"n":1})",
       "'k' should be a whole number from 0 to 2147483647, found -1"},
      {R"({"type":"goal","task":"a","robot":"r","k":"\u001b[31m","n":1})",
       R"('k' should be a whole number, found "\u001b[31m")"},
      {R"({"type":"goal","task":"a" "robot":"r","k":1,"n":1})", "damaged text"},
      {"{\"type\":\"goal\",\"task\":\"\xff\",\"robot\":\"r\"}", "damaged text"},
      {std::string(100'000, '['), "damaged text"},
      {"{\"type\":\"goal\",\"task\":" + std::string(100'000, '[') + "}", "damaged text"},
  };
  for (const auto& [line, message] : cases) {
    EXPECT_THAT(answer(line), HasSubstr(message)) << line.substr(0, 100);
    EXPECT_THAT(answer(line), testing::StartsWith("this is no line of a trace: "));
  }
}

}  // namespace
}  // namespace rubicon::trace
