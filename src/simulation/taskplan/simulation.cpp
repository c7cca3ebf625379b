#include "src/simulation/taskplan/simulation.hpp"

#include <algorithm>
#include <utility>

#include "src/simulation/schedule/critical_chain.hpp"
#include "src/simulation/taskplan/plan_cost.hpp"

namespace rubicon::taskplan {

using schedule::TaskEnd;

Simulation::Simulation(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
                       const interpreter::Draws& draws, trace::TraceSink* sink,
                       const RunOptions& options, const site::PreparedSite& prepared,
                       Verdicts known)
    : plan_(plan),
      options_(options),
      stage_(plan, sources, draws, sink, options.detail, prepared),
      records_(stage_.tasks()),
      checkpoints_(stage_, records_, zone_waits_),
      excluded_(std::move(known.tasks)),
      parking_failed_(std::move(known.parking_failed)),
      second_chances_(std::move(known.second_chances)),
      failed_choices_(std::move(known.failed_choices)) {
  parking_failed_.resize(plan.robots.size());
  stage_.on_motion = options.on_motion;
  stage_.traces_graphs = options.traces_graphs;
  if (stage_.support) {
    stage_.support->set_done([this](int task) { return records_.status(task) == Status::done; });
  }
  stage_.may_park_some_day = [this](int robot) { return may_park(robot, false); };
  stage_.is_over = [this](int task) { return is_over(task); };
  stage_.has_begun = [this](int task) { return records_.has_begun(task); };
  stage_.allocator->set_choices(
      {[this](int task, const std::vector<int>& queues) { return choose_queue(task, queues); },
       [this](int task, int queue) { return asks_no_more(task, queue); }});
  for (const auto& [task, excluded] : excluded_) {
    stage_.allocator->exclude(task);
    stage_.links->leave_out(task);
    known_before_.insert(excluded.cause);
    if (!excluded.involved.empty()) doubtful_.insert(task);
    stage_.trace.repeat(excluded.lines);
    if (excluded.lines.empty()) trace_end(task, excluded.outcome.start, excluded.outcome);
  }
  stage_.links->count_links();
}

std::optional<Schedule> Simulation::run() {
  look_at_movings();
  start_plan();
  while (!must_restart_) {
    if (apply_rejection() || repeat_lift()) continue;
    if (process_event() || hand_out() || untangle_fleets()) continue;
    if (park_idle_machines() || find_deadlock()) continue;
    const std::optional<Ticks> next = stage_.events.next();
    const Ticks chance = stage_.allocator->next_chance(stage_.now());
    Ticks time = std::min(next.value_or(schedule::kEndOfTime), chance);
    time = std::min(time, next_look_of_movings(time));
    if (!stage_.active.empty() || !zone_waits_.all().empty()) {
      time = std::min(time, stage_.breakdowns.next_repaired(stage_.now()));
    }
    if (time < schedule::kEndOfTime) {
      stage_.events.advance_to(time);
      stage_.site.set_time(stage_.now());
      look_at_movings();
      ask_again_for_zones();
    } else if (!resolve_standstill()) {
      break;
    }
  }
  if (must_restart_) return std::nullopt;
  Schedule schedule = make_schedule();
  stage_.trace.release_before(stage_.trace.mark());
  return schedule;
}

/// Tasks without links ask from now on; of those that are precomputed all is known already.
void Simulation::start_plan() {
  ResourceAllocator& allocator = *stage_.allocator;
  LinkState& links = *stage_.links;
  const int always = std::get<int>(allocator.queue_for({}, {}));
  for (int task = 0; task < stage_.plan_tasks(); ++task) {
    if (links.is_precomputed(task)) {
      const schedule::TaskTimes times = links.times(task);
      records_.set_status(task, Status::asking);
      allocator.ask(always, task, stage_.spec(task).priority, times.start);
      links.publish(task, TaskEnd::start, times.start);
      links.publish(task, TaskEnd::finish, times.finish);
    } else if (links.may_start(task)) {
      may_start(task, -1);
    }
  }
  propagate();
}

/// When something with a timetable has to look next. Where nothing else is to come: as long as
/// anything may come of it, while a task is under way and not all of these things have come by
/// since a machine moved.
Ticks Simulation::next_look_of_movings(Ticks other) {
  site::SiteWorld& site = stage_.site;
  if (site.movings() == 0) return schedule::kEndOfTime;
  const Ticks look = site.next_moving_look();
  if (other < schedule::kEndOfTime) return look;
  const bool may_help = !stage_.active.empty() && look < site.movings_worth_waiting();
  return may_help ? look : schedule::kEndOfTime;
}

/// What keeps a timetable stops or goes on, and whoever waits for it is told.
void Simulation::look_at_movings() {
  for (const site::MovingEvent& event : stage_.site.look_at_movings()) {
    stage_.trace.moving(event, stage_.site.moving(event.moving).name());
    stage_.announce({-1, -1, event.moving});
  }
}

/// Lets the first task whose event has come go on; false if there is none.
bool Simulation::process_event() {
  const std::optional<int> task = stage_.events.take_due();
  if (!task) return false;
  ActiveTask& active = *stage_.active.find(*task);
  if (active.is_held()) {
    complete(active);
  } else {
    go_on(active, active.activity->resume(active, stage_));
  }
  propagate();
  return true;
}

/// Gives the next task what it asks for; false if nobody can be given anything.
bool Simulation::hand_out() {
  const auto grant = stage_.allocator->take(stage_.now());
  if (!grant) return false;
  if (ActiveTask* const active = stage_.active.find(grant->task)) {
    go_on(*active, active->activity->granted(*active, stage_, *grant));
  } else if (zone_is_free(*grant)) {
    begin_task(*grant);
  }
  propagate();
  return true;
}

/// Whether no machine stands where the people of the task will work. If one does, the task gives
/// back what it got and asks again when something has happened.
bool Simulation::zone_is_free(const ResourceAllocator::Grant& grant) {
  const interpreter::TaskSpec& task = stage_.spec_in(grant.task, grant.queue);
  if (task.zones.empty()) return true;
  const std::optional<int> robot = stage_.site.machine_in(zone_of(task), task.robot);
  if (!robot) return true;
  stage_.allocator->undo_to(grant.before);
  stage_.begins_to_wait(grant.task);
  zone_waits_.add(grant.task, stage_.now(), *robot);
  return false;
}

void Simulation::ask_again_for_zones() {
  for (ZoneWait& wait : zone_waits_.all()) {
    if (wait.asks) continue;
    wait.asks = true;
    ask(wait.task, stage_.now());
  }
}

/// The task asks for its robots and crews from the moment its links let it start.
void Simulation::may_start(int task, int before) {
  LinkState& links = *stage_.links;
  if (excluded_.contains(task) || links.is_precomputed(task)) return;
  const schedule::TaskTimes times = links.ready_times(task, before, stage_.now());
  links.set_times(task, times);
  records_.set_status(task, Status::asking);
  ask(task, stage_.has_choices(task) ? times.wanted : times.start);
  stage_.begins_to_wait(task);
  if (!links.is_milestone(task)) return;
  links.publish(task, TaskEnd::start, times.start);
  if (!links.may_finish(task)) return;
  links.publish(task, TaskEnd::finish,
                schedule::held_finish(links.bounds_of(task, true), times.start));
}

/// A task that is held to its finish goes on.
void Simulation::may_finish(int task) {
  const ActiveTask* const active = stage_.active.look_at(task);
  if (!active || !active->is_held()) return;
  stage_.events.set(task, std::max(stage_.now(), stage_.links->bounds_of(task, true).finish));
}

void Simulation::propagate() {
  if (!stage_.rejection) stage_.links->propagate(*this);
}

ActiveTask& Simulation::activate(int task) {
  const interpreter::TaskSpec& each = stage_.spec(task);
  ActiveTask active;
  active.task = task;
  active.phases = phases_of(each, stage_.draws);
  active.hits = HitRecorder(stage_.trace.events());
  active.account.over_time.resize(stage_.held_by(task).size(), 0);
  active.account.worked = active.account.outside = active.account.over_time;
  active.account.off = active.account.over_time;
  TaskOutcome& outcome = active.account.outcome;
  outcome.task = each.name;
  outcome.parking = stage_.is_park(task);
  if (each.robot >= 0) outcome.robot = stage_.robot_spec(each.robot).name;
  outcome.crews = crew_names(plan_, each);
  outcome.start = active.account.part_since = stage_.now();
  outcome.dig = each.dig;
  if (outcome.dig) outcome.dig->result = stage_.draws.result(*each.dig);
  if (each.dig && each.dig->soil >= 0) stage_.site_changes.begin_dig(each.dig->soil);
  if (stage_.has_choices(task)) outcome.choice = choice_text(task);
  stage_.active.add(std::move(active));
  return *stage_.active.find(task);
}

/// What a task asked for came free last, from another one.
void Simulation::hold_until_free(schedule::TaskTimes& times,
                                 const schedule::ResourceStates::Last& last) const {
  times.wanted = last.since;
  times.held = schedule::Held::resource;
  times.link = -1;
  times.resource = last.resource;
  times.task_before = last.task_before;
  times.given_back_midway = last.midway;
  times.kept = last.kept;
  // 0: it has never been out of order.
  const Ticks repaired_at =
      last.resource < stage_.robots() ? stage_.breakdowns.out_until(last.resource) : 0;
  times.repaired = repaired_at > 0 && repaired_at == last.since;
}

void Simulation::begin_task(const ResourceAllocator::Grant& grant) {
  const int task = grant.task;
  checkpoints_.add(task, grant.before);
  if (stage_.has_choices(task)) take_members(grant);
  LinkState& links = *stage_.links;
  const Ticks now = stage_.now();
  schedule::TaskTimes times = links.times(task);
  if (links.is_precomputed(task)) {
    for (const Share& share : stage_.allocator->shares(stage_.queue_of(task))) {
      stage_.allocator->take_directly(share, task);
    }
  } else if (grant.last.resource >= 0 && grant.last.since > times.ready) {
    hold_until_free(times, grant.last);
  }
  times.start = now;
  const schedule::WorkCalendar& calendar = stage_.calendar(task);
  if (!links.is_milestone(task)) {
    times.first_gain = times.wanted - calendar.last_working(times.wanted);
  }
  ActiveTask& active = activate(task);
  WaitTimes& waits = active.account.outcome.waits;
  waits.predecessor = times.ready;
  waits.resource = times.wanted - times.ready;
  waits.shift = now - times.wanted;
  if (const ZoneWait* const zone = zone_waits_.find(task)) {
    const Ticks since = std::max(zone->since, times.wanted);
    const Ticks waited = now - since;
    waits.machine = waited;
    waits.shift -= waited;
    const int mover = stage_.allocator->state(zone->robot).last;
    times.start_wait = {
        since, {now, schedule::Held::machine, zone->robot, mover, stage_.parking_of(mover)}};
    zone_waits_.erase(task);
  }
  links.set_times(task, times);
  records_.set_status(task, Status::active);
  const interpreter::TaskSpec& each = stage_.spec(task);
  if (auto* const trace = stage_.trace_of(task)) {
    const schedule::ChainStep step = start_step(links.network(), task, times);
    std::string because = schedule::text_of(links.network(), step);
    const std::string& choice = active.account.outcome.choice;
    if (!choice.empty()) because += "; " + choice;
    trace->task_start(now, because, step.task_before < 0 ? "" : stage_.spec(step.task_before).name,
                      interpreter::member_names(plan_, each), stage_.place_of_park(task));
  }
  if (!each.zones.empty()) {
    stage_.site_changes.hold_zone(task, each.name, zone_of(each), each.robot);
  }
  const bool known = links.is_precomputed(task) || links.is_milestone(task);
  if (!known) links.publish(task, TaskEnd::start, now);
  if (!known && links.known_work(task) && links.may_finish(task)) {
    const Ticks done = calendar.finish(now, links.work(task));
    links.publish(task, TaskEnd::finish, schedule::held_finish(links.bounds_of(task, true), done));
  }
  if (active.phases.empty()) {
    finish_task(active);
    return;
  }
  active.activity = Snapshot(activity_of(active.now()));
  stage_.came_further(active);
  go_on(active, active.activity->begin(active, stage_));
}

/// Goes on with the phases until one takes time, the task is over or cannot be done.
void Simulation::go_on(ActiveTask& active, Step step) {
  while (step != Step::pending) {
    if (step == Step::over) {
      stage_.made_progress();
      ++active.phase;
    } else {
      active.phase = 0;
      forget_lift(stage_, active.task);
    }
    active.activity = {};
    if (active.phase == active.phases.size()) {
      finish_task(active);
      return;
    }
    active.activity = Snapshot(activity_of(active.now()));
    if (step == Step::over) stage_.came_further(active);
    step = active.activity->begin(active, stage_);
  }
}

/// All phases are over: the task finishes as soon as its links let it.
void Simulation::finish_task(ActiveTask& active) {
  active.held_since = stage_.now();
  if (!stage_.links->may_finish(active.task)) {
    stage_.begins_to_wait(active.task);
    return;
  }
  const Ticks finish =
      schedule::held_finish(stage_.links->bounds_of(active.task, true), stage_.now());
  if (finish > stage_.now()) {
    stage_.events.set(active.task, finish);
  } else {
    complete(active);
  }
}

void Simulation::complete(ActiveTask& active) {
  const int task = active.task;
  const Ticks now = stage_.now();
  LinkState& links = *stage_.links;
  const schedule::LinkBounds bounds = links.bounds_of(task, true);
  schedule::TaskTimes times = links.times(task);
  TaskOutcome& outcome = active.account.outcome;
  const bool held = active.held_since < now;
  if (held) {
    const int before =
        bounds.finish_link < 0 ? -1 : links.links_of(task)[index(bounds.finish_link)].task;
    outcome.waits.predecessor += now - active.held_since;
    stage_.pause(task, "held", before < 0 ? std::string() : stage_.spec(before).name,
                 active.held_since);
  }
  if (held || links.started_for_finish(times, task)) times.finish_link = bounds.finish_link;
  times.finish = now;
  links.set_times(task, times);
  repair_after(active);
  hold_all(active);
  outcome.duration = now - outcome.start;
  if (!outcome.parts.empty()) stage_.end_part(active);
  find_cold_joints(task, outcome);
  trace_end(task, now, outcome);
  const interpreter::TaskSpec& each = stage_.spec(task);
  if (!each.zones.empty()) {
    stage_.site_changes.release_zone(task, each.name, zone_of(each), each.robot);
    stage_.announce({-1, task});
  }
  if (stage_.is_park(task)) {
    records_.finish_parking(task, std::move(outcome));
  } else {
    if (options_.on_task) options_.on_task(records_.count_one(), stage_.plan_tasks(), outcome);
    records_.finish(task, std::move(outcome));
    if (stage_.group_of(task) >= 0) free_groups(false);
  }
  stage_.events.cancel(task);
  stage_.active.erase(task);
  checkpoints_.drop(task);
  if (each.robot >= 0) look_again_who_waits_for(each.robot);
  if (!links.is_known(task, TaskEnd::finish)) links.publish(task, TaskEnd::finish, now);
}

/// A machine that is to be repaired when its task is over: nobody has it meanwhile.
void Simulation::repair_after(ActiveTask& active) {
  const int robot = stage_.spec(active.task).robot;
  if (!stage_.breakdowns.breaks(robot)) return;
  if (breaks_down_now(active, stage_)) {
    const Ticks until = begin_repair(active, stage_);
    stage_.allocator->set_out(robot, until);
    stage_.breakdowns.set_out(robot, until);
  }
  stage_.breakdowns.give_back(robot, work_in(active));
}

/// Gives back what the task held, and counts for how long it did.
void Simulation::hold_all(ActiveTask& active) {
  const ActiveTask::Account& account = active.account;
  const Ticks worked = stage_.working_time(active);
  for (ResourceHold& hold : active.account.outcome.holds) hold.after = worked - hold.after;
  const std::vector<int>& resources = stage_.held_by(active.task);
  for (std::size_t i = 0; i < resources.size(); ++i) {
    const int resource = resources[i];
    ResourceHold hold;
    hold.resource = resource;
    hold.from = account.outcome.start;
    hold.to = stage_.now();
    hold.held =
        stage_.allocator->hours(resource).work_between(account.outcome.start, stage_.now()) +
        account.over_time[i];
    const bool robot = resource < stage_.robots();
    hold.people = stage_.share_of(active.task, resource).units;
    hold.busy = account.worked[i];
    if (robot) {
      hold.busy += account.outcome.motion_time;
    } else if (const auto rounds = time_in_rounds(plan_, account.outcome, resource)) {
      hold.busy = std::min(hold.held, *rounds / hold.people);
    }
    hold.off = account.off[i];
    if (resource == stage_.spec(active.task).robot) hold.off += account.repair;
    hold.overtime = stage_.overtime.in_shifts(resource, account.outcome.start, stage_.now()) +
                    account.outside[i];
    active.account.outcome.holds.push_back(hold);
    // It comes free when it is repaired.
    const Ticks free =
        robot ? std::max(stage_.now(), stage_.breakdowns.out_until(resource)) : stage_.now();
    stage_.allocator->release(resource, active.task, free, false, hold.held);
  }
}

/// The joints between all that the task laid, where it says when they are cold.
void Simulation::find_cold_joints(int task, TaskOutcome& outcome) {
  const interpreter::TaskSpec& spec = stage_.spec(task);
  if (!spec.cover || spec.cover->cold_after == 0) return;
  outcome.joints = coverage::find_joints(outcome.laid, spec.cover->width, spec.cover->cold_after);
  outcome.laid.clear();
  auto* const trace = stage_.trace.of(task, spec);
  if (trace == nullptr) return;
  for (const coverage::ColdJoint& joint : outcome.joints->cold) {
    trace->cold_joint(joint, stage_.now());
  }
}

void Simulation::trace_end(int task, Ticks time, const TaskOutcome& outcome) {
  // One by a pool that was undone has nobody any more: its end is told of whom it had.
  const interpreter::TaskSpec* spec = &stage_.spec(task);
  for (const interpreter::TaskSpec& choice : spec->choices) {
    if (choice.robot >= 0 && stage_.robot_spec(choice.robot).name == outcome.robot) spec = &choice;
  }
  if (auto* const trace = stage_.trace.of(task, *spec)) {
    std::optional<trace::TruckTimes> rounds;
    if (const auto work = truck_work(plan_, outcome)) {
      rounds.emplace().driving = work->driving;
      for (const auto& [who, seconds] : work->serving) rounds->serving.push_back(seconds);
    }
    trace->task_end(time, name_of(outcome.result), outcome.reason, rounds);
  }
}

}  // namespace rubicon::taskplan
