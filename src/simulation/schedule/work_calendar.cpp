#include "src/simulation/schedule/work_calendar.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <iterator>

namespace rubicon::schedule {

namespace {

using Interval = WorkCalendar::Interval;

/// In order, with those that meet or overlap joined.
std::vector<Interval> joined(std::vector<Interval> intervals) {
  std::sort(intervals.begin(), intervals.end(), [](const Interval& a, const Interval& b) {
    return std::pair(a.from, a.to) < std::pair(b.from, b.to);
  });
  std::vector<Interval> result;
  for (const Interval& each : intervals) {
    if (!result.empty() && each.from <= result.back().to) {
      result.back().to = std::max(result.back().to, each.to);
    } else {
      result.push_back(each);
    }
  }
  return result;
}

/// What is in both lists; each in order and apart.
std::vector<Interval> common(const std::vector<Interval>& a, const std::vector<Interval>& b) {
  std::vector<Interval> result;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const Interval both{std::max(a[i].from, b[j].from), std::min(a[i].to, b[j].to)};
    if (both.from < both.to) result.push_back(both);
    (a[i].to < b[j].to ? i : j) += 1;
  }
  return result;
}

template <typename T>
std::vector<T> merged(const std::vector<T>& a, const std::vector<T>& b) {
  std::vector<T> result;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

std::string never_works(const std::vector<std::string>& names) {
  if (names.size() < 2) {
    return fmt::format("calendar '{}' has no working hours", fmt::join(names, ""));
  }
  return fmt::format("calendars '{}' have no working hours in common", fmt::join(names, "', '"));
}

}  // namespace

WorkCalendar::WorkCalendar() : week_{{0, kWeek}}, week_worked_{0, kWeek}, off_work_{0} {}

std::variant<WorkCalendar, CalendarMistake> WorkCalendar::make(Parts parts) {
  WorkCalendar calendar;
  std::sort(parts.names.begin(), parts.names.end());
  calendar.names_ = std::move(parts.names);
  if (parts.monday > 0 || parts.monday <= -kWeek) {
    return CalendarMistake{
        "a calendar counts from the Monday of the week in which the plan starts"};
  }
  calendar.monday_ = parts.monday;
  calendar.carry_over_ = parts.carry_over;
  for (const Interval& each : parts.week) {
    if (each.from < 0 || each.from >= each.to || each.to > kWeek) {
      return CalendarMistake{
          fmt::format("calendar '{}' has a shift that does not end after it begins",
                      fmt::join(calendar.names_, "', '"))};
    }
  }
  calendar.week_ = joined(std::move(parts.week));
  if (calendar.week_.empty()) return CalendarMistake{never_works(calendar.names_)};
  calendar.week_worked_.assign(1, 0);
  for (const Interval& each : calendar.week_) {
    calendar.week_worked_.push_back(calendar.week_worked_.back() + each.to - each.from);
  }
  std::sort(parts.off_days.begin(), parts.off_days.end());
  parts.off_days.erase(std::unique(parts.off_days.begin(), parts.off_days.end()),
                       parts.off_days.end());
  calendar.off_work_.assign(1, 0);
  // Nothing asks beyond the end of time, and the ticks of such a day need not fit.
  std::erase_if(parts.off_days, [](std::int64_t day) {
    return day < -kEndOfTime / kDay || day > kEndOfTime / kDay;
  });
  calendar.first_day_ = parts.first_day;
  if (!parts.lost) {
    for (const std::int64_t day : parts.off_days) calendar.add_off_day(day);
    return calendar;
  }
  calendar.lost_ = parts.lost;
  calendar.listed_off_ = std::move(parts.off_days);
  calendar.drawn_until_ = floor_division(-parts.monday, kDay);
  while (calendar.next_listed_ < calendar.listed_off_.size() &&
         calendar.listed_off_[calendar.next_listed_] < calendar.drawn_until_) {
    calendar.add_off_day(calendar.listed_off_[calendar.next_listed_++]);
  }
  return calendar;
}

/// The days off come in order.
void WorkCalendar::add_off_day(std::int64_t day) const {
  const Ticks before = pattern_worked(day * kDay);
  const Ticks work = pattern_worked((day + 1) * kDay) - before;
  if (work == 0) return;
  off_days_.push_back(day);
  off_reached_.push_back(before - off_work_.back());
  off_work_.push_back(off_work_.back() + work);
}

/// Draws which days before this one are lost.
void WorkCalendar::draw_until(std::int64_t day) const {
  constexpr std::int64_t kDrawnAtOnce = 64;
  if (!lost_ || day <= drawn_until_) return;
  const std::int64_t end = std::max(day, drawn_until_ + kDrawnAtOnce);
  for (; drawn_until_ < end; ++drawn_until_) {
    const bool listed =
        next_listed_ < listed_off_.size() && listed_off_[next_listed_] == drawn_until_;
    if (listed) ++next_listed_;
    if (listed || lost_->is_lost(first_day_ + drawn_until_)) add_off_day(drawn_until_);
  }
}

WorkCalendar::Lost WorkCalendar::lost_until(Ticks end) const {
  Lost lost;
  if (!lost_) return lost;
  const Ticks from = -monday_;
  const Ticks to = within_time(end) - monday_;
  for (std::int64_t day = floor_division(from, kDay); day * kDay < to; ++day) {
    const Ticks begin = std::max(day * kDay, from);
    const bool works = pattern_worked(std::min((day + 1) * kDay, to)) > pattern_worked(begin);
    if (!works || std::binary_search(listed_off_.begin(), listed_off_.end(), day)) continue;
    ++lost.working_days;
    if (lost_->is_lost(first_day_ + day)) lost.days.push_back(first_day_ + day);
  }
  return lost;
}

std::variant<WorkCalendar, CalendarMistake> intersection(const WorkCalendar& a,
                                                         const WorkCalendar& b) {
  if (a == WorkCalendar()) return b;
  if (b == WorkCalendar()) return a;
  WorkCalendar::Parts parts;
  parts.names = merged(a.names_, b.names_);
  if (a.monday_ != b.monday_) {
    return CalendarMistake{fmt::format("calendars '{}' do not count from the same start",
                                       fmt::join(parts.names, "', '"))};
  }
  parts.monday = a.monday_;
  parts.week = common(a.week_, b.week_);
  parts.off_days =
      merged(a.lost_ ? a.listed_off_ : a.off_days_, b.lost_ ? b.listed_off_ : b.off_days_);
  parts.first_day = a.first_day_;
  parts.lost = a.lost_ && b.lost_ ? both_lost(*a.lost_, *b.lost_) : a.lost_ ? a.lost_ : b.lost_;
  parts.carry_over = a.carry_over_ || b.carry_over_;
  return WorkCalendar::make(std::move(parts));
}

/// How many days off lie before this day.
std::size_t WorkCalendar::offs_before(std::int64_t day) const {
  const auto at = std::lower_bound(off_days_.begin(), off_days_.end(), day);
  return static_cast<std::size_t>(at - off_days_.begin());
}

/// Working time from Monday to u (ticks from Monday) if there were no days off.
Ticks WorkCalendar::pattern_worked(Ticks u) const {
  const std::int64_t week = floor_division(u, kWeek);
  const Ticks rest = u - week * kWeek;
  const auto after = std::upper_bound(week_.begin(), week_.end(), rest,
                                      [](Ticks time, const Interval& i) { return time < i.from; });
  Ticks work = week * week_worked_.back();
  if (after != week_.begin()) {
    const auto index = static_cast<std::size_t>(after - week_.begin() - 1);
    work += week_worked_[index] + std::min(rest, week_[index].to) - week_[index].from;
  }
  return work;
}

/// The first u at which `pattern_worked` is `work`.
Ticks WorkCalendar::pattern_reach(Ticks work) const {
  const Ticks per_week = week_worked_.back();
  const std::int64_t week = floor_division(work - 1, per_week);
  constexpr std::int64_t kMostWeeks = kEndOfTime / kWeek + 2;
  if (week > kMostWeeks) return kEndOfTime + kWeek;
  if (week < -kMostWeeks) return -kEndOfTime - kWeek;
  const Ticks rest = work - week * per_week;  // 1 ... per_week
  const auto at = std::lower_bound(week_worked_.begin(), week_worked_.end(), rest);
  const auto index = static_cast<std::size_t>(at - week_worked_.begin() - 1);
  return week * kWeek + week_[index].from + rest - week_worked_[index];
}

/// Working time up to t, from some moment that is the same for all t.
Ticks WorkCalendar::worked(Ticks t) const {
  const Ticks u = t - monday_;
  const std::int64_t day = floor_division(u, kDay);
  draw_until(day + 1);
  const std::size_t offs = offs_before(day);
  if (offs < off_days_.size() && off_days_[offs] == day) return off_reached_[offs];
  return pattern_worked(u) - off_work_[offs];
}

/// The first moment at which `worked` is `work`: days off that begin before that are passed over.
Ticks WorkCalendar::reach(Ticks work) const {
  while (true) {
    const auto at = std::lower_bound(off_reached_.begin(), off_reached_.end(), work);
    const Ticks skipped = off_work_[static_cast<std::size_t>(at - off_reached_.begin())];
    const Ticks reached = within_time(pattern_reach(work + skipped) + monday_);
    // Of the days up to there it must be known whether they are lost.
    const std::int64_t day = floor_division(reached - monday_, kDay) + 1;
    if (!lost_ || day <= drawn_until_ || reached == kEndOfTime) return reached;
    draw_until(day);
  }
}

bool WorkCalendar::works_at(Ticks t) const {
  t = within_time(t);
  return work_between(t, t + 1) == 1;
}

Ticks WorkCalendar::next_working(Ticks t) const {
  const Ticks end = finish(t, 1);
  return end == kEndOfTime ? end : end - 1;
}

Ticks WorkCalendar::last_working(Ticks t) const {
  const Ticks start = latest_start(t, 1);
  return start == -kEndOfTime ? start : start + 1;
}

Ticks WorkCalendar::shift_end(Ticks t) const {
  t = within_time(t);
  if (!works_at(t)) return t;
  const Ticks u = t - monday_;
  Ticks end = kEndOfTime - monday_;
  const std::int64_t tomorrow = floor_division(u, kDay) + 1;
  draw_until(tomorrow + kWeek / kDay);
  if (lost_ && week_worked_.back() == kWeek) {
    while (offs_before(tomorrow) == off_days_.size() && drawn_until_ < kEndOfTime / kDay) {
      draw_until(drawn_until_ + 1);
    }
  }
  const std::size_t offs = offs_before(tomorrow);
  if (offs < off_days_.size()) end = off_days_[offs] * kDay;
  if (week_worked_.back() < kWeek) {
    const std::int64_t week = floor_division(u, kWeek);
    const auto after =
        std::upper_bound(week_.begin(), week_.end(), u - week * kWeek,
                         [](Ticks time, const Interval& i) { return time < i.from; });
    Ticks to = std::prev(after)->to;
    // A night shift over Sunday goes on in the next week.
    if (to == kWeek && week_.front().from == 0) to += week_.front().to;
    end = std::min(end, week * kWeek + to);
  }
  return within_time(end + monday_);
}

Interval WorkCalendar::longest_shift() const {
  if (week_worked_.back() == kWeek) return {0, kEndOfTime};
  Interval longest;
  for (Interval each : week_) {
    if (each.to == kWeek && week_.front().from == 0) each.to += week_.front().to;
    if (each.to - each.from > longest.to - longest.from) longest = each;
  }
  return longest;
}

Ticks WorkCalendar::finish(Ticks t, Ticks work) const {
  t = within_time(t);
  if (work <= 0 || t == kEndOfTime) return t;
  return reach(worked(t) + within_time(work));
}

Ticks WorkCalendar::latest_start(Ticks t, Ticks work) const {
  t = within_time(t);
  if (work <= 0 || t == -kEndOfTime) return t;
  // The last moment with so much work before it is one tick before the first with one tick more.
  return within_time(reach(worked(t) - within_time(work) + 1) - 1);
}

Ticks WorkCalendar::shifted(Ticks t, Ticks work) const {
  return work >= 0 ? finish(t, work) : latest_start(t, -within_time(work));
}

Ticks WorkCalendar::work_between(Ticks from, Ticks to) const {
  from = within_time(from);
  to = within_time(to);
  return from < to ? worked(to) - worked(from) : 0;
}

Ticks WorkCalendar::idle_between(Ticks from, Ticks to) const {
  from = within_time(from);
  to = within_time(to);
  return from < to ? to - from - work_between(from, to) : 0;
}

}  // namespace rubicon::schedule
