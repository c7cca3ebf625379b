#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/machine/machine.hpp"
#include "src/simulation/taskplan/activity.hpp"
#include "src/simulation/taskplan/machine_wait.hpp"
#include "src/simulation/taskplan/strip_progress.hpp"

namespace rubicon::taskplan {

/// A motion that the plan does not give as such: one of those of a task that digs.
struct MotionLeg {
  std::vector<interpreter::GoalSpec> goals;
  std::string situation;                     ///< that is on meanwhile
  std::vector<std::pair<int, int>> entered;  ///< bodies of the robot, components they may cut into
  bool guided = true;                        ///< by the guides of the task
  std::string what;                          ///< before the reason why it cannot be made
  /// Where it meets one of these it may end short; `ended_short` of the task says why. Null: none.
  std::shared_ptr<const std::set<std::string>> may_end_at;  // shared: each cut has the same
};

/// A motion of a task's robot: its script runs until it is at the goal, waits for machines in its
/// way, and is tried again when they have moved.
class MotionActivity : public Activity {
 public:
  /// To the goals of its task.
  MotionActivity() = default;
  /// To goals that were found on the way.
  explicit MotionActivity(MotionLeg leg)
      : leg_(std::make_shared<const MotionLeg>(std::move(leg))) {}
  Step begin(ActiveTask& task, Stage& stage) override;
  Step resume(ActiveTask& task, Stage& stage) override;
  WaitSet waits(const ActiveTask& task, const Stage& stage) const override;
  std::string text_of(const ActiveTask& task, const Stage& stage,
                      const WaitTarget& target) const override;
  std::string standstill_reason(const ActiveTask& task, const Stage& stage) const override;
  bool wakes_at(const ActiveTask& task, const Stage& stage, const SiteEvent& event) const override;
  std::vector<int> robots_in_the_way(const Stage& stage) const override;
  bool settle(ActiveTask& task, Stage& stage) override;
  std::unique_ptr<Activity> snapshot() const override {
    return std::make_unique<MotionActivity>(*this);
  }

 private:
  enum class Doing : std::uint8_t { moving, waiting_for_shift, waiting_for_machine, under_repair };
  /// Where the robot stood when it began to wait for others, and how far these had come.
  struct WaitPlace {
    std::vector<double> q;
    std::uint64_t others = 0;
  };

  Step start_machine(ActiveTask& task, Stage& stage);
  Step move_on(ActiveTask& task, Stage& stage);
  bool may_end_short(const RecordedHit* hit) const;
  Step end_motion(ActiveTask& task, Stage& stage);
  Step retry(ActiveTask& task, Stage& stage);
  void wait_for_shift(ActiveTask& task, Stage& stage);
  void wait_for_repair(ActiveTask& task, Stage& stage);
  bool is_at_goal(const ActiveTask& task, Stage& stage) const;
  void wait_for_machine(ActiveTask& task, Stage& stage, std::vector<Blocker> blockers, bool enough);
  void count_step(ActiveTask& task, Stage& stage, Ticks to, bool waited);
  void count_time(ActiveTask& task, Stage& stage, Ticks to, bool waited);
  void note_laid(ActiveTask& task, const Stage& stage, const std::vector<double>& before);
  void charge_wait(int looks);
  void refund_waits(const Stage& stage);
  std::string text_of_waits(const ActiveTask& task, const Stage& stage) const;

  std::shared_ptr<const MotionLeg> leg_;  // shared: never changed; null: that of the phase
  Doing doing_ = Doing::moving;
  Ticks since_ = 0;  ///< it waits for its shift or is under repair
  MachineWait wait_;
  std::vector<WaitPlace> places_;  ///< where it began to wait
  std::optional<interpreter::Machine> machine_;
  std::vector<interpreter::GoalSpec> goals_;         ///< those that are left
  std::shared_ptr<interpreter::GoalMemory> memory_;  ///< of the motion that begin() began
  double budget_ = 0;                                ///< attempts left
  Ticks machine_start_ = 0;
  int tries_before_ = 0;             ///< of the machine, up to its last step
  int free_tries_ = 0;               ///< of these, what waiting for other machines took
  int waits_ = 0;                    ///< `wait`s since the last progress of anybody: they count
  std::uint64_t progress_seen_ = 0;  ///< the progress of the site up to which they were counted
  std::size_t way_points_ = 0;       ///< behind it for good
  std::size_t goals_dropped_ = 0;    ///< from the front of `goals_`
  /// What would be accepted when the stop began that its motion may end with.
  std::optional<std::uint64_t> version_at_stop_;
  Ticks looked_again_ = -1;  ///< when it did so as something had gone since it was met
  std::string waited_for_;   ///< who was in its way when it waited last
  bool stands_ = false;      ///< what goes on is a `wait` or a stop, and no step
  StripProgress strip_;      ///< of a task that covers a floor
};

}  // namespace rubicon::taskplan
