#include "src/results/gantt/trace_times.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/header_json.hpp"

namespace rubicon::gantt {
namespace {

const std::string kHeader =
    test::whole_header({{"plan", "yard"},
                        {"calendars",
                         {{{"name", "site"},
                           {"shifts", {{{"days", {0, 4}}, {"minutes", {{420, 720}, {780, 960}}}}}},
                           {"off", {"2026-12-25"}},
                           {"carry_over", false}}}},
                        {"robots", {{{"name", "crane"}, {"calendar", "site"}}}},
                        {"crews", {{{"name", "riggers"}}}},
                        {"tasks", {{{"name", "set"}, {"crews", {"riggers"}}}}}})
        .dump();

TraceTimes read(const std::vector<std::string>& lines) {
  TraceTimesReader reader;
  for (const std::string& line : lines) reader.line(line);
  return reader.take();
}

TEST(TraceTimes, KeepWorkAndWaitingOfTasksThatWereDone) {
  const TraceTimes times = read(
      {kHeader, R"({"type":"task_start","task":"set","robot":"crane","t":1})",
       R"({"type":"try","this is":"not read})",
       R"({"type":"pause","task":"set","robot":"crane","why":"shift","for":"","from":2,"t":3.000000001})",
       R"({"type":"task_start","task":"bad","robot":"crane","t":1})",
       R"({"type":"work","task":"set","robot":"crane","what":"hook","crew":"riggers","from":4,"t":6,"time":2})",
       R"({"type":"task_end","task":"bad","robot":"crane","t":1,"result":"rejected","reason":"x"})",
       R"({"type":"task_end","task":"set","robot":"crane","t":7,"result":"done","reason":""})"});
  ASSERT_EQ(times.runs.size(), 1U);
  const TaskTimes& task = times.runs.at({"set", schedule::kSecond});
  EXPECT_EQ(task.end, 7 * schedule::kSecond);
  ASSERT_EQ(task.stretches.size(), 2U);
  EXPECT_EQ(task.stretches[0].to, 3'000'000'001);
  EXPECT_EQ(task.stretches[0].kind, Stretch::Kind::wait);
  EXPECT_EQ(task.stretches[1].crew, "riggers");
  EXPECT_EQ(times.plan, "yard");
  EXPECT_EQ(times.calendar_of.at("crane"), "site");
  EXPECT_FALSE(times.calendar_of.contains("riggers"));
  EXPECT_EQ(times.held.at("set"), std::vector<std::string>{"riggers"});
  EXPECT_EQ(times.calendars.front().off.front(), (schedule::Date{2026, 12, 25}));
}

TEST(TraceTimes, ReadLinesThatAnotherProgramWroteAnew) {
  const TraceTimes times = read(
      {kHeader, R"({ "task": "set", "t": 1, "robot": "crane", "type": "task_start" })",
       R"({ "task": "set", "robot": "crane", "t": 7, "reason": "", "result": "done", "type": "task_end" })"});
  EXPECT_EQ(times.runs.at({"set", schedule::kSecond}).end, 7 * schedule::kSecond);
}

TEST(TraceTimes, RefuseWhatIsNoTrace) {
  EXPECT_THROW(read({""}), std::invalid_argument);
  EXPECT_THROW(read({"{}"}), std::invalid_argument);
  EXPECT_THROW(read({R"({"type":"work"})"}), std::invalid_argument);
  EXPECT_THROW(read({R"({"type":"header"})"}), std::invalid_argument);
  EXPECT_THROW(read({kHeader.substr(0, kHeader.size() / 2)}), std::invalid_argument);
  EXPECT_THROW(read({kHeader, "garbage"}), std::invalid_argument);
  EXPECT_THROW(
      read(
          {kHeader, R"({"type":"task_start","task":"set","robot":"","t":1})",
           R"({"type":"work","task":"set","robot":"","what":"hook","crew":"","from":4,"t":3,"time":0})"}),
      std::invalid_argument);
  EXPECT_THROW(read({kHeader, R"({"type":"work","task":"set","from":"x"})"}),
               std::invalid_argument);
}

}  // namespace
}  // namespace rubicon::gantt
