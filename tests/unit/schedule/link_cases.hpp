#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/simulation/schedule/link.hpp"
#include "tests/unit/schedule/calendar_cases.hpp"

namespace rubicon::test {

/// A schedule worked by hand: `lead` (10 h) comes first, then `a` (6 h, after lead), and `b` (4 h)
/// follows `a` by the link of the case. Each has a crew of its own, so only links and shifts
/// matter.
struct LinkCase {
  const char* name;
  schedule::LinkType type;
  schedule::Ticks lag;
  schedule::LagClock clock;
  const char* expected;  ///< "START .. FINISH" of b
  const char* why;
};

/// The cases with one calendar for all three crews.
struct LinkCases {
  const char* name;
  const char* start;
  std::optional<schedule::CalendarRules> rules;  ///< none: day and night
  std::vector<LinkCase> cases;
};

/// Every type of link, without lag, with a positive and a negative one: without a calendar, with a
/// daily shift, over a weekend with a day off, and with lags in working hours.
const std::vector<LinkCases>& link_cases();

}  // namespace rubicon::test
