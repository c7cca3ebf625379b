#include "src/results/gantt/off_times.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace rubicon::gantt {

namespace {

using schedule::kDay;
using schedule::kMinute;

/// Of more days than this (three years) no chart shows the nights.
constexpr Ticks kMostDays = 1100;

/// Nor of more turns of shifts than this, twenty a day in three years: they would stand on each
/// other and cost time and memory.
constexpr Ticks kMostTurns = 20 * kMostDays;

/// Minutes of a day at which a shift may begin or end.
std::set<int> turning_minutes(const schedule::CalendarRules& rules) {
  std::set<int> minutes = {0};
  for (const auto& shift : rules.shifts) {
    for (const auto& [from, to] : shift.minutes) minutes.insert({from, to});
  }
  return minutes;
}

void add(std::vector<Span>& spans, const Span& next) {
  if (next.from >= next.to) return;
  if (!spans.empty() && spans.back().to == next.from) {
    spans.back().to = next.to;
  } else {
    spans.push_back(next);
  }
}

}  // namespace

std::vector<Span> off_times(const schedule::CalendarRules& rules, const schedule::CivilTime& start,
                            Ticks end) {
  const auto made = schedule::calendar_of(rules, start);
  if (const auto* mistake = std::get_if<schedule::CalendarMistake>(&made)) {
    throw std::invalid_argument(mistake->message);
  }
  const auto& calendar = std::get<schedule::WorkCalendar>(made);
  std::vector<Span> off;
  if (end / kDay > kMostDays) return off;
  const std::set<int> minutes = turning_minutes(rules);
  if ((end / kDay + 1) * static_cast<Ticks>(minutes.size()) > kMostTurns) return off;
  std::vector<Ticks> turns = {0};
  for (Ticks day = -start.minute_of_day * kMinute; day < end; day += kDay) {
    for (const int minute : minutes) {
      const Ticks turn = day + minute * kMinute;
      if (turn > turns.back() && turn < end) turns.push_back(turn);
    }
  }
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const Ticks to = i + 1 < turns.size() ? turns[i + 1] : end;
    if (!calendar.works_at(turns[i])) add(off, {turns[i], to});
  }
  return off;
}

std::vector<Span> in_both(const std::vector<Span>& a, const std::vector<Span>& b) {
  std::vector<Span> both;
  for (std::size_t i = 0, k = 0; i < a.size() && k < b.size();) {
    add(both, {std::max(a[i].from, b[k].from), std::min(a[i].to, b[k].to)});
    ++(a[i].to < b[k].to ? i : k);
  }
  return both;
}

std::vector<Span> without(const Span& span, const std::vector<Span>& off) {
  std::vector<Span> left;
  Ticks from = span.from;
  auto next = std::partition_point(off.begin(), off.end(),
                                   [&](const Span& each) { return each.to <= span.from; });
  for (; next != off.end() && next->from < span.to; ++next) {
    if (next->from > from) left.push_back({from, next->from});
    from = std::max(from, next->to);
  }
  if (from < span.to) left.push_back({from, span.to});
  return left;
}

}  // namespace rubicon::gantt
