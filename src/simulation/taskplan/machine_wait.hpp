#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/simulation/taskplan/active_task.hpp"
#include "src/simulation/taskplan/hit_recorder.hpp"
#include "src/simulation/taskplan/stage.hpp"

namespace rubicon::taskplan {

/// Who is in the way: a machine, a task with a zone of people, something with a timetable.
struct Blocker {
  int robot = -1;
  int zone_task = -1;
  int moving = -1;
  std::string moved;  ///< the part that met it
  std::string met;    ///< what it met; with `turn` the node where the robot goes first
  bool turn = false;
  Ticks time = 0;  ///< when it was met

  static Blocker of(const interpreter::HitPair& pair) {
    return {pair.machine, pair.zone_task, pair.moving, pair.moved, pair.met, pair.turn};
  }
  bool same_as(const Blocker& other) const {
    return robot == other.robot && zone_task == other.zone_task && moving == other.moving;
  }
};

/// Whether a machine or a zone has gone since it was met: nothing more will be told of it.
bool has_gone(const Stage& stage, const Blocker& blocker);

/// The machines and zones among hits, each once.
std::vector<Blocker> blockers_of(const std::vector<RecordedHit>& hits);

/// "left (go_right) waits for right: left.car meets right.car".
std::string text_of_way(const Stage& stage, int task, const Blocker& blocker);

/// Waiting until any of those in the way moves or leaves.
struct MachineWait {
  std::vector<Blocker> blockers;
  Ticks since = 0;
  std::uint64_t traffic = 0;  ///< what had changed on networks when it looked last
  std::uint64_t others = 0;   ///< how far those in the way had come when it began
  /// It waits where it waited before, and who is in the way came no further: until one does.
  bool stubborn = false;
  bool is_enough = false;  ///< what it has reached is enough for the task

  /// `own`: the robot that waits, -1: none.
  WaitSet waits(const Stage& stage, int own = -1) const;
  bool wakes_at(const Stage& stage, const SiteEvent& event) const;
  /// The machines that are in the way, or in the way of what is.
  std::vector<int> robots(const Stage& stage) const;
  /// Things with a timetable go on without anybody's doing: sets when the task looks again.
  void wait_for_timetables(Stage& stage, int task) const;
  /// Where it is known that the task waited for who was in the way, for the critical path.
  void note_wait(Stage& stage, int task) const;
  /// `own`: the robot that waits, -1: none.
  std::string standstill_reason(const Stage& stage, int own) const;
  /// Whom the trace names.
  std::string first_name(const Stage& stage) const;
};

/// How far those in the way have come, as a number that changes when one gets any further.
std::uint64_t progress_of(const Stage& stage, const std::vector<Blocker>& blockers);

}  // namespace rubicon::taskplan
