#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/simulation/taskplan/schedule.hpp"

namespace rubicon::taskplan {

/// Which machines have worked so long that they break down. Work is what a machine moves, and what
/// is worked in the tasks that have it; waits and nights do not count. Without a sample nothing
/// breaks down. A value: a run that goes back takes an earlier copy.
class Breakdowns {
 public:
  Breakdowns() = default;
  Breakdowns(const interpreter::PlanModel& plan,
             const std::optional<interpreter::SampleSpec>& sample);

  /// Whether the machine breaks down at all.
  bool breaks(int robot) const { return robot >= 0 && !machines_.empty() && machine(robot).breaks; }
  /// How much the machine can work still; 0: it is to be repaired now. `in_task`: what it did in
  /// the task that has it, all in all.
  Ticks left(int robot, Ticks in_task) const;

  /// A repair begins.
  struct Repair {
    Ticks every = 0;   ///< so much work it was good for
    Ticks worked = 0;  ///< so much it has done
    Ticks time = 0;    ///< in its working hours
  };
  Repair begin_repair(int robot, Ticks in_task);
  /// The task that had it is over.
  void give_back(int robot, Ticks in_task);

  /// Until when the machine is under repair that no task has.
  Ticks out_until(int robot) const {
    return robot < 0 || machines_.empty() ? 0 : machine(robot).out_until;
  }
  void set_out(int robot, Ticks until) { machine(robot).out_until = until; }
  /// The next end of such a repair after `now`; kEndOfTime if there is none.
  Ticks next_repaired(Ticks now) const;

 private:
  struct Machine {
    bool breaks = false;
    Ticks every = 0;         ///< the work that it is good for this time
    Ticks worked = 0;        ///< since the last repair, without the task that has it
    std::uint64_t uses = 0;  ///< draws up to now
    Ticks out_until = 0;
  };
  Machine& machine(int robot) { return machines_[static_cast<std::size_t>(robot)]; }
  const Machine& machine(int robot) const { return machines_[static_cast<std::size_t>(robot)]; }
  Ticks drawn(const sampling::DurationLaw& law, const std::string& name, std::uint64_t use) const;
  void draw(int robot);

  const interpreter::PlanModel* plan_ = nullptr;
  std::optional<interpreter::SampleSpec> sample_;
  std::vector<Machine> machines_;
};

class Stage;
struct ActiveTask;

/// What the robot of the task has done in it.
Ticks work_in(const ActiveTask& task);
/// Whether the robot of the task breaks down now, where nothing hangs on it and no lift is under
/// way: a lift is finished first.
bool breaks_down_now(const ActiveTask& task, const Stage& stage);
/// Its repair begins; when it will be done. kEndOfTime: never, also where machines broke down more
/// often than anybody counts.
Ticks begin_repair(const ActiveTask& task, Stage& stage);
/// Why a task is rejected whose machine is never repaired.
std::string never_repaired(const Stage& stage);

}  // namespace rubicon::taskplan
