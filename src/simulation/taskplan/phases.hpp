#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "src/simulation/taskplan/activity.hpp"
#include "src/simulation/taskplan/schedule.hpp"

namespace rubicon::taskplan {

/// What a task does, one after the other (LANGUAGE section 12).
struct Phase {
  enum class Kind { motion, weigh, work, attach, detach, remove, dig, haul };
  Kind kind = Kind::work;
  MotionPurpose purpose = MotionPurpose::go;  ///< of a motion
  const interpreter::WorkSpec* work = nullptr;
  const char* what = "";     ///< of a work: hook, adjust, release, takes
  int component = -1;        ///< of all that handle one
  bool begins_lift = false;  ///< the hook work, or the pick-up where there is none

  /// Work in the midst of which a machine may break down: nothing hangs on it.
  bool interruptible() const { return kind == Kind::work && std::string_view(what) == "takes"; }
};

/// The phases of a task; they point into it.
std::vector<Phase> phases_of(const interpreter::TaskSpec& task, const interpreter::Draws& draws);

/// What is done in a phase.
std::unique_ptr<Activity> activity_of(const Phase& phase);

}  // namespace rubicon::taskplan
