// What the commands say, on a trace that is short enough to read.

#include <gtest/gtest.h>

#include "tests/unit/debug/hand_trace.hpp"
#include "tests/unit/debug/shipped_traces.hpp"

namespace rubicon::test {

namespace {

/// x is moved twice, then barred; y is raised; x arrives.
std::vector<std::string> short_trace() {
  return {
      hand_header(),
      hand_record("goal", R"("k":1,"n":1)"),
      hand_record("set", R"("var":"side","value":-1)"),
      hand_loop("enter"),
      hand_try(1, "x", 2, true, 1, 1, 0),
      hand_record("try", R"("n":2,"command":"move_to","parameter":"x","file":"s.motion","line":2,)"
                         R"("column":3,"ok":false,"reason":"hit","hit":["r.arm","wall"],"t":1,)"
                         R"("q":{"x":1,"y":0})"),
      hand_record("try", R"("n":3,"command":"together","parameter":["x","y"],"file":"s.motion",)"
                         R"("line":3,"column":3,"ok":true,"reason":"","t":2.5,"q":{"x":2,"y":1})"),
      hand_record("wait", R"("n":4,"t":3)"),
      hand_try(5, "x", 2, false, 3, 2, 1, "at goal"),
      hand_loop("exit", R"(,"reached":true,"successes":2)"),
      hand_end(R"("status":"done","reached":true,"tries":5,"accepted":2,"q":{"x":2,"y":1},)"
               R"("t":3)")};
}

TEST(Session, TellsEachStep) {
  debug::Session session = session_of(short_trace());
  EXPECT_EQ(session.opening(), "plan p. 'help' tells the commands.\np  begins  t 0 s\n");
  EXPECT_EQ(session.execute("step"),
            "  waypoint 1 of 1 begins\n"
            "  var(side) = -1\n"
            "  chain begins  s.motion:1\n"
            "p  try 1/5  t 1 s\n"
            "  s.motion:2  move_to(x, 3),\n"
            "  move_to x  0 -> 1  accepted\n");
  EXPECT_EQ(session.execute(""),
            "p  try 2/5  t 1 s\n"
            "  s.motion:2  move_to(x, 3),\n"
            "  move_to x  1  refused: arm of r meets wall\n");
  EXPECT_EQ(session.execute("s"),
            "p  try 3/5  t 2.5 s\n"
            "  s.motion:3  move_dir(y, 1)\n"
            "  together x  1 -> 2,  y  0 -> 1  accepted\n");
  EXPECT_EQ(session.execute("s"), "p  wait 4/5  t 3 s\n  wait  0.5 s\n");
  EXPECT_EQ(session.execute("s"),
            "p  try 5/5  t 3 s\n"
            "  s.motion:2  move_to(x, 3),\n"
            "  move_to x  2  refused: it is there already\n");
  EXPECT_EQ(session.execute("s"),
            "  chain ends reached, 2 successes  s.motion:1\n"
            "p  after 5/5  t 3 s\n"
            "  the motion ends done, 5 tried, 2 accepted\n");
  EXPECT_EQ(session.execute("s"), "this is the end\n");
  EXPECT_EQ(session.execute("back 5"),
            "p  try 1/5  t 1 s\n"
            "  s.motion:2  move_to(x, 3),\n"
            "  move_to x  0 -> 1  accepted\n");
}

TEST(Session, ShowsLoopsVariablesAndConfiguration) {
  debug::Session session = session_of(short_trace());
  EXPECT_EQ(session.execute("where"), "in no loop\n");
  EXPECT_EQ(session.execute("print"), "no variable is set\n");
  session.execute("run to 3");
  EXPECT_EQ(session.execute("where"),
            "#0  chain at s.motion:1: round 2, 3 tried, 2 accepted; ends reached after try 5, 2 "
            "successes\n");
  EXPECT_EQ(session.execute("print"), "var(side) = -1\n");
  EXPECT_EQ(session.execute("print var(side)"), "var(side) = -1\n");
  EXPECT_EQ(session.execute("p y"), "y = 1\n");
  EXPECT_EQ(session.execute("p sde"),
            "no variable that is set and no parameter is called 'sde'; did you mean side?\n");
  EXPECT_EQ(session.execute("config"), "x  1 -> 2\ny  0 -> 1\n");
  session.execute("back");
  EXPECT_EQ(session.execute("config"), "x  1\ny  0\n");
  EXPECT_EQ(session.execute("info"),
            "p  try 2/5  t 1 s\n"
            "  s.motion:2  move_to(x, 3),\n"
            "  move_to x  1  refused: arm of r meets wall\n"
            "  r: motion 1 of 1: going; waypoint 1\n"
            "  2 tried so far, 1 accepted, 0 of them waits; record 5 of 10\n"
            "  in s.motion:2\n");
}

TEST(Session, ListsTheScriptWithTheMarks) {
  debug::Session session = session_of(short_trace());
  session.execute("run to 2");
  session.execute("break 3");
  EXPECT_EQ(session.execute("list"),
            "s.motion\n"
            "       1  chain {\n"
            " ->    2    move_to(x, 3),\n"
            "*      3    move_dir(y, 1)\n"
            "       4  };\n");
  EXPECT_EQ(session.execute("list 9"), "s.motion has 4 lines\n");
  EXPECT_EQ(session.execute("list t.motion:1"),
            "there is no file 't.motion'; did you mean s.motion?\n");
}

TEST(Session, GoesToMomentsTriesAndEndsOfLoops) {
  debug::Session session = session_of(short_trace());
  session.execute("until 0:00:02");
  EXPECT_EQ(session.state().n, 3);
  session.execute("until 0.5");
  EXPECT_EQ(session.state().n, 1);
  EXPECT_EQ(session.execute("until 99"), "this task ends before, at t 3 s\n");
  EXPECT_EQ(session.execute("until noon"), "until when? until T, in seconds or as h:mm:ss\n");
  EXPECT_EQ(session.execute("next"),
            "p  after 5/5  t 3 s\n  s.motion:1  chain {\n  chain ends reached, 2 successes\n");
  EXPECT_EQ(session.execute("next"),
            "p  after 5/5  t 3 s\n  the motion ends done, 5 tried, 2 accepted\n");
  EXPECT_EQ(session.execute("next"), "this is the end\n");
  EXPECT_EQ(session.execute("run to 9"), "there is no try 9 in this task: they are 1 to 5\n");
  EXPECT_EQ(session.execute("run"), "run to what? run to N, the number of a try\n");
  EXPECT_EQ(session.execute("step x"), "'x' is no number of steps\n");
  EXPECT_EQ(session.execute("step -1"), "'-1' is no number of steps\n");
}

TEST(Session, GoesFromTaskToTask) {
  debug::Session session = session_of(trace_of("taskplans/two_cranes.plan"), "set_wall_4");
  EXPECT_EQ(session.execute("task set_slab_1").substr(0, 18), "set_slab_1  begins");
  EXPECT_EQ(session.execute("task 1").substr(0, 18), "set_wall_1  begins");
  EXPECT_EQ(session.execute("task set_wal_1"),
            "no task 'set_wal_1' began; did you mean set_wall_1?\n");
}

TEST(Session, ARejectedTaskSaysThatItDidNotHappen) {
  const auto& lines = trace_of("examples/08_what_cannot_be_done/site.plan");
  const debug::Recording recording = recording_of(lines);
  int undone = 0;
  for (const debug::TaskRun& run : recording.runs) {
    if (!run.undone()) continue;
    ++undone;
    debug::Session session = session_of(lines, recording.texts[run.name()]);
    EXPECT_NE(session.opening().find("what follows did not happen: it is rejected and was undone"),
              std::string::npos);
    do {
      EXPECT_NE(session.execute("info").find("  did not happen\n"), std::string::npos);
    } while (session.execute("step") != "this is the end\n");
  }
  EXPECT_EQ(undone, 2);
}

TEST(Session, SaysWhyThereIsNothingToStepThrough) {
  const auto why = [](const std::vector<std::string>& lines, const std::string& task) {
    return debug::Session::why_not(recording_of(lines), task);
  };
  EXPECT_EQ(why({hand_header("tasks")}, ""),
            "this trace has no steps (its detail is 'tasks'): run again with --trace-detail steps");
  EXPECT_EQ(why({hand_header()}, ""), "no task began: there is nothing to step through");
  EXPECT_EQ(why({hand_header()}, "p"), "'p' never began");
  EXPECT_EQ(why(trace_of("taskplans/two_cranes.plan"), "set_wal_4"),
            "there is no task 'set_wal_4'; did you mean set_wall_4?");
  EXPECT_EQ(why(short_trace(), "p"), "");
  const auto& lines = trace_of("examples/08_what_cannot_be_done/site.plan");
  for (const debug::PlannedTask& task : recording_of(lines).tasks) {
    if (task.result == "not reached") {
      EXPECT_EQ(why(lines, task.name), "'" + task.name + "' never began: " + task.reason);
    }
  }
}

}  // namespace

}  // namespace rubicon::test
