#include "src/results/verify/replay/component_stays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/results/verify/geometry/pose_miss.hpp"

namespace rubicon::verify {

namespace {

using math::at;

class StayBuilder {
 public:
  StayBuilder(const Trace& trace, const std::vector<TaskRun>& runs,
              const std::vector<RobotTrack>& tracks, Faults& faults)
      : trace_(trace), runs_(runs), tracks_(tracks), faults_(faults) {
    for (const SceneComponent& component : trace.scene.components) {
      places_.push_back({true, component.X_WO, 0});
    }
  }

  std::vector<Stay> build(std::vector<LoadEvent> events, Ticks until) {
    add_removals(events);
    std::stable_sort(events.begin(), events.end(), [](const LoadEvent& a, const LoadEvent& b) {
      return std::tie(a.time, a.line) < std::tie(b.time, b.line);
    });
    for (const LoadEvent& event : events) apply(event);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (places_[i].stands) leave(static_cast<int>(i), until);
    }
    return std::move(stays_);
  }

 private:
  struct Place {
    bool stands = false;
    Pose X_WO = Pose::Identity();
    Ticks since = 0;
  };

  void add_removals(std::vector<LoadEvent>& events) const {
    for (std::size_t run = 0; run < runs_.size(); ++run) {
      if (!runs_[run].happened) continue;
      for (const int index : runs_[run].records) {
        const Record& record = trace_.records[at(index)];
        const auto* change = std::get_if<LoadChange>(&record.what);
        if (change == nullptr || change->kind != LoadChange::Kind::remove) continue;
        events.push_back(
            {record.time, record.line, static_cast<int>(run), *change, Pose::Identity(), -1, -1});
      }
    }
  }

  const std::string& name(const LoadEvent& event) const {
    return trace_.scene.components[at(event.change.component)].name;
  }

  void fault(const LoadEvent& event, std::string text) {
    faults_.push_back({FaultKind::load, ResultFile::trace, event.line,
                       trace_.runs[at(runs_[at(event.run)].run)], event.time, std::move(text)});
  }

  void leave(int component, Ticks time) {
    Place& place = places_[at(component)];
    stays_.push_back({component, place.X_WO, place.since, time});
    place.stands = false;
  }

  void apply(const LoadEvent& event) {
    const int component = event.change.component;
    Place& place = places_[at(component)];
    switch (event.change.kind) {
      case LoadChange::Kind::attach:
        take(event, place);
        break;
      case LoadChange::Kind::detach:
        put_down(event, place);
        break;
      case LoadChange::Kind::remove:
        if (!place.stands) fault(event, name(event) + " is removed and does not stand");
        if (place.stands) leave(component, event.time);
        break;
    }
  }

  void take(const LoadEvent& event, const Place& place) {
    if (!place.stands) {
      fault(event, name(event) + " is taken and does not stand");
      return;
    }
    const PoseMiss off = pose_miss(event.X_WT * event.change.X, place.X_WO);
    if (!off.within(kSamePose)) {
      fault(event, fmt::format("{} hangs {} from where it stood", name(event), text_of(off)));
    }
    leave(event.change.component, event.time);
  }

  void put_down(const LoadEvent& event, Place& place) {
    const auto& loads = tracks_[at(event.robot)].loads;
    if (place.stands || event.hung < 0 ||
        loads[at(event.hung)].component != event.change.component) {
      fault(event, name(event) + " is put down and does not hang there");
    } else {
      const PoseMiss off = pose_miss(event.X_WT * loads[at(event.hung)].X_TO, event.change.X);
      if (!off.within(kSamePose)) {
        fault(event, fmt::format("{} hangs {} from where it is put", name(event), text_of(off)));
      }
    }
    if (place.stands) leave(event.change.component, event.time);
    place = {true, event.change.X, event.time};
    check_goal(event);
  }

  void check_goal(const LoadEvent& event) {
    const int task = runs_[at(event.run)].task;
    if (task < 0) return;
    const SceneTask& planned = trace_.scene.tasks[at(task)];
    if (planned.move != event.change.component) return;  // reported with the phases of the task
    const PoseMiss off = pose_miss(event.change.X, planned.X_WO_goal);
    if (off.within(goal_tolerance(trace_.scene.robots[at(event.robot)], planned.within))) return;
    fault(event, fmt::format("{} is {} from its goal", name(event), text_of(off)));
  }

  const Trace& trace_;
  const std::vector<TaskRun>& runs_;
  const std::vector<RobotTrack>& tracks_;
  Faults& faults_;
  std::vector<Place> places_;
  std::vector<Stay> stays_;
};

}  // namespace

std::vector<Stay> component_stays(const Trace& trace, const std::vector<TaskRun>& runs,
                                  const std::vector<RobotTrack>& tracks,
                                  std::vector<LoadEvent> events, Ticks until, Faults& faults) {
  return StayBuilder(trace, runs, tracks, faults).build(std::move(events), until);
}

}  // namespace rubicon::verify
