#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/exchange/project_io/value_text.hpp"
#include "src/exchange/project_io/xer_calendar.hpp"
#include "src/exchange/project_io/xer_number.hpp"
#include "tests/unit/project_io/project_support.hpp"
#include "tests/unit/project_io/sample_files_io.hpp"

namespace rubicon::test {
namespace {

using namespace project_io;

class Xer : public testing::Test {
 protected:
  Xer() : reading_(read_schedule(sample("hall.xer"))) {}

  const Task& task(const std::string& name) const {
    for (const Task& each : reading_.project->tasks) {
      if (each.name == name) return each;
    }
    ADD_FAILURE() << name;
    return reading_.project->tasks.front();
  }

  Reading reading_;
};

TEST_F(Xer, reads_the_work_breakdown_as_an_outline) {
  ASSERT_TRUE(reading_.project);
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < reading_.project->tasks.size(); ++i) {
    const Task& each = reading_.project->tasks[i];
    lines.push_back(std::to_string(each.level) + (reading_.project->is_heading(i) ? "=" : " ") +
                    each.name);
  }
  EXPECT_THAT(lines, testing::ElementsAre("1=Substructure", "2 Piles", "2 Slab \"on grade\"",
                                          "1=Superstructure", "2 Site management", "2=Steel",
                                          "3 Columns", "3 Frame done"));
}

TEST_F(Xer, reads_activities) {
  ASSERT_TRUE(reading_.project);
  EXPECT_EQ(reading_.project->name, "HALL-2");
  EXPECT_EQ(reading_.project->currency_symbol, "€");
  EXPECT_EQ(reading_.project->start.text, "2026-03-02 07:00");
  EXPECT_EQ(task("Piles").code, "A1010");
  EXPECT_EQ(task("Piles").duration.seconds, 80 * 3600);
  EXPECT_EQ(task("Piles").percent_complete, 100);
  EXPECT_EQ(task("Slab \"on grade\"").duration.seconds, 40 * 3600 + 1800);
  EXPECT_EQ(task("Slab \"on grade\"").constraint, Constraint::start_no_earlier_than);
  EXPECT_TRUE(task("Frame done").milestone);
  EXPECT_FALSE(task("Columns").milestone);
}

TEST_F(Xer, reads_every_type_of_link_with_lags) {
  ASSERT_TRUE(reading_.project);
  EXPECT_EQ(task("Slab \"on grade\"").after,
            (std::vector<Link>{{1001, LinkType::FS, 0, {TimeUnit::hours, false, false}}}));
  EXPECT_EQ(task("Columns").after[0].type, LinkType::SS);
  EXPECT_EQ(task("Columns").after[0].lag, 16 * 3600);
  EXPECT_EQ(task("Frame done").after[0].type, LinkType::FF);
  EXPECT_EQ(task("Frame done").after[0].lag, -9000);
  EXPECT_EQ(task("Site management").after[0].type, LinkType::SF);
}

TEST_F(Xer, reads_calendars) {
  ASSERT_TRUE(reading_.project);
  const Calendar& calendar = reading_.project->calendars.at(0);
  EXPECT_EQ(reading_.project->calendar, 501);
  EXPECT_EQ(text_of(calendar.week[0].value()), "07:00-12:00,12:30-15:30");  // Monday
  EXPECT_EQ(text_of(calendar.week[6].value()), "off");
  ASSERT_EQ(calendar.exceptions.size(), 2u);
  EXPECT_EQ(calendar.exceptions[0],
            (CalendarException{"2026-03-14", "2026-03-14", {{420, 720}}, ""}));
  EXPECT_EQ(calendar.exceptions[1], (CalendarException{"2026-05-01", "2026-05-01", {}, ""}));
}

TEST_F(Xer, reads_resources) {
  ASSERT_TRUE(reading_.project);
  ASSERT_EQ(reading_.project->resources.size(), 3u);
  EXPECT_EQ(reading_.project->resources[0].standard_rate, 48.5);
  EXPECT_EQ(reading_.project->resources[0].max_units, 4);
  EXPECT_EQ(reading_.project->resources[2].type, ResourceType::material);
  EXPECT_EQ(reading_.project->assignments.size(), 3u);
}

TEST_F(Xer, an_activity_goes_by_its_own_calendar_or_by_those_of_its_resources) {
  ASSERT_TRUE(reading_.project);
  EXPECT_TRUE(task("Columns").ignores_resource_calendars);  // task dependent
  EXPECT_EQ(task("Columns").calendar, 501);
  // Only a material is on it, which works by no calendar.
  EXPECT_FALSE(task("Slab \"on grade\"").ignores_resource_calendars);
  std::string text = sample("hall.xer");
  text.replace(text.find("TT_Task", text.find("%R\t1003")), 7, "TT_Rsrc");
  text.replace(text.find("TT_Task", text.find("%R\t1002")), 7, "TT_Rsrc");
  const Reading by_resources = read_schedule(text);
  ASSERT_TRUE(by_resources.project);
  for (const Task& each : by_resources.project->tasks) {
    const bool has_own = each.name != "Columns" && each.code[0] != 'S';  // headings have none
    EXPECT_EQ(each.calendar, has_own ? 501 : kNone) << each.name;
    EXPECT_FALSE(each.ignores_resource_calendars);
  }
}

TEST_F(Xer, lists_what_it_does_not_understand) {
  EXPECT_TRUE(reading_.says("I07", "project 'OTHER' is left out"));
  EXPECT_TRUE(reading_.says("I07", "'Site management' lasts as long as others"));
  EXPECT_TRUE(reading_.says("I07", "table UDFVALUE is not taken over (1 rows)"));
  EXPECT_TRUE(
      reading_.says("I07", "column status_code of TASK is not taken over, here 'TK_Complete'"));
  EXPECT_FALSE(reading_.says("I03", ""));
}

TEST_F(Xer, of_several_projects_takes_the_one_that_was_exported) {
  const auto schedule = [](const std::string& projects) {
    return read_schedule(
        "ERMHDR\t1\n%T\tPROJECT\n%F\tproj_id\tproj_short_name\texport_flag\n" + projects +
        "%T\tTASK\n%F\ttask_id\tproj_id\ttask_name\n%R\t2\t2\thandover\n%R\t10\t1\tdig\n%R\t30"
        "\t3\troof\n%E\n");
  };
  const std::string linked = "%R\t2\tENABLING\tN\n", exported = "%R\t1\tMAIN\tY\n",
                    other = "%R\t3\tOTHER\tY\n", empty = "%R\t4\tEMPTY\tY\n";
  for (const std::string& projects :
       {linked + exported, exported + linked, empty + linked + exported + other}) {
    const Reading reading = schedule(projects);
    ASSERT_TRUE(reading.project);
    EXPECT_EQ(reading.project->name, "MAIN");
    EXPECT_EQ(reading.project->tasks.size(), 1u);
    EXPECT_TRUE(reading.says("I07", "'ENABLING' is left out: it was not exported"));
    EXPECT_FALSE(reading.says("I07", "export_flag"));
  }
  EXPECT_TRUE(schedule(exported + other).says("I07", "'OTHER' is left out: one plan holds one"));
  // Where none is said to be exported, the first with activities.
  EXPECT_EQ(schedule("%R\t4\tEMPTY\t\n%R\t3\tOTHER\tN\n").project->name, "OTHER");
  EXPECT_TRUE(schedule(empty + linked).says("I02", "no project"));
}

TEST_F(Xer, says_what_is_wrong_with_rows) {
  const Reading reading = read_schedule(
      "ERMHDR\t1\n%R\t1\n%T\tPROJECT\n%F\tproj_id\n%R\t1\t2\n%T\tPROJWBS\n%F\twbs_id\tproj_"
      "id\tparent_wbs_id\n"
      "%R\t5\t1\t6\n%R\t6\t1\t5\n%R\t6\t1\t\n"
      "%T\tTASK\n%F\ttask_id\tproj_id\twbs_id\ttarget_work_qty\tcstr_type\n%R\tx\t1\t6\t1e9\tCS_"
      "ODD\n%R\t2\t1\t\tten\t\n"
      "%T\tCALENDAR\n%F\tclndr_id\tclndr_data\n%R\t1\t(0||Calendar\n"
      "%T\tTASKPRED\n%F\ttask_id\tpred_task_id\tpred_type\n%R\t2\t9\tPR_X\n%R\t77\t2\tPR_FS\n");
  ASSERT_TRUE(reading.project);
  for (const auto& [code, words] : std::initializer_list<std::pair<const char*, const char*>>{
           {"I03", "expected a line that begins with"},
           {"I03", "2 cells, its table 1 columns"},
           {"I06", "work breakdown"},
           {"I04", "wbs_id 6 is there twice"},
           {"I03", "expected a number in column task_id"},
           {"I03", "no sensible time"},
           {"I03", "unknown constraint 'CS_ODD'"},
           {"I03", "target_work_qty of TASK, found 'ten'; left out"},
           {"I03", "could not be read to the end"},
           {"I03", "expected PR_FS"},
           {"I05", "no activity 77"},
           {"I05", "task 9, which is not there"},
           {"I01", "no last line %E"},
           {"I04", "this task has no number"}}) {
    EXPECT_TRUE(reading.says(code, words)) << words << "\n" << testing::PrintToString(reading.said);
  }
  EXPECT_TRUE(read_schedule("ERMHDR\t1\n%E\n").says("I02", "no project"));
}

TEST_F(Xer, numbers_have_the_decimal_symbol_of_the_currency_of_the_file) {
  const std::vector<std::tuple<const char*, const char*, double>> good = {
      {"7,5", ",", 7.5},     {"-2,25", ",", -2.25},      {"8", ",", 8},
      {"1500", ",", 1500},   {"1,500", ",", 1.5},        {"7.5", ",", 7.5},
      {"0.125", ",", 0.125}, {"1234.5", ",", 1234.5},    {"7.5", ".", 7.5},
      {"1.500", ".", 1.5},   {"7\u066b5", "\u066b", 7.5}};
  for (const auto& [text, decimal, expected] : good) {
    double value = -1;
    EXPECT_TRUE(read_xer_number(text, decimal, value)) << text;
    EXPECT_EQ(value, expected) << text;
  }
  for (const auto& [text, decimal] :
       std::vector<std::pair<const char*, const char*>>{{"1.500", ","},
                                                        {"-12.000", ","},
                                                        {"1.234,5", ","},
                                                        {"7,5,1", ","},
                                                        {",", ","},
                                                        {"7,5", "."},
                                                        {"1,500", "."},
                                                        {"seven", ","}}) {
    double value = -1;
    EXPECT_FALSE(read_xer_number(text, decimal, value)) << text;
    EXPECT_EQ(value, -1) << text;
  }
}

TEST_F(Xer, takes_the_currency_that_its_header_names) {
  const auto schedule = [](const char* header, const char* hours) {
    return read_schedule(std::string("ERMHDR\t1\t2026-01-05\tProject\ta\tA\tdb\tPM") + header +
                         "\n%T\tCURRTYPE\n%F\tcurr_short_name\tcurr_symbol\tdecimal_symbol\n"
                         "%R\tUSD\t$\t.\n%R\tEUR\tE\t,\n%T\tPROJECT\n%F\tproj_id\n%R\t1\n"
                         "%T\tTASK\n%F\ttask_id\tproj_id\ttarget_drtn_hr_cnt\n%R\t1\t1\t" +
                         hours + "\n%E\n");
  };
  const Reading euro = schedule("\tEUR", "7,5");
  ASSERT_TRUE(euro.project);
  EXPECT_EQ(euro.project->currency_symbol, "E");
  EXPECT_EQ(euro.project->tasks.at(0).duration.seconds, 27000);
  EXPECT_FALSE(euro.says("I03", ""));
  const Reading none = schedule("", "7.5");
  ASSERT_TRUE(none.project);
  EXPECT_EQ(none.project->currency_symbol, "$");
  EXPECT_EQ(none.project->tasks.at(0).duration.seconds, 27000);
  EXPECT_FALSE(schedule("\tUSD", "7,5").project);
}

TEST_F(Xer, without_its_durations_and_lags_it_is_no_schedule) {
  const auto schedule = [](const std::string& hours, const std::string& lag) {
    return read_schedule(
        "ERMHDR\t1\n%T\tPROJECT\n%F\tproj_id\n%R\t1\n"
        "%T\tTASK\n%F\ttask_id\tproj_id\ttarget_drtn_hr_cnt\n%R\t1\t1\t8\n%R\t2\t1\t" +
        hours +
        "\n%T\tTASKPRED\n%F\ttask_id\tpred_task_id\tpred_type\tlag_hr_cnt\n%R\t2\t1\tPR_FS\t" +
        lag + "\n%E\n");
  };
  EXPECT_TRUE(schedule("8", "-4.5").project);
  for (const auto& [hours, lag, words] :
       std::vector<std::tuple<const char*, const char*, const char*>>{
           {"ten", "0", "expected a number in column target_drtn_hr_cnt of TASK, found 'ten'"},
           {"-8", "0", "expected 0 hours or more in column target_drtn_hr_cnt of TASK"},
           {"1e9", "0", "1000000000 hours in column target_drtn_hr_cnt is no sensible time"},
           {"8", "4,5", "expected a number in column lag_hr_cnt of TASKPRED, found '4,5'"}}) {
    const Reading reading = schedule(hours, lag);
    EXPECT_FALSE(reading.project) << words;
    EXPECT_TRUE(reading.says("I03", words)) << testing::PrintToString(reading.said);
  }
}

TEST_F(Xer, calendar_data_of_any_text_is_read_without_harm) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "(0||a()(";
  for (const std::string& text :
       {deep, std::string("("), std::string("(0||"), std::string("(0||a(b|c)"),
        std::string("(0||C()((0||Exceptions()((0||0(d|99999999)())))))")}) {
    Calendar calendar;
    EXPECT_FALSE(read_xer_calendar(text, calendar));
    EXPECT_TRUE(calendar.exceptions.empty());
  }
}

}  // namespace
}  // namespace rubicon::test
