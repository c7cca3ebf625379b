#include "src/exchange/project_io/plan_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "interpreter/parse/parse.hpp"
#include "src/exchange/project_io/identifiers.hpp"
#include "tests/unit/project_io/project_support.hpp"
#include "tests/unit/project_io/sample_files_io.hpp"

namespace rubicon::test {
namespace {

using namespace project_io;
using testing::HasSubstr;
using testing::Not;

class PlanText : public testing::Test {
 protected:
  PlanText() : planned_(plan_of(*read_schedule(sample("house.xml")).project)) {}

  bool says(const std::string& words) const {
    for (const std::string& each : planned_.said) {
      if (each.starts_with("I08 ") && each.find(words) != std::string::npos) return true;
    }
    return false;
  }

  Planned planned_;
};

TEST_F(PlanText, check_takes_it_and_it_is_in_canonical_form) {
  EXPECT_EQ(planned_.mistakes, "");
  EXPECT_EQ(interpreter::format_text(planned_.text, interpreter::TextKind::plan), planned_.text);
}

TEST_F(PlanText, settings_calendars_and_crews) {
  EXPECT_THAT(planned_.text, HasSubstr("plan house_garage {\n  start_at \"2026-03-02 07:00\";\n"));
  EXPECT_THAT(planned_.text,
              HasSubstr("  calendar baustelle {\n    mon-tue 07:00-12:00, 12:30-15:30;\n"
                        "    off 2026-04-03, 2026-04-04, 2026-04-05, 2026-04-06, 2026-05-01;\n"));
  EXPECT_THAT(planned_.text, HasSubstr("  calendar kran {\n    mon 07:00-12:00, 12:30-15:30;\n"));
  EXPECT_THAT(planned_.text, Not(HasSubstr("calendar nie {")));
  EXPECT_THAT(
      planned_.text,
      HasSubstr("  crew maurer {\n    size 3;\n    cost 165 per h;\n    calendar baustelle;\n  }"));
  EXPECT_THAT(planned_.text,
              HasSubstr("  crew kran {\n    cost 1200.1 per h;\n    calendar kran;\n  }"));
  EXPECT_THAT(planned_.text, Not(HasSubstr("crew beton")));
}

TEST_F(PlanText, tasks_links_and_headings) {
  EXPECT_THAT(planned_.text, HasSubstr("// = Rohbau\n"));
  EXPECT_THAT(
      planned_.text,
      HasSubstr("task fundament {\n    by maurer;\n    takes 24 h;\n    needs 2 maurer;\n  }"));
  // Elapsed time needs no shifts; it is no crew's work.
  EXPECT_THAT(planned_.text, HasSubstr("    takes 72 h;\n    after fundament;\n  }"));
  // Half of 24 h of work is one working day and a half: 24 h and 4 h.
  EXPECT_THAT(planned_.text, HasSubstr("after fundament SS + 28 h, ausharten FS + 24 h;"));
  // A calendar of its own beside those of its crews.
  EXPECT_THAT(planned_.text, HasSubstr("by kran, maurer, crew_wande;"));
  EXPECT_THAT(planned_.text,
              HasSubstr("takes 1815 s;\n    after fundament SF + 48 h, wande FF - 2 h;"));
  EXPECT_THAT(planned_.text,
              HasSubstr("task rohbau_fertig {\n    takes 0 s;\n    after decke;\n  }"));
}

TEST_F(PlanText, headings_that_are_linked_become_milestones) {
  EXPECT_THAT(planned_.text,
              HasSubstr("task rohbau_ends {\n    takes 0 s;\n    after fundament, ausharten, "
                        "wande, decke, rohbau_fertig;\n  }"));
  EXPECT_THAT(
      planned_.text,
      HasSubstr("task ausbau_begins {\n    takes 0 s;\n    after rohbau_ends FS + 24 h;\n  }"));
}

TEST_F(PlanText, dates_become_lags_behind_the_beginning) {
  // 2026-03-02 07:00 to 2026-04-20 07:00: 49 days.
  EXPECT_THAT(
      planned_.text,
      HasSubstr(
          "after plan_begins FS + 1176 h, ausbau_begins;\n    // not before 2026-04-20 07:00"));
  EXPECT_THAT(planned_.text, HasSubstr("after plan_begins FF +"));
  EXPECT_THAT(planned_.text, HasSubstr("// not finished before 2026-05-11 15:30"));
}

TEST_F(PlanText, levelled_a_resource_is_one_crew_whatever_its_size) {
  interpreter::Diagnostics said;
  const std::string text = plan_text(*read_schedule(sample("house.xml")).project, "house.xml", said,
                                     {}, Levelling::resources);
  EXPECT_THAT(text, HasSubstr("  crew maurer {\n    size 3;\n"));
  EXPECT_THAT(text, HasSubstr("    needs 2 maurer;\n"));
}

TEST_F(PlanText, names_are_unique_and_readable) {
  // Of two walls the second is told apart by its heading; a name without a letter by its number.
  EXPECT_THAT(planned_.text, HasSubstr("task wande {"));
  EXPECT_THAT(planned_.text, HasSubstr("  task ausbau_wande {\n    name \"Wände\";\n"));
  EXPECT_THAT(planned_.text, HasSubstr("  task row_10 {\n    name \"日本\";\n"));
}

TEST_F(PlanText, lists_where_the_plan_goes_by_less) {
  for (const char* words :
       {"1 days of calendar 'Baustelle' have hours of their own", "calendar 'Nie' never works",
        "resource 'Beton' is a material", "task 'Garage' is not active",
        "0.5 of 'Maurer' are on 'Wände': in the plan 1, of whom the cost is",
        "counts working time there", "link from 'Wände' to 'Garage' is carried along"}) {
    EXPECT_TRUE(says(words)) << words << "\n" << testing::PrintToString(planned_.said);
  }
}

TEST(PlanTextLimits, long_and_late_things_are_said_as_far_as_a_plan_can) {
  Project project;
  project.start.text = "2026-03-02 07:00";
  Task first;
  first.uid = 1;
  first.name = "a";
  first.duration.seconds = 200000000;
  first.constraint = Constraint::as_late_as_possible;
  Task second = first;
  second.uid = 2;
  second.after.push_back({1, LinkType::FS, 300000000, {TimeUnit::days, true, false}});
  Task heading = first;
  heading.uid = 3;
  Task below = first;
  below.uid = 4;
  below.level = 2;
  below.after.push_back({3, LinkType::FS, 0, {}});
  heading.after.push_back({1, LinkType::FF, 0, {}});
  second.after.push_back({3, LinkType::SS, 0, {}});
  below.after.clear();
  project.tasks = {first, second, heading, below};
  Resource resource;
  resource.uid = 1;
  resource.standard_rate = 12;
  resource.rate_format = 8;
  project.resources = {resource};
  Calendar calendar;
  calendar.uid = 1;
  for (auto& day : calendar.week) day = DayTimes{{0, 60}};
  calendar.exceptions = {{"2026-03-02", "2099-12-31", {}, ""}};
  project.calendars = {calendar};
  const Planned planned = plan_of(project);
  EXPECT_EQ(planned.mistakes, "");
  for (const char* words :
       {"takes longer than a plan can say", "is longer than a plan can say",
        "knows no latest dates", "is bound to the start of", "a heading's end is bound",
        "is not a cost by time", "too many days off"}) {
    EXPECT_THAT(planned.said, testing::Contains(HasSubstr(words)));
  }
}

/// One task of 8 h and those on it, with their calendars; calendar 1 is day, 2 is night, 3 is any.
Project with_hours(std::int64_t task_calendar, const std::vector<std::int64_t>& of_resources) {
  Project project;
  project.start.text = "2026-03-02 00:00";
  const DayTimes hours[] = {{{480, 960}}, {{1080, 1320}}, {{0, 1440}}};
  for (std::size_t i = 0; i < 3; ++i) {
    Calendar calendar;
    calendar.uid = static_cast<std::int64_t>(i + 1);
    calendar.name = std::vector<std::string>{"day", "night", "any"}[i];
    for (auto& day : calendar.week) day = hours[i];
    project.calendars.push_back(calendar);
  }
  Task task;
  task.uid = 1;
  task.name = "dig";
  task.duration.seconds = 8 * 3600;
  task.calendar = task_calendar;
  project.tasks = {task};
  for (std::size_t i = 0; i < of_resources.size(); ++i) {
    Resource resource;
    resource.uid = static_cast<std::int64_t>(i + 1);
    resource.name = std::string("gang") + std::to_string(i + 1);
    resource.standard_rate = 100;
    resource.rate_format = 2;
    resource.calendar = of_resources[i];
    project.resources.push_back(resource);
    Assignment assignment;
    assignment.uid = resource.uid;
    assignment.task = 1;
    assignment.resource = resource.uid;
    project.assignments.push_back(assignment);
  }
  return project;
}

// Without a calendar its cost would count nights.
TEST(PlanTextHours, a_crew_has_the_hours_of_its_tasks) {
  Project by_itself = with_hours(1, {1});
  by_itself.tasks[0].ignores_resource_calendars = true;
  EXPECT_THAT(plan_of(by_itself).text,
              HasSubstr("crew gang1 {\n    cost 100 per h;\n    calendar day;\n  }"));
  by_itself.resources[0].calendar = 2;
  const std::string at_day = plan_of(by_itself).text;
  EXPECT_THAT(at_day, HasSubstr("crew gang1 {\n    cost 100 per h;\n    calendar day;\n  }"));
  EXPECT_THAT(at_day, HasSubstr("free_crew gang1 calendar 1;"));
  EXPECT_THAT(plan_of(with_hours(1, {3})).text,
              HasSubstr("crew gang1 {\n    cost 100 per h;\n    calendar day;\n  }"));
  EXPECT_THAT(plan_of(with_hours(kNone, {3})).text,
              HasSubstr("crew gang1 {\n    cost 100 per h;\n    calendar any;\n  }"));
}

// Two gangs that relieve each other: together they would never work.
TEST(PlanTextHours, who_has_no_hour_in_common_is_there_in_the_hours_of_the_others) {
  const Planned planned = plan_of(with_hours(kNone, {1, 2}));
  EXPECT_EQ(planned.mistakes, "");
  EXPECT_THAT(planned.text, HasSubstr("crew gang2 {\n    cost 100 per h;\n    calendar day;\n  }"));
  EXPECT_THAT(
      planned.said,
      testing::Contains(HasSubstr("'gang2' has no hour in common with the others on task 'dig'")));
}

TEST(PlanTextLimits, a_date_that_must_hold_is_only_not_before) {
  Project project;
  project.start.text = "2026-03-02 07:00";
  Task task;
  task.uid = 1;
  task.name = "a";
  task.constraint = Constraint::must_start_on;
  task.constraint_date.text = "2026-03-03 07:00";
  project.tasks = {task};
  const Planned planned = plan_of(project);
  EXPECT_THAT(planned.text, HasSubstr("after plan_begins FS + 24 h;"));
  EXPECT_THAT(planned.said, testing::Contains(HasSubstr("'a' must be on 2026-03-03 07:00")));
}

TEST(Identifiers, are_names_of_the_language) {
  Identifiers names;
  EXPECT_EQ(names.make("Höhe 2e verdieping", "x"), "hohe_2e_verdieping");
  EXPECT_EQ(names.make("2e", "x"), "_2e");
  EXPECT_EQ(names.make("chain", "x"), "chain_");
  EXPECT_EQ(names.make("After", "x"), "after_");
  EXPECT_EQ(names.make("  (…) ", "row_3"), "row_3");
  EXPECT_EQ(names.make("Łódź Œuvre ß", "x"), "lodz_ouvre_s");
  EXPECT_EQ(names.make("wall", "x"), "wall");
  EXPECT_EQ(names.make("Wall", "x", "north"), "north_wall");
  EXPECT_EQ(names.make("WALL", "x", "north"), "north_wall_2");
  EXPECT_EQ(names.make("wall", "x"), "wall_2");
  EXPECT_EQ(names.make(std::string(1000, 'a'), "x").size(), 48u);
  EXPECT_EQ(names.make("\xff\xfe", "bad"), "bad");
}

}  // namespace
}  // namespace rubicon::test
