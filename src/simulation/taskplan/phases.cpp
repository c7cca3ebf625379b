#include "src/simulation/taskplan/phases.hpp"

#include "src/simulation/taskplan/dig_activity.hpp"
#include "src/simulation/taskplan/handling_activity.hpp"
#include "src/simulation/taskplan/haul_activity.hpp"
#include "src/simulation/taskplan/motion_activity.hpp"
#include "src/simulation/taskplan/work_activity.hpp"

namespace rubicon::taskplan {

std::vector<Phase> phases_of(const interpreter::TaskSpec& task, const interpreter::Draws& draws) {
  using Kind = Phase::Kind;
  std::vector<Phase> phases;
  const auto work = [&](const interpreter::WorkSpec& spec, const char* what) {
    phases.push_back({Kind::work, MotionPurpose::go, &spec, what, -1, false});
  };
  const auto handle = [&](Kind kind, int component) {
    phases.push_back({kind, MotionPurpose::go, nullptr, "", component, false});
  };
  const auto motion = [&](MotionPurpose purpose) {
    phases.push_back({Kind::motion, purpose, nullptr, "", task.move.value_or(-1), false});
  };
  if (task.move) {
    motion(MotionPurpose::grip);
    handle(Kind::weigh, *task.move);
    if (task.hook) work(*task.hook, "hook");
    const bool hooks = task.hook && interpreter::ticks_from_seconds(draws.duration(*task.hook)) > 0;
    if (hooks) phases.back().begins_lift = true;
    handle(Kind::attach, *task.move);
    phases.back().begins_lift = !hooks;
    motion(MotionPurpose::carry);
    if (task.adjust) work(*task.adjust, "adjust");
    motion(MotionPurpose::place);
    if (task.release) work(*task.release, "release");
    handle(Kind::detach, *task.move);
  }
  if (task.go) motion(MotionPurpose::go);
  if (task.motion_dig) {
    phases.push_back({Kind::dig, MotionPurpose::dig, nullptr, "", task.motion_dig->soil, false});
  }
  if (task.haul) phases.push_back({Kind::haul, MotionPurpose::haul, nullptr, "", -1, false});
  for (const interpreter::WorkSpec& extra : task.takes) work(extra, "takes");
  for (const int component : task.remove) handle(Kind::remove, component);
  return phases;
}

std::unique_ptr<Activity> activity_of(const Phase& phase) {
  switch (phase.kind) {
    case Phase::Kind::motion:
      return std::make_unique<MotionActivity>();
    case Phase::Kind::work:
      return std::make_unique<WorkActivity>();
    case Phase::Kind::dig:
      return std::make_unique<DigActivity>();
    case Phase::Kind::haul:
      return std::make_unique<HaulActivity>();
    case Phase::Kind::weigh:
    case Phase::Kind::attach:
    case Phase::Kind::detach:
    case Phase::Kind::remove:
      break;
  }
  return std::make_unique<HandlingActivity>();
}

}  // namespace rubicon::taskplan
