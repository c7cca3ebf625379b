#include "src/results/verify/replay/holds.hpp"

#include <algorithm>
#include <set>

#include "src/motion/math/index.hpp"

namespace rubicon::verify {

namespace {

using math::at;

/// Nobody works in it, nothing moves or goes: a moment that others wait for.
bool is_milestone(const SceneTask& task) {
  const bool works = std::any_of(task.takes.begin(), task.takes.end(),
                                 [](const SceneWork& work) { return work.time > 0; });
  return task.robot < 0 && !works && task.remove.empty() && task.zones.empty();
}

}  // namespace

std::vector<Hold> holds_of(const Trace& trace, const std::vector<TaskRun>& runs, int index) {
  std::vector<Hold> holds;
  const TaskRun& run = runs[at(index)];
  if (!run.happened) return holds;
  const Scene& scene = trace.scene;
  const int robots = static_cast<int>(scene.robots.size());
  std::set<int> crews;
  const auto people_of = [&](int resource) {
    if (run.task >= 0 && resource >= robots) {
      const auto& needs = scene.tasks[at(run.task)].needs;
      const auto need = needs.find(resource - robots);
      if (need != needs.end()) return need->second;
    }
    return size_of_resource(scene, resource);
  };
  const auto hold_whole = [&](int resource) {
    holds.push_back(
        {resource, run.start, run.end, index, run.start_line, true, people_of(resource)});
  };
  if (run.robot >= 0) hold_whole(run.robot);
  if (run.task >= 0 && !is_milestone(scene.tasks[at(run.task)])) {
    const SceneTask& task = scene.tasks[at(run.task)];
    crews.insert(task.crews.begin(), task.crews.end());
    for (const int robot : task.also_robots) hold_whole(robot);
    for (const SceneWork& work : task.takes) {
      if (run.robot < 0 && work.crew >= 0) crews.insert(work.crew);
    }
  }
  for (const int crew : crews) hold_whole(robots + crew);
  for (const int i : run.records) {
    const Record& record = trace.records[at(i)];
    const auto* work = std::get_if<Work>(&record.what);
    if (work == nullptr || work->crew < 0 || crews.contains(work->crew)) continue;
    holds.push_back({robots + work->crew, work->from, record.time, index, record.line, false,
                     people_of(robots + work->crew)});
  }
  return holds;
}

std::vector<int> calendars_of(const Trace& trace, const std::vector<TaskRun>& runs, int index) {
  std::vector<int> calendars;
  for (const Hold& hold : holds_of(trace, runs, index)) {
    if (!hold.whole) continue;
    const std::vector<int> its = calendar_of_resource(trace.scene, hold.resource);
    calendars.insert(calendars.end(), its.begin(), its.end());
  }
  return calendars;
}

int size_of_resource(const Scene& scene, int resource) {
  const int robots = static_cast<int>(scene.robots.size());
  return resource < robots ? 1 : scene.crews[at(resource - robots)].size;
}

const std::string& resource_name(const Scene& scene, int resource) {
  const int robots = static_cast<int>(scene.robots.size());
  return resource < robots ? scene.robots[at(resource)].name
                           : scene.crews[at(resource - robots)].name;
}

std::vector<int> calendar_of_resource(const Scene& scene, int resource) {
  const int robots = static_cast<int>(scene.robots.size());
  const int calendar = resource < robots ? scene.robots[at(resource)].calendar
                                         : scene.crews[at(resource - robots)].calendar;
  return calendar < 0 ? std::vector<int>() : std::vector<int>{calendar};
}

}  // namespace rubicon::verify
