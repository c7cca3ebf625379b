#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "src/simulation/taskplan/activity.hpp"
#include "src/simulation/taskplan/load_turning.hpp"
#include "src/simulation/taskplan/machine_wait.hpp"
#include "src/simulation/taskplan/stage.hpp"

namespace rubicon::taskplan {

/// Work of a crew: in the shifts of all that it needs, by a crew that the task holds or by one that
/// it asks for here and gives back at the end.
class WorkActivity : public Activity {
 public:
  Step begin(ActiveTask& task, Stage& stage) override;
  Step resume(ActiveTask& task, Stage& stage) override;
  Step granted(ActiveTask& task, Stage& stage, const ResourceAllocator::Grant& grant) override;
  WaitSet waits(const ActiveTask& task, const Stage& stage) const override;
  std::string text_of(const ActiveTask& task, const Stage& stage,
                      const WaitTarget& target) const override;
  std::string standstill_reason(const ActiveTask& task, const Stage& stage) const override;
  bool wakes_at(const ActiveTask& task, const Stage& stage, const SiteEvent& event) const override;
  std::vector<int> robots_in_the_way(const Stage& stage) const override;
  std::unique_ptr<Activity> snapshot() const override {
    return std::make_unique<WorkActivity>(*this);
  }

 private:
  enum class Doing : std::uint8_t {
    working,
    waiting_for_shift,
    waiting_for_crew,
    waiting_for_lift,
    waiting_for_machine,
    under_repair
  };

  Step ask(ActiveTask& task, Stage& stage);
  static int work_queue(const ActiveTask& task, Stage& stage);
  static const schedule::WorkCalendar& work_hours(const ActiveTask& task, Stage& stage);
  static void end_shift_wait(ActiveTask& task, Stage& stage, Ticks since);
  Step work(ActiveTask& task, Stage& stage);
  bool finds_a_turn(ActiveTask& task, Stage& stage);
  bool may_turn(ActiveTask& task, Stage& stage);
  Step try_again(ActiveTask& task, Stage& stage);
  Ticks part_of(const ActiveTask& task, const Stage& stage, Ticks left) const;
  void wait_for_repair(ActiveTask& task, Stage& stage);
  void give_back(ActiveTask& task, Stage& stage);

  Doing doing_ = Doing::working;
  Ticks since_ = 0;         ///< it waits for a shift or a crew, or its machine is under repair
  Ticks done_ = 0;          ///< of work that a breakdown interrupts: what is done of it
  bool held_back_ = false;  ///< the lift that it begins has waited for a shift into which it fits
  int crew_ = -1;           ///< a crew it has, or asks for, for this work only: a resource
  Ticks crew_since_ = 0;    ///< when it got it
  Ticks before_ = 0;        ///< working time of the task until then
  LoadTurning turning_;     ///< of work that turns the load
  MachineWait wait_;        ///< for those in the way of that
};

}  // namespace rubicon::taskplan
