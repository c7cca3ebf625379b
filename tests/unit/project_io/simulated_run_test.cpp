#include "src/exchange/project_io/simulated_run.hpp"

#include <gtest/gtest.h>

namespace rubicon::project_io {
namespace {

SimulatedTask done(int from, int to) {
  SimulatedTask task;
  task.done = true;
  task.start_seconds = from;
  task.finish_seconds = to;
  task.start.text = "2026-03-02 07:00:0" + std::to_string(from);
  task.finish.text = "2026-03-02 07:00:0" + std::to_string(to);
  task.note = "done";
  return task;
}

SimulatedTask refused() {
  SimulatedTask task;
  task.note = "refused";
  return task;
}

Project one_line(int level = 1) {
  Project project;
  Task& task = project.tasks.emplace_back();
  task.uid = 7;
  task.level = level;
  task.notes = "by hand";
  task.duration.seconds = 3600;
  Assignment& assignment = project.assignments.emplace_back();
  assignment.task = 7;
  return project;
}

TEST(SimulatedRun, PutsATaskWhereItStood) {
  Project project = one_line();
  SimulatedRun run;
  run.start.text = "2026-03-02 07:00:00";
  run.tasks["pour"] = done(2, 5);
  take_run(run, {{"pour", {}}}, project);
  const Task& task = project.tasks[0];
  EXPECT_TRUE(task.manual);
  EXPECT_EQ(task.start.text, "2026-03-02 07:00:02");
  EXPECT_EQ(task.finish.text, "2026-03-02 07:00:05");
  EXPECT_EQ(task.duration.seconds, 3);
  EXPECT_TRUE(task.format.elapsed);
  EXPECT_EQ(task.constraint, Constraint::start_no_earlier_than);
  EXPECT_EQ(task.constraint_date, task.start);
  EXPECT_EQ(task.notes, "by hand\ndone");
  EXPECT_EQ(project.assignments[0].start, task.start);
  EXPECT_EQ(project.assignments[0].finish, task.finish);
  EXPECT_EQ(project.start, run.start);
}

TEST(SimulatedRun, LeavesWhatWasNotDoneAsItIsPlanned) {
  Project project = one_line();
  SimulatedRun run;
  run.tasks["pour"] = refused();
  take_run(run, {{"pour", {}}}, project);
  EXPECT_FALSE(project.tasks[0].manual);
  EXPECT_EQ(project.tasks[0].duration.seconds, 3600);
  EXPECT_EQ(project.tasks[0].notes, "by hand\nrefused");
  EXPECT_TRUE(project.assignments[0].start.text.empty());
}

TEST(SimulatedRun, GoesFromTheBeginToTheLastPart) {
  Project project = one_line();
  SimulatedRun run;
  run.tasks["walls_begins"] = done(1, 1);
  run.tasks["walls_ends"] = done(4, 4);
  run.tasks["set_a"] = done(1, 3);
  run.tasks["set_b"] = done(3, 6);
  run.tasks["set_c"] = refused();
  take_run(run, {{"walls", {"set_a", "set_b", "set_c"}}}, project);
  EXPECT_EQ(project.tasks[0].start.text, "2026-03-02 07:00:01");
  EXPECT_EQ(project.tasks[0].finish.text, "2026-03-02 07:00:06");
  EXPECT_EQ(project.tasks[0].duration.seconds, 5);
  EXPECT_EQ(project.tasks[0].notes, "by hand\nrubicon: 2 of 3 parts done");
}

TEST(SimulatedRun, TellsWhatHoldsUpALineInParts) {
  Project project = one_line();
  SimulatedRun run;
  run.tasks["walls_begins"] = done(1, 1);
  run.tasks["walls_ends"] = refused();
  run.tasks["set_a"] = done(1, 3);
  run.tasks["set_b"] = refused();
  take_run(run, {{"walls", {"set_a", "set_b"}}}, project);
  EXPECT_FALSE(project.tasks[0].manual);
  EXPECT_EQ(project.tasks[0].notes, "by hand\nrefused; 1 of 2 parts done");
}

TEST(SimulatedRun, LeavesHeadingsAlone) {
  Project project = one_line();
  Task below;
  below.uid = 8;
  below.level = 2;
  project.tasks.push_back(below);
  SimulatedRun run;
  run.tasks["storey_begins"] = run.tasks["storey_ends"] = done(1, 2);
  take_run(run, {{"storey", {}}, {"", {}}}, project);
  EXPECT_FALSE(project.tasks[0].manual);
  EXPECT_EQ(project.tasks[0].notes, "by hand");
}

}  // namespace
}  // namespace rubicon::project_io
