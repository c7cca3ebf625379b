#include "src/simulation/taskplan/simulation.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "src/simulation/schedule/critical_chain.hpp"
#include "src/simulation/site/make_site.hpp"
#include "src/simulation/taskplan/plan_calendars.hpp"
#include "src/simulation/taskplan/plan_network.hpp"

namespace rubicon::taskplan {

Simulation::Simulation(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
                       trace::TraceSink* sink, const RunOptions& options, Verdicts known)
    : plan_(plan),
      sources_(sources),
      options_(options),
      site_(site::make_site(plan)),
      excluded_(std::move(known.tasks)),
      parking_failed_(std::move(known.parking_failed)),
      second_chances_(std::move(known.second_chances)) {
  if (sink) {
    buffer_.emplace(*sink);
    trace_.emplace(*buffer_, plan, sources, options.detail);
    buffer_->set_kept(true);
    trace_->header();
  }
  prepare();
  if (buffer_) buffer_->set_kept(false);
}

void Simulation::prepare() {
  const int robots = static_cast<int>(plan_.robots.size());
  for (int robot = 0; robot < robots; ++robot) {
    views_.emplace_back(site_, robot);
    interpreter::TaskSpec& park = parks_.emplace_back();
    park.name = "park " + robot_spec(robot).name;
    park.robot = robot;
    if (!robot_spec(robot).park) continue;
    park.go.emplace();
    park.go->values = *robot_spec(robot).park;
  }
  parking_failed_.resize(parks_.size());
  for (const interpreter::TaskSpec& task : plan_.tasks) specs_.push_back(&task);
  for (const interpreter::TaskSpec& park : parks_) specs_.push_back(&park);
  tasks_of_.resize(parks_.size());
  for (int task = 0; task < static_cast<int>(plan_.tasks.size()); ++task) {
    if (spec(task).robot >= 0) tasks_of_[index(spec(task).robot)].push_back(task);
  }

  std::vector<std::string> names;
  std::vector<int> calendars;
  for (const interpreter::RobotSpec& robot : plan_.robots) {
    names.push_back(robot.name);
    calendars.push_back(calendar_index(plan_, robot.calendar));
  }
  for (const interpreter::CrewSpec& crew : plan_.crews) {
    names.push_back(crew.name);
    calendars.push_back(calendar_index(plan_, crew.calendar));
  }
  schedule::Network network;
  for (const std::string& name : names) network.resources.push_back({name, -1});
  allocator_.emplace(std::move(names), std::move(calendars), calendars_of(plan_), journal_);
  queue_.resize(specs_.size());
  outcomes_.resize(specs_.size());
  std::vector<Ticks> work;
  for (int task = 0; task < static_cast<int>(specs_.size()); ++task) {
    work.push_back(prepare_queue(task));
  }
  prepare_links(std::move(network), std::move(work));
  for (const auto& [task, excluded] : excluded_) {
    allocator_->exclude(task);
    known_before_.insert(excluded.cause);
    if (!excluded.involved.empty()) doubtful_.insert(task);
    if (!buffer_) continue;
    for (const std::string& line : excluded.lines) buffer_->line(line);
    if (excluded.lines.empty()) trace_end(task, excluded.outcome.start, excluded.outcome);
  }
}

/// What the task holds from start to finish: its robot and the crews of `by`; one without a robot
/// also the crews of its works. The crew work that is known before it starts; -1: not known.
Ticks Simulation::prepare_queue(int task) {
  const interpreter::TaskSpec& each = spec(task);
  std::vector<int> resources = held_resources(plan_, each);
  const auto queue = allocator_->queue_for(resources, resources);
  queue_[index(task)] = std::get<int>(queue);
  // What may fail or has to wait for a machine is known only when it is done.
  if (each.robot >= 0 || !each.remove.empty()) return -1;
  const Ticks work = std::accumulate(each.takes.begin(), each.takes.end(), Ticks{0},
                                     [](Ticks sum, const interpreter::WorkSpec& one) {
                                       return sum + interpreter::ticks_from_seconds(one.duration);
                                     });
  if (work == 0 && !each.zones.empty()) return -1;
  // A milestone waits for nobody.
  if (work == 0) queue_[index(task)] = std::get<int>(allocator_->queue_for({}, {}));
  return work;
}

std::optional<Schedule> Simulation::run() {
  start_plan();
  while (!must_restart_) {
    if (apply_rejection()) continue;
    if (process_events() || hand_out() || park_idle_machines() || find_deadlock()) continue;
    const std::optional<Ticks> next = next_event();
    const Ticks chance = allocator_->next_chance(now_.now);
    if (next || chance < schedule::kEndOfTime) {
      now_.now = std::min(next.value_or(schedule::kEndOfTime), chance);
      site_.set_time(now_.now);
      ask_again_for_zones();
    } else if (!resolve_standstill()) {
      break;
    }
  }
  if (must_restart_) return std::nullopt;
  if (buffer_) buffer_->release_before(buffer_->mark());
  return make_schedule();
}

std::optional<Ticks> Simulation::next_event() const {
  std::optional<Ticks> next;
  for (const auto& active : now_.active) {
    if (active->wake && (!next || *active->wake < *next)) next = active->wake;
  }
  return next;
}

/// Lets the first task whose event has come go on; false if there is none.
bool Simulation::process_events() {
  const ActiveTask* first = nullptr;
  for (const auto& active : now_.active) {
    if (!active->wake || *active->wake > now_.now) continue;
    if (!first ||
        std::pair(*active->wake, active->sequence) < std::pair(*first->wake, first->sequence)) {
      first = active.get();
    }
  }
  if (!first) return false;
  ActiveTask& active = *find_active(first->task);
  active.wake.reset();
  go_on(active);
  propagate();
  return true;
}

void Simulation::wake_at(ActiveTask& active, Ticks time) {
  active.wake = time;
  active.sequence = ++now_.sequence;
}

/// Gives the next task what it asks for; false if nobody can be given anything.
bool Simulation::hand_out() {
  const auto grant = allocator_->take(now_.now);
  if (!grant) return false;
  if (ActiveTask* const active = find_active(grant->task)) {
    crew_came(*active, *grant);
  } else if (zone_is_free(*grant)) {
    begin_task(*grant);
  }
  propagate();
  return true;
}

/// Whether no machine stands where the people of the task will work. If one does, the task gives
/// back what it got and asks again when something has happened.
bool Simulation::zone_is_free(const ResourceAllocator::Grant& grant) {
  const interpreter::TaskSpec& task = spec(grant.task);
  if (task.zones.empty()) return true;
  const std::optional<int> robot = site_.machine_in(task.zones, task.robot);
  if (!robot) return true;
  allocator_->set_states(grant.before);
  new_waits_.push_back(grant.task);
  const auto waits = std::find_if(now_.zone_waits.begin(), now_.zone_waits.end(),
                                  [&](const ZoneWait& wait) { return wait.task == grant.task; });
  if (waits == now_.zone_waits.end()) {
    now_.zone_waits.push_back({grant.task, now_.now, *robot, false});
  } else {
    waits->robot = *robot;
    waits->asks = false;
  }
  return false;
}

void Simulation::ask_again_for_zones() {
  for (ZoneWait& wait : now_.zone_waits) {
    if (wait.asks) continue;
    wait.asks = true;
    allocator_->ask(queue_[index(wait.task)], wait.task, spec(wait.task).priority, now_.now);
  }
}

ActiveTask& Simulation::activate(int task) {
  const interpreter::TaskSpec& each = spec(task);
  auto active = std::make_shared<ActiveTask>();
  active->task = task;
  active->phases = phases_of(each);
  active->hits = HitRecorder(trace_ ? &*trace_ : nullptr);
  active->over_time.resize(allocator_->resources(queue_[index(task)]).size(), 0);
  active->worked = active->over_time;
  TaskOutcome& outcome = active->outcome;
  outcome.task = each.name;
  outcome.parking = is_park(task);
  if (each.robot >= 0) outcome.robot = robot_spec(each.robot).name;
  outcome.crews = crew_names(plan_, each);
  outcome.start = now_.now;
  now_.active.push_back(std::move(active));
  return *find_active(task);
}

void Simulation::begin_task(const ResourceAllocator::Grant& grant) {
  const int task = grant.task;
  add_checkpoint(task, grant.before);
  schedule::TaskTimes times = links_->times(task);
  if (links_->is_precomputed(task)) {
    for (const int resource : allocator_->resources(queue_[index(task)])) {
      allocator_->take_directly(resource, task);
    }
  } else if (grant.resource >= 0 && grant.free > times.ready) {
    times.wanted = grant.free;
    times.held = schedule::Held::resource;
    times.link = -1;
    times.resource = grant.resource;
    times.task_before = grant.task_before;
    times.given_back_midway = grant.midway;
  }
  times.start = now_.now;
  const schedule::WorkCalendar& calendar = allocator_->calendar(queue_[index(task)]);
  if (!links_->is_milestone(task)) {
    times.first_gain = times.wanted - calendar.last_working(times.wanted);
  }
  ActiveTask& active = activate(task);
  WaitTimes& waits = active.outcome.waits;
  waits.predecessor = times.ready;
  waits.resource = times.wanted - times.ready;
  waits.shift = now_.now - times.wanted;
  const auto zone = std::find_if(now_.zone_waits.begin(), now_.zone_waits.end(),
                                 [&](const ZoneWait& wait) { return wait.task == task; });
  if (zone != now_.zone_waits.end()) {
    const Ticks waited = now_.now - std::max(zone->since, times.wanted);
    waits.machine = waited;
    waits.shift -= waited;
    times.held = schedule::Held::machine;
    times.resource = zone->robot;
    times.task_before = allocator_->state(zone->robot).last;
    times.given_back_midway = true;
    times.wanted = now_.now;
    now_.zone_waits.erase(zone);
  }
  links_->set_times(task, times);
  journal_.assign(status_[index(task)], Status::active);
  own_trace(active);
  if (trace_) trace_start(task, times);
  const interpreter::TaskSpec& each = spec(task);
  if (!each.zones.empty()) {
    site_.hold_zone(task, "the zone of " + each.name, each.zones, each.robot);
    journal_.on_undo([this, task] { site_.release_zone(task); });
  }
  const bool known = links_->is_precomputed(task) || links_->is_milestone(task);
  if (!known) links_->publish(task, schedule::TaskEnd::start, now_.now);
  if (!known && links_->known_work(task) && links_->may_finish(task)) {
    const Ticks done = calendar.finish(now_.now, links_->work(task));
    links_->publish(task, schedule::TaskEnd::finish,
                    schedule::held_finish(links_->bounds_of(task, true), done));
  }
  run_phases(active);
}

/// All phases are over: the task finishes as soon as its links let it.
void Simulation::finish_task(ActiveTask& active) {
  active.doing = Doing::held;
  active.since = now_.now;
  if (!links_->may_finish(active.task)) {
    new_waits_.push_back(active.task);
    return;
  }
  const Ticks finish = schedule::held_finish(links_->bounds_of(active.task, true), now_.now);
  if (finish > now_.now) {
    wake_at(active, finish);
  } else {
    complete(active);
  }
}

void Simulation::complete(ActiveTask& active) {
  const int task = active.task;
  const schedule::LinkBounds bounds = links_->bounds_of(task, true);
  schedule::TaskTimes times = links_->times(task);
  const bool held = active.since < now_.now;
  if (held) {
    const int before =
        bounds.finish_link < 0 ? -1 : links_->links_of(task)[index(bounds.finish_link)].task;
    active.outcome.waits.predecessor += now_.now - active.since;
    pause(active, "held", before < 0 ? std::string() : spec(before).name);
  }
  if (held || links_->started_for_finish(times, task)) times.finish_link = bounds.finish_link;
  times.finish = now_.now;
  links_->set_times(task, times);
  journal_.assign(status_[index(task)], Status::done);
  hold_all(active);
  active.outcome.duration = now_.now - active.outcome.start;
  trace_end(task, now_.now, active.outcome);
  const interpreter::TaskSpec& each = spec(task);
  if (!each.zones.empty()) {
    site_.release_zone(task);
    journal_.on_undo([this, task] {
      site_.hold_zone(task, "the zone of " + spec(task).name, spec(task).zones, spec(task).robot);
    });
    wake_those_who_wait_for(-1, task);
  }
  if (is_park(task)) {
    parkings_.push_back(std::move(active.outcome));
    journal_.on_undo([this] { parkings_.pop_back(); });
    journal_.assign(status_[index(task)], Status::pending);
  } else {
    if (options_.on_task) {
      options_.on_task(++done_, static_cast<int>(plan_.tasks.size()), active.outcome);
      journal_.on_undo([this] { --done_; });
    }
    outcomes_[index(task)] = std::move(active.outcome);
    journal_.on_undo([this, task] { outcomes_[index(task)].reset(); });
  }
  std::erase_if(now_.active, [&](const auto& other) { return other->task == task; });
  drop_checkpoint(task);
  if (each.robot >= 0) look_again_who_waits_for(each.robot);
  if (!links_->is_known(task, schedule::TaskEnd::finish)) {
    links_->publish(task, schedule::TaskEnd::finish, now_.now);
  }
}

/// Gives back what the task held, and counts for how long it did.
void Simulation::hold_all(ActiveTask& active) {
  const std::vector<int>& resources = allocator_->resources(queue_[index(active.task)]);
  for (std::size_t i = 0; i < resources.size(); ++i) {
    const int resource = resources[i];
    ResourceHold hold;
    hold.resource = resource;
    hold.held = allocator_->hours(resource).work_between(active.outcome.start, now_.now) +
                active.over_time[i];
    const bool robot = resource < static_cast<int>(plan_.robots.size());
    hold.busy = robot ? active.outcome.motion_time : active.worked[i];
    active.outcome.holds.push_back(hold);
    allocator_->release(resource, now_.now, false);
  }
}

ActiveTask* Simulation::find_active(int task) {
  for (auto& active : now_.active) {
    if (active->task != task) continue;
    // Others may keep this state to go back to it: what changes is a copy.
    if (active.use_count() > 1) active = std::make_shared<ActiveTask>(*active);
    return active.get();
  }
  return nullptr;
}

const ActiveTask* Simulation::look_at_active(int task) const {
  for (const auto& active : now_.active) {
    if (active->task == task) return active.get();
  }
  return nullptr;
}

const interpreter::Program& Simulation::program_of(int robot) {
  const auto& checked = robot_spec(robot).robot;
  const auto found = programs_.find(checked.get());
  if (found != programs_.end()) return found->second;
  return programs_.emplace(checked.get(), interpreter::compile(checked)).first->second;
}

void Simulation::own_trace(const ActiveTask& active) {
  if (!trace_) return;
  buffer_->set_owner(active.task);
  trace_->set_task(spec(active.task).name, spec(active.task).robot);
}

void Simulation::trace_start(int task, const schedule::TaskTimes& times) {
  const schedule::ChainStep step = start_step(links_->network(), task, times);
  trace_->task_start(now_.now, schedule::text_of(links_->network(), step),
                     step.task_before < 0 ? "" : spec(step.task_before).name);
}

void Simulation::trace_end(int task, Ticks time, const TaskOutcome& outcome) {
  if (!trace_) return;
  buffer_->set_owner(task);
  trace_->set_task(spec(task).name, spec(task).robot);
  trace_->task_end(time, name_of(outcome.result), outcome.reason);
}

}  // namespace rubicon::taskplan
