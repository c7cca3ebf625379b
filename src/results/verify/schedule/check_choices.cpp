#include "src/results/verify/schedule/check_choices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/results/verify/replay/holds.hpp"

namespace rubicon::verify {

namespace {

using math::at;

/// Whom a task has by its pools: what all its choices have in common it has anyway.
std::set<int> members_of(const Scene& scene, const SceneTask& task) {
  std::set<int> members;
  const auto held = [&](const SceneTask& choice) {
    std::set<int> all;
    if (choice.robot >= 0) all.insert(choice.robot);
    for (const int crew : choice.crews) all.insert(static_cast<int>(scene.robots.size()) + crew);
    return all;
  };
  for (const int resource : held(task)) {
    const std::string& name = resource_name(scene, resource);
    const std::string list = ", " + task.members + ",";
    if (list.find(", " + name + ",") != std::string::npos) members.insert(resource);
  }
  return members;
}

/// The task whose members it has: what all of a group lead to.
int first_of(const Scene& scene, int task) {
  std::set<int> seen;  // a hostile header may go round
  while (scene.tasks[at(task)].same_as >= 0 && seen.insert(task).second) {
    task = scene.tasks[at(task)].same_as;
  }
  return task;
}

}  // namespace

std::optional<Trace> with_choices(const Trace& trace, Faults& faults) {
  const auto by_pools = [](const SceneTask& task) { return !task.choices.empty(); };
  const bool any = std::any_of(trace.scene.tasks.begin(), trace.scene.tasks.end(), by_pools);
  std::optional<Trace> result;
  if (any) result = trace;
  for (const Record& record : trace.records) {
    const auto* start = std::get_if<TaskStart>(&record.what);
    if (start == nullptr) continue;
    const std::string& name = trace.runs[at(record.run)];
    const auto fault = [&](std::string text) {
      faults.push_back({FaultKind::resource, ResultFile::trace, record.line, name, record.time,
                        std::move(text)});
    };
    const auto known = trace.scene.task_index.find(name);
    if (known == trace.scene.task_index.end()) continue;
    const std::vector<SceneTask>& choices = trace.scene.tasks[at(known->second)].choices;
    if (choices.empty()) {
      if (!start->chosen.empty()) fault("it chooses somebody, and names no pool");
      continue;
    }
    const auto choice = std::find_if(choices.begin(), choices.end(), [&](const SceneTask& each) {
      return each.members == start->chosen;
    });
    if (choice == choices.end()) {
      fault(fmt::format("'{}' is no choice of its pools", start->chosen));
      continue;
    }
    SceneTask& task = result->scene.tasks[at(known->second)];
    const int same_as = task.same_as;
    std::vector<SceneLink> after = std::move(task.after);
    task = *choice;
    task.after = std::move(after);
    task.same_as = same_as;
    task.choices = choices;
  }
  return result;
}

void check_same_as(const Trace& trace, const std::vector<TaskRun>& runs, Faults& faults) {
  const Scene& scene = trace.scene;
  std::vector<int> run_of(scene.tasks.size(), -1);
  std::map<int, std::vector<Hold>> holds;  // of each resource
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!runs[i].happened) continue;
    if (runs[i].task >= 0) run_of[at(runs[i].task)] = static_cast<int>(i);
    for (const Hold& hold : holds_of(trace, runs, static_cast<int>(i))) {
      holds[hold.resource].push_back(hold);
    }
  }
  for (std::size_t i = 0; i < scene.tasks.size(); ++i) {
    const SceneTask& task = scene.tasks[i];
    const int run = run_of[i];
    if (task.same_as < 0 || run < 0 || run_of[at(task.same_as)] < 0) continue;
    const TaskRun& own = runs[at(run)];
    const TaskRun& before = runs[at(run_of[at(task.same_as)])];
    const auto fault = [&](std::string text) {
      faults.push_back({FaultKind::resource, ResultFile::trace, own.start_line, task.name,
                        own.start, std::move(text)});
    };
    const std::set<int> members = members_of(scene, task);
    for (const int resource : members_of(scene, scene.tasks[at(task.same_as)])) {
      const std::string& name = resource_name(scene, resource);
      if (!members.contains(resource)) {
        fault(fmt::format("it has not {}, as {} has", name, scene.tasks[at(task.same_as)].name));
      }
      for (const Hold& hold : holds[resource]) {
        const TaskRun& other = runs[at(hold.run)];
        if (other.task < 0 || hold.from < before.end - kTimeSlack ||
            hold.to > own.start + kTimeSlack) {
          continue;
        }
        // Of what takes no time, at the same moment, the order of the records counts.
        if (other.end_line < before.start_line || other.start_line > own.start_line) continue;
        if (first_of(scene, other.task) == first_of(scene, static_cast<int>(i))) continue;
        fault(fmt::format("{} is in {} before, and was kept for it", name,
                          scene.tasks[at(other.task)].name));
      }
    }
  }
}

std::vector<Kept> kept_for_nothing(const Trace& trace, const std::vector<TaskRun>& runs) {
  struct Group {
    std::set<int> members;  // whom those of it had that are done
    Ticks until = 0;
    bool for_nothing = false;
  };
  const Scene& scene = trace.scene;
  std::set<int> firsts;
  for (std::size_t i = 0; i < scene.tasks.size(); ++i) {
    if (scene.tasks[i].same_as >= 0) firsts.insert(first_of(scene, static_cast<int>(i)));
  }
  std::map<int, Group> groups;
  for (const TaskRun& run : runs) {
    if (run.task < 0 || !run.ended) continue;
    const int first = first_of(scene, run.task);
    if (!firsts.contains(first)) continue;
    Group& group = groups[first];
    if (run.happened) group.members.merge(members_of(scene, scene.tasks[at(run.task)]));
    if (run.end > group.until) group.for_nothing = !run.happened;
    group.until = std::max(group.until, run.end);
  }
  std::vector<Kept> kept;
  for (const auto& [first, group] : groups) {
    if (!group.for_nothing) continue;
    for (const int resource : group.members) kept.push_back({resource, group.until});
  }
  return kept;
}

}  // namespace rubicon::verify
