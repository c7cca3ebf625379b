// Forward and back are one walk: each place looks the same from both sides.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "tests/unit/debug/direct_replay.hpp"
#include "tests/unit/debug/shipped_traces.hpp"

namespace rubicon::test {

namespace {

/// All that can be seen at a place.
struct Seen {
  std::string task;
  debug::TaskState state;
  std::string shown;
  bool operator==(const Seen&) const = default;
};

Seen look(debug::Session& session) {
  Seen seen{session.recording().texts[session.run().name()], session.state(), {}};
  for (const char* command : {"info", "where", "print", "config", "list"}) {
    seen.shown += session.execute(command);
  }
  return seen;
}

/// The places that one command repeated leads through, the first one too.
std::vector<Seen> walk(debug::Session& session, const std::string& command,
                       const std::string& last) {
  std::vector<Seen> places{look(session)};
  while (session.execute(command) != last) places.push_back(look(session));
  return places;
}

class Walk : public testing::TestWithParam<std::string> {};

TEST_P(Walk, StepsAndStepsBackMeetTheSamePlaces) {
  debug::Session session = session_of(trace_of(GetParam()));
  const std::vector<Seen> forward = walk(session, "step", "this is the end\n");
  std::vector<Seen> back = walk(session, "back", "this is the beginning\n");
  std::reverse(back.begin(), back.end());
  ASSERT_EQ(forward.size(), back.size());
  for (std::size_t i = 0; i < forward.size(); ++i) {
    ASSERT_EQ(forward[i].state, back[i].state) << i;
    ASSERT_EQ(forward[i].shown, back[i].shown) << i;
    ASSERT_EQ(forward[i].task, back[i].task) << i;
  }
}

TEST_P(Walk, StepsStopAtEveryTryAndWaitAndAtBothEndsOfEachTask) {
  std::size_t expected = 0;
  for (const DirectRun& run : direct_runs(trace_of(GetParam()))) {
    expected += 2;
    for (const auto& record : run.records) {
      expected += record.at("type") == "try" || record.at("type") == "wait" ? 1 : 0;
    }
  }
  debug::Session session = session_of(trace_of(GetParam()));
  std::size_t stops = 1;
  while (session.execute("step") != "this is the end\n") ++stops;
  EXPECT_EQ(stops, expected);
}

TEST_P(Walk, RecordsForwardAndBackMeetTheSamePlaces) {
  debug::Session session = session_of(trace_of(GetParam()));
  const auto positions = [&](const std::string& command, const std::string& last) {
    std::vector<debug::TaskState> states{session.state()};
    while (session.execute(command) != last) states.push_back(session.state());
    return states;
  };
  const auto forward = positions("record", "this is the end\n");
  auto back = positions("record -1", "this is the beginning\n");
  std::reverse(back.begin(), back.end());
  EXPECT_TRUE(forward == back);
}

TEST_P(Walk, ManyStepsAtOnceAreAsManySteps) {
  debug::Session one = session_of(trace_of(GetParam()));
  debug::Session many = session_of(trace_of(GetParam()));
  for (const int count : {1, 7, 50, 3}) {
    for (int i = 0; i < count; ++i) one.execute("step");
    many.execute("step " + std::to_string(count));
    EXPECT_EQ(one.state(), many.state());
  }
  for (const int count : {2, 30, 8}) {
    for (int i = 0; i < count; ++i) one.execute("back");
    many.execute("back " + std::to_string(count));
    EXPECT_EQ(one.state(), many.state());
  }
}

TEST_P(Walk, RunToATryIsTheStepWithItsNumber) {
  debug::Session session = session_of(trace_of(GetParam()));
  const int last = session.run().last().n;
  for (int n = 1; n <= last; n += 1 + last / 50) {
    session.execute("run to " + std::to_string(n));
    ASSERT_EQ(session.state().n, n);
    session.execute("back");
    ASSERT_EQ(session.state().n, n - 1);
  }
}

/// `next` and `out` end where the loops of the state say that fewer run.
TEST_P(Walk, NextAndOutLeaveLoops) {
  debug::Session session = session_of(trace_of(GetParam()));
  session.execute("step");
  int left = 0;
  for (int i = 0; i < 400; ++i) {
    const debug::TaskState before = session.state();
    const debug::TaskRun* run = &session.run();
    const bool out = i % 3 == 2;
    const std::string said = session.execute(out ? "out" : "next");
    if (said == "this is the end\n") break;
    const std::size_t wanted = out ? 2 : 1;
    if (&session.run() == run && before.loops.size() >= wanted) {
      ASSERT_LE(session.state().loops.size(), before.loops.size() - wanted);
      ASSERT_GT(session.state().position, before.position);
      ++left;
    }
    session.execute("step");
  }
  EXPECT_GT(left, 0);
}

std::string name_of(const testing::TestParamInfo<std::string>& plan) {
  std::string name;
  for (const char c : plan.param)
    name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(ShippedPlans, Walk, testing::ValuesIn(walked_plans()), name_of);

}  // namespace

}  // namespace rubicon::test
