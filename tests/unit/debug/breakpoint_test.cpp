// Breakpoints stop at exactly the records that a scan of the trace finds.

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "tests/unit/debug/direct_replay.hpp"
#include "tests/unit/debug/shipped_traces.hpp"

namespace rubicon::test {

namespace {

using nlohmann::json;

/// Task and number of a record in its run; 0 is the beginning.
using Stop = std::pair<std::size_t, std::size_t>;

std::vector<Stop> scan(const std::vector<DirectRun>& runs,
                       const std::function<bool(const json&)>& wanted) {
  std::vector<Stop> stops;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    for (std::size_t i = 0; i < runs[r].records.size(); ++i) {
      if (wanted(runs[r].records[i])) stops.emplace_back(r, i + 1);
    }
  }
  return stops;
}

Stop place(const debug::Session& session) {
  const auto run = static_cast<std::size_t>(&session.run() - session.recording().runs.data());
  return {run, session.state().position};
}

/// Where `command` repeated stops at a breakpoint.
std::vector<Stop> stops_of(debug::Session& session, const std::string& command) {
  std::vector<Stop> stops;
  while (session.execute(command).starts_with("breakpoint ")) stops.push_back(place(session));
  return stops;
}

void expect_stops(debug::Session& session, const std::string& where, std::vector<Stop> expected) {
  session.execute("delete");
  session.execute("run to 1");
  while (session.execute("reverse") != "this is the beginning\n") {
  }
  ASSERT_TRUE(session.execute("break " + where).starts_with("breakpoint ")) << where;
  EXPECT_EQ(stops_of(session, "continue"), expected) << where;
  std::reverse(expected.begin(), expected.end());
  EXPECT_EQ(stops_of(session, "reverse"), expected) << where;
}

bool is_hit_of(const json& record, const std::string& one, const std::string& other) {
  if (!record.contains("hit")) return false;
  const std::string moved = record.at("hit").at(0);
  const std::string met = record.at("hit").at(1);
  return (moved == one && met == other) || (moved == other && met == one);
}

TEST(Breakpoint, StopsAtEveryRefusal) {
  for (const std::string& plan : walked_plans()) {
    const auto runs = direct_runs(trace_of(plan));
    debug::Session session = session_of(trace_of(plan));
    expect_stops(session, "refused", scan(runs, [](const json& record) {
                   return record.at("type") == "try" && !record.at("ok");
                 }));
    expect_stops(session, "hit",
                 scan(runs, [](const json& record) { return record.contains("hit"); }));
  }
}

TEST(Breakpoint, StopsAtEveryHitOfAPairInEitherOrder) {
  std::size_t pairs = 0;
  for (const std::string& plan : walked_plans()) {
    const auto runs = direct_runs(trace_of(plan));
    debug::Session session = session_of(trace_of(plan));
    std::set<std::pair<std::string, std::string>> met;
    for (const DirectRun& run : runs) {
      for (const json& record : run.records) {
        if (record.contains("hit")) {
          met.emplace(record.at("hit").at(0).get<std::string>(),
                      record.at("hit").at(1).get<std::string>());
        }
      }
    }
    for (const auto& [one, other] : met) {
      const auto expected =
          scan(runs, [&](const json& record) { return is_hit_of(record, one, other); });
      expect_stops(session, "pair \"" + one + "\" \"" + other + "\"", expected);
      expect_stops(session, "pair \"" + other + "\" \"" + one + "\"", expected);
      ++pairs;
    }
  }
  EXPECT_GE(pairs, 10u);
}

TEST(Breakpoint, StopsAtEveryRecordOfALine) {
  std::size_t lines = 0;
  for (const std::string& plan : walked_plans()) {
    const auto runs = direct_runs(trace_of(plan));
    debug::Session session = session_of(trace_of(plan));
    std::set<std::pair<std::string, int>> named;
    for (const DirectRun& run : runs) {
      for (const json& record : run.records) {
        if (record.contains("file")) {
          named.emplace(record.at("file").get<std::string>(), record.at("line").get<int>());
        }
      }
    }
    for (const auto& [file, line] : named) {
      const auto expected = scan(runs, [&, file = file, line = line](const json& record) {
        const std::string type = record.at("type");
        return (type == "try" || type == "enter" || type == "which") &&
               record.value("file", "") == file && record.value("line", 0) == line;
      });
      expect_stops(session, file + ":" + std::to_string(line), expected);
      ++lines;
    }
  }
  EXPECT_GE(lines, 30u);
}

TEST(Breakpoint, StopsWhereATaskBegins) {
  debug::Session session = session_of(trace_of("taskplans/two_cranes.plan"));
  const auto runs = direct_runs(trace_of("taskplans/two_cranes.plan"));
  for (std::size_t r = 1; r < runs.size(); ++r) {
    expect_stops(session, "task \"" + runs[r].task + "\"", {{r, 0}});
  }
}

TEST(Breakpoint, OfOneTaskStaysInIt) {
  debug::Session session = session_of(trace_of("taskplans/two_cranes.plan"), "set_wall_4");
  session.execute("break hit");
  std::size_t stops = 0;
  while (session.execute("continue").starts_with("breakpoint ")) {
    ++stops;
    EXPECT_EQ(session.recording().texts[session.run().name()], "set_wall_4");
  }
  EXPECT_GT(stops, 10u);
}

TEST(Breakpoint, WrongOnesAreRefusedWithAWayOut) {
  debug::Session session = session_of(trace_of("taskplans/two_cranes.plan"));
  session.execute("step");
  const auto said = [&](const std::string& text) { return session.execute("break " + text); };
  EXPECT_EQ(said("pair hig.hook"),
            "nothing meets 'hig.hook' in this recording; did you mean high.hook?\n");
  EXPECT_EQ(
      said("pair low.jib wall_2"),
      "nothing meets 'wall_2' in this recording; what meets something is high.hook, low.jib\n");
  EXPECT_EQ(said("lift.motion:3"), "there is no file 'lift.motion'\n");
  EXPECT_EQ(
      said("lift_over_and_wait.moton:3"),
      "there is no file 'lift_over_and_wait.moton'; did you mean lift_over_and_wait.motion?\n");
  EXPECT_EQ(said("refsed"),
            "'refsed' is no place to stop; did you mean refused?; see help break\n");
  EXPECT_EQ(said(""), "where? see help break\n");
  EXPECT_EQ(said("0"), "'0' is no line: it is LINE or FILE:LINE\n");
  EXPECT_EQ(said("99999999999999999999"),
            "'99999999999999999999' is no line: it is LINE or FILE:LINE\n");
  EXPECT_EQ(said("task set_wal_4"),
            "no task 'set_wal_4' begins in this recording; did you mean set_wall_4?\n");
  EXPECT_EQ(said("refused now"), "'now' is too much; see help break\n");
  EXPECT_EQ(session.execute("breaks"), "no breakpoints\n");
  EXPECT_EQ(
      said("4"),
      "breakpoint 1: lift_over_and_wait.motion:4; nothing is tried there, but at 13, 14, 15\n");
  EXPECT_EQ(session.execute("delete 2"), "there is no breakpoint 2\n");
  EXPECT_EQ(session.execute("delete 1"), "breakpoint 1 is gone\n");
}

}  // namespace

}  // namespace rubicon::test
