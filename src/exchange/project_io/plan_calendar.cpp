#include "src/exchange/project_io/plan_calendar.hpp"

#include <algorithm>
#include <set>

#include "src/exchange/project_io/dates.hpp"
#include "src/exchange/project_io/value_text.hpp"

namespace rubicon::project_io {

namespace {

/// Most days off of one calendar: fifty years of weekends and holidays.
constexpr std::size_t kMaxOffDays = 8000;

/// Most days that are looked at for one calendar: exceptions that lie over one another again and
/// again are damage.
constexpr int kMaxSteps = 1000000;

/// The calendar and its bases, the lowest first.
std::vector<const Calendar*> chain(const Project& project, const Calendar& calendar) {
  std::vector<const Calendar*> result = {&calendar};
  while (result.front()->base != kNone) {
    const auto found =
        std::find_if(project.calendars.begin(), project.calendars.end(),
                     [&](const Calendar& each) { return each.uid == result.front()->base; });
    if (found == project.calendars.end() ||
        std::find(result.begin(), result.end(), &*found) != result.end()) {
      break;
    }
    result.insert(result.begin(), &*found);
  }
  return result;
}

}  // namespace

std::optional<PlanCalendar> plan_calendar(const Project& project, const Calendar& calendar,
                                          const std::string& from) {
  constexpr int kLongAgo = -1000000;
  const int first_day = day_number(from).value_or(kLongAgo);
  PlanCalendar result;
  std::set<int> off, special;
  int steps = 0;
  for (const Calendar* each : chain(project, calendar)) {
    for (std::size_t day = 0; day < 7; ++day) {
      if (each->week[day]) result.week[day] = *each->week[day];
    }
    for (const CalendarException& exception : each->exceptions) {
      const auto first = day_number(exception.first), last = day_number(exception.last);
      if (!first || !last) continue;
      for (int day = std::max(*first, first_day); day <= *last; ++day) {
        if (off.size() + special.size() >= kMaxOffDays || ++steps > kMaxSteps) {
          result.cut = true;
          break;
        }
        (exception.times.empty() ? special : off).erase(day);
        (exception.times.empty() ? off : special).insert(day);
      }
    }
  }
  if (std::all_of(result.week.begin(), result.week.end(),
                  [](const DayTimes& day) { return day.empty(); })) {
    return std::nullopt;
  }
  for (const int day : off) result.off.push_back(date_text(day));
  result.special_days = static_cast<int>(special.size());
  return result;
}

PlanCalendar plan_calendar(const interpreter::CalendarSpec& spec) {
  PlanCalendar result;
  for (const auto& shift : spec.shifts) {
    for (int day = shift.first_day; day <= shift.last_day; ++day) {
      DayTimes& times = result.week[static_cast<std::size_t>(day)];
      for (const auto& [from, to] : shift.minutes) times.push_back({from, to});
      times = tidy(std::move(times));
    }
  }
  for (const schedule::Date& day : spec.off) result.off.push_back(schedule::text_of(day));
  std::sort(result.off.begin(), result.off.end());
  result.off.erase(std::unique(result.off.begin(), result.off.end()), result.off.end());
  return result;
}

}  // namespace rubicon::project_io
