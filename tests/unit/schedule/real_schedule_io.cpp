#include "tests/unit/schedule/real_schedule_io.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string_view>

#include "tests/unit/schedule/calendar_cases.hpp"

namespace rubicon::test {

using schedule::CalendarRules;
using schedule::CivilTime;
using schedule::Date;
using schedule::kHour;
using schedule::LinkType;

namespace {

/// The insides of all elements <name>, none of which holds another of its name.
std::vector<std::string_view> elements(std::string_view text, const std::string& name) {
  std::vector<std::string_view> result;
  const std::string open = "<" + name + ">", close = "</" + name + ">";
  for (std::size_t at = text.find(open); at != std::string_view::npos; at = text.find(open, at)) {
    at += open.size();
    const std::size_t end = text.find(close, at);
    result.push_back(text.substr(at, end - at));
  }
  return result;
}

std::string element(std::string_view text, const std::string& name) {
  const auto all = elements(text, name);
  return all.empty() ? "" : std::string(all.front());
}

/// "2015-02-18T08:00:00".
CivilTime civil_time(const std::string& text) {
  return schedule::parse_civil_time(text.substr(0, 10) + " " + text.substr(11, 5)).value();
}

/// Monday to Friday 08:00 to 16:00, as the file says, without its days off.
CalendarRules calendar_rules(std::string_view calendar) {
  CalendarRules rules;
  rules.name = element(calendar, "Name");
  rules.shifts = {{0, 4, {{8 * 60, 16 * 60}}}};
  for (const std::string_view day : elements(calendar, "WeekDay")) {
    if (element(day, "TimePeriod").empty() || element(day, "DayWorking") == "1") continue;
    const Date first = civil_time(element(day, "FromDate")).date;
    const Date last = civil_time(element(day, "ToDate")).date;
    for (auto each = schedule::days_from_date(first); each <= schedule::days_from_date(last);
         ++each) {
      rules.off.push_back(schedule::date_from_days(each));
    }
  }
  return rules;
}

}  // namespace

std::optional<RealSchedule> read_real_schedule(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  RealSchedule result;
  result.start = civil_time(element(text, "StartDate"));
  schedule::Network& network = result.network;
  const std::string_view first_calendar = elements(text, "Calendar").front();
  network.calendars = {calendar(calendar_rules(first_calendar), schedule::text_of(result.start))};
  const std::vector<std::string_view> tasks = elements(text, "Task");
  for (const std::string_view each : tasks) {
    const int number = std::stoi(element(each, "UID"));
    result.tasks[number] = static_cast<int>(network.tasks.size());
    schedule::NetworkTask task;
    task.name = element(each, "Name");
    task.work = std::stoi(element(each, "Duration").substr(2)) * kHour;  // PT16H0M0S
    if (task.work > 0) {
      // Nobody waits for a crew in this schedule, so each task has its own.
      EXPECT_EQ(element(each, "CalendarUID"), element(first_calendar, "UID"));
      task.resources = {static_cast<int>(network.resources.size())};
      network.resources.push_back({"crew of " + task.name, 0});
      result.dates[number] = {task.name, civil_time(element(each, "Start")),
                              civil_time(element(each, "Finish"))};
    }
    network.tasks.push_back(std::move(task));
  }
  for (const std::string_view each : tasks) {
    const int index = result.tasks.at(std::stoi(element(each, "UID")));
    for (const std::string_view link : elements(each, "PredecessorLink")) {
      const std::string type = element(link, "Type");
      EXPECT_TRUE(type == "1" || type == "3") << type;
      network.tasks[static_cast<std::size_t>(index)].after.push_back(
          {result.tasks.at(std::stoi(element(link, "PredecessorUID"))),
           type == "1" ? LinkType::FS : LinkType::SS,
           std::stoi(element(link, "LinkLag")) * schedule::kMinute / 10,
           schedule::LagClock::working});
    }
    if (element(each, "ConstraintType") != "4") continue;  // start no earlier than
    // A milestone that starts with the plan and holds its own finish until that date.
    schedule::NetworkTask date;
    date.name = "date";
    date.after = {
        {static_cast<int>(network.tasks.size()), LinkType::SF,
         schedule::ticks_between(result.start, civil_time(element(each, "ConstraintDate")))
             .value()}};
    network.tasks[static_cast<std::size_t>(index)].after.push_back(
        {static_cast<int>(network.tasks.size())});
    network.tasks.push_back(std::move(date));
  }
  return result;
}

}  // namespace rubicon::test
