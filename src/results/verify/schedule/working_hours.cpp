#include "src/results/verify/schedule/working_hours.hpp"

#include <algorithm>

#include "src/results/verify/schedule/civil_date.hpp"

namespace rubicon::verify {

namespace {

/// 0 Monday; 1970-01-01 was a Thursday.
std::size_t weekday(std::int64_t day) { return static_cast<std::size_t>(((day + 3) % 7 + 7) % 7); }

std::int64_t day_of(Ticks time) { return time >= 0 ? time / kDay : -((-time + kDay - 1) / kDay); }

/// The next number of SplitMix64 (Steele, Lea, Flood 2014) from this state.
std::uint64_t scrambled(std::uint64_t state) {
  std::uint64_t x = state + 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

/// Evenly between 0 and 1, of a date: docs/studies.md says how.
double weather(std::uint64_t seed, std::uint64_t run, std::int64_t date) {
  std::uint64_t name = 14695981039346656037ull;  // FNV-1a of "weather"
  for (const char c : {'w', 'e', 'a', 't', 'h', 'e', 'r'}) {
    name = (name ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  }
  const std::uint64_t place = scrambled(scrambled(seed) ^ run) ^ name;
  const std::uint64_t number =
      date == 0 ? scrambled(place) : scrambled(scrambled(place) ^ static_cast<std::uint64_t>(date));
  return static_cast<double>(number >> 11) / 9007199254740992.0;
}

/// 0 January ... 11 December, by going from year to year.
int month_of_day(std::int64_t date) {
  std::int64_t year = 1970;
  const auto is_leap = [](std::int64_t y) { return y % 4 == 0 && (y % 100 != 0 || y % 400 == 0); };
  while (date < 0) date += is_leap(--year) ? 366 : 365;
  while (date >= (is_leap(year) ? 366 : 365)) date -= is_leap(year++) ? 366 : 365;
  constexpr int kDays[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  int month = 0;
  for (;; ++month) {
    const int days = kDays[month] + (month == 1 && is_leap(year) ? 1 : 0);
    if (date < days) return month;
    date -= days;
  }
}

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

WorkingHours::WorkingHours(const Scene& scene) : seed_(scene.seed), run_(scene.run) {
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
    if (scene.sampled) calendar.lost = rules.lost;
    calendars_.push_back(std::move(calendar));
  }
}

std::vector<WorkingHours::Interval> WorkingHours::hours(std::span<const int> calendars,
                                                        std::int64_t day) const {
  std::vector<Interval> common = {{0, kDay}};
  for (const int index : calendars) {
    const Calendar& calendar = calendars_[static_cast<std::size_t>(index)];
    if (calendar.off.contains(first_day_ + day) || is_lost(index, day)) return {};
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

bool WorkingHours::is_lost(int index, std::int64_t day) const {
  const Calendar& calendar = calendars_[static_cast<std::size_t>(index)];
  if (calendar.lost.empty() || day < 0) return false;
  const std::int64_t date = first_day_ + day;
  return weather(seed_, run_, date) < calendar.lost[static_cast<std::size_t>(month_of_day(date))];
}

LostDates WorkingHours::lost_until(int index, Ticks end) const {
  LostDates result;
  const Calendar& calendar = calendars_[static_cast<std::size_t>(index)];
  for (std::int64_t day = 0; day * kDay < start_ + end; ++day) {
    if (calendar.off.contains(first_day_ + day)) continue;
    bool works = false;
    for (const auto& [from, to] : calendar.week[weekday(first_day_ + day)]) {
      const Ticks begin = std::max(day * kDay + from, start_);
      works = works || begin < std::min(day * kDay + to, start_ + end);
    }
    if (!works) continue;
    ++result.working_days;
    if (is_lost(index, day)) result.days.push_back(first_day_ + day);
  }
  return result;
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
