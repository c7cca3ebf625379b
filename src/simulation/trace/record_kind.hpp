#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace rubicon::trace {

/// What a record of a trace tells of (docs/trace.md); a film numbers them in this order
/// (docs/film.md).
enum class RecordKind : std::uint8_t {
  task_start,
  goal,
  set,
  enter,
  exit,
  which,
  attempt,  ///< "try"
  wait,
  work,
  pause,
  attach,
  detach,
  remove,
  end,
  task_end,
  stop,
  guide,
  way_point,
  turn,        ///< of a hanging load, by people
  moving,      ///< something with a timetable stops or goes on
  cold_joint,  ///< what a tool laid met what had lain for too long
  breakdown,   ///< of a machine, and its repair
  lost_days,   ///< of a calendar, by the weather
  soil,        ///< a bucket has taken it
  think,       ///< a guide, while its robot stands
  foreseen,    ///< what another machine is foreseen to sweep, and a way would meet
  forbidden    ///< where a robot may not stand about what its guide searched through
};

/// As the member `type` writes them, in the order of RecordKind.
inline constexpr std::array<std::string_view, 27> kRecordTypes = {
    "task_start", "goal",      "set",   "enter",     "exit",     "which",    "try",
    "wait",       "work",      "pause", "attach",    "detach",   "remove",   "end",
    "task_end",   "stop",      "guide", "way_point", "turn",     "moving",   "cold_joint",
    "breakdown",  "lost_days", "soil",  "think",     "foreseen", "forbidden"};

/// The kind of a record by its `type`; nothing for what is none, such as a header.
constexpr std::optional<RecordKind> record_kind(std::string_view type) {
  for (std::size_t i = 0; i < kRecordTypes.size(); ++i) {
    if (kRecordTypes[i] == type) return static_cast<RecordKind>(i);
  }
  return std::nullopt;
}

}  // namespace rubicon::trace
