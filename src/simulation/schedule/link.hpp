#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "src/simulation/schedule/ticks.hpp"
#include "src/simulation/schedule/work_calendar.hpp"

namespace rubicon::schedule {

/// Which event of the task before holds which event of the task after: finish to start, ...
enum class LinkType { FS, SS, FF, SF };

/// "FS", "SS", "FF", "SF".
const char* name_of(LinkType type);

/// The type of that name; nothing for any other text.
std::optional<LinkType> parse_link_type(std::string_view text);

/// What a lag is counted in: every hour of the day, or working hours of the task after.
enum class LagClock { elapsed, working };

/// Which end of a task.
enum class TaskEnd { start, finish };

/// A task comes after another: its event is at least `lag` after the other's. A negative lag allows
/// it to be earlier.
struct Link {
  int task = -1;  ///< the task before
  LinkType type = LinkType::FS;
  Ticks lag = 0;
  LagClock clock = LagClock::elapsed;
};

/// The event of the task before that the link counts from.
TaskEnd end_before(LinkType type);

/// The event of the task after that the link holds.
TaskEnd end_after(LinkType type);

/// The moment before which a link does not let its event happen: the event it counts from, and the
/// lag (in working hours: those of `calendar`, of the task after).
Ticks bound_of(const Link& link, Ticks event, const WorkCalendar& calendar);

/// What the links of a task allow: -kEndOfTime if they hold nothing.
struct LinkBounds {
  Ticks start = -kEndOfTime;   ///< the task does not start before
  Ticks finish = -kEndOfTime;  ///< nor finish before
  int start_link = -1;         ///< the link that says so, the first of equals
  int finish_link = -1;

  /// Takes in what link number `index` says: `bound_of` it, for its `end_after`.
  void hold(TaskEnd end, Ticks bound, int index);
};

/// What decides when a task can start, but for shifts. `finish_link`: the start keeps the finish
/// from coming too early.
enum class StartHold { not_before, start_link, finish_link };

/// When a task can start.
struct EarliestStart {
  Ticks wanted = 0;  ///< by links and `not_before`, in or out of shift
  Ticks start = 0;   ///< `wanted`, or the begin of the next shift
  StartHold hold = StartHold::not_before;
};

/// The earliest start of a task with `work` ticks of crew work, not before `not_before`: late
/// enough for links that hold its start, and so late that it does not finish before links allow.
/// Where that finish is out of shift, the work is done by the end of the shift before (see
/// `held_finish`). A task without work needs no shift and starts where its links put it.
EarliestStart earliest_start(const LinkBounds& bounds, Ticks not_before, Ticks work,
                             const WorkCalendar& calendar);

/// The earliest start of a task whose duration shows only when it has run (motions): links that
/// hold its finish do not move its start.
EarliestStart earliest_start_of_unknown(const LinkBounds& bounds, Ticks not_before,
                                        const WorkCalendar& calendar);

/// The finish of a task that is done at `done`: it is held, with all that it holds, until links
/// allow it to finish.
Ticks held_finish(const LinkBounds& bounds, Ticks done);

}  // namespace rubicon::schedule
