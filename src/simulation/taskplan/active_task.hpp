#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/machine/machine.hpp"
#include "src/simulation/taskplan/hit_recorder.hpp"
#include "src/simulation/taskplan/phases.hpp"
#include "src/simulation/taskplan/schedule.hpp"

namespace rubicon::taskplan {

/// What a task that has begun is doing.
enum class Doing {
  moving,
  working,
  waiting_for_shift,
  waiting_for_crew,
  waiting_for_machine,
  held
};

/// Who is in the way of a motion: a machine, or a task with a zone of people.
struct Blocker {
  int robot = -1;
  int zone_task = -1;
  std::string moved;  ///< the part that met it
  std::string met;    ///< what it met

  bool same_as(const Blocker& other) const {
    return robot == other.robot && zone_task == other.zone_task;
  }
};

/// Where a robot stood when it began to wait for others, and how far these had come.
struct WaitPlace {
  std::vector<double> q;
  std::uint64_t others = 0;
};

/// A task that has what it needs but for its zone, in which a machine stands.
struct ZoneWait {
  int task = -1;
  Ticks since = 0;
  int robot = -1;
  bool asks = false;  ///< it asks again for robots and crews
};

/// A task under way. A value: a run that goes back takes an earlier copy.
struct ActiveTask {
  int task = -1;
  TaskOutcome outcome;
  std::vector<Phase> phases;
  std::size_t phase = 0;
  Doing doing = Doing::moving;
  Doing then = Doing::moving;    ///< what it goes on with when the shift begins
  Ticks since = 0;               ///< when it began what it does
  std::optional<Ticks> wake;     ///< its next event; none: others wake it
  std::uint64_t sequence = 0;    ///< of its next event
  int crew = -1;                 ///< a crew it has, or asks for, for a work only: a resource
  Ticks crew_since = 0;          ///< when it got it
  std::vector<Ticks> over_time;  ///< motion out of shift of each robot and crew it holds
  std::vector<Ticks> worked;     ///< crew work of each of these

  // a motion
  std::optional<interpreter::Machine> machine;
  HitRecorder hits{nullptr};
  std::vector<interpreter::GoalSpec> goals;  ///< those that are left
  double budget = 0;                         ///< attempts left
  Ticks machine_start = 0;
  int tries_before = 0;             ///< of the machine, up to its last step
  int free_tries = 0;               ///< of these, what waiting for other machines took
  int waits = 0;                    ///< `wait`s since the last progress of anybody: they count
  std::uint64_t progress_seen = 0;  ///< the progress of the site up to which they were counted
  std::size_t way_points = 0;       ///< of this phase, behind it for good
  std::size_t goals_dropped = 0;    ///< of this phase, from the front of `goals`
  bool waits_in_script = false;     ///< its step is a `wait`
  math::Pose X_WO = math::Pose::Identity();  ///< where the component stood that it set out to take
  std::vector<Blocker> blockers;
  std::vector<WaitPlace> places;  ///< where it began to wait in this phase
  std::uint64_t progress = 0;     ///< grows with every phase done and every new place
  std::uint64_t others = 0;       ///< how far those in the way had come when it began to wait
  bool stubborn =
      false;  ///< it waits where it waited before, and who is in the way came no further
  bool may_go_on = false;  ///< what it waits with is enough for the task

  const Phase& now() const { return phases[phase]; }
};

}  // namespace rubicon::taskplan
