#pragma once

#include <vector>

#include "src/simulation/schedule/calendar_rules.hpp"

namespace rubicon::gantt {

using schedule::Ticks;

/// A time from which something holds up to another.
struct Span {
  Ticks from = 0;
  Ticks to = 0;
};

/// The times out of shift in [0, end), in order, for a plan that starts at `start`; none for a plan
/// that lasts longer than a chart can show the nights of. Throws std::invalid_argument for rules
/// that make no calendar.
std::vector<Span> off_times(const schedule::CalendarRules& rules, const schedule::CivilTime& start,
                            Ticks end);

/// The times that are in both of two lists, each in order.
std::vector<Span> in_both(const std::vector<Span>& a, const std::vector<Span>& b);

/// What is left of `span` without the times of `off`, which are in order.
std::vector<Span> without(const Span& span, const std::vector<Span>& off);

}  // namespace rubicon::gantt
