#include "src/exchange/project_io/outline_bounds.hpp"

#include <fmt/format.h>

namespace rubicon::project_io {

using interpreter::LinkSpec;
using interpreter::TaskSpec;

OutlineBounds::OutlineBounds(const interpreter::PlanModel& plan, const CarriedProject& carried)
    : plan_(plan), places_(carried.milestone_places), started_by_(plan.tasks.size()) {
  for (const std::string& line : carried.task_order) {
    for (const bool ends : {false, true}) {
      const std::string name = usual_milestone(line, ends);
      if (carried.milestones.contains(name)) places_.emplace(name, MilestonePlace{line, ends});
    }
  }
  for (const auto& [name, place] : places_) names_[{place.line, place.ends}] = name;
  for (std::size_t i = 0; i < plan.tasks.size(); ++i) {
    index_.emplace(plan.tasks[i].name, i);
    for (const LinkSpec& link : plan.tasks[i].after) {
      const bool of_start = link.type == LinkType::FS || link.type == LinkType::SS;
      if (of_start && link.lag >= 0) started_by_[static_cast<std::size_t>(link.task)].push_back(i);
    }
  }
}

const MilestonePlace* OutlineBounds::place(const std::string& milestone) const {
  const auto found = places_.find(milestone);
  return found == places_.end() ? nullptr : &found->second;
}

const TaskSpec* OutlineBounds::milestone_of(const std::string& line, bool ends) const {
  const auto name = names_.find({line, ends});
  if (name == names_.end()) return nullptr;
  const auto found = index_.find(name->second);
  return found == index_.end() ? nullptr : &plan_.tasks[found->second];
}

std::vector<bool> OutlineBounds::bound_to(std::size_t milestone, bool ends) const {
  std::vector<bool> bound(plan_.tasks.size(), false);
  std::vector<std::size_t> open = {milestone};
  const auto reach = [&](std::size_t i) {
    if (bound[i]) return;
    bound[i] = true;
    open.push_back(i);
  };
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    if (!ends) {
      for (const std::size_t next : started_by_[at]) reach(next);
      continue;
    }
    for (const LinkSpec& link : plan_.tasks[at].after) {
      const bool of_finish = link.type == LinkType::FS || link.type == LinkType::FF;
      if (of_finish && link.lag >= 0) reach(static_cast<std::size_t>(link.task));
    }
  }
  return bound;
}

std::string OutlineBounds::objection(const std::string& heading, std::size_t task) {
  for (const bool ends : {false, true}) {
    const TaskSpec* milestone = milestone_of(heading, ends);
    if (milestone == nullptr) continue;
    const auto [bound, is_new] = bound_.try_emplace({heading, ends});
    if (is_new) bound->second = bound_to(index_.at(milestone->name), ends);
    if (bound->second[task]) continue;
    return ends ? fmt::format("'{}' does not wait for it", milestone->name)
                : fmt::format("it does not wait for '{}'", milestone->name);
  }
  return {};
}

}  // namespace rubicon::project_io
