#include "src/simulation/taskplan/stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "src/simulation/site/make_site.hpp"
#include "src/simulation/taskplan/plan_calendars.hpp"
#include "src/simulation/taskplan/plan_network.hpp"
#include "src/simulation/taskplan/precomputed_times.hpp"

namespace rubicon::taskplan {

Stage::Stage(const interpreter::PlanModel& the_plan, const interpreter::SourceMap& the_sources,
             const interpreter::Draws& the_draws, trace::TraceSink* sink, trace::TraceDetail detail,
             const site::PreparedSite& prepared)
    : plan(the_plan),
      draws(the_draws),
      sources(the_sources),
      trace(the_plan, the_sources, sink, detail),
      site(site::make_site(the_plan, prepared)),
      site_changes(site) {
  if (plan.support.mode != interpreter::SupportRules::Mode::off) {
    support.emplace(plan, site, prepared.surfaces);
    support->find_floating();
  }
  for (int robot = 0; robot < robots(); ++robot) {
    views_.emplace_back(site, robot);
    interpreter::TaskSpec& park = parks_.emplace_back();
    park.name = "park " + robot_spec(robot).name;
    park.robot = robot;
    if (!robot_spec(robot).park) continue;
    park.go.emplace();
    park.go->values = *robot_spec(robot).park;
    if (const int fleet = robot_spec(robot).fleet; fleet >= 0) {
      park.guides = {plan.fleets[at(fleet)].guide};
    }
  }
  for (const interpreter::TaskSpec& task : plan.tasks) specs_.push_back(&task);
  for (const interpreter::TaskSpec& park : parks_) specs_.push_back(&park);
  tasks_of_.resize(parks_.size());
  chosen_.resize(specs_.size(), -1);
  set_groups();
  for (int task = 0; task < plan_tasks(); ++task) {
    std::set<int> its = {spec(task).robot};
    for (const interpreter::TaskSpec& choice : spec(task).choices) its.insert(choice.robot);
    its.erase(-1);
    for (const int robot : its) tasks_of_[at(robot)].push_back(task);
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
    sizes.push_back(static_cast<int>(crew.size));
    calendars.push_back(calendar_index(plan, crew.calendar));
  }
  schedule::Network network;
  for (std::size_t i = 0; i < names.size(); ++i) {
    network.resources.push_back({names[i], -1, sizes[i]});
  }
  allocator.emplace(std::move(names), sizes, std::move(calendars), calendars_of(plan, draws));
  overtime = OvertimeHours(plan, draws);
  breakdowns = Breakdowns(plan, draws.sample);
  queue_.resize(specs_.size());
  choice_queues_.resize(specs_.size());
  std::vector<Ticks> work;
  for (int task = 0; task < tasks(); ++task) work.push_back(prepare_queue(task));

  network.tasks = network_tasks(plan, draws);
  const auto precomputed = precomputed_times(plan, network.tasks, draws);
  for (const interpreter::TaskSpec& park : parks_) network.tasks.emplace_back().name = park.name;
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    // Motions are work too.
    const bool moves = specs_[i]->robot >= 0 || specs_[i]->move || specs_[i]->go;
    if (network.tasks[i].work == 0 && moves) network.tasks[i].work = 1;
  }
  links.emplace(std::move(network), std::move(work), precomputed,
                [this](int task) -> const schedule::WorkCalendar& { return calendar(task); });
}

/// What the task holds from start to finish: its robot and the crews of `by`; one without a robot
/// also the crews of its works. The crew work that is known before it starts; -1: not known.
Ticks Stage::prepare_queue(int task) {
  const interpreter::TaskSpec& each = spec(task);
  queue_[at(task)] =
      std::get<int>(allocator->queue_for(shares_of(task, each), held_resources(plan, each)));
  if (has_choices(task)) {
    prepare_choices(task);
    return -1;
  }
  // What may fail or has to wait for a machine is known only when it is done.
  if (each.robot >= 0 || !each.remove.empty()) return -1;
  const Ticks work =
      std::accumulate(each.takes.begin(), each.takes.end(), Ticks{0},
                      [this](Ticks sum, const interpreter::WorkSpec& one) {
                        return sum + interpreter::ticks_from_seconds(draws.duration(one));
                      });
  if (work == 0 && !each.zones.empty()) return -1;
  // A milestone waits for nobody.
  if (work == 0) queue_[at(task)] = std::get<int>(allocator->queue_for({}, {}));
  return work;
}

/// Where a task by pools asks: in as many queues as it has choices.
void Stage::prepare_choices(int task) {
  for (const interpreter::TaskSpec& choice : spec(task).choices) {
    choice_queues_[at(task)].push_back(
        std::get<int>(allocator->queue_for(shares_of(task, choice), held_resources(plan, choice))));
  }
}

/// Tasks with the same members as another are one group, named by the first.
void Stage::set_groups() {
  group_.resize(specs_.size(), -1);
  for (int task = 0; task < plan_tasks(); ++task) {
    int first = task;
    while (plan_spec(first).same_as) first = *plan_spec(first).same_as;
    if (first == task) continue;
    group_[at(task)] = group_[at(first)] = first;
  }
  for (int task = 0; task < plan_tasks(); ++task) {
    if (group_of(task) >= 0) groups_[group_of(task)].push_back(task);
  }
}

bool Stage::group_is_over(int group) const {
  const std::vector<int>& all = groups_.at(group);
  return std::all_of(all.begin(), all.end(), [this](int task) { return is_over(task); });
}

void Stage::choose(int task, int choice) {
  choices_.assign(chosen_[at(task)], choice);
  choices_.assign(queue_[at(task)], choice_queues_[at(task)][at(choice)]);
}

const interpreter::TaskSpec& Stage::spec_in(int task, int queue) const {
  const std::vector<int>& queues = choice_queues(task);
  const auto place = std::find(queues.begin(), queues.end(), queue);
  if (place == queues.end()) return spec(task);
  return plan_spec(task).choices[static_cast<std::size_t>(place - queues.begin())];
}

std::vector<Share> Stage::shares_of(int task, const interpreter::TaskSpec& choice) const {
  std::vector<Share> shares;
  for (const int resource : held_resources(plan, choice)) {
    shares.push_back({resource, people_of(plan, choice, resource), -1});
  }
  for (const interpreter::PoolMember& member : choice.members) {
    const int resource = resource_of(plan, member);
    for (Share& share : shares) {
      if (share.resource == resource) share.group = group_of(task);
    }
  }
  return shares;
}

Share Stage::share_of(int task, int resource) const {
  return {resource, people_of(plan, spec(task), resource), -1};
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
    // Who waits for something with a timetable has an event of its own.
    if (!task.activity || (events.is_set(task.task) && site.movings() == 0)) continue;
    if (events.is_due(task.task)) continue;
    if (task.activity->wakes_at(task, *this, event)) events.set(task.task, now());
  }
}

void Stage::came_further(ActiveTask& task) {
  ++task.account.progress;
  announce({spec(task.task).robot, task.task});
}

std::optional<schedule::Parking> Stage::parking_of(int task) const {
  if (task < 0 || !is_park(task)) return std::nullopt;
  const schedule::TaskTimes& times = links->times(task);
  return schedule::Parking{times.held,        times.resource,
                           times.task_before, times.given_back_midway,
                           times.repaired,    times.wanted};
}

void Stage::pause(int task, const char* why, const std::string& whom, Ticks since) {
  if (since == now()) return;
  if (auto* const writer = trace_of(task)) writer->pause(why, whom, since, now());
}

void Stage::end_shift_wait(ActiveTask& task, Ticks since, Ticks first_gain, const LiftNote* lift) {
  if (since == now()) return;
  task.account.outcome.waits.shift += now() - since;
  note_off(task, since, now());
  schedule::MidWait wait{now(), schedule::Held::shift};
  wait.since = since;
  wait.first_gain = first_gain;
  if (lift && lift->missed) {
    wait.missed = lift->missed;
    wait.first_gain = lift->missed->gain;
  }
  links->add_mid_wait(task.task, std::move(wait));
  pause(task.task, lift ? "lift" : "shift", lift ? lift->because : std::string(), since);
}

void Stage::note_off(ActiveTask& task, Ticks from, Ticks to, Ticks works) const {
  if (to - from <= works) return;
  const std::vector<int>& held = held_by(task.task);
  for (std::size_t i = 0; i < held.size(); ++i) {
    const Ticks hours = allocator->hours(held[i]).work_between(from, to);
    task.account.off[i] += std::max<Ticks>(hours - works, 0);
  }
  const Ticks own = calendar(task.task).work_between(from, to);
  task.account.part_off += std::max<Ticks>(own - works, 0);
}

void Stage::end_part(ActiveTask& task) const {
  task.account.outcome.parts.push_back({time_of_part(task), queue_of(task.task), false});
  task.account.part_since = now();
  task.account.part_off = 0;
}

void Stage::end_part(ActiveTask& task, int queue, bool whole) const {
  const Ticks work = allocator->calendar(queue).work_between(task.account.part_since, now());
  task.account.outcome.parts.push_back({work, queue, whole});
  task.account.part_since = now();
  task.account.part_off = 0;
}

/// Of the part under way, without what it waited for shifts.
Ticks Stage::time_of_part(const ActiveTask& task) const {
  const Ticks own = calendar(task.task).work_between(task.account.part_since, now());
  return std::max<Ticks>(own - task.account.part_off, 0);
}

Ticks Stage::working_time(const ActiveTask& task) const {
  Ticks time = time_of_part(task);
  for (const TaskStretch& part : task.account.outcome.parts) time += part.work;
  return time;
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

std::vector<bool> Stage::idle_robots() const {
  std::vector<bool> idle;
  for (int robot = 0; robot < robots(); ++robot) {
    idle.push_back(allocator->state(robot).holder() < 0 && !site.load(robot) &&
                   breakdowns.out_until(robot) <= now());
  }
  return idle;
}

/// Of those who hold it so many must give it back as to make up what is missing; those for whom it
/// is kept must all be over.
void Stage::add_resource(WaitSet& waits, int task, const Share& share, int choice) const {
  if (allocator->is_free(share)) return;
  const schedule::ResourceState& state = allocator->state(share.resource);
  WaitTarget held{WaitTarget::Kind::resource, share.resource, {}, false, false};
  int given = 0;
  for (const schedule::ResourceState::Held& each : state.held) {
    if (each.task == task) continue;
    held.by.push_back(each.task);
    held.gives.push_back(each.units);
    given += each.units;
  }
  held.choice = choice;
  held.missing = std::min(share.units - state.free_units, given);
  if (held.missing > 0) waits.targets.push_back(std::move(held));
  if (state.reserved < 0 || state.reserved == share.group) return;
  for (const int other : group(state.reserved)) {
    if (is_over(other)) continue;
    WaitTarget& kept = waits.targets.emplace_back();
    kept.kind = WaitTarget::Kind::kept;
    kept.number = share.resource;
    kept.by = {other};
    kept.choice = choice;
  }
}

/// It goes on as soon as it can have all that one of its choices needs, and what it waits for
/// already has come.
void Stage::add_choices(WaitSet& waits, int task) const {
  const std::vector<WaitTarget> needed = waits.targets;
  const std::vector<int>& queues = choice_queues(task);
  WaitSet chosen;
  chosen.any = true;
  for (std::size_t i = 0; i < queues.size(); ++i) {
    if (allocator->asks_no_more(task, queues[i])) continue;
    const int choice = static_cast<int>(i);
    const std::size_t before = chosen.targets.size();
    for (const Share& share : allocator->shares(queues[i])) {
      add_resource(chosen, task, share, choice);
    }
    // Nobody holds it: it has only to work again.
    if (chosen.targets.size() == before) return;
    for (const WaitTarget& each : needed) chosen.targets.emplace_back(each).choice = choice;
  }
  if (!chosen.targets.empty()) waits = std::move(chosen);
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
