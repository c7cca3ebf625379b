#include "src/simulation/taskplan/work_activity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

namespace rubicon::taskplan {

Step WorkActivity::begin(ActiveTask& task, Stage& stage) {
  const interpreter::WorkSpec& spec = *task.now().work;
  if (interpreter::ticks_from_seconds(stage.draws.duration(spec)) == 0) return Step::over;
  const LiftNote* const note = stage.lift_notes.of(task.task);
  if (task.now().begins_lift && note && stage.now() < note->not_before) {
    doing_ = Doing::waiting_for_lift;
    since_ = stage.now();
    stage.events.set(task.task, note->not_before);
    return Step::pending;
  }
  return ask(task, stage);
}

/// For the crew, unless the task has it.
Step WorkActivity::ask(ActiveTask& task, Stage& stage) {
  const interpreter::WorkSpec& spec = *task.now().work;
  if (breaks_down_now(task, stage)) {
    wait_for_repair(task, stage);
    return Step::pending;
  }
  if (spec.turning && !may_turn(task, stage)) return Step::pending;
  const int queue = work_queue(task, stage);
  if (queue == stage.queue_of(task.task)) return work(task, stage);
  doing_ = Doing::waiting_for_crew;
  since_ = stage.now();
  crew_ = stage.crew_resource(spec.crew);
  stage.begins_to_wait(task.task);
  stage.allocator->ask(queue, task.task, stage.spec(task.task).priority, stage.now());
  return Step::pending;
}

Step WorkActivity::resume(ActiveTask& task, Stage& stage) {
  if (doing_ == Doing::waiting_for_shift) {
    end_shift_wait(task, stage, since_);
    return work(task, stage);
  }
  if (doing_ == Doing::waiting_for_lift) {
    const LiftNote* const note = stage.lift_notes.of(task.task);
    stage.end_shift_wait(task, since_, first_gain_of_lift(stage, task.task, since_, note), note);
    held_back_ = true;
    return ask(task, stage);
  }
  if (doing_ == Doing::waiting_for_machine) return try_again(task, stage);
  if (doing_ == Doing::under_repair) {
    task.account.outcome.waits.repair += stage.now() - since_;
    task.account.repair +=
        stage.allocator->hours(stage.spec(task.task).robot).work_between(since_, stage.now());
    stage.pause(task.task, "repair", stage.robot_spec(stage.spec(task.task).robot).name, since_);
    return ask(task, stage);
  }
  if (done_ < interpreter::ticks_from_seconds(stage.draws.duration(*task.now().work))) {
    return work(task, stage);
  }
  if (turning_.angle_deg != 0) stage.announce({stage.spec(task.task).robot, -1});
  give_back(task, stage);
  return Step::over;
}

/// How people can turn the load now; true if they can, or if nobody who is in their way will leave:
/// then the task is rejected.
bool WorkActivity::finds_a_turn(ActiveTask& task, Stage& stage) {
  const Ticks duration = interpreter::ticks_from_seconds(stage.draws.duration(*task.now().work));
  turning_ = load_turning(stage, task.task, duration);
  wait_.blockers.clear();
  for (const interpreter::HitPair& hit : turning_.hits) {
    task.hits.note(hit);
    if (!hit.may_leave()) continue;
    const Blocker blocker = Blocker::of(hit);
    const auto same = [&](const Blocker& other) { return other.same_as(blocker); };
    if (std::any_of(wait_.blockers.begin(), wait_.blockers.end(), same)) continue;
    wait_.blockers.push_back(blocker);
  }
  if (turning_.hits.empty() || !wait_.blockers.empty()) return wait_.blockers.empty();
  const int component = stage.site.load(stage.spec(task.task).robot)->component;
  stage.reject(task.task, text_of_barred(turning_, stage.site.component_name(component)),
               stage.in_the_way_of(task));
  return true;
}

/// Whether people can turn the load now. If not, the task waits for the machines and people in the
/// way, without its crew, or is rejected where there are none.
bool WorkActivity::may_turn(ActiveTask& task, Stage& stage) {
  if (finds_a_turn(task, stage)) return !stage.rejection;
  doing_ = Doing::waiting_for_machine;
  wait_.since = stage.now();
  wait_.others = progress_of(stage, wait_.blockers);
  stage.begins_to_wait(task.task);
  wait_.wait_for_timetables(stage, task.task);
  if (crew_ >= 0) stage.allocator->release(crew_, task.task, stage.now(), true, 0);
  crew_ = -1;
  return false;
}

/// Those in the way have moved. Where the load can still not be turned, nothing is told of it.
Step WorkActivity::try_again(ActiveTask& task, Stage& stage) {
  const schedule::WorkCalendar& calendar = stage.allocator->calendar(work_queue(task, stage));
  if (!lift_of(stage, task.task) && !calendar.works_at(stage.now())) {
    stage.events.set(task.task, calendar.next_working(stage.now()));
    return Step::pending;
  }
  const MachineWait before = wait_;
  if (!finds_a_turn(task, stage) || stage.rejection) {
    if (!stage.rejection) wait_.wait_for_timetables(stage, task.task);
    return Step::pending;
  }
  task.account.outcome.waits.machine += stage.now() - before.since;
  stage.pause(task.task, "machine", before.first_name(stage), before.since);
  before.note_wait(stage, task.task);
  return ask(task, stage);
}

/// The queue with the hours of the work: those of all that the task holds and of the crew that does
/// the work. A lift that is held whole begins in the hours of all that it needs, and then goes on
/// whatever the hour.
int WorkActivity::work_queue(const ActiveTask& task, Stage& stage) {
  const int held = stage.queue_of(task.task);
  const int crew = task.now().work->crew;
  if (crew < 0) return held;
  std::vector<int> hours = stage.allocator->resources(held);
  const int resource = stage.crew_resource(crew);
  if (std::find(hours.begin(), hours.end(), resource) != hours.end()) return held;
  hours.push_back(resource);
  if (lift_of(stage, task.task)) {
    hours.clear();
  } else if (task.now().begins_lift && is_held_whole(stage, task.task)) {
    hours = lift_resources(stage, task.task);
  }
  return std::get<int>(
      stage.allocator->queue_for({stage.share_of(task.task, resource)}, std::move(hours)));
}

/// The hours in which the work begins and, but for a lift that is held whole, goes on.
const schedule::WorkCalendar& WorkActivity::work_hours(const ActiveTask& task, Stage& stage) {
  const bool begins = task.now().begins_lift && is_held_whole(stage, task.task);
  return begins ? lift_hours(stage, task.task) : stage.allocator->calendar(work_queue(task, stage));
}

/// It waited from then until now for a shift of all that the work needs.
void WorkActivity::end_shift_wait(ActiveTask& task, Stage& stage, Ticks since) {
  stage.end_shift_wait(task, since, since - work_hours(task, stage).last_working(since));
}

Step WorkActivity::granted(ActiveTask& task, Stage& stage, const ResourceAllocator::Grant& grant) {
  const Ticks free = std::clamp(grant.last.since, since_, stage.now());
  if (free > since_) {
    task.account.outcome.waits.resource += free - since_;
    if (auto* const trace = stage.trace_of(task.task)) {
      trace->pause("crew", stage.allocator->name(crew_), since_, free);
    }
    stage.links->add_mid_wait(task.task,
                              {free, schedule::Held::resource, crew_, grant.last.task_before});
  }
  end_shift_wait(task, stage, free);
  crew_since_ = stage.now();
  before_ = stage.working_time(task);
  if (!lift_of(stage, task.task)) stage.end_part(task);
  return work(task, stage);
}

/// Always takes time.
Step WorkActivity::work(ActiveTask& task, Stage& stage) {
  const interpreter::WorkSpec& spec = *task.now().work;
  const bool begins = task.now().begins_lift && is_held_whole(stage, task.task);
  const schedule::WorkCalendar& calendar = work_hours(task, stage);
  const bool goes_on = stage.links->is_milestone(task.task) || lift_of(stage, task.task);
  if (!goes_on && !calendar.works_at(stage.now())) {
    doing_ = Doing::waiting_for_shift;
    since_ = stage.now();
    const Ticks next = calendar.next_working(stage.now());
    if (next >= schedule::kEndOfTime) {
      stage.reject(task.task, "there is no shift any more for all that it needs");
    } else {
      stage.events.set(task.task, next);
    }
    return Step::pending;
  }
  if (task.now().interruptible() && breaks_down_now(task, stage)) {
    wait_for_repair(task, stage);
    return Step::pending;
  }
  if (spec.turning && !may_turn(task, stage)) return Step::pending;
  const Ticks duration =
      part_of(task, stage, interpreter::ticks_from_seconds(stage.draws.duration(spec)) - done_);
  done_ += duration;
  if (begins) begin_lift(task, stage, held_back_ ? stage.lift_notes.of(task.task) : nullptr);
  const bool whole = lift_of(stage, task.task) != nullptr;
  const Ticks finish = whole ? stage.now() + duration : calendar.finish(stage.now(), duration);
  if (finish >= schedule::kEndOfTime) {
    stage.reject(task.task,
                 fmt::format("its work ({}) is not done within 126 years", task.now().what));
    return Step::pending;
  }
  doing_ = Doing::working;
  task.account.outcome.work_time += duration;
  task.account.outcome.waits.shift += finish - stage.now() - duration;
  stage.note_off(task, stage.now(), finish, duration);
  const std::vector<int>& held = stage.held_by(task.task);
  const bool by_machine =
      task.now().kind == Phase::Kind::dig || task.now().kind == Phase::Kind::haul;
  for (std::size_t i = 0; i < held.size(); ++i) {
    // A machine fills, dumps and tips by itself, whoever else holds the task.
    const bool takes_part = spec.crew >= 0 ? held[i] == stage.crew_resource(spec.crew)
                                           : !by_machine || held[i] < stage.robots();
    if (takes_part) task.account.worked[i] += duration;
  }
  if (auto* const trace = stage.trace_of(task.task)) {
    trace->work(task.now().what,
                spec.crew < 0 ? "" : stage.plan.crews[static_cast<std::size_t>(spec.crew)].name,
                stage.now(), finish, duration);
  }
  if (turning_.angle_deg != 0) {
    const int robot = stage.spec(task.task).robot;
    stage.site.begin_turn(robot, turning_.angle_deg, finish);
    if (auto* const trace = stage.trace_of(task.task)) {
      const site::Load& load = *stage.site.load(robot);
      trace->turn(load.name, turning_.angle_deg, load.X_TO, stage.now(), finish, turning_.refused);
    }
    stage.announce({robot, -1});
  }
  stage.events.set(task.task, finish);
  return Step::pending;
}

/// What can be done of the work at once: until the machine breaks down, where nothing hangs on it.
Ticks WorkActivity::part_of(const ActiveTask& task, const Stage& stage, Ticks left) const {
  const int robot = stage.spec(task.task).robot;
  const bool interrupts = stage.breakdowns.breaks(robot) && task.now().interruptible();
  return interrupts ? std::min(left, stage.breakdowns.left(robot, work_in(task))) : left;
}

/// The machine is repaired where it stands, before the work begins or goes on.
void WorkActivity::wait_for_repair(ActiveTask& task, Stage& stage) {
  doing_ = Doing::under_repair;
  since_ = stage.now();
  const Ticks end = begin_repair(task, stage);
  if (end >= schedule::kEndOfTime) {
    stage.reject(task.task, never_repaired(stage));
  } else {
    stage.events.set(task.task, end);
  }
}

void WorkActivity::give_back(ActiveTask& task, Stage& stage) {
  if (crew_ < 0) return;
  ResourceHold hold;
  hold.resource = crew_;
  hold.from = crew_since_;
  hold.to = stage.now();
  if (!lift_of(stage, task.task)) {
    stage.end_part(task, work_queue(task, stage), false);
  }
  hold.before = before_;
  hold.after = stage.working_time(task);  // until now: the rest when the task is done
  hold.held = stage.allocator->hours(crew_).work_between(crew_since_, stage.now());
  hold.people = stage.share_of(task.task, crew_).units;
  hold.overtime = stage.overtime.in_shifts(crew_, crew_since_, stage.now());
  if (lift_of(stage, task.task)) {
    hold.held = stage.now() - crew_since_;
    hold.overtime += stage.overtime.out_of_shift(crew_, crew_since_, stage.now());
  }
  hold.busy = interpreter::ticks_from_seconds(stage.draws.duration(*task.now().work));
  hold.off = std::max<Ticks>(hold.held - hold.busy, 0);
  task.account.outcome.holds.push_back(hold);
  stage.allocator->release(crew_, task.task, stage.now(), true, hold.held);
  crew_ = -1;
}

WaitSet WorkActivity::waits(const ActiveTask& task, const Stage& stage) const {
  if (doing_ == Doing::waiting_for_machine) return wait_.waits(stage);
  WaitSet waits;
  if (doing_ == Doing::waiting_for_crew)
    stage.add_resource(waits, task.task, stage.share_of(task.task, crew_));
  return waits;
}

std::string WorkActivity::text_of(const ActiveTask& task, const Stage& stage,
                                  const WaitTarget& target) const {
  if (doing_ != Doing::waiting_for_machine) return Activity::text_of(task, stage, target);
  return text_of_way(stage, task.task, wait_.blockers[static_cast<std::size_t>(target.number)]);
}

std::string WorkActivity::standstill_reason(const ActiveTask& task, const Stage& stage) const {
  if (doing_ == Doing::waiting_for_machine)
    return wait_.standstill_reason(stage, stage.spec(task.task).robot);
  if (doing_ != Doing::waiting_for_crew) return {};
  const int holder = stage.allocator->state(crew_).holder();
  return fmt::format("it never gets {}, which {} holds", stage.allocator->name(crew_),
                     holder >= 0 ? stage.spec(holder).name : std::string("nobody"));
}

bool WorkActivity::wakes_at(const ActiveTask&, const Stage& stage, const SiteEvent& event) const {
  return doing_ == Doing::waiting_for_machine && wait_.wakes_at(stage, event);
}

std::vector<int> WorkActivity::robots_in_the_way(const Stage& stage) const {
  return doing_ == Doing::waiting_for_machine ? wait_.robots(stage) : std::vector<int>();
}

}  // namespace rubicon::taskplan
