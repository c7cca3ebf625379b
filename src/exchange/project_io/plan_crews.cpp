#include "src/exchange/project_io/plan_crews.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "src/exchange/project_io/crew_lanes.hpp"
#include "src/exchange/project_io/plan_calendar.hpp"
#include "src/exchange/project_io/plan_terms.hpp"

namespace rubicon::project_io {

namespace {

using TaskAndResource = std::pair<std::size_t, std::size_t>;

/// Who works on what, each pair once, in the order of the assignments; and with how many.
std::vector<TaskAndResource> workers_of(const Project& project,
                                        std::map<TaskAndResource, double>& units) {
  std::unordered_map<std::int64_t, std::size_t> tasks;
  std::unordered_map<std::int64_t, std::size_t> resources;
  for (std::size_t i = 0; i < project.tasks.size(); ++i) tasks.emplace(project.tasks[i].uid, i);
  for (std::size_t i = 0; i < project.resources.size(); ++i) {
    resources.emplace(project.resources[i].uid, i);
  }
  std::vector<TaskAndResource> pairs;
  std::set<TaskAndResource> known;
  for (const Assignment& each : project.assignments) {
    if (each.resource == kNone) continue;
    const TaskAndResource pair(tasks.at(each.task), resources.at(each.resource));
    if (project.resources[pair.second].type != ResourceType::work) continue;
    if (known.insert(pair).second) pairs.push_back(pair);
    units[pair] += each.units;
  }
  return pairs;
}

using Week = std::array<DayTimes, 7>;

/// The hours that both weeks have; nothing: none.
std::optional<Week> common_hours(const Week& a, const Week& b) {
  Week both;
  bool any = false;
  for (std::size_t day = 0; day < 7; ++day) {
    for (const Interval& here : a[day]) {
      for (const Interval& there : b[day]) {
        const Interval common{std::max(here.from, there.from), std::min(here.to, there.to)};
        if (common.from < common.to) both[day].push_back(common);
      }
    }
    any |= !both[day].empty();
  }
  return any ? std::optional(both) : std::nullopt;
}

/// The week of each calendar that ever works.
std::map<std::int64_t, Week> weeks_of(const Project& project) {
  std::map<std::int64_t, Week> weeks;
  for (const Calendar& each : project.calendars) {
    if (auto plan = plan_calendar(project, each, "")) weeks.emplace(each.uid, plan->week);
  }
  return weeks;
}

/// Which crews are free of the calendar of their resource, and what then holds by itself.
void free_crews(const Project& project, const PlanNetwork& network,
                const std::vector<TaskAndResource>& pairs, PlanCrews& crews) {
  const auto works = [&](std::size_t task) {
    return network.tasks[task].planned && plan_seconds(project.tasks[task]) > 0 &&
           !runs_day_and_night(project.tasks[task]);
  };
  const auto calendar_of = [&](std::size_t resource) {
    return crew_calendar(project, project.resources[resource]);
  };
  std::vector<std::size_t> nth(project.tasks.size(), 0);
  std::vector<std::string> names;  // by pair
  std::vector<bool> by_itself;     // by pair: the task does not ask for the hours of this resource
  const std::map<std::int64_t, Week> weeks = weeks_of(project);
  std::map<std::size_t, Week> common;       // by line: of those on it so far
  std::vector<std::int64_t> hours_of_task;  // by line: its own calendar, or that of the first on it
  for (const Task& task : project.tasks) hours_of_task.push_back(task.calendar);
  for (const auto& [task, resource] : pairs) {
    names.push_back(crews.of_task[task][nth[task]++].crew);
    by_itself.push_back(works(task) && (goes_by_itself(project.tasks[task]) ||
                                        (project.tasks[task].calendar != kNone &&
                                         works_always(project, calendar_of(resource)))));
    if (works(task) && !by_itself.back()) {
      if (hours_of_task[task] == kNone) hours_of_task[task] = calendar_of(resource);
      for (const std::int64_t calendar : {hours_of_task[task], calendar_of(resource)}) {
        const auto week = weeks.find(calendar);
        if (week == weeks.end()) continue;
        const auto hours = common.try_emplace(task, week->second).first;
        if (const auto both = common_hours(hours->second, week->second)) {
          hours->second = *both;
          continue;
        }
        by_itself.back() = true;
        crews.apart.push_back({task, resource});
      }
    }
    if (by_itself.back()) crews.free[names.back()] = kNone;
  }
  // A crew whose tasks all have the same hours has these, so that nights cost nothing.
  std::map<std::string, std::set<std::int64_t>> hours;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [task, resource] = pairs[i];
    if (!works(task) || !crews.free.contains(names[i])) continue;
    hours[names[i]].insert(by_itself[i] ? hours_of_task[task] : calendar_of(resource));
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto found = crews.free.find(names[i]);
    if (found == crews.free.end() || hours[names[i]].size() > 1) continue;
    found->second = *hours[names[i]].begin();
    if (found->second == calendar_of(pairs[i].second)) crews.free.erase(found);
  }
  crews.calendars.resize(project.tasks.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [task, resource] = pairs[i];
    if (!works(task) || by_itself[i] || !crews.free.contains(names[i])) continue;
    const std::int64_t calendar = calendar_of(resource);
    std::vector<std::int64_t>& known = crews.calendars[task];
    if (std::find(known.begin(), known.end(), calendar) == known.end()) known.push_back(calendar);
  }
}

}  // namespace

PlanCrews plan_crews(const Project& project, const PlanNetwork& network, Levelling levelling,
                     Identifiers& taken) {
  PlanCrews crews;
  const auto new_name = [&](const Resource& resource) {
    return taken.make(resource.name, fmt::format("crew_{}", resource.uid));
  };
  for (const Resource& resource : project.resources) crews.names.push_back({new_name(resource)});
  std::map<TaskAndResource, double> units;
  const std::vector<TaskAndResource> pairs = workers_of(project, units);
  std::map<TaskAndResource, std::size_t> lane_of;
  if (levelling == Levelling::none) {
    std::vector<std::vector<std::size_t>> lines(project.resources.size());
    // A milestone holds nobody: it needs no lane.
    for (const auto& [task, resource] : pairs) {
      if (network.tasks[task].planned && plan_seconds(project.tasks[task]) > 0) {
        lines[resource].push_back(task);
      }
    }
    const CrewLanes lanes(network);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      std::sort(lines[i].begin(), lines[i].end());
      const std::vector<std::size_t> found = lanes.lanes_of(lines[i]);
      for (std::size_t k = 0; k < found.size(); ++k) {
        lane_of[{lines[i][k], i}] = found[k];
        while (crews.names[i].size() <= found[k]) {
          crews.names[i].push_back(new_name(project.resources[i]));
        }
      }
    }
  }
  crews.of_task.resize(project.tasks.size());
  for (const TaskAndResource& pair : pairs) {
    const auto lane = lane_of.find(pair);
    const std::vector<std::string>& names = crews.names[pair.second];
    crews.of_task[pair.first].push_back(
        {names[lane == lane_of.end() ? 0 : lane->second], pair.second, units.at(pair)});
  }
  free_crews(project, network, pairs, crews);
  return crews;
}

}  // namespace rubicon::project_io
