#pragma once

#include <memory>
#include <string>
#include <vector>

#include "src/simulation/taskplan/activity.hpp"
#include "src/simulation/taskplan/machine_wait.hpp"

namespace rubicon::taskplan {

/// Whether the task is rejected because others, machines too, stand on the component, which it
/// takes away.
bool undercuts(ActiveTask& task, Stage& stage, int component);

/// What takes no time: weighs, takes up, sets down or removes a component. Only people in whose
/// zone it stands, and the hours of a lift that begins with it, keep it from being taken up.
class HandlingActivity : public Activity {
 public:
  Step begin(ActiveTask& task, Stage& stage) override;
  Step resume(ActiveTask& task, Stage& stage) override;
  WaitSet waits(const ActiveTask& task, const Stage& stage) const override;
  std::string text_of(const ActiveTask& task, const Stage& stage,
                      const WaitTarget& target) const override;
  std::string standstill_reason(const ActiveTask& task, const Stage& stage) const override;
  bool wakes_at(const ActiveTask& task, const Stage& stage, const SiteEvent& event) const override;
  std::unique_ptr<Activity> snapshot() const override {
    return std::make_unique<HandlingActivity>(*this);
  }

 private:
  static Step weigh(ActiveTask& task, Stage& stage);
  Step begin_lift_here(ActiveTask& task, Stage& stage);
  Step attach(ActiveTask& task, Stage& stage);
  static Step detach(ActiveTask& task, Stage& stage);
  static Step remove(ActiveTask& task, Stage& stage);

  MachineWait wait_;         ///< of `attach`, once it waits
  bool holds_back_ = false;  ///< the lift that it begins waits for a shift
  bool held_back_ = false;   ///< and has waited for one into which it fits
  Ticks since_ = 0;          ///< since when
};

}  // namespace rubicon::taskplan
