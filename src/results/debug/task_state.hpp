#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "src/results/debug/event.hpp"

namespace rubicon::debug {

/// No real trace has more; one that somebody made up must not take time and memory by the square
/// of its length, since every state is kept and copied.
inline constexpr std::size_t kMostLoops = 1000;       ///< in one another
inline constexpr std::size_t kMostVariables = 4000;   ///< of a waypoint
inline constexpr std::size_t kMostParameters = 1000;  ///< of a robot
/// So many places of loops are told apart by how often they begin; those of longer scripts are not
/// counted.
inline constexpr std::size_t kMostVisited = 1000;

/// A loop that runs.
struct LoopState {
  TextId kind = kNone;          ///< chain, cycle, first
  std::uint32_t place = kNone;  ///< where it stands
  std::size_t entered = 0;      ///< the event that began it
  int visit = 0;  ///< how often it has begun since the waypoint began; 0 where it is not counted
  std::uint32_t first = kNone;  ///< the place that was tried or begun first in it
  int rounds = 0;               ///< how often that place was
  int tried = 0;                ///< attempts in it, loops inside it too
  int made = 0;                 ///< of them accepted

  bool operator==(const LoopState&) const = default;
};

/// Where a task stands after some of its events.
struct TaskState {
  std::size_t position = 0;          ///< so many events are behind it
  double t = 0;                      ///< s
  int n = 0;                         ///< number of the last attempt or wait
  int tried = 0;                     ///< attempts so far
  int made = 0;                      ///< of them accepted
  int waits = 0;                     ///< so far
  int motion = 0;                    ///< the motion it is in or was in last, from 1
  bool moving = false;               ///< whether that motion goes on
  int way_point = 0;                 ///< from 1; 0 before the first
  TextId carries = kNone;            ///< the component that hangs on the tool
  int carried = 0;                   ///< motions with it that have ended
  std::uint32_t row = kNone;         ///< the configuration; kNone: as at the beginning
  std::uint32_t row_before = kNone;  ///< before the last attempt
  std::vector<LoopState> loops;      ///< outermost first
  std::vector<std::pair<TextId, double>> variables;   ///< in the order of their first set
  std::vector<std::pair<std::uint32_t, int>> visits;  ///< place of a loop, how often it began

  bool operator==(const TaskState&) const = default;
};

/// The state after one more event.
void apply(const Event& event, TaskState& state);

}  // namespace rubicon::debug
