#include "src/exchange/project_io/working_time.hpp"

#include "src/simulation/schedule/calendar_rules.hpp"

namespace rubicon::project_io {

namespace {

std::optional<schedule::WorkCalendar> work_calendar(const PlanCalendar& plan,
                                                    const schedule::CivilTime& start) {
  schedule::CalendarRules rules;
  for (int day = 0; day < 7; ++day) {
    schedule::CalendarRules::Shift shift{day, day, {}};
    for (const Interval& each : plan.week[static_cast<std::size_t>(day)]) {
      shift.minutes.emplace_back(each.from, each.to);
    }
    if (!shift.minutes.empty()) rules.shifts.push_back(std::move(shift));
  }
  for (const std::string& off : plan.off) {
    if (const auto date = schedule::parse_date(off)) rules.off.push_back(*date);
  }
  auto made = schedule::calendar_of(rules, start);
  auto* calendar = std::get_if<schedule::WorkCalendar>(&made);
  return calendar == nullptr ? std::nullopt : std::optional(std::move(*calendar));
}

}  // namespace

std::optional<std::int64_t> work_between(const FixedDates& dates,
                                         const std::vector<PlanCalendar>& calendars,
                                         const Moment& start) {
  const auto begin = schedule::parse_civil_time(start.text);
  if (!begin || !dates.finish) return std::nullopt;
  schedule::WorkCalendar all;
  for (const PlanCalendar& each : calendars) {
    const auto calendar = work_calendar(each, *begin);
    if (!calendar) return std::nullopt;
    auto both = schedule::intersection(all, *calendar);
    auto* met = std::get_if<schedule::WorkCalendar>(&both);
    if (met == nullptr) return std::nullopt;
    all = std::move(*met);
  }
  const schedule::Ticks from = dates.start * schedule::kSecond;
  const schedule::Ticks to = *dates.finish * schedule::kSecond;
  const schedule::Ticks work = all.work_between(from, to);
  if (!all.works_at(from) || work == 0 || all.finish(from, work) != to) return std::nullopt;
  return work / schedule::kSecond;
}

}  // namespace rubicon::project_io
