// What the debugger shows at any place of a recording, against a replay of the records themselves.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/debug/direct_replay.hpp"
#include "tests/unit/debug/shipped_traces.hpp"

namespace rubicon::test {

namespace {

void expect_same(const debug::Recording& recording, const debug::TaskRun& run,
                 const debug::TaskState& state, const DirectState& expected) {
  EXPECT_EQ(state.t, expected.t);
  EXPECT_EQ(state.n, expected.n);
  EXPECT_EQ(recording.texts[state.carries], expected.carries);
  std::map<std::string, double> variables;
  for (const auto& [name, value] : state.variables) variables[recording.texts[name]] = value;
  EXPECT_EQ(variables, expected.variables);
  ASSERT_EQ(state.loops.size(), expected.loops.size());
  for (std::size_t i = 0; i < state.loops.size(); ++i) {
    const debug::LoopState& loop = state.loops[i];
    EXPECT_EQ(recording.texts[loop.kind], expected.loops[i].kind);
    EXPECT_EQ(recording.places[loop.place].line, expected.loops[i].line);
    EXPECT_EQ(recording.files[recording.places[loop.place].file].path, expected.loops[i].file);
    EXPECT_EQ(loop.tried, expected.loops[i].tried);
    EXPECT_EQ(loop.made, expected.loops[i].made);
  }
  if (expected.q.empty()) return;
  const std::vector<double> q = run.configuration(state.row);
  ASSERT_EQ(q.size(), expected.q.size());
  for (std::size_t i = 0; i < q.size(); ++i) EXPECT_EQ(q[i], expected.q.at(run.parameters()[i]));
}

TEST(State, IsWhatADirectReplayOfTheRecordsGivesAtEveryRecord) {
  for (const std::string& plan : walked_plans()) {
    const debug::Recording recording = recording_of(trace_of(plan));
    const std::vector<DirectRun> runs = direct_runs(trace_of(plan));
    ASSERT_EQ(recording.runs.size(), runs.size()) << plan;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const debug::TaskRun& run = recording.runs[r];
      ASSERT_EQ(recording.texts[run.name()], runs[r].task);
      ASSERT_EQ(run.size(), runs[r].records.size());
      DirectState expected;
      for (std::size_t i = 0; i < run.size(); ++i) {
        direct_apply(runs[r].records[i], expected);
        expect_same(recording, run, run.state_at(i + 1), expected);
        if (HasFailure()) FAIL() << plan << ", " << runs[r].task << ", record " << i;
      }
    }
  }
}

/// A robot's configuration before the first step of a task is where its last task left it.
TEST(State, BeginsWhereTheRobotStood) {
  for (const std::string& plan : walked_plans()) {
    const debug::Recording recording = recording_of(trace_of(plan));
    for (const debug::TaskRun& run : recording.runs) {
      if (run.events().front().kind == debug::EventKind::task_end) continue;
      const std::vector<double> before = run.configuration(debug::kNone);
      for (std::size_t i = 0; i < run.size(); ++i) {
        const debug::Event& event = run.events()[i];
        if (event.kind != debug::EventKind::attempt) continue;
        // The first attempt moves what its command names, and what is derived of that.
        const std::vector<double> after = run.configuration(event.row);
        const auto& moved = recording.commands[event.text].parameters;
        for (std::size_t k = 0; k < before.size(); ++k) {
          ASSERT_FALSE(std::isnan(before[k])) << plan << " " << run.parameters()[k];
          const bool named =
              std::find(moved.begin(), moved.end(), run.parameters()[k]) != moved.end();
          if (!event.ok) {
            EXPECT_EQ(before[k], after[k]) << plan;
          }
          if (named && event.ok) {
            EXPECT_NE(before[k], after[k]) << plan;
          }
        }
        break;
      }
    }
  }
}

/// Every loop that ends is known at its beginning by the event that ends it.
TEST(State, KnowsWhereEachLoopEnds) {
  int loops = 0;
  for (const std::string& plan : walked_plans()) {
    const debug::Recording recording = recording_of(trace_of(plan));
    for (const debug::TaskRun& run : recording.runs) {
      std::vector<std::size_t> open;
      for (std::size_t i = 0; i < run.size(); ++i) {
        const debug::Event& event = run.events()[i];
        if (event.kind == debug::EventKind::goal || event.kind == debug::EventKind::end) {
          for (const std::size_t left : open) EXPECT_EQ(run.events()[left].row, debug::kNone);
          open.clear();
        }
        if (event.kind == debug::EventKind::enter) open.push_back(i);
        if (event.kind != debug::EventKind::exit) continue;
        ASSERT_FALSE(open.empty());
        EXPECT_EQ(run.events()[open.back()].row, i);
        open.pop_back();
        ++loops;
      }
    }
  }
  EXPECT_GT(loops, 500);
}

}  // namespace

}  // namespace rubicon::test
