#include "src/results/gantt/time_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "src/simulation/schedule/time_text.hpp"

namespace rubicon::gantt {

namespace {

using schedule::CivilTime;
using schedule::kDay;
using schedule::kHour;
using schedule::kMinute;
using schedule::kSecond;
using schedule::kWeek;

constexpr std::array<Ticks, 24> kSteps = {
    kSecond,     2 * kSecond, 5 * kSecond,  10 * kSecond, 30 * kSecond, kMinute,
    2 * kMinute, 5 * kMinute, 10 * kMinute, 15 * kMinute, 30 * kMinute, kHour,
    2 * kHour,   3 * kHour,   6 * kHour,    12 * kHour,   kDay,         2 * kDay,
    kWeek,       2 * kWeek,   4 * kWeek,    13 * kWeek,   26 * kWeek,   52 * kWeek};

constexpr std::array<const char*, 12> kMonths = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                 "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};

Ticks choose_step(Ticks end, int most) {
  for (const Ticks step : kSteps) {
    if (end / step + 1 <= most) return step;
  }
  return (end / (most - 1) / (52 * kWeek) + 1) * (52 * kWeek);
}

const char* month_of(const schedule::Date& date) {
  return kMonths[static_cast<std::size_t>(date.month - 1)];
}

class DatedAxis {
 public:
  DatedAxis(const CivilTime& start, Ticks step) : start_(start), step_(step) {}

  /// The first mark: not before the plan, at a round time of the clock, the week or the day.
  Ticks first() const {
    const std::int64_t day = schedule::days_from_date(start_.date);
    const std::int64_t since = step_ % kWeek == 0 ? schedule::weekday_from_days(day)
                               : step_ > kDay     ? day % (step_ / kDay)
                                                  : 0;
    const Ticks begun = (since * kDay + start_.minute_of_day * kMinute) % step_;
    return begun == 0 ? 0 : step_ - begun;
  }

  std::string mark(Ticks time) const {
    const CivilTime moment = schedule::civil_time_at(start_, time);
    if (step_ >= kDay) return fmt::format("{} {}", moment.date.day, month_of(moment.date));
    const int minute = moment.minute_of_day;
    if (step_ >= kMinute) return fmt::format("{:02}:{:02}", minute / 60, minute % 60);
    return fmt::format("{:02}:{:02}:{:02}", minute / 60, minute % 60, time / kSecond % 60);
  }

  std::string head(Ticks time) const {
    const CivilTime moment = schedule::civil_time_at(start_, time);
    const schedule::Date& date = moment.date;
    if (step_ >= kDay) return fmt::format("{} {}", month_of(date), date.year);
    return fmt::format(
        "{} {} {} {}",
        schedule::kWeekdayNames[static_cast<std::size_t>(schedule::weekday_of(date))], date.day,
        month_of(date), date.year);
  }

  /// Where the next day, or month, begins.
  Ticks next_head(Ticks time) const {
    CivilTime moment = schedule::civil_time_at(start_, time);
    std::int64_t day = schedule::days_from_date(moment.date) + 1;
    if (step_ >= kDay) {
      while (schedule::date_from_days(day).day != 1) ++day;
    }
    return schedule::ticks_between(start_, {schedule::date_from_days(day), 0})
        .value_or(schedule::kEndOfTime);
  }

 private:
  CivilTime start_;
  Ticks step_;
};

std::string elapsed_label(Ticks time, Ticks step) {
  const Ticks seconds = time / kSecond;
  if (step >= kDay) return fmt::format("day {}", time / kDay + 1);
  if (time >= kDay && step >= kMinute) {
    return fmt::format("{} d {:02}:{:02}", time / kDay, seconds / 3600 % 24, seconds / 60 % 60);
  }
  if (step >= kMinute) return fmt::format("{}:{:02} h", seconds / 3600, seconds / 60 % 60);
  return fmt::format("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

/// More heads than this would stand on each other.
constexpr std::size_t kMostHeads = 200;

}  // namespace

TimeAxis make_axis(const std::optional<CivilTime>& start, Ticks end, int most) {
  TimeAxis axis;
  const Ticks step = choose_step(end, most);
  if (!start) {
    for (Ticks time = 0; time <= end; time += step) {
      axis.marks.push_back({time, elapsed_label(time, step)});
    }
    return axis;
  }
  const DatedAxis dated(*start, step);
  for (Ticks time = dated.first(); time <= end; time += step) {
    axis.marks.push_back({time, dated.mark(time)});
  }
  for (Ticks time = 0; time <= end && axis.heads.size() < kMostHeads;
       time = dated.next_head(time)) {
    axis.heads.push_back({time, dated.head(time)});
  }
  return axis;
}

}  // namespace rubicon::gantt
