#include "src/simulation/taskplan/stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "src/simulation/site/make_site.hpp"
#include "src/simulation/taskplan/plan_calendars.hpp"
#include "src/simulation/taskplan/plan_network.hpp"
#include "src/simulation/taskplan/precomputed_times.hpp"

namespace rubicon::taskplan {

Stage::Stage(const interpreter::PlanModel& the_plan, const interpreter::SourceMap& the_sources,
             trace::TraceSink* sink, trace::TraceDetail detail)
    : plan(the_plan),
      sources(the_sources),
      trace(the_plan, the_sources, sink, detail),
      site(site::make_site(the_plan)),
      site_changes(site) {
  for (int robot = 0; robot < robots(); ++robot) {
    views_.emplace_back(site, robot);
    interpreter::TaskSpec& park = parks_.emplace_back();
    park.name = "park " + robot_spec(robot).name;
    park.robot = robot;
    if (!robot_spec(robot).park) continue;
    park.go.emplace();
    park.go->values = *robot_spec(robot).park;
  }
  for (const interpreter::TaskSpec& task : plan.tasks) specs_.push_back(&task);
  for (const interpreter::TaskSpec& park : parks_) specs_.push_back(&park);
  tasks_of_.resize(parks_.size());
  for (int task = 0; task < plan_tasks(); ++task) {
    if (spec(task).robot >= 0) tasks_of_[at(spec(task).robot)].push_back(task);
  }

  std::vector<std::string> names;
  std::vector<int> sizes;
  std::vector<int> calendars;
  for (const interpreter::RobotSpec& robot : plan.robots) {
    names.push_back(robot.name);
    sizes.push_back(1);
    calendars.push_back(calendar_index(plan, robot.calendar));
  }
  for (const interpreter::CrewSpec& crew : plan.crews) {
    names.push_back(crew.name);
    sizes.push_back(1);
    calendars.push_back(calendar_index(plan, crew.calendar));
  }
  schedule::Network network;
  for (const std::string& name : names) network.resources.push_back({name, -1});
  allocator.emplace(std::move(names), sizes, std::move(calendars), calendars_of(plan));
  queue_.resize(specs_.size());
  std::vector<Ticks> work;
  for (int task = 0; task < tasks(); ++task) work.push_back(prepare_queue(task));

  network.tasks = network_tasks(plan);
  const auto precomputed = precomputed_times(plan, network.tasks);
  for (const interpreter::TaskSpec& park : parks_) network.tasks.emplace_back().name = park.name;
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    // Motions are work too.
    if (network.tasks[i].work == 0 && specs_[i]->robot >= 0) network.tasks[i].work = 1;
  }
  links.emplace(std::move(network), std::move(work), precomputed,
                [this](int task) -> const schedule::WorkCalendar& { return calendar(task); });
}

/// What the task holds from start to finish: its robot and the crews of `by`; one without a robot
/// also the crews of its works. The crew work that is known before it starts; -1: not known.
Ticks Stage::prepare_queue(int task) {
  const interpreter::TaskSpec& each = spec(task);
  const std::vector<int> resources = held_resources(plan, each);
  std::vector<Share> shares;
  for (const int resource : resources) shares.push_back(share_of(task, resource));
  const auto queue = allocator->queue_for(std::move(shares), resources);
  queue_[at(task)] = std::get<int>(queue);
  // What may fail or has to wait for a machine is known only when it is done.
  if (each.robot >= 0 || !each.remove.empty()) return -1;
  const Ticks work = std::accumulate(each.takes.begin(), each.takes.end(), Ticks{0},
                                     [](Ticks sum, const interpreter::WorkSpec& one) {
                                       return sum + interpreter::ticks_from_seconds(one.duration);
                                     });
  if (work == 0 && !each.zones.empty()) return -1;
  // A milestone waits for nobody.
  if (work == 0) queue_[at(task)] = std::get<int>(allocator->queue_for({}, {}));
  return work;
}

Share Stage::share_of(int /*task*/, int resource) const {
  return {resource, allocator->size_of(resource)};
}

const interpreter::Program& Stage::program_of(int robot) {
  const auto& checked = robot_spec(robot).robot;
  const auto found = programs_.find(checked.get());
  if (found != programs_.end()) return found->second;
  return programs_.emplace(checked.get(), interpreter::compile(checked)).first->second;
}

std::string Stage::who_is(int task) const {
  const int robot = spec(task).robot;
  return robot >= 0 ? fmt::format("{} ({})", robot_spec(robot).name, spec(task).name)
                    : spec(task).name;
}

void Stage::reject(int task, std::string reason, std::vector<int> involved) {
  if (!rejection) rejection = Rejection{task, std::move(reason), std::move(involved)};
}

void Stage::made_progress() {
  ++progress.count;
  progress.last = now();
}

void Stage::announce(const SiteEvent& event) {
  for (std::size_t i = 0; i < active.size(); ++i) {
    const ActiveTask& task = active[i];
    if (!task.activity || events.is_set(task.task)) continue;
    if (task.activity->wakes_at(task, *this, event)) events.set(task.task, now());
  }
}

void Stage::came_further(ActiveTask& task) {
  ++task.account.progress;
  announce({spec(task.task).robot, task.task});
}

void Stage::pause(int task, const char* why, const std::string& whom, Ticks since) {
  if (since == now()) return;
  if (auto* const writer = trace_of(task)) writer->pause(why, whom, since, now());
}

WaitTarget Stage::move_of(int robot, WaitTarget::Kind kind, int number) const {
  WaitTarget target{kind, number, {}, false, false};
  const int holder = allocator->state(robot).holder();
  if (holder >= 0) {
    target.by.push_back(holder);
    target.machine = kind == WaitTarget::Kind::activity;
    return target;
  }
  target.idle = true;
  if (may_park_some_day(robot)) return target;
  for (const int task : tasks_of_[at(robot)]) {
    if (!is_over(task)) target.by.push_back(task);
  }
  return target;
}

void Stage::add_resource(WaitSet& waits, int task, int resource) const {
  const int holder = allocator->state(resource).holder();
  if (holder < 0 || holder == task) return;
  waits.targets.push_back({WaitTarget::Kind::resource, resource, {holder}, false, false});
}

std::string Stage::gone(int component) const {
  for (int robot = 0; robot < robots(); ++robot) {
    const auto& load = site.load(robot);
    if (!load || load->component != component) continue;
    const int holder = allocator->state(robot).holder();
    return fmt::format("{} hangs on {} just then{}", site.component_name(component),
                       robot_spec(robot).name,
                       holder >= 0 ? ": put this after " + spec(holder).name : std::string());
  }
  return site.component_name(component) + " is not on the site any more";
}

std::vector<int> Stage::users_of(int component) const {
  std::vector<int> users;
  for (int i = 0; i < plan_tasks(); ++i) {
    const interpreter::TaskSpec& task = spec(i);
    const bool removes =
        std::find(task.remove.begin(), task.remove.end(), component) != task.remove.end();
    if (has_begun(i) && (removes || task.move == component)) users.push_back(i);
  }
  return users;
}

std::vector<int> Stage::in_the_way_of(const ActiveTask& task) const {
  std::vector<int> tasks;
  for (std::size_t i = 0; i < active.size(); ++i) {
    const int other = active[i].task;
    if (other == task.task) continue;
    const interpreter::TaskSpec& its = spec(other);
    const auto& met = task.hits.met();
    const bool machine = its.robot >= 0 && met.contains({its.robot, std::string()});
    if (machine || (its.move && met.contains({-1, site.component_name(*its.move)}))) {
      tasks.push_back(other);
    }
  }
  return tasks;
}

}  // namespace rubicon::taskplan
