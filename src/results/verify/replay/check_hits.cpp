#include "src/results/verify/replay/check_hits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/results/verify/replay/site_parts.hpp"

namespace rubicon::verify {

namespace {

using math::at;

/// The load of a short plan.
constexpr const char* kCarried = "load";

class HitCheck {
 public:
  HitCheck(const Trace& trace, const TaskRun& run, Faults& faults)
      : trace_(trace),
        run_(run),
        faults_(faults),
        robot_(trace.scene.robots[at(run.robot)]),
        load_(run.robot == 0 && !trace.scene.carry.empty() ? kCarried : "") {}

  void check() {
    for (const int index : run_.records) {
      record_ = &trace_.records[at(index)];
      if (const auto* attempt = std::get_if<Try>(&record_->what)) {
        check(*attempt);
      } else if (const auto* change = std::get_if<LoadChange>(&record_->what)) {
        const bool hangs = change->kind == LoadChange::Kind::attach;
        if (change->kind != LoadChange::Kind::remove) {
          load_ = hangs ? trace_.scene.components[at(change->component)].name : "";
        }
      } else if (const auto* turn = std::get_if<LoadTurn>(&record_->what)) {
        if (turn->hit) check_names(turn->hit->first, turn->hit->second);
      } else if (const auto* end = std::get_if<MotionEnd>(&record_->what)) {
        check(*end);
      }
    }
  }

 private:
  void fault(FaultKind kind, std::string text) {
    faults_.push_back({kind, ResultFile::trace, record_->line, trace_.runs[at(run_.run)],
                       record_->time, std::move(text)});
  }

  void check(const Try& attempt) {
    if (attempt.ok) {
      if (!attempt.reason.empty() || attempt.hit) {
        fault(FaultKind::order, "a step that was made has a reason why it was refused");
      }
      return;
    }
    const bool limit = attempt.reason.starts_with("limit ");
    ++refused_[limit ? "limit" : attempt.reason];
    const auto is_parameter = [&](const SceneParameter& each) {
      return each.name == attempt.reason.substr(6);
    };
    if (limit && std::none_of(robot_.parameters.begin(), robot_.parameters.end(), is_parameter)) {
      fault(FaultKind::order, fmt::format("'{}' names no parameter", attempt.reason));
    } else if (!limit && attempt.reason != "at goal" && attempt.reason != "no direction" &&
               attempt.reason != "hit") {
      fault(FaultKind::order, fmt::format("'{}' is no reason for a refusal", attempt.reason));
    }
    if (attempt.hit.has_value() != (attempt.reason == "hit")) {
      fault(FaultKind::order, "a refusal for a hit names what met, and no other does");
    } else if (attempt.hit) {
      check_names(attempt.hit->first, attempt.hit->second);
    }
  }

  bool has_body(const SceneRobot& robot, const std::string& name) const {
    return std::any_of(robot.bodies.begin(), robot.bodies.end(), [&](const SceneBody& body) {
      const std::string whole = robot.name + "." + body.name;
      return name == whole || (body.buffer > 0 && name == buffer_name(whole));
    });
  }

  bool is_on_site(const std::string& name) const {
    const Scene& scene = trace_.scene;
    if (scene.component_index.contains(name)) return true;
    if (!scene.carry.empty() && name == kCarried) return true;
    for (std::size_t i = 0; i < scene.site.size(); ++i) {
      if (name == scene.site_name(i)) return true;
    }
    if (name == "the load chart of " + robot_.name) return true;
    const auto is_moving = [&](const SceneMoving& each) {
      return name == each.name || (!each.overhead.empty() && name == air_above(each.name));
    };
    if (std::any_of(scene.movings.begin(), scene.movings.end(), is_moving)) return true;
    return std::any_of(scene.robots.begin(), scene.robots.end(),
                       [&](const SceneRobot& each) { return has_body(each, name); }) ||
           std::any_of(scene.tasks.begin(), scene.tasks.end(), [&](const SceneTask& task) {
             return (!task.zones.empty() && name == "the zone of " + task.name) ||
                    (!task.zones_overhead.empty() && name == overhead_name(task.name));
           });
  }

  /// Machines may keep out of what is no body: dynamic workspaces, and pits under their wheels.
  bool is_of_workspaces(const std::string& moved, const std::string& met) const {
    const auto& rules = trace_.scene.workspaces;
    if (!rules || moved != "the workspace of " + robot_.name) return false;
    const auto is_people = [&](const SceneMoving& each) {
      return !each.overhead.empty() && each.name == met;
    };
    return std::any_of(rules->robots.begin(), rules->robots.end(),
                       [&](int other) {
                         const std::string& name = trace_.scene.robots[at(other)].name;
                         return name != robot_.name && met == "the workspace of " + name;
                       }) ||
           std::any_of(trace_.scene.movings.begin(), trace_.scene.movings.end(), is_people);
  }
  bool is_pit(const std::string& met) const {
    if (run_.task < 0 || !trace_.scene.tasks[at(run_.task)].haul) return false;
    return std::any_of(trace_.scene.tasks.begin(), trace_.scene.tasks.end(),
                       [&](const SceneTask& task) {
                         return (task.motion_dig || (task.dig && task.dig->pit)) &&
                                met == "the pit of " + task.name;
                       });
  }

  void check_names(const std::string& moved, const std::string& met) {
    if (is_of_workspaces(moved, met)) return;
    if (is_pit(met) && has_body(robot_, moved)) return;
    if (!has_body(robot_, moved) && (load_.empty() || moved != load_)) {
      fault(FaultKind::contact, fmt::format("'{}' is no part of {}", moved, robot_.name));
    }
    if (!is_on_site(met) || met == moved) {
      fault(FaultKind::contact, fmt::format("'{}' is nothing that {} could meet", met, moved));
    }
  }

  void check(const MotionEnd& end) {
    const std::map<std::string, int> counted = std::exchange(refused_, {});
    std::set<std::string> reasons;
    for (const auto& [reason, count] : counted) reasons.insert(reason);
    for (const auto& [reason, count] : end.refused_for) reasons.insert(reason);
    const auto of = [](const std::map<std::string, int>& counts, const std::string& reason) {
      const auto found = counts.find(reason);
      return found == counts.end() ? 0 : found->second;
    };
    for (const std::string& reason : reasons) {
      if (of(counted, reason) == of(end.refused_for, reason)) continue;
      fault(FaultKind::clock,
            fmt::format("the motion counts {} refusals for '{}'; there are {}",
                        of(end.refused_for, reason), reason, of(counted, reason)));
    }
  }

  const Trace& trace_;
  const TaskRun& run_;
  Faults& faults_;
  const SceneRobot& robot_;
  std::string load_;  ///< what hangs on it; "": nothing
  std::map<std::string, int> refused_;
  const Record* record_ = nullptr;
};

}  // namespace

void check_hits(const Trace& trace, const TaskRun& run, Faults& faults) {
  if (run.happened && run.robot >= 0) HitCheck(trace, run, faults).check();
}

}  // namespace rubicon::verify
