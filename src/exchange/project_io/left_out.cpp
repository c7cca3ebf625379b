#include "src/exchange/project_io/left_out.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace rubicon::project_io {

namespace {

using interpreter::PlanModel;
using interpreter::TaskSpec;
using interpreter::WorkSpec;

/// The things of one kind, in the order of the plan.
class Things {
 public:
  void add(const std::string& name, interpreter::Span span) {
    if (names_.empty()) span_ = span;
    names_.push_back(name);
  }

  /// Lists them; `message` has {} where they are named, as `noun` (one of them, several).
  void list(const char* kind, const char* one, const char* several, const char* message,
            Listing& listing, const std::string& hint = {}) const {
    if (names_.empty()) return;
    const std::string noun = names_.size() == 1 ? one : several;
    listing.add("I09", kind, span_, fmt::format(fmt::runtime(message), noun + " " + text()), hint);
  }

 private:
  /// 'a', 'b' and 2 more
  std::string text() const {
    constexpr std::size_t kMostNames = 4;
    const std::size_t shown = names_.size() > kMostNames ? kMostNames - 1 : names_.size();
    std::string text;
    for (std::size_t i = 0; i < shown; ++i) {
      if (i > 0) text += i + 1 == names_.size() ? " and " : ", ";
      text += "'" + names_[i] + "'";
    }
    if (shown < names_.size()) text += fmt::format(" and {} more", names_.size() - shown);
    return text;
  }

  std::vector<std::string> names_;
  interpreter::Span span_;
};

/// Adds a thing to a list where `holds`.
template <typename Thing>
void add_if(bool holds, const Thing& thing, Things& things) {
  if (holds) things.add(thing.name, thing.span);
}

bool is_uncertain(const TaskSpec& task) {
  const auto by_law = [](const WorkSpec& work) { return work.law.has_value(); };
  const auto by_law_if_any = [&](const std::optional<WorkSpec>& work) {
    return work && by_law(*work);
  };
  return std::any_of(task.takes.begin(), task.takes.end(), by_law) || by_law_if_any(task.hook) ||
         by_law_if_any(task.adjust) || by_law_if_any(task.release) ||
         (task.dig && task.dig->draw >= 0);
}

bool is_fraction(double seconds) {
  constexpr double kRounding = 1e-6;  // of sums of numbers as people write them
  return std::fabs(seconds - std::round(seconds)) > kRounding;
}

void list_tasks(const PlanModel& plan, const std::vector<const TaskSpec*>& tasks, bool of_run,
                Listing& listing) {
  Things motions, zones, priorities, pools, same, uncertain, fractions;
  for (const TaskSpec* each : tasks) {
    if (each == nullptr) continue;
    const TaskSpec& task = *each;
    const bool moves = task.move || task.go || task.motion_dig || task.haul;
    add_if(moves && !of_run, task, motions);
    add_if(!task.zones.empty() || !task.remove.empty(), task, zones);
    if (task.priority != 0) priorities.add(task.name, task.priority_span);
    add_if(!task.same_as && !task.choices.empty(), task, pools);
    add_if(task.same_as.has_value(), task, same);
    // What was drawn is as certain as any other duration.
    const bool spreads = is_uncertain(task) && !plan.sample;
    add_if(spreads && !of_run, task, uncertain);
    add_if(!spreads && !of_run && is_fraction(crew_seconds(task)), task, fractions);
  }
  motions.list("motion", "task", "tasks",
               "the motions of {} are left out: a schedule knows crew work only", listing,
               "what a run takes is in its own schedule (rubicon run --out)");
  zones.list("zone", "task", "tasks",
             "zones and what is removed in {} are left out: a schedule has no place", listing);
  priorities.list("priority", "task", "tasks", "the priority of {} is left out", listing);
  pools.list("pool", "task", "tasks",
             "the choice of who does {} is left out: a schedule has no pools", listing);
  same.list("same as", "task", "tasks", "'same as' of {} is left out: a schedule has no pools",
            listing);
  fractions.list("fraction", "task", "tasks", "the durations of {} are rounded to whole seconds",
                 listing);
  uncertain.list("uncertain", "task", "tasks",
                 "the spread of the durations of {} is left out: their means are written", listing);
}

void list_resources(const PlanModel& plan, bool of_run, Listing& listing) {
  Things rentals, mobilisations, overtimes, fuels, breakdowns;
  const auto add_charges = [&](const auto& owner) {
    add_if(owner.charges.rental_per_day.has_value(), owner, rentals);
    add_if(owner.charges.mobilisation.has_value(), owner, mobilisations);
    add_if(owner.charges.overtime != 1, owner, overtimes);
    add_if(owner.charges.fuel.has_value(), owner, fuels);
  };
  for (const interpreter::RobotSpec& robot : plan.robots) {
    add_charges(robot);
    add_if(robot.breakdown && !of_run, robot, breakdowns);
  }
  for (const interpreter::CrewSpec& crew : plan.crews) add_charges(crew);
  rentals.list("rental", "of", "of", "the rental {} is left out", listing);
  mobilisations.list("mobilisation", "of", "of", "the mobilisation {} is left out", listing);
  overtimes.list("overtime", "of", "of", "the overtime {} is left out", listing);
  fuels.list("fuel", "of", "of", "the fuel {} is left out", listing);
  breakdowns.list("breakdown", "of", "of", "breakdowns {} are left out", listing);
}

void list_plan(const PlanModel& plan, bool of_run, Listing& listing) {
  Things lost, networks, movings, materials;
  for (const interpreter::CalendarSpec& calendar : plan.calendars) {
    add_if(calendar.loses_days() && !of_run, calendar, lost);
  }
  for (const interpreter::NetworkSpec& network : plan.networks) add_if(true, network, networks);
  for (const interpreter::MovingSpec& moving : plan.movings) add_if(true, moving, movings);
  for (const interpreter::ComponentSpec& component : plan.components) {
    add_if(component.cost.has_value(), component, materials);
  }
  lost.list("lost", "calendar", "calendars", "the lost days of {} are left out", listing);
  networks.list("network", "network", "networks", "a schedule has no place for {}", listing);
  movings.list("timetable", "of", "of", "the timetable {} is left out", listing);
  materials.list("material", "component", "components", "the cost of {} is left out", listing);
  if (plan.overhead_per_day.value_or(0) > 0) {
    listing.add("I09", "overhead", {}, "the overhead of the plan is left out");
  }
}

}  // namespace

double crew_seconds(const TaskSpec& task) {
  double seconds = 0;
  for (const auto& work : task.takes) seconds += work.duration;
  for (const auto* work : {&task.hook, &task.adjust, &task.release}) {
    if (*work) seconds += (*work)->duration;
  }
  return seconds;
}

void list_left_out(const PlanModel& plan, const std::vector<const TaskSpec*>& tasks, bool of_run,
                   Listing& listing) {
  list_tasks(plan, tasks, of_run, listing);
  list_resources(plan, of_run, listing);
  list_plan(plan, of_run, listing);
}

}  // namespace rubicon::project_io
