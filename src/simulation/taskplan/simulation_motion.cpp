#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "src/simulation/taskplan/goal_holds.hpp"
#include "src/simulation/taskplan/motion_task.hpp"
#include "src/simulation/taskplan/reason.hpp"
#include "src/simulation/taskplan/simulation.hpp"

namespace rubicon::taskplan {

namespace {

using interpreter::MotionStatus;

/// Whether a motion that ended so may succeed when another machine has moved.
bool may_try_again(MotionStatus status) {
  return status == MotionStatus::done || status == MotionStatus::livelock ||
         status == MotionStatus::circling;
}

/// So many attempts before a `wait` are free: a script looks round before it waits. More count, so
/// that no script is busy for ever between two waits.
constexpr int kFreeTries = 100;

/// The machines and zones among hits, each once.
std::vector<Blocker> blockers_of(const std::vector<RecordedHit>& hits) {
  std::vector<Blocker> blockers;
  for (const RecordedHit& hit : hits) {
    const Blocker blocker{hit.pair.machine, hit.pair.zone_task, hit.pair.moved, hit.pair.met};
    if (blocker.robot < 0 && blocker.zone_task < 0) continue;
    const bool known = std::any_of(blockers.begin(), blockers.end(),
                                   [&](const Blocker& other) { return other.same_as(blocker); });
    if (!known) blockers.push_back(blocker);
  }
  return blockers;
}

/// The way point at which a machine was met first.
std::size_t first_way_point(const HitRecorder& hits) {
  int first = 0;
  for (const RecordedHit& hit : hits.given_way()) {
    if (first == 0 || hit.way_point < first) first = hit.way_point;
  }
  return static_cast<std::size_t>(std::max(first - 1, 0));
}

}  // namespace

bool Simulation::begin_motion(ActiveTask& active) {
  const interpreter::TaskSpec& task = spec(active.task);
  const MotionPurpose purpose = active.now().purpose;
  if (task.move && purpose == MotionPurpose::grip && !site_.stands(*task.move)) {
    reject(active, gone(*task.move), users_of(*task.move));
    return false;
  }
  const schedule::WorkCalendar& calendar = allocator_->calendar(queue_[index(active.task)]);
  if (!calendar.works_at(now_.now)) {
    wait_for_shift(active, calendar, Doing::moving);
    return false;
  }
  active.goals = goals_of(plan_, task, purpose, site_);
  if (purpose == MotionPurpose::grip) active.X_WO = site_.X_WO(*task.move);
  active.budget = task.budget.value_or(plan_.budget);
  active.waits = 0;
  active.way_points = active.goals_dropped = 0;
  // What stopped the carrying motion still keeps the placing one from its goal.
  if (purpose != MotionPurpose::place) active.hits.forget();
  const std::vector<double>& q = site_.configuration(task.robot);
  const robot::RobotModel& model = robot_spec(task.robot).robot->model;
  const robot::Mounting& mounting = site_.robot(task.robot).mounting;
  if (active.goals.size() == 1 &&
      goal_holds(model, mounting, q, active.goals.front(), within_of(plan_, task, purpose))) {
    MotionOutcome held;
    held.purpose = purpose;
    held.start = now_.now;
    held.end.reached = true;
    held.end.q = q;
    held.end.time = now_.now;
    own_trace(active);
    if (trace_) trace_->motion_end(held.end);
    active.outcome.motions.push_back(std::move(held));
    return true;
  }
  return start_machine(active);
}

/// Whether the motion is over at once.
bool Simulation::start_machine(ActiveTask& active) {
  const interpreter::TaskSpec& task = spec(active.task);
  const MotionPurpose purpose = active.now().purpose;
  interpreter::MotionTask motion;
  motion.goals = active.goals;
  motion.situations = situations_of(plan_, task, purpose);
  motion.within = within_of(plan_, task, purpose);
  motion.budget = active.budget;
  motion.full_budget = task.budget.value_or(plan_.budget);
  motion.first_n = active.outcome.tried + 1;
  motion.start = now_.now;
  motion.q = site_.configuration(task.robot);
  motion.mounting = site_.robot(task.robot).mounting;
  active.doing = Doing::moving;
  active.machine_start = now_.now;
  active.tries_before = active.free_tries = 0;
  active.machine.emplace(program_of(task.robot), std::move(motion));
  return move_on(active);
}

/// Attempts until one takes time; whether the motion is over and did what the task needs.
bool Simulation::move_on(ActiveTask& active) {
  const int robot = spec(active.task).robot;
  const schedule::WorkCalendar& calendar = allocator_->calendar(queue_[index(active.task)]);
  if (calendar.carries_over() && !calendar.works_at(now_.now)) {
    wait_for_shift(active, calendar, Doing::moving);
    return false;
  }
  own_trace(active);
  interpreter::Machine& machine = *active.machine;
  active.waits_in_script = false;
  refund_waits(active);
  while (machine.time() == now_.now) {
    const std::vector<double> before = machine.q();
    if (!machine.advance(views_[index(robot)], &active.hits)) break;
    if (machine.time() == now_.now) continue;
    count_step(active, machine.time(), machine.q() == before);
  }
  note_way_point(active);
  if (machine.time() > now_.now) {
    wake_at(active, machine.time());
    return false;
  }
  return end_motion(active);
}

/// A step from now to `to`, or a `wait` of the script, which waits for what was in the way last.
void Simulation::count_step(ActiveTask& active, Ticks to, bool waited) {
  const Ticks duration = to - now_.now;
  active.waits_in_script = waited;
  const int tries = active.machine->tries();
  const bool others = std::any_of(now_.active.begin(), now_.active.end(), [&](const auto& other) {
    return other->task != active.task &&
           (spec(other->task).robot >= 0 || !spec(other->task).zones.empty());
  });
  if (waited) charge_wait(active, others ? tries - active.tries_before - 1 : 0);
  active.tries_before = tries;
  if (waited && !active.hits.given_way().empty()) {
    active.outcome.waits.machine += duration;
  } else {
    active.outcome.motion_time += duration;
  }
  const std::vector<int>& resources = allocator_->resources(queue_[index(active.task)]);
  for (std::size_t i = 0; i < resources.size(); ++i) {
    active.over_time[i] += allocator_->hours(resources[i]).idle_between(now_.now, to);
  }
}

/// A `wait` counts until anybody makes progress; `looks`, what the script tried before it while
/// others are at work, not at all.
void Simulation::charge_wait(ActiveTask& active, int looks) {
  const int free = std::min(looks, kFreeTries);
  active.free_tries += free;
  active.machine->extend_budget(free);
  ++active.waits;
}

/// Somebody has made progress since the script waited: what it waited does not count any more.
void Simulation::refund_waits(ActiveTask& active) {
  if (active.progress_seen == now_.progress) return;
  active.progress_seen = now_.progress;
  active.free_tries += active.waits;
  active.machine->extend_budget(active.waits);
  active.waits = 0;
}

/// Something is done that is not done twice: a load taken or set down, work, a way point reached.
void Simulation::note_progress() {
  ++now_.progress;
  now_.progress_at = now_.now;
}

/// A motion that was stopped may reach its way points again: only the first time is progress.
void Simulation::note_way_point(ActiveTask& active) {
  const std::size_t behind = active.goals_dropped + active.machine->way_point();
  if (behind <= active.way_points) return;
  active.way_points = behind;
  note_progress();
}

/// How often a script waited since anybody made progress, and who waits for whom.
std::string Simulation::text_of_waits(const ActiveTask& active) const {
  std::vector<std::string> texts;
  std::set<int> seen;
  const ActiveTask* each = &active;
  while (each && seen.insert(each->task).second) {
    const std::vector<Blocker> met = each->doing == Doing::waiting_for_machine
                                         ? each->blockers
                                         : blockers_of(each->hits.given_way());
    if (met.empty()) break;
    texts.push_back(text_of_way(each->task, met.front()));
    const int robot = met.front().robot;
    each = look_at_active(robot >= 0 ? allocator_->state(robot).holder : met.front().zone_task);
  }
  return fmt::format("{} of them waits since {:g} s, when anybody last made progress{}{}",
                     active.waits, interpreter::seconds_from_ticks(now_.progress_at),
                     texts.empty() ? "" : ": ", fmt::join(texts, ", "));
}

bool Simulation::end_motion(ActiveTask& active) {
  MotionOutcome made;
  made.purpose = active.now().purpose;
  made.start = active.machine_start;
  made.end = active.machine->end();
  active.machine.reset();
  active.outcome.tried += made.end.tries;
  active.outcome.accepted += made.end.accepted;
  active.budget -= made.end.tries - active.free_tries;
  own_trace(active);
  if (trace_) trace_->motion_end(made.end);
  const bool reached = made.end.reached;
  const bool enough = is_enough(made.purpose, made.end);
  std::vector<Blocker> blockers;
  if (!reached && may_try_again(made.end.status)) {
    blockers = blockers_of(enough ? active.hits.open() : active.hits.given_way());
  }
  active.outcome.motions.push_back(std::move(made));
  if (blockers.empty()) {
    if (enough) return true;
    const interpreter::TaskSpec& task = spec(active.task);
    const std::string component = task.move ? site_.component_name(*task.move) : std::string();
    std::string reason =
        task_reason(active.outcome.motions.back(), active.hits.last(), component, sources_);
    const bool spent = active.outcome.motions.back().end.status == MotionStatus::budget;
    if (spent && active.waits > 0) reason += "; " + text_of_waits(active);
    reject(active, std::move(reason), in_the_way_of(active));
    return false;
  }
  const std::size_t behind = std::min(first_way_point(active.hits), active.goals.size() - 1);
  active.goals.erase(active.goals.begin(),
                     active.goals.begin() + static_cast<std::ptrdiff_t>(behind));
  active.goals_dropped += behind;
  active.doing = Doing::waiting_for_machine;
  active.since = now_.now;
  active.blockers = std::move(blockers);
  active.may_go_on = enough;
  new_waits_.push_back(active.task);
  note_place(active);
  return false;
}

/// How far those in the way have come, as a number that changes when one gets any further.
std::uint64_t Simulation::progress_of(const std::vector<Blocker>& blockers) const {
  std::uint64_t sum = 0;
  for (const Blocker& blocker : blockers) {
    const int task =
        blocker.robot >= 0 ? allocator_->state(blocker.robot).holder : blocker.zone_task;
    const ActiveTask* const other = look_at_active(task);
    sum = sum * 1'000'003 + static_cast<std::uint64_t>(task + 2) * 65'537 +
          (other ? other->progress + 1 : 0);
  }
  return sum;
}

/// A script that evades and comes back to where it waited before, while nobody in its way came any
/// further, would go on for ever: it now waits until one does.
void Simulation::note_place(ActiveTask& active) {
  const std::vector<double>& q = site_.configuration(spec(active.task).robot);
  const std::uint64_t others = progress_of(active.blockers);
  active.others = others;
  for (WaitPlace& place : active.places) {
    if (place.q != q) continue;
    active.stubborn = place.others == others;
    place.others = others;
    return;
  }
  active.places.push_back({q, others});
  active.stubborn = false;
  came_further(active);
}

void Simulation::came_further(ActiveTask& active) {
  ++active.progress;
  wake_those_who_wait_for(spec(active.task).robot, active.task);
}

/// What was in the way has moved: the script is tried again. Where it still makes no step, the try
/// leaves no trace and the task goes on waiting.
bool Simulation::retry(ActiveTask& active) {
  const schedule::WorkCalendar& calendar = allocator_->calendar(queue_[index(active.task)]);
  const bool hangs = site_.load(spec(active.task).robot).has_value();
  if (!hangs && !calendar.works_at(now_.now)) {
    wake_at(active, calendar.next_working(now_.now));
    return false;
  }
  const ActiveTask before = active;
  const TraceBuffer::Mark mark = buffer_ ? buffer_->mark() : 0;
  active.outcome.waits.machine += now_.now - active.since;
  const Blocker first = active.blockers.front();
  pause(active, "machine",
        first.robot >= 0 ? robot_spec(first.robot).name
                         : "the zone of " + spec(first.zone_task).name);
  active.hits.forget();
  active.doing = Doing::moving;
  const bool moves = active.now().kind == Phase::Kind::motion;
  const bool over = moves ? start_machine(active) : begin_phase(active);
  const bool fruitless = active.doing == Doing::waiting_for_machine && !rejection_ &&
                         active.outcome.accepted == before.outcome.accepted;
  if (!fruitless) {
    const int holder = first.robot >= 0 ? allocator_->state(first.robot).last : first.zone_task;
    if (now_.now > before.since) {
      links_->add_mid_wait(active.task, {now_.now, schedule::Held::machine, first.robot, holder});
    }
    return over;
  }
  std::vector<Blocker> blockers = std::move(active.blockers);
  HitRecorder hits = std::move(active.hits);
  active = before;
  active.blockers = std::move(blockers);
  active.hits = std::move(hits);
  active.wake.reset();
  if (buffer_) buffer_->forget_since(mark);
  return false;
}

/// A machine moved, or people left: those who wait for it try again.
void Simulation::wake_those_who_wait_for(int robot, int zone_task) {
  for (std::size_t i = 0; i < now_.active.size(); ++i) {
    const ActiveTask& waiting = *now_.active[i];
    if (waiting.doing != Doing::waiting_for_machine || waiting.wake) continue;
    const std::vector<Blocker>& blockers = waiting.blockers;
    const bool waits = std::any_of(blockers.begin(), blockers.end(), [&](const Blocker& blocker) {
      return (robot >= 0 && blocker.robot == robot) ||
             (zone_task >= 0 && blocker.zone_task == zone_task);
    });
    if (waiting.stubborn && progress_of(blockers) == waiting.others) continue;
    if (waits) wake_at(*find_active(now_.active[i]->task), now_.now);
  }
}

bool Simulation::may_park(int robot) const {
  if (!robot_spec(robot).park) return false;
  // Where it could not go it is asked again later, but not for ever.
  const ParkingFailure& failure = parking_failed_[index(robot)];
  if (failure.count >= kMostParkings || now_.now <= failure.last) return false;
  if (allocator_->state(robot).holder >= 0 || site_.load(robot)) return false;
  const interpreter::TaskSpec& park = parks_[index(robot)];
  return !goal_holds(robot_spec(robot).robot->model, site_.robot(robot).mounting,
                     site_.configuration(robot), *park.go, {});
}

/// Asks idle machines that are in somebody's way to their park position; whether one was asked.
bool Simulation::park_idle_machines() {
  std::vector<std::pair<int, int>> in_the_way;  // the robot, the task that waits for it
  for (const auto& active : now_.active) {
    if (active->doing != Doing::waiting_for_machine) continue;
    for (const Blocker& blocker : active->blockers) {
      in_the_way.emplace_back(blocker.robot, active->task);
    }
  }
  for (const ZoneWait& wait : now_.zone_waits) in_the_way.emplace_back(wait.robot, wait.task);
  for (const auto& [robot, asking] : in_the_way) {
    if (robot < 0 || !may_park(robot)) continue;
    const int task = static_cast<int>(plan_.tasks.size()) + robot;
    ResourceAllocator::Grant grant;
    grant.task = task;
    grant.queue = queue_[index(task)];
    grant.before = allocator_->states();
    allocator_->take_directly(robot, task);
    schedule::TaskTimes times;
    times.ready = times.wanted = now_.now;
    times.held = schedule::Held::asked;
    times.task_before = asking;
    times.given_back_midway = true;
    links_->set_times(task, times);
    links_->forget_known(task);
    begin_task(grant);
    asked_for_.push_back(asking);
    journal_.on_undo([this] { asked_for_.pop_back(); });
    propagate();
    return true;
  }
  return false;
}

}  // namespace rubicon::taskplan
