#include "src/results/verify/schedule/working_hours.hpp"

#include <algorithm>

#include "src/results/verify/schedule/civil_date.hpp"

namespace rubicon::verify {

namespace {

/// 0 Monday; 1970-01-01 was a Thursday.
std::size_t weekday(std::int64_t day) { return static_cast<std::size_t>(((day + 3) % 7 + 7) % 7); }

std::int64_t day_of(Ticks time) { return time >= 0 ? time / kDay : -((-time + kDay - 1) / kDay); }

/// Sorted, and joined where they touch.
void tidy(std::vector<std::pair<Ticks, Ticks>>& intervals) {
  std::sort(intervals.begin(), intervals.end());
  std::vector<std::pair<Ticks, Ticks>> joined;
  for (const auto& each : intervals) {
    if (!joined.empty() && each.first <= joined.back().second) {
      joined.back().second = std::max(joined.back().second, each.second);
    } else {
      joined.push_back(each);
    }
  }
  intervals = std::move(joined);
}

}  // namespace

WorkingHours::WorkingHours(const Scene& scene) {
  first_day_ = day_number("2024-01-01");
  if (!scene.start_at.empty()) {
    first_day_ = day_number(scene.start_at);
    start_ = (minute_number(scene.start_at) - first_day_ * kMinutesOfDay) * kMinute;
  }
  for (const SceneCalendar& rules : scene.calendars) {
    Calendar calendar;
    calendar.week.resize(7);
    for (const SceneCalendar::Shift& shift : rules.shifts) {
      for (int day = std::max(shift.first_day, 0); day <= std::min(shift.last_day, 6); ++day) {
        for (const auto& [from, to] : shift.minutes) {
          calendar.week[static_cast<std::size_t>(day)].emplace_back(from * kMinute, to * kMinute);
        }
      }
    }
    for (auto& day : calendar.week) tidy(day);
    for (const std::string& day : rules.off) calendar.off.insert(day_number(day));
    calendars_.push_back(std::move(calendar));
  }
}

std::vector<WorkingHours::Interval> WorkingHours::hours(std::span<const int> calendars,
                                                        std::int64_t day) const {
  std::vector<Interval> common = {{0, kDay}};
  for (const int index : calendars) {
    const Calendar& calendar = calendars_[static_cast<std::size_t>(index)];
    if (calendar.off.contains(first_day_ + day)) return {};
    std::vector<Interval> both;
    for (const Interval& a : common) {
      for (const Interval& b : calendar.week[weekday(first_day_ + day)]) {
        const Interval cut{std::max(a.first, b.first), std::min(a.second, b.second)};
        if (cut.first < cut.second) both.push_back(cut);
      }
    }
    common = std::move(both);
  }
  return common;
}

Ticks WorkingHours::between(std::span<const int> calendars, Ticks from, Ticks to) const {
  if (calendars.empty()) return std::max<Ticks>(to - from, 0);
  Ticks sum = 0;
  for (std::int64_t day = day_of(start_ + from); day * kDay < start_ + to; ++day) {
    for (const auto& [begin, end] : hours(calendars, day)) {
      const Ticks cut_begin = std::max(start_ + from, day * kDay + begin);
      const Ticks cut_end = std::min(start_ + to, day * kDay + end);
      if (cut_begin < cut_end) sum += cut_end - cut_begin;
    }
  }
  return sum;
}

bool WorkingHours::at(std::span<const int> calendars, Ticks time) const {
  return between(calendars, time - kTimeSlack, time + kTimeSlack) > 0;
}

}  // namespace rubicon::verify
