#include "src/simulation/taskplan/preflight_errors.hpp"

#include <fmt/format.h>

#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "src/simulation/schedule/calendar_rules.hpp"
#include "src/simulation/taskplan/plan_calendars.hpp"

namespace rubicon::taskplan {

namespace {

using interpreter::Diagnostic;
using interpreter::Severity;
using interpreter::Span;

Diagnostic mistake(const char* code, Span span, std::string message, std::string hint = {}) {
  return {Severity::error, code, span, std::move(message), {}, std::move(hint)};
}

void add_unsupported(const interpreter::PlanModel& plan, std::vector<Diagnostic>& all) {
  for (const interpreter::PlanModel::Use& use : plan.uses) {
    if (use.what == "import") {
      all.push_back(mistake("X01", use.span, "run does not read imports in a plan",
                            "make a plan of the file with rubicon import, and run that"));
    }
    if (use.what.starts_with("policy ")) {
      all.push_back(mistake("X04", use.span, "a network with " + use.what + " has no tasks",
                            "rubicon run and rubicon check take it; rubicon verify judges its "
                            "result"));
    }
  }
}

/// Whether all calendars can be made.
bool add_calendar_mistakes(const interpreter::PlanModel& plan, std::vector<Diagnostic>& all) {
  bool fine = true;
  for (const interpreter::CalendarSpec& calendar : plan.calendars) {
    if (!calendar.off.empty() && !plan.start_at) {
      fine = false;
      all.push_back(mistake("X02", calendar.span,
                            fmt::format("calendar '{}' has days off, but the plan does not say on "
                                        "which day it begins",
                                        calendar.name),
                            "add for example start_at \"2026-03-02 07:00\";"));
      continue;
    }
    const auto made = schedule::calendar_of(calendar, start_of(plan));
    if (const auto* wrong = std::get_if<schedule::CalendarMistake>(&made)) {
      fine = false;
      all.push_back(mistake("X03", calendar.span, wrong->message));
    }
  }
  return fine;
}

std::string calendar_name(const interpreter::PlanModel& plan, int resource) {
  const auto robots = static_cast<int>(plan.robots.size());
  return resource < robots ? plan.robots[static_cast<std::size_t>(resource)].calendar
                           : plan.crews[static_cast<std::size_t>(resource - robots)].calendar;
}

/// The sets of calendars that have to have hours in common for a task.
std::set<std::set<int>> calendar_sets(const interpreter::PlanModel& plan,
                                      const interpreter::TaskSpec& task) {
  std::set<int> held;
  const auto calendar_of = [&](int resource) {
    return calendar_index(plan, calendar_name(plan, resource));
  };
  for (const int resource : held_resources(plan, task)) held.insert(calendar_of(resource));
  held.erase(-1);
  std::set<std::set<int>> sets = {held};
  const auto with = [&](const interpreter::WorkSpec& work) {
    if (work.crew < 0) return;
    std::set<int> both = held;
    both.insert(calendar_of(static_cast<int>(plan.robots.size()) + work.crew));
    both.erase(-1);
    sets.insert(std::move(both));
  };
  for (const auto& work : {task.hook, task.adjust, task.release}) {
    if (work) with(*work);
  }
  for (const interpreter::WorkSpec& work : task.takes) with(work);
  if (interpreter::held_whole(plan, task)) {
    std::set<int> lift = held;
    for (const int crew : interpreter::crews_of_lift(task)) {
      lift.insert(calendar_of(static_cast<int>(plan.robots.size()) + crew));
    }
    lift.erase(-1);
    sets.insert(std::move(lift));
  }
  return sets;
}

void add_common_hours_mistakes(const interpreter::PlanModel& plan, std::vector<Diagnostic>& all) {
  const std::vector<schedule::WorkCalendar> calendars = calendars_of(plan);
  std::set<std::set<int>> seen;
  for (const interpreter::TaskSpec& task : plan.tasks) {
    std::set<std::set<int>> sets = calendar_sets(plan, task);
    for (const interpreter::TaskSpec& choice : task.choices) {
      sets.merge(calendar_sets(plan, choice));
    }
    for (const std::set<int>& set : sets) {
      if (set.size() < 2 || !seen.insert(set).second) continue;
      schedule::WorkCalendar common = calendars[static_cast<std::size_t>(*set.begin())];
      for (auto index = std::next(set.begin()); index != set.end(); ++index) {
        auto both = intersection(common, calendars[static_cast<std::size_t>(*index)]);
        if (const auto* wrong = std::get_if<schedule::CalendarMistake>(&both)) {
          all.push_back(
              mistake("X03", task.span,
                      fmt::format("task '{}' never begins: {}", task.name, wrong->message)));
          break;
        }
        common = std::get<schedule::WorkCalendar>(std::move(both));
      }
    }
  }
}

}  // namespace

std::vector<Diagnostic> preflight_errors(const interpreter::PlanModel& plan) {
  std::vector<Diagnostic> all;
  add_unsupported(plan, all);
  if (add_calendar_mistakes(plan, all)) add_common_hours_mistakes(plan, all);
  return all;
}

}  // namespace rubicon::taskplan
