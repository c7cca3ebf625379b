#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/project_io/project_support.hpp"
#include "tests/unit/project_io/sample_files_io.hpp"

namespace rubicon::test {
namespace {

using namespace project_io;

/// What is changed in an imported plan holds on the way back; all else stays.
class EditedPlan : public testing::Test {
 protected:
  EditedPlan()
      : project_(*read_schedule(sample("house.xml")).project), text_(plan_of(project_).text) {}

  void replace(const std::string& what, const std::string& with) {
    const std::size_t at = text_.find(what);
    ASSERT_NE(at, std::string::npos) << what << " in\n" << text_;
    text_.replace(at, what.size(), with);
  }

  Project back() { return project_of_plan(text_).project.value_or(Project{}); }

  Project project_;
  std::string text_;
};

TEST_F(EditedPlan, durations) {
  replace("takes 24 h;", "takes 30 h;");
  project_.tasks[2].duration.seconds = 30 * 3600;
  Project changed = back();
  // Half of the new duration is another lag than the one in the plan: the plan holds.
  EXPECT_EQ(changed.tasks[4].after[0].lag, 28 * 3600);
  EXPECT_EQ(changed.tasks[4].after[0].format, (TimeFormat{TimeUnit::hours, true, false}));
  changed.tasks[4].after[0] = project_.tasks[4].after[0];
  EXPECT_TRUE(changed == project_);
}

TEST_F(EditedPlan, lags_and_types_of_links) {
  replace("ausharten FS + 24 h", "ausharten SS + 6 h");
  project_.tasks[4].after[1] = {3, LinkType::SS, 6 * 3600, {TimeUnit::hours, true, false}};
  EXPECT_TRUE(back() == project_);
}

TEST_F(EditedPlan, links_taken_out) {
  replace("after decke;", "");
  project_.tasks[6].after.clear();
  EXPECT_TRUE(back() == project_);
}

TEST_F(EditedPlan, dates) {
  replace("after plan_begins FS + 1176 h", "after plan_begins FS + 1200 h");
  project_.tasks[8].constraint_date.text = "2026-04-21 07:00";
  EXPECT_TRUE(back() == project_);
  replace("after plan_begins FS + 1200 h, ausbau_begins", "after ausbau_begins");
  project_.tasks[8].constraint = Constraint::as_soon_as_possible;
  project_.tasks[8].constraint_date.text = "";
  EXPECT_TRUE(back() == project_);
}

TEST_F(EditedPlan, calendars_and_crews) {
  replace("mon-tue 07:00-12:00", "mon-tue 06:00-12:00");
  replace("size 3;", "size 4;");
  replace("cost 165 per h;", "cost 240 per h;");
  const Project changed = back();
  EXPECT_EQ(changed.calendars[0].week[0]->front().from, 6 * 60);
  EXPECT_EQ(changed.calendars[0].name, "Baustelle");
  EXPECT_EQ(changed.resources[0].max_units, 4);
  EXPECT_EQ(changed.resources[0].standard_rate, 60);
  EXPECT_EQ(changed.tasks, project_.tasks);
}

TEST_F(EditedPlan, new_tasks_come_behind_the_one_before_them) {
  replace("  task ausharten {",
          "  task extra { by maurer; takes 2 h; after fundament; }\n  task ausharten {");
  const Project changed = back();
  ASSERT_EQ(changed.tasks.size(), 12u);
  EXPECT_EQ(changed.tasks[3].name, "extra");
  EXPECT_EQ(changed.tasks[3].level, 2);
  EXPECT_EQ(changed.tasks[3].uid, 11);
  EXPECT_EQ(changed.tasks[3].after.at(0).predecessor, 2);
  EXPECT_EQ(changed.assignments.back().task, 11);
  EXPECT_EQ(changed.assignments.back().resource, 1);
}

TEST_F(EditedPlan, tasks_taken_out_are_gone_with_their_links) {
  replace("  task rohbau_fertig {\n    takes 0 s;\n    after decke;\n  }\n", "");
  replace(", rohbau_fertig;", ";");
  const Project changed = back();
  EXPECT_EQ(changed.tasks.size(), 10u);
  EXPECT_EQ(changed.tasks[6].name, "Ausbau");
}

TEST_F(EditedPlan, a_plan_without_import_block_goes_out_as_well) {
  const Reading reading = project_of_plan(
      "plan p { start_at \"2026-03-02 07:00\"; calendar c { mon-fri 07:00-15:00; off 2026-05-01; "
      "}\n"
      "crew a { size 2; cost 50 per h; calendar c; } crew b;\n"
      "task dig { by a; takes 1 h; takes 30 min; }\n"
      "task done { takes 0 s; after dig SS + 2 h; priority 2; zone box(0, 0, 0, 1, 1, 1); } }");
  ASSERT_TRUE(reading.project);
  const Project& project = *reading.project;
  EXPECT_EQ(project.name, "p");
  EXPECT_EQ(project.start.text, "2026-03-02 07:00");
  EXPECT_EQ(project.calendars.at(0).exceptions.at(0).first, "2026-05-01");
  EXPECT_EQ(project.resources.at(0).calendar, project.calendars[0].uid);
  EXPECT_EQ(project.tasks.at(0).duration.seconds, 5400);
  EXPECT_TRUE(project.tasks.at(1).milestone);
  EXPECT_EQ(project.tasks[1].after.at(0).lag, 7200);
  EXPECT_TRUE(project.tasks[1].after[0].format.elapsed);
  EXPECT_EQ(project.assignments.size(), 1u);
  EXPECT_TRUE(reading.says("I09", "the priority of task 'done'"));
  EXPECT_TRUE(reading.says("I09", "zones"));
}

TEST_F(EditedPlan, a_not_before_is_a_start_no_earlier_than) {
  for (const char* start : {"start_at \"2026-03-02 07:00\";", ""}) {
    const Reading reading =
        project_of_plan(fmt::format("plan p {{ {} crew a; task now {{ by a; takes 1 h; }}\n"
                                    "task later {{ by a; takes 1 h; not_before 50 h; }}\n"
                                    "task after {{ by a; takes 1 h; not_before 180090 s; }} }}",
                                    start));
    ASSERT_TRUE(reading.project);
    const Project& project = *reading.project;
    const bool dated = *start != 0;
    EXPECT_EQ(project.start.text, dated ? "2026-03-02 07:00" : "2024-01-01 00:00");
    EXPECT_EQ(reading.says("I09", "the plan has no start_at"), !dated);
    EXPECT_EQ(project.tasks.at(0).constraint, Constraint::as_soon_as_possible);
    for (const std::size_t i : {1u, 2u}) {
      EXPECT_EQ(project.tasks.at(i).constraint, Constraint::start_no_earlier_than);
    }
    EXPECT_EQ(project.tasks[1].constraint_date.text,
              dated ? "2026-03-04 09:00" : "2024-01-03 02:00");
    EXPECT_EQ(project.tasks[2].constraint_date.text,
              dated ? "2026-03-04 09:01:30" : "2024-01-03 02:01:30");
    const std::string back = plan_of(project).text;
    EXPECT_NE(back.find("after plan_begins FS + 50 h;"), std::string::npos) << back;
    EXPECT_NE(back.find("after plan_begins FS + 180090 s;"), std::string::npos) << back;
  }
}

TEST_F(EditedPlan, a_not_before_joins_the_constraint_that_was_carried) {
  const std::string link = "after plan_begins FS + 1176 h";  // 2026-04-20 07:00
  replace(link, "not_before \"2026-04-19 07:00\"; " + link);
  EXPECT_TRUE(back() == project_);
  replace("2026-04-19 07:00\"; " + link, "2026-04-21 08:30\"; " + link);
  const Reading reading = project_of_plan(text_);
  ASSERT_TRUE(reading.project);
  project_.tasks[8].constraint_date.text = "2026-04-21 08:30";
  EXPECT_TRUE(*reading.project == project_);
  EXPECT_TRUE(reading.said.empty()) << testing::PrintToString(reading.said);

  // A date for the finish gives way, and that is told.
  Project other;
  other.start.text = "2026-03-02 07:00";
  Task task;
  task.uid = task.id = 1;
  task.name = "roof";
  task.duration.seconds = 3600;
  task.constraint = Constraint::finish_no_earlier_than;
  task.constraint_date.text = "2026-03-04 07:00";
  other.tasks = {task};
  std::string text = plan_of(other).text;
  const std::string takes = "takes 1 h;";
  text.replace(text.find(takes), takes.size(), takes + " not_before 1 h;");
  const Reading replaced = project_of_plan(text);
  ASSERT_TRUE(replaced.project);
  EXPECT_EQ(replaced.project->tasks.at(0).constraint, Constraint::start_no_earlier_than);
  EXPECT_EQ(replaced.project->tasks[0].constraint_date.text, "2026-03-02 08:00");
  EXPECT_TRUE(replaced.says("I09", "the other constraint of task 'roof'"));
}

TEST_F(EditedPlan, dates_that_are_too_far_for_a_lag_come_back_as_not_before) {
  const Reading reading = project_of_plan(
      "plan p { start_at \"2026-03-02 07:00\"; task near { takes 1 h; not_before \"2029-05-02 "
      "07:00\"; }\n"
      "task far { takes 1 h; not_before \"2031-03-02 07:30\"; } }");
  ASSERT_TRUE(reading.project);
  const Planned plan = plan_of(*reading.project);
  EXPECT_EQ(plan.mistakes, "") << plan.text;
  EXPECT_NE(plan.text.find("not_before \"2031-03-02 07:30\";"), std::string::npos) << plan.text;
  EXPECT_EQ(plan.text.find("not_before \"2029"), std::string::npos) << plan.text;
  const Reading back = project_of_plan(plan.text);
  ASSERT_TRUE(back.project);
  EXPECT_EQ(back.project->tasks, reading.project->tasks);
  // What no plan can say is told.
  Project never = *reading.project;
  never.tasks.at(1).constraint_date.text = "2199-01-01 00:00";
  const Planned told = plan_of(never);
  EXPECT_EQ(told.mistakes, "") << told.text;
  EXPECT_THAT(told.said, testing::Contains(testing::HasSubstr("the date of 'far', 2199-01-01")));
}

// A schedule has the rate of one of a crew: 123 / 7 * 7 is 123.00000000000001.
TEST_F(EditedPlan, rates_of_crews_come_back_without_rounding) {
  const Reading reading = project_of_plan(
      "plan p { start_at \"2026-03-02 07:00\"; crew gang { size 7; cost 123 per h; }\n"
      "task a { by gang; takes 1 h; } }");
  ASSERT_TRUE(reading.project);
  EXPECT_THAT(plan_of(*reading.project).text, testing::HasSubstr("cost 123 per h;"));
}

TEST_F(EditedPlan, people_of_a_crew_are_units) {
  const Reading reading = project_of_plan(
      "plan p { start_at \"2026-03-02 07:00\"; crew gang { size 4; cost 90 per h; } crew two { "
      "size "
      "2; }\n"
      "task part { by gang; takes 1 h; needs 2 gang; } task all { by gang, two; takes 1 h; } }");
  ASSERT_TRUE(reading.project);
  const Project& project = *reading.project;
  ASSERT_EQ(project.assignments.size(), 3u);
  EXPECT_EQ(project.resources.at(0).max_units, 4);
  EXPECT_EQ(project.assignments[0].units, 2);
  EXPECT_EQ(project.assignments[1].units, 4);
  EXPECT_EQ(project.assignments[2].units, 2);
  EXPECT_EQ(project.resources.at(0).standard_rate, 22.5);  // of one of them
  EXPECT_TRUE(reading.said.empty());
  // They come back with the plan that is made of the schedule.
  const Reading back = project_of_plan(plan_of(project).text);
  ASSERT_TRUE(back.project);
  EXPECT_EQ(back.project->assignments, project.assignments);
  EXPECT_EQ(back.project->resources, project.resources);
}

TEST_F(EditedPlan, what_a_schedule_has_no_word_for_is_listed_by_kind) {
  const Reading reading = project_of_plan(
      "plan p { start_at \"2026-03-02 07:00\"; overhead 100 per day;\n"
      "calendar day { mon-fri 07:00-16:00; lost 0.1; } crew x { calendar day; rental 10 per day; "
      "}\n"
      "crew y { mobilisation 5; overtime 1.5; } pool people { of x, y; }\n"
      "for i from 1 to 6 { task t[i] { by people; takes uniform(1 h, 2 h); priority i; } }\n"
      "task u { by same as t[1]; takes 1 h; after t[1]; priority 1; } }");
  ASSERT_TRUE(reading.project);
  EXPECT_THAT(
      reading.said,
      testing::UnorderedElementsAre(
          testing::HasSubstr("the overhead of the plan is left out"),
          testing::HasSubstr("the lost days of calendar 'day' are left out"),
          testing::HasSubstr("the rental of 'x' is left out"),
          testing::HasSubstr("the mobilisation of 'y' is left out"),
          testing::HasSubstr("the overtime of 'y' is left out"),
          testing::HasSubstr("the priority of tasks 't_1', 't_2', 't_3' and 4 more is left out"),
          testing::HasSubstr(
              "the choice of who does tasks 't_1', 't_2', 't_3' and 3 more is left out"),
          testing::HasSubstr("'same as' of task 'u' is left out"),
          testing::HasSubstr(
              "the spread of the durations of tasks 't_1', 't_2', 't_3' and 3 more")));
  for (const std::string& each : reading.said) EXPECT_EQ(each.substr(0, 3), "I09") << each;
}

TEST_F(EditedPlan, imports_of_other_things_are_left_alone) {
  replace("  import \"schedule.xml\" as schedule {",
          "  import \"model.ifc\" as schedules { storey \"{\"; match a { b; } }\n"
          "  import \"schedule.xml\" as schedule {");
  const Reading reading = project_of_plan(text_);
  ASSERT_TRUE(reading.project);
  EXPECT_TRUE(*reading.project == project_);
  EXPECT_TRUE(reading.said.empty());
}

TEST_F(EditedPlan, a_broken_import_block_is_told_and_harms_nothing) {
  replace("project house_garage", "projekt house_garage");
  replace("priority 700", "priority lots");
  replace("\"2026-03-14=", "\"2026-03-99=");
  replace("type \"SS\"", "type \"XX\"");
  const Reading reading = project_of_plan(text_);
  ASSERT_TRUE(reading.project);
  EXPECT_EQ(reading.project->tasks.size(), 11u);
  EXPECT_TRUE(reading.says("I10", "'projekt' in this import is not understood"));
  EXPECT_TRUE(reading.says("I10", "the value of 'priority'"));
  EXPECT_TRUE(reading.says("I10", "'exceptions'"));
  EXPECT_TRUE(reading.says("I10", "'link'"));
}

TEST_F(EditedPlan, what_a_schedule_cannot_say_so_finely_is_rounded_and_told) {
  const Reading reading = project_of_plan(
      "plan lags { crew c; task a { by c; takes 100 s; } task b { by c; takes 0.4 s; after a + 5 "
      "s; }"
      "task d { by c; takes 2.5 s; after b + 11 s; } task e { by c; takes 10 s; after d - 5 s; }"
      "task f { by c; takes 1 h; after e + 12 s; } }");
  ASSERT_TRUE(reading.project);
  std::vector<std::int64_t> lags;
  for (const Task& task : reading.project->tasks) {
    for (const Link& link : task.after) lags.push_back(link.lag);
  }
  EXPECT_EQ(lags, (std::vector<std::int64_t>{6, 12, -6, 12}));
  EXPECT_TRUE(reading.says("I09", "the lag of 5 s from 'a' to 'b' is written as 6 s"));
  EXPECT_TRUE(reading.says("I09", "(2 more like it)"));
  EXPECT_TRUE(
      reading.says("I09", "the durations of tasks 'b' and 'd' are rounded to whole seconds"));
  EXPECT_EQ(reading.said.size(), 2u);
}

}  // namespace
}  // namespace rubicon::test
