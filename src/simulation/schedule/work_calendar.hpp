#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "src/simulation/schedule/lost_days.hpp"
#include "src/simulation/schedule/ticks.hpp"

namespace rubicon::schedule {

/// Why there is no such calendar, in a sentence for the user.
struct CalendarMistake {
  std::string message;
};

/// When work is done: the same hours every week, but for days off.
///
/// Working time is a set of half-open intervals [from, to). Every query takes
/// O(log days off + log intervals of a week), however long the time it spans: the working time up
/// to a moment is a sum over whole weeks less a running sum over days off, and `reach` inverts it.
/// Moments beyond kEndOfTime are kEndOfTime.
class WorkCalendar {
 public:
  /// Part of a week: ticks from Monday 00:00, from < to <= kWeek.
  struct Interval {
    Ticks from = 0;
    Ticks to = 0;

    bool operator==(const Interval&) const = default;
  };

  /// What a calendar is made of. `calendar_of` makes it from what a plan says.
  struct Parts {
    std::vector<std::string> names;      ///< whose calendar, for messages
    Ticks monday = 0;                    ///< 00:00 on Monday of the week of the start, <= 0
    std::vector<Interval> week;          ///< in any order, may overlap
    std::vector<std::int64_t> off_days;  ///< days from that Monday, in any order
    bool carry_over = false;             ///< motions too stop at the end of a shift
    std::int64_t first_day = 0;          ///< that Monday, counted from 1970-01-01
    std::optional<LostDays> lost = {};   ///< from the start on
  };

  /// A calendar of these parts, or what is wrong with them: an interval that is none, or no
  /// working time at all.
  static std::variant<WorkCalendar, CalendarMistake> make(Parts parts);

  /// Day and night, every day: where there is no calendar.
  WorkCalendar();

  /// Whether work is done in the tick that begins at t.
  bool works_at(Ticks t) const;

  /// The first moment at or after t at which work can begin.
  Ticks next_working(Ticks t) const;

  /// The last moment at or before t at which work can have ended: t itself in a shift and at its
  /// end, else the end of the shift before.
  Ticks last_working(Ticks t) const;

  /// The end of the shift that t lies in: the first moment at or after t at which no work is done;
  /// t itself out of shift, kEndOfTime where work never stops.
  Ticks shift_end(Ticks t) const;

  /// The longest shift of a week, days off aside; `to` may lie in the next week. Day and night:
  /// from 0 to kEndOfTime.
  Interval longest_shift() const;

  /// When work that begins at t (or, out of shift, when the next shift begins) is done. It stops
  /// at the end of a shift and goes on in the next. No work is done at once: t.
  Ticks finish(Ticks t, Ticks work) const;

  /// The last moment at which work can begin that is done by t. No work: t.
  Ticks latest_start(Ticks t, Ticks work) const;

  /// t moved by so much working time: `finish` for a positive, `latest_start` for a negative one.
  Ticks shifted(Ticks t, Ticks work) const;

  /// Working time in [from, to); 0 if there is nothing between.
  Ticks work_between(Ticks from, Ticks to) const;

  /// Time outside of shifts in [from, to); 0 if there is nothing between.
  Ticks idle_between(Ticks from, Ticks to) const;

  /// What the weather takes of the time up to `end`, from the start on.
  struct Lost {
    std::int64_t working_days = 0;   ///< days with working time, lost or not
    std::vector<std::int64_t> days;  ///< those that are lost, counted from 1970-01-01
  };
  Lost lost_until(Ticks end) const;

  bool carries_over() const { return carry_over_; }
  /// 00:00 on Monday of the week of the start, <= 0: what weeks count from.
  Ticks monday() const { return monday_; }

  /// The names of the calendars this one is made of, sorted; none for the one without a name.
  const std::vector<std::string>& names() const { return names_; }

  bool operator==(const WorkCalendar&) const = default;

  friend std::variant<WorkCalendar, CalendarMistake> intersection(const WorkCalendar& a,
                                                                  const WorkCalendar& b);

 private:
  void add_off_day(std::int64_t day) const;
  void draw_until(std::int64_t day) const;
  std::size_t offs_before(std::int64_t day) const;
  Ticks pattern_worked(Ticks u) const;
  Ticks pattern_reach(Ticks work) const;
  Ticks worked(Ticks t) const;
  Ticks reach(Ticks work) const;

  std::vector<std::string> names_;
  Ticks monday_ = 0;
  std::vector<Interval> week_;      // in order, apart from each other
  std::vector<Ticks> week_worked_;  // up to the begin of each interval; then of the whole week
  // Days off in order, only those on which the week works: where days are lost, of those before
  // `drawn_until_`. They are drawn when somebody asks so far, so a calendar is of one thread.
  mutable std::vector<std::int64_t> off_days_;
  mutable std::vector<Ticks> off_work_;     // the work of the days off before each; then of all
  mutable std::vector<Ticks> off_reached_;  // `worked` at the begin of each day off
  bool carry_over_ = false;
  std::int64_t first_day_ = 0;
  std::optional<LostDays> lost_;
  std::vector<std::int64_t> listed_off_;  // where days are lost: those that the plan names
  mutable std::size_t next_listed_ = 0;
  mutable std::int64_t drawn_until_ = 0;
};

/// When both work: hours that both have, days off of either; motions carry over if either says so.
/// A mistake if they have no hour in common or do not count from the same start.
std::variant<WorkCalendar, CalendarMistake> intersection(const WorkCalendar& a,
                                                         const WorkCalendar& b);

}  // namespace rubicon::schedule
