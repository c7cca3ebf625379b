#include "src/simulation/taskplan/schedule.hpp"

#include <algorithm>

namespace rubicon::taskplan {

const char* name_of(TaskResult result) {
  switch (result) {
    case TaskResult::done:
      return "done";
    case TaskResult::rejected:
      return "rejected";
    case TaskResult::not_reached:
      return "not reached";
  }
  return "";
}

std::vector<std::string> crew_names(const interpreter::PlanModel& plan,
                                    const interpreter::TaskSpec& task) {
  std::vector<std::string> names;
  const auto add = [&](int crew) {
    if (crew < 0) return;
    const std::string& name = plan.crews[static_cast<std::size_t>(crew)].name;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const int crew : task.crews) add(crew);
  for (const auto& work : {task.hook, task.adjust, task.release}) {
    if (work) add(work->crew);
  }
  for (const interpreter::WorkSpec& work : task.takes) add(work.crew);
  return names;
}

}  // namespace rubicon::taskplan
