#include <fmt/format.h>

#include <algorithm>

#include "interpreter/check/check_plan_parts.hpp"

namespace rubicon::interpreter {

namespace {

/// The calendars of all that the lift of a task needs; "" for who has none.
std::vector<const std::string*> calendars_of_lift(const PlanModel& plan, const TaskSpec& task) {
  std::vector<const std::string*> names;
  if (task.robot >= 0) {
    names.push_back(&plan.robots[static_cast<std::size_t>(task.robot)].calendar);
  }
  for (const int crew : crews_of_lift(task)) {
    names.push_back(&plan.crews[static_cast<std::size_t>(crew)].calendar);
  }
  return names;
}

const CalendarSpec* find_calendar(const PlanModel& plan, const std::string& name) {
  const auto found = std::find_if(plan.calendars.begin(), plan.calendars.end(),
                                  [&](const CalendarSpec& each) { return each.name == name; });
  return found == plan.calendars.end() ? nullptr : &*found;
}

}  // namespace

std::vector<int> crews_of_lift(const TaskSpec& task) {
  std::vector<int> crews = task.crews;
  for (const auto* work : {&task.hook, &task.adjust, &task.release}) {
    if (!*work || (*work)->crew < 0) continue;
    if (std::find(crews.begin(), crews.end(), (*work)->crew) == crews.end()) {
      crews.push_back((*work)->crew);
    }
  }
  return crews;
}

bool held_whole(const PlanModel& plan, const TaskSpec& task) {
  if (!task.whole || !task.move) return false;
  bool any = false;
  for (const std::string* name : calendars_of_lift(plan, task)) {
    const CalendarSpec* calendar = find_calendar(plan, *name);
    if (calendar == nullptr) continue;
    if (calendar->carry_over) return false;
    any = true;
  }
  return any;
}

namespace plan_check {

std::optional<bool> resolve_whole(Subject& subject, const syntax::WholeItem& item) {
  if (!item.value || item.value->text == "on") return true;
  if (item.value->text == "off") return false;
  subject.error("P09", item.value->span,
                fmt::format("whole is on or off, found '{}'", item.value->text));
  return std::nullopt;
}

void check_whole(Subject& subject) {
  const PlanModel& plan = subject.model;
  std::vector<std::vector<const TaskSpec*>> needed(plan.calendars.size());
  for (const TaskSpec& task : plan.tasks) {
    if (!task.whole || !task.move) continue;
    std::vector<const CalendarSpec*> seen;
    for (const std::string* name : calendars_of_lift(plan, task)) {
      const CalendarSpec* calendar = find_calendar(plan, *name);
      if (calendar == nullptr || !calendar->carry_over) continue;
      if (std::find(seen.begin(), seen.end(), calendar) != seen.end()) continue;
      seen.push_back(calendar);
      needed[static_cast<std::size_t>(calendar - plan.calendars.data())].push_back(&task);
    }
  }
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (needed[i].empty()) continue;
    const std::size_t others = needed[i].size() - 1;
    Diagnostic diagnostic;
    diagnostic.severity = Severity::warning;
    diagnostic.code = "P36";
    diagnostic.span = plan.calendars[i].span;
    diagnostic.message = fmt::format(
        "calendar '{}' says carry_over: the load of task '{}'{} may hang on the hook beyond the "
        "end "
        "of a shift",
        plan.calendars[i].name, needed[i].front()->name,
        others == 0 ? std::string() : fmt::format(" (and of {} more)", others));
    diagnostic.hint = "leave out carry_over, or say whole off; in the plan";
    subject.diagnostics.add(std::move(diagnostic));
  }
}

}  // namespace plan_check

}  // namespace rubicon::interpreter
