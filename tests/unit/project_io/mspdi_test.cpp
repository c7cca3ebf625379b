#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/exchange/project_io/value_text.hpp"
#include "tests/unit/project_io/project_support.hpp"
#include "tests/unit/project_io/sample_files_io.hpp"

namespace rubicon::test {
namespace {

using namespace project_io;

std::string link(int predecessor, int type, int lag, int format) {
  return fmt::format(
      "<PredecessorLink><PredecessorUID>{}</PredecessorUID><Type>{}</Type><LinkLag>{}</LinkLag>"
      "<LagFormat>{}</LagFormat></PredecessorLink>",
      predecessor, type, lag, format);
}

Reading two_tasks(const std::string& second) {
  return read_schedule(mspdi("<Tasks>" + mspdi_task(1, "a", "<Duration>PT10H0M0S</Duration>") +
                             mspdi_task(2, "b", second) + "</Tasks>"));
}

TEST(Mspdi, reads_the_head_of_a_project) {
  const Reading reading = read_schedule(sample("house.xml"));
  ASSERT_TRUE(reading.project);
  EXPECT_EQ(reading.project->name, "House & garage");
  EXPECT_EQ(reading.project->title, "A \"small\" house");
  EXPECT_EQ(reading.project->start.text, "2026-03-02 07:00");
  EXPECT_EQ(reading.project->currency_symbol, "€");
  EXPECT_EQ(reading.project->calendar, 1);
  EXPECT_EQ(reading.project->tasks.size(), 11u);
  EXPECT_THAT(reading.said, testing::IsEmpty());
}

TEST(Mspdi, reads_every_type_of_link) {
  constexpr std::array<LinkType, 4> kTypes = {LinkType::FF, LinkType::FS, LinkType::SF,
                                              LinkType::SS};
  for (int type = 0; type < 4; ++type) {
    const Reading reading = two_tasks(link(1, type, 0, 7));
    ASSERT_TRUE(reading.project);
    ASSERT_EQ(reading.project->tasks[1].after.size(), 1u);
    EXPECT_EQ(reading.project->tasks[1].after[0].type, kTypes[static_cast<std::size_t>(type)]);
  }
}

TEST(Mspdi, reads_lags_in_every_unit) {
  struct Case {
    int lag, format;
    std::int64_t expected;  // s, or percent
    const char* unit;
  };
  for (const Case& each : std::initializer_list<Case>{{300, 3, 1800, "m"},
                                                      {300, 4, 1800, "em"},
                                                      {1200, 5, 7200, "h"},
                                                      {-1200, 6, -7200, "eh"},
                                                      {4800, 7, 28800, "d"},
                                                      {14400, 8, 86400, "ed"},
                                                      {24000, 9, 144000, "w"},
                                                      {100800, 10, 604800, "ew"},
                                                      {96000, 11, 576000, "mo"},
                                                      {432000, 12, 2592000, "emo"},
                                                      {50, 19, 50, "%"},
                                                      {-25, 20, -25, "e%"},
                                                      {4800, 39, 28800, "d?"},
                                                      {14400, 40, 86400, "ed?"},
                                                      {10, 51, 10, "%?"}}) {
    const Reading reading = two_tasks(link(1, 1, each.lag, each.format));
    ASSERT_TRUE(reading.project);
    const Link& read = reading.project->tasks[1].after.at(0);
    EXPECT_EQ(read.lag, each.expected) << each.format;
    EXPECT_EQ(text_of(read.format), each.unit);
    EXPECT_EQ(mspdi_code(read.format), each.format);
  }
}

TEST(Mspdi, reads_calendars_with_both_forms_of_exceptions) {
  const Reading reading = read_schedule(sample("house.xml"));
  ASSERT_TRUE(reading.project);
  const Calendar& site = reading.project->calendars.at(0);
  EXPECT_EQ(text_of(*site.week[0]), "07:00-12:00,12:30-15:30");  // Monday
  EXPECT_EQ(text_of(*site.week[1]), "07:00-12:00,12:30-15:30");
  EXPECT_EQ(text_of(*site.week[2]), "off");  // not said
  EXPECT_EQ(text_of(*site.week[6]), "off");  // Sunday
  ASSERT_EQ(site.exceptions.size(), 3u);  // the first of May is there twice, and once with a name
  EXPECT_EQ(site.exceptions[0],
            (CalendarException{"2026-03-14", "2026-03-14", {{420, 1440}}, "Samstag"}));
  EXPECT_EQ(site.exceptions[1],
            (CalendarException{"2026-04-03", "2026-04-06", {}, "Ostern | frei"}));
  EXPECT_EQ(site.exceptions[2],
            (CalendarException{"2026-05-01", "2026-05-01", {}, "Tag der Arbeit"}));
  const Calendar& crane = reading.project->calendars.at(1);
  EXPECT_EQ(crane.base, 1);
  EXPECT_FALSE(crane.week[0]);
  EXPECT_EQ(text_of(crane.week[1].value()), "off");
}

TEST(Mspdi, writes_out_exceptions_that_come_again) {
  const auto calendar = [](const std::string& pattern) {
    return read_schedule(mspdi(
        "<Calendars><Calendar><UID>1</UID><Exceptions><Exception><TimePeriod>"
        "<FromDate>2026-03-01T00:00:00</FromDate><ToDate>2027-12-31T23:59:00</ToDate></TimePeriod>"
        "<DayWorking>0</DayWorking>" +
        pattern + "</Exception></Exceptions></Calendar></Calendars>"));
  };
  // Every second week on Wednesdays (the fourth bit), beginning with the week of Sunday 1 March.
  const Reading weekly = calendar("<Type>6</Type><Period>2</Period><DaysOfWeek>8</DaysOfWeek>");
  ASSERT_TRUE(weekly.project);
  const auto& days = weekly.project->calendars[0].exceptions;
  ASSERT_GE(days.size(), 3u);
  EXPECT_EQ(days[0].first, "2026-03-04");
  EXPECT_EQ(days[1].first, "2026-03-18");
  EXPECT_EQ(days[2].first, "2026-04-01");
  const Reading yearly = calendar("<Type>2</Type><Month>11</Month><MonthDay>25</MonthDay>");
  ASSERT_TRUE(yearly.project);
  ASSERT_EQ(yearly.project->calendars[0].exceptions.size(), 2u);
  EXPECT_EQ(yearly.project->calendars[0].exceptions[1].first, "2027-12-25");
  const Reading monthly = calendar("<Type>5</Type>");
  EXPECT_TRUE(monthly.says("I07", "pattern that is not understood"));
}

TEST(Mspdi, reads_outline_milestones_durations_and_constraints) {
  const Reading reading = read_schedule(sample("house.xml"));
  ASSERT_TRUE(reading.project);
  const auto& tasks = reading.project->tasks;
  EXPECT_TRUE(reading.project->is_heading(0));
  EXPECT_TRUE(reading.project->is_heading(1));
  EXPECT_FALSE(reading.project->is_heading(2));
  EXPECT_EQ(tasks[2].level, 2);
  EXPECT_EQ(tasks[2].duration.seconds, 24 * 3600);
  EXPECT_EQ(tasks[2].finish.text, "2026-03-04 15:30:30");
  EXPECT_EQ(tasks[2].notes, "Bewehrung \"B500\" & Beton;\nsecond line { } ");
  EXPECT_TRUE(tasks[3].format.elapsed);
  EXPECT_TRUE(tasks[4].format.estimated);
  EXPECT_TRUE(tasks[6].milestone);
  EXPECT_EQ(tasks[8].constraint, Constraint::start_no_earlier_than);
  EXPECT_EQ(tasks[8].deadline.text, "2026-05-20 15:30");
  EXPECT_FALSE(tasks[9].active);
}

TEST(Mspdi, reads_resources_and_assignments) {
  const Reading reading = read_schedule(sample("house.xml"));
  ASSERT_TRUE(reading.project);
  const auto& resources = reading.project->resources;
  ASSERT_EQ(resources.size(), 4u);
  EXPECT_EQ(resources[0].max_units, 3);
  EXPECT_EQ(resources[1].rate_format, 3);
  EXPECT_EQ(resources[2].type, ResourceType::material);
  EXPECT_EQ(resources[3].type, ResourceType::cost);
  ASSERT_EQ(reading.project->assignments.size(), 5u);
  EXPECT_EQ(reading.project->assignments[0].work.seconds, 48 * 3600);
  EXPECT_EQ(reading.project->assignments[4].resource, kNone);
}

TEST(Mspdi, lists_what_it_does_not_understand_once_a_kind_at_its_place) {
  const Reading reading = read_schedule(
      mspdi("\n<Tasks>" + mspdi_task(1, "a", "<Hyperlink>http://x</Hyperlink>") +
            mspdi_task(2, "b", "<Hyperlink>http://y</Hyperlink><Empty/><IsNull>0</IsNull>") +
            "</Tasks><Surprise><Inner>1</Inner></Surprise>"));
  EXPECT_THAT(reading.said,
              testing::ElementsAre("I07 3:51 Hyperlink of Task is not taken over, here 'http://x' "
                                   "(1 more like it)",
                                   testing::HasSubstr("Surprise of Project is not taken over")));
}

TEST(Mspdi, leaves_wrong_values_out_and_says_so) {
  const Reading reading = two_tasks(
      "<Start>2026-02-30T07:00:00</Start><Work>a day</Work><Priority>high</Priority>"
      "<DurationFormat>99</DurationFormat><ConstraintType>12</ConstraintType><Milestone>no</"
      "Milestone>"
      "<PercentComplete>1e99</PercentComplete><FixedCost>nan</FixedCost>" +
      link(1, 9, 0, 7));
  ASSERT_TRUE(reading.project);
  for (const char* word : {"Start of Task, found '2026-02-30T07:00:00'", "Work of Task",
                           "Priority of Task", "DurationFormat", "ConstraintType", "Milestone",
                           "PercentComplete", "FixedCost", "type of link"}) {
    EXPECT_TRUE(reading.says("I03", word)) << word;
  }
  EXPECT_EQ(reading.project->tasks[1].after[0].type, LinkType::FS);
}

TEST(Mspdi, a_task_whose_duration_cannot_be_read_is_an_error_a_heading_is_none) {
  const Reading task = two_tasks("<Duration>a day</Duration>");
  EXPECT_FALSE(task.project);
  EXPECT_TRUE(task.says("I03", "Duration of Task, found 'a day'"));
  EXPECT_TRUE(two_tasks("<Summary>1</Summary><Duration>a day</Duration>").project);
}

TEST(Mspdi, gives_new_numbers_to_doubles) {
  const Reading reading =
      read_schedule(mspdi("<Tasks>" + mspdi_task(4, "a", "") + mspdi_task(4, "b", "") +
                          "<Task><Name>c</Name></Task></Tasks>"));
  ASSERT_TRUE(reading.project);
  EXPECT_EQ(reading.project->tasks[1].uid, 5);
  EXPECT_EQ(reading.project->tasks[2].uid, 6);
  EXPECT_TRUE(reading.says("I04", "which is taken"));
}

TEST(Mspdi, takes_out_references_to_nothing) {
  const Reading reading =
      read_schedule(mspdi("<CalendarUID>9</CalendarUID><Tasks>" +
                          mspdi_task(1, "a", "<CalendarUID>3</CalendarUID>" + link(7, 1, 0, 7)) +
                          "</Tasks><Assignments><Assignment><UID>1</UID><TaskUID>8</TaskUID></"
                          "Assignment></Assignments>"));
  ASSERT_TRUE(reading.project);
  EXPECT_EQ(reading.project->calendar, kNone);
  EXPECT_TRUE(reading.says("I05", "no calendar 9"));
  EXPECT_TRUE(reading.says("I05", "no calendar 3"));
  EXPECT_TRUE(reading.says("I05", "task 7, which is not there"));
  EXPECT_TRUE(reading.says("I05", "no task 8 for this assignment"));
}

TEST(Mspdi, breaks_rings_of_links) {
  const Reading reading = read_schedule(mspdi(
      "<Tasks>" + mspdi_task(1, "a", link(3, 1, 0, 7)) + mspdi_task(2, "b", link(1, 1, 0, 7)) +
      mspdi_task(3, "c", link(2, 1, 0, 7) + link(3, 1, 0, 7)) +
      mspdi_task(4, "d", link(3, 1, 0, 7)) + "</Tasks>"));
  ASSERT_TRUE(reading.project);
  EXPECT_TRUE(reading.says("I06", "in a ring; the link 'c' FS 'a' is left out"));
  EXPECT_TRUE(reading.says("I06", "'c' waits for itself"));
  EXPECT_EQ(reading.project->tasks[1].after.size(), 1u);
  EXPECT_EQ(reading.project->tasks[2].after.size(), 1u);
  EXPECT_EQ(plan_of(*reading.project).mistakes, "");
}

TEST(Mspdi, sees_rings_over_headings) {
  // A task below a heading that the heading waits for.
  const Reading reading = read_schedule(
      mspdi("<Tasks>" + mspdi_task(1, "top", "<OutlineLevel>1</OutlineLevel>" + link(2, 1, 0, 7)) +
            mspdi_task(2, "below", "<OutlineLevel>2</OutlineLevel>") + "</Tasks>"));
  ASSERT_TRUE(reading.project);
  EXPECT_TRUE(reading.says("I06", "in a ring"));
  EXPECT_EQ(plan_of(*reading.project).mistakes, "");
}

TEST(Mspdi, lists_rows_and_links_that_it_leaves_out) {
  const Reading reading = read_schedule(mspdi(
      "<Calendars><Calendar><UID>1</UID><BaseCalendarUID>2</BaseCalendarUID></Calendar>"
      "<Calendar><UID>2</UID><BaseCalendarUID>1</BaseCalendarUID></Calendar></Calendars><Tasks>" +
      mspdi_task(1, "a", "<IsNull>1</IsNull>") +
      mspdi_task(2, "b", "<OutlineLevel>7</OutlineLevel>") +
      mspdi_task(3, "c",
                 "<PredecessorLink><PredecessorUID>1</PredecessorUID><CrossProject>1</CrossProject>"
                 "</PredecessorLink>" +
                     link(2, 1, 2000000000, 7)) +
      "</Tasks>"));
  ASSERT_TRUE(reading.project);
  EXPECT_EQ(reading.project->tasks.size(), 2u);
  EXPECT_EQ(reading.project->tasks[0].level, 1);
  EXPECT_EQ(reading.project->tasks[1].after.at(0).lag, 0);
  EXPECT_TRUE(reading.says("I06", "is based on itself"));
  EXPECT_TRUE(reading.says("I07", "a blank row is left out"));
  EXPECT_TRUE(reading.says("I07", "waits for a task of another project"));
  EXPECT_TRUE(reading.says("I03", "outline level 7 cannot follow level 0"));
  EXPECT_TRUE(reading.says("I03", "2000000000 is no sensible lag"));
}

TEST(Mspdi, reads_utf16_and_windows_text) {
  const std::string text =
      mspdi("<Name>B\xc3\xbcro</Name><Tasks>" + mspdi_task(1, "a", "") + "</Tasks>");
  std::string wide = "\xff\xfe";
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\xc3') {
      wide += std::string("\xfc\0", 2);
      ++i;
    } else {
      wide += text[i];
      wide += '\0';
    }
  }
  std::string windows = text;
  windows.replace(windows.find("\xc3\xbc"), 2, "\xfc");
  for (const std::string& bytes : {text, wide, windows, "\xef\xbb\xbf" + text}) {
    const Reading reading = read_schedule(bytes);
    ASSERT_TRUE(reading.project);
    EXPECT_EQ(reading.project->name, "Büro");
  }
}

TEST(Mspdi, refuses_other_files) {
  EXPECT_TRUE(read_schedule("").says("I02", "found nothing"));
  EXPECT_TRUE(read_schedule("plan p { }").says("I02", "expected Microsoft Project XML"));
  EXPECT_TRUE(read_schedule("<html/>").says("I02", "found 'html'"));
  EXPECT_TRUE(
      read_schedule("<Project xmlns=\"http://schemas.microsoft.com/developer/msbuild/2003\"/>")
          .says("I02", "msbuild"));
  EXPECT_TRUE(read_schedule("<Project>").says("I01", "broken"));
}

}  // namespace
}  // namespace rubicon::test
