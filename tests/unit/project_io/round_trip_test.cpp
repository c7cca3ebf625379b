#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "src/exchange/project_io/tidy_project.hpp"
#include "src/exchange/project_io/value_text.hpp"
#include "src/exchange/project_io/write_mspdi.hpp"
#include "tests/unit/project_io/project_support.hpp"
#include "tests/unit/project_io/sample_files_io.hpp"

namespace rubicon::test {
namespace {

using namespace project_io;

/// The same project, or the first difference.
std::string difference(const Project& a, const Project& b) {
  for (std::size_t i = 0; i < std::min(a.calendars.size(), b.calendars.size()); ++i) {
    if (!(a.calendars[i] == b.calendars[i])) return "calendar " + a.calendars[i].name;
  }
  for (std::size_t i = 0; i < std::min(a.tasks.size(), b.tasks.size()); ++i) {
    const Task &x = a.tasks[i], &y = b.tasks[i];
    if (x == y) continue;
    return fmt::format(
        "task {} '{}' / {} '{}': {} s / {} s, level {} / {}, links {} / {}, {} / {}, "
        "'{}' / '{}'",
        x.uid, x.name, y.uid, y.name, x.duration.seconds, y.duration.seconds, x.level, y.level,
        x.after.size(), y.after.size(), x.after == y.after, text_of(x.constraint),
        x.constraint_date.text, y.constraint_date.text);
  }
  for (std::size_t i = 0; i < std::min(a.resources.size(), b.resources.size()); ++i) {
    if (!(a.resources[i] == b.resources[i])) return "resource " + a.resources[i].name;
  }
  for (std::size_t i = 0; i < std::min(a.assignments.size(), b.assignments.size()); ++i) {
    if (!(a.assignments[i] == b.assignments[i])) return fmt::format("assignment {}", i);
  }
  return a == b ? "" : "the head, or how many there are";
}

/// Both ways back give the project again, and the plan is well.
void expect_round_trip(const Project& project) {
  const Reading xml = read_schedule(write_mspdi(project));
  ASSERT_TRUE(xml.project);
  EXPECT_EQ(difference(project, *xml.project), "");
  EXPECT_TRUE(xml.said.empty()) << testing::PrintToString(xml.said);
  const Planned plan = plan_of(project);
  ASSERT_EQ(plan.mistakes, "") << plan.text;
  const Reading back = project_of_plan(plan.text);
  ASSERT_TRUE(back.project);
  EXPECT_EQ(difference(project, *back.project), "") << plan.text;
  EXPECT_TRUE(back.said.empty()) << testing::PrintToString(back.said);
}

TEST(RoundTrip, a_project_with_every_construct_comes_back) {
  const Reading reading = read_schedule(sample("house.xml"));
  ASSERT_TRUE(reading.project);
  expect_round_trip(*reading.project);
}

/// Microsoft Project lets elapsed durations run on in nights and on days off, whatever the
/// calendars of those who are assigned.
TEST(RoundTrip, an_elapsed_duration_runs_day_and_night_whoever_is_on_it) {
  const std::string week =
      "<WeekDays><WeekDay><DayType>2</DayType><DayWorking>1</DayWorking><WorkingTimes><WorkingTime>"
      "<FromTime>07:00:00</FromTime><ToTime>15:00:00</ToTime></WorkingTime></WorkingTimes></"
      "WeekDay>"
      "</WeekDays>";
  const auto schedule = [&](int format) {
    return mspdi(
        "<StartDate>2026-03-02T07:00:00</StartDate><Calendars><Calendar><UID>1</UID>"
        "<Name>site</Name><IsBaseCalendar>1</IsBaseCalendar>" +
        week + "</Calendar></Calendars><Tasks>" +
        mspdi_task(1, "cure",
                   fmt::format("<Duration>PT30H0M0S</Duration><DurationFormat>{}"
                               "</DurationFormat>",
                               format)) +
        "</Tasks><Resources><Resource><UID>1</UID><Name>masons</Name><Type>1</Type>"
        "<CalendarUID>1</CalendarUID></Resource></Resources><Assignments><Assignment>"
        "<UID>1</UID><TaskUID>1</TaskUID><ResourceUID>1</ResourceUID></Assignment>"
        "</Assignments>");
  };
  constexpr int kHours = 5, kElapsedHours = 6;
  const Project shifts = *read_schedule(schedule(kHours)).project;
  EXPECT_NE(plan_of(shifts).text.find("by masons;"), std::string::npos);
  const Project elapsed = *read_schedule(schedule(kElapsedHours)).project;
  EXPECT_TRUE(elapsed.tasks[0].format.elapsed);
  EXPECT_EQ(plan_of(elapsed).text.find("by "), std::string::npos) << plan_of(elapsed).text;
  expect_round_trip(elapsed);
}

TEST(RoundTrip, a_primavera_project_comes_back) {
  const Reading reading = read_schedule(sample("hall.xer"));
  ASSERT_TRUE(reading.project);
  expect_round_trip(*reading.project);
}

/// The names of the elements directly in the first <element> of a text that has `mark` in it.
std::vector<std::string> children(const std::string& xml, const std::string& element,
                                  const std::string& mark) {
  const std::size_t begin = xml.rfind("<" + element + ">", xml.find(mark));
  std::istringstream lines(xml.substr(begin, xml.find("</" + element + ">", begin) - begin));
  std::vector<std::string> names;
  std::string line;
  std::getline(lines, line);
  const std::size_t indent = 6;
  while (std::getline(lines, line)) {
    if (line.size() > indent && line.find('<') == indent && line[indent + 1] != '/') {
      const std::string name =
          line.substr(indent + 1, line.find_first_of(" >/", indent + 1) - indent - 1);
      if (names.empty() || names.back() != name) names.push_back(name);
    }
  }
  return names;
}

/// The schema is a sequence: Project reads elements in this order (mspdi_pj12.xsd; Active and
/// Manual came with Project 2010).
TEST(RoundTrip, elements_stand_in_the_order_of_the_schema) {
  Project project = *read_schedule(sample("house.xml")).project;
  project.tasks[4].hide_bar = true;
  project.tasks[4].notes = "n";
  project.resources[3].notes = "n";
  const std::string xml = write_mspdi(project);
  EXPECT_EQ(children(xml, "Task", "<UID>4</UID>"),
            (std::vector<std::string>{"UID",
                                      "ID",
                                      "Name",
                                      "Active",
                                      "Manual",
                                      "Type",
                                      "OutlineNumber",
                                      "OutlineLevel",
                                      "Priority",
                                      "Duration",
                                      "DurationFormat",
                                      "Work",
                                      "EffortDriven",
                                      "Milestone",
                                      "Summary",
                                      "FixedCost",
                                      "FixedCostAccrual",
                                      "PercentComplete",
                                      "ConstraintType",
                                      "CalendarUID",
                                      "IgnoreResourceCalendar",
                                      "Notes",
                                      "HideBar",
                                      "PredecessorLink"}));
  EXPECT_EQ(children(xml, "Resource", "Miete"),
            (std::vector<std::string>{"UID", "ID", "Name", "Type", "MaxUnits", "StandardRate",
                                      "StandardRateFormat", "OvertimeRate", "OvertimeRateFormat",
                                      "CostPerUse", "CalendarUID", "Notes", "IsCostResource"}));
  EXPECT_EQ(children(xml, "Assignment", "<Units>14.5"),
            (std::vector<std::string>{"UID", "TaskUID", "ResourceUID", "PercentWorkComplete",
                                      "Units", "Work"}));
}

TEST(RoundTrip, carriage_returns_become_line_feeds) {
  const Reading reading =
      read_schedule(mspdi("<Tasks>" + mspdi_task(1, "a&#13;&#10;b&#13;c", "") + "</Tasks>"));
  ASSERT_TRUE(reading.project);
  EXPECT_EQ(reading.project->tasks.at(0).name, "a\nb\nc");
  expect_round_trip(*reading.project);
}

TEST(RoundTrip, an_empty_project_comes_back) { expect_round_trip(Project{}); }

/// Random projects with odd names, links of all kinds, and numbers far apart.
class RandomProject {
 public:
  explicit RandomProject(unsigned seed) : random_(seed) {}

  Project make() {
    Project project;
    project.name = name();
    project.author = name();
    if (chance(2)) project.start.text = "2026-03-02 07:00";
    if (chance(5)) project.start.text += project.start.text.empty() ? "" : ":30";
    project.minutes_per_day = chance(3) ? 450 : 480;
    const int calendars = below(4);
    for (int i = 0; i < calendars; ++i) project.calendars.push_back(calendar(i + 1, i));
    project.calendar = calendars > 0 && chance(2) ? 1 : kNone;
    const int tasks = below(25);
    int level = 0;
    for (int i = 0; i < tasks; ++i) {
      level = 1 + below(std::min(level + 1, 4));
      project.tasks.push_back(task(i + 10, level, i, calendars));
    }
    const int resources = below(5);
    for (int i = 0; i < resources; ++i) project.resources.push_back(resource(i + 1, calendars));
    for (int i = 0; i < below(12) && tasks > 0; ++i) {
      Assignment each;
      each.uid = i;
      each.task = 10 + below(tasks);
      each.resource = resources > 0 ? 1 + below(resources) : kNone;
      each.units = below(4) + 0.25;
      project.assignments.push_back(each);
    }
    Listing listing;
    tidy_project(project, {}, listing);
    return project;
  }

 private:
  int below(int n) { return n <= 0 ? 0 : static_cast<int>(random_() % static_cast<unsigned>(n)); }
  bool chance(int n) { return below(n) == 0; }

  std::string name() {
    static const std::vector<std::string> kNames = {"",
                                                    "Wall",
                                                    "wall",
                                                    "chain",
                                                    "1e verdieping",
                                                    "Straße — \"Nord\"",
                                                    "日本",
                                                    "a;b{c}//",
                                                    "after",
                                                    "&quot; &#9;",
                                                    "row_12",
                                                    "plan_begins",
                                                    "tab\tline\nend",
                                                    "wall_2",
                                                    "wall_begins",
                                                    "x\\",
                                                    "/* no */",
                                                    "\x01"};
    std::string result = kNames[static_cast<std::size_t>(below(static_cast<int>(kNames.size())))];
    return chance(20) ? std::string(300, 'n') + result : result;
  }

  DayTimes times() {
    if (chance(3)) return {};
    const int from = below(600);
    return tidy({{from, from + 1 + below(300)}, {1000, 1000 + 1 + below(440)}});
  }

  Calendar calendar(int uid, int lower) {
    Calendar result;
    result.uid = uid;
    result.name = name();
    if (lower > 0 && chance(2)) result.base = 1 + below(lower);
    for (auto& day : result.week) {
      if (result.base == kNone || chance(2)) day = times();
    }
    for (int i = below(4); i > 0; --i) {
      const int day = 1 + below(20);
      result.exceptions.push_back({fmt::format("2026-0{}-{:02}", 1 + below(6), day),
                                   fmt::format("2026-06-{:02}", 20 + below(10)),
                                   chance(3) ? times() : DayTimes{}, chance(2) ? name() : ""});
      if (chance(2)) result.exceptions.back().last = result.exceptions.back().first;
    }
    return result;
  }

  Task task(int uid, int level, int before, int calendars) {
    constexpr std::array<std::int64_t, 7> kDurations = {0, 0, 1, 3600, 28800, 90061, 4000000000};
    Task result;
    result.uid = uid;
    result.id = uid;
    result.name = name();
    result.notes = name();
    result.level = level;
    result.duration.seconds = kDurations[static_cast<std::size_t>(below(7))];
    result.milestone = result.duration.seconds == 0 && chance(2);
    result.active = !chance(10);
    result.hide_bar = chance(10);
    result.format = format();
    if (calendars > 0 && chance(3)) result.calendar = 1 + below(calendars);
    result.ignores_resource_calendars = chance(3);
    if (chance(4)) place(result);
    if (chance(3)) {
      result.constraint = static_cast<Constraint>(below(8));
      result.constraint_date.text = fmt::format("2026-0{}-1{} 08:30", 1 + below(9), below(9));
    }
    for (int i = below(4); i > 0 && before > 0; --i) {
      Link link;
      link.predecessor = 10 + below(before);
      link.type = static_cast<LinkType>(below(4));
      link.format = format();
      link.lag = chance(2) ? 0 : 6 * (below(200000) - 50000);
      if (chance(30)) link.lag = 6000000000;
      if (chance(4)) {
        link.format.unit = TimeUnit::percent;
        link.lag = below(300) - 100;
      }
      result.after.push_back(link);
    }
    return result;
  }

  /// Dates in fact or by hand, some of them nonsense.
  void place(Task& task) {
    const auto moment = [&] {
      return Moment{fmt::format("2026-0{}-1{} 0{}:00{}", 1 + below(5), below(9), 7 + below(3),
                                chance(3) ? ":20" : "")};
    };
    task.manual = chance(2);
    if (chance(2)) task.start = moment();
    if (chance(2)) task.finish = moment();
    if (chance(2)) task.actual_start = moment();
    if (chance(3)) task.actual_finish = moment();
  }

  TimeFormat format() { return {static_cast<TimeUnit>(below(5)), chance(4), chance(4)}; }

  Resource resource(int uid, int calendars) {
    Resource result;
    result.uid = uid;
    result.name = name();
    result.type = static_cast<ResourceType>(below(3));
    result.max_units = below(5) * 0.5;
    result.standard_rate = below(1000) / 7.0;
    result.rate_format = 1 + below(8);
    if (calendars > 0 && chance(2)) result.calendar = 1 + below(calendars);
    return result;
  }

  std::mt19937 random_;
};

TEST(RoundTrip, random_projects_come_back) {
  for (unsigned seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    expect_round_trip(RandomProject(seed).make());
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace
}  // namespace rubicon::test
