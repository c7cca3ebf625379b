#include "src/simulation/taskplan/motion_activity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "src/simulation/taskplan/goal_holds.hpp"
#include "src/simulation/taskplan/load_judgement.hpp"
#include "src/simulation/taskplan/load_turning.hpp"
#include "src/simulation/taskplan/motion_task.hpp"
#include "src/simulation/taskplan/reason.hpp"

namespace rubicon::taskplan {

namespace {

using interpreter::MotionStatus;

/// So many attempts before a `wait` are free: a script looks round before it waits. More count, so
/// that no script is busy for ever between two waits.
constexpr int kFreeTries = 100;

/// Whether a motion that ended so may succeed when another machine has moved.
bool may_try_again(MotionStatus status) {
  return status == MotionStatus::done || status == MotionStatus::livelock ||
         status == MotionStatus::circling || status == MotionStatus::no_way;
}

/// The waypoint at which a machine was met first.
std::size_t first_way_point(const HitRecorder& hits) {
  int first = 0;
  for (const RecordedHit& hit : hits.given_way()) {
    if (first == 0 || hit.way_point < first) first = hit.way_point;
  }
  return static_cast<std::size_t>(std::max(first - 1, 0));
}

/// Whether other machines or people are at work beside the task, or something keeps a timetable.
bool has_others(const Stage& stage, int task) {
  for (std::size_t i = 0; i < stage.active.size(); ++i) {
    const int other = stage.active[i].task;
    if (other == task) continue;
    if (stage.spec(other).robot >= 0 || !stage.spec(other).zones.empty()) return true;
  }
  return stage.now() < stage.site.movings_worth_waiting();
}

}  // namespace

Step MotionActivity::begin(ActiveTask& task, Stage& stage) {
  const interpreter::TaskSpec& spec = stage.spec(task.task);
  const MotionPurpose purpose = task.now().purpose;
  if (spec.move && purpose == MotionPurpose::grip && !stage.site.stands(*spec.move)) {
    stage.reject(task.task, stage.gone(*spec.move), stage.users_of(*spec.move));
    return Step::pending;
  }
  if (purpose == MotionPurpose::grip) {
    if (auto reason = too_heavy(stage, task.task)) {
      stage.reject(task.task, std::move(*reason), {});
      return Step::pending;
    }
  }
  goals_ = leg_ ? leg_->goals : goals_of(stage.plan, spec, purpose, stage.site);
  // What makes no step needs no shift.
  const bool is_held = is_at_goal(task, stage);
  if (!is_held && !lift_of(stage, task.task) && !stage.calendar(task.task).works_at(stage.now())) {
    wait_for_shift(task, stage);
    return Step::pending;
  }
  if (purpose == MotionPurpose::carry && spec.adjust && spec.adjust->turning) {
    if (auto reason = why_not_by_turning(stage, task.task)) {
      stage.reject(task.task, std::move(*reason));
      return Step::pending;
    }
  }
  if (purpose == MotionPurpose::grip) task.X_WO = stage.site.X_WO(*spec.move);
  memory_ = std::make_shared<interpreter::GoalMemory>();
  budget_ = spec.budget.value_or(stage.plan.budget);
  waits_ = 0;
  way_points_ = goals_dropped_ = 0;
  // What stopped the carrying motion still keeps the placing one from its goal.
  if (purpose != MotionPurpose::place) task.hits.forget();
  if (is_held) {
    MotionOutcome held;
    held.purpose = purpose;
    held.start = stage.now();
    held.end.reached = true;
    held.end.q = stage.site.configuration(spec.robot);
    held.end.time = stage.now();
    if (auto* const trace = stage.trace_of(task.task)) trace->motion_end(held.end);
    ++task.account.outcome.motions;
    return Step::over;
  }
  return start_machine(task, stage);
}

Step MotionActivity::resume(ActiveTask& task, Stage& stage) {
  switch (doing_) {
    case Doing::moving:
      if (!stands_) stage.announce({stage.spec(task.task).robot, -1});
      return move_on(task, stage);
    case Doing::waiting_for_shift:
      stage.end_shift_wait(task, since_, since_ - stage.calendar(task.task).last_working(since_));
      if (!machine_) return begin(task, stage);
      machine_->resume_at(stage.now());
      doing_ = Doing::moving;
      return move_on(task, stage);
    case Doing::waiting_for_machine:
      return retry(task, stage);
    case Doing::under_repair:
      task.account.outcome.waits.repair += stage.now() - since_;
      task.account.repair +=
          stage.allocator->hours(stage.spec(task.task).robot).work_between(since_, stage.now());
      stage.pause(task.task, "repair", stage.robot_spec(stage.spec(task.task).robot).name, since_);
      if (!stage.calendar(task.task).works_at(stage.now())) {
        wait_for_shift(task, stage);
        return Step::pending;
      }
      machine_->resume_at(stage.now());
      doing_ = Doing::moving;
      return move_on(task, stage);
  }
  return Step::pending;
}

Step MotionActivity::start_machine(ActiveTask& task, Stage& stage) {
  const interpreter::TaskSpec& spec = stage.spec(task.task);
  const MotionPurpose purpose = task.now().purpose;
  interpreter::MotionTask motion;
  motion.goals = goals_;
  motion.situations = situations_of(stage.plan, spec, purpose);
  if (leg_) motion.situations.push_back(leg_->situation);
  if (!leg_ || leg_->guided) motion.guides = spec.guides;
  for (guides::GuideSpec& guide : motion.guides) guide.tells_tree = stage.traces_graphs;
  // On the lanes of a fleet who goes first is known.
  motion.looks_ahead =
      stage.site.foresees(spec.robot) &&
      std::none_of(motion.guides.begin(), motion.guides.end(), [](const guides::GuideSpec& guide) {
        return guide.kind == guides::GuideKind::lanes;
      });
  if (spec.cover && !motion.guides.empty()) {
    motion.fence = std::make_shared<const interpreter::FloorFence>(
        stage.plan.areas[static_cast<std::size_t>(spec.cover->area)], *spec.cover);
  }
  motion.within = within_of(stage.plan, spec, purpose);
  motion.clauses = spec.clauses;
  std::vector<std::pair<int, int>> entered = spec.clauses.entered;
  if (leg_) entered.insert(entered.end(), leg_->entered.begin(), leg_->entered.end());
  stage.site.let_enter(spec.robot, std::move(entered));
  motion.budget = budget_;
  motion.full_budget = spec.budget.value_or(stage.plan.budget);
  motion.first_n = task.account.outcome.tried + 1;
  motion.start = stage.now();
  motion.q = stage.site.configuration(spec.robot);
  motion.mounting = stage.site.robot(spec.robot).mounting;
  if (stage.on_motion) {
    stage.on_motion(spec.name, purpose, stage.program_of(spec.robot), motion,
                    stage.view(spec.robot));
  }
  motion.memory = memory_;  // not for observers, which may ask from other threads
  doing_ = Doing::moving;
  machine_start_ = stage.now();
  tries_before_ = free_tries_ = 0;
  version_at_stop_.reset();
  machine_.emplace(stage.program_of(spec.robot), std::move(motion));
  return move_on(task, stage);
}

/// Attempts until one takes time, or a stop does.
Step MotionActivity::move_on(ActiveTask& task, Stage& stage) {
  const schedule::WorkCalendar& calendar = stage.calendar(task.task);
  stage.trace_of(task.task);
  interpreter::Machine& machine = *machine_;
  stands_ = false;
  // A motion that has ended, with its stop, is told before the night.
  const bool goes_on = !machine.ended();
  if (goes_on && calendar.carries_over() && !calendar.works_at(stage.now())) {
    if (!machine.stop(&task.hits)) {
      wait_for_shift(task, stage);
      return Step::pending;
    }
    stands_ = true;
    count_time(task, stage, machine.time(), false);
  }
  if (!stands_ && goes_on && breaks_down_now(task, stage) && !is_at_goal(task, stage)) {
    if (!machine.stop(&task.hits)) {
      wait_for_repair(task, stage);
      return Step::pending;
    }
    stands_ = true;
    count_time(task, stage, machine.time(), false);
  }
  refund_waits(stage);
  const std::uint64_t traffic = stage.site.traffic_changes();
  while (machine.time() == stage.now()) {
    const std::vector<double> before = machine.q();
    const int tries = machine.tries();
    if (!machine.advance(stage.view(stage.spec(task.task).robot), &task.hits)) break;
    if (machine.time() == stage.now()) continue;
    // What takes time and is no attempt is a stop.
    const bool stops = machine.tries() == tries;
    const bool waits = !stops && machine.q() == before;
    stands_ = stops || waits;
    version_at_stop_.reset();
    if (stops) version_at_stop_ = stage.view(stage.spec(task.task).robot).version();
    if (!stops) count_step(task, stage, machine.time(), waits);
    if (!stops && !waits) note_laid(task, stage, before);
    if (stops) count_time(task, stage, machine.time(), false);
  }
  if (stage.site.traffic_changes() != traffic) {
    stage.announce({stage.spec(task.task).robot, -1});
  }
  // A motion that was stopped may reach its waypoints again: only the first time is progress.
  const std::size_t behind = goals_dropped_ + machine.way_point();
  if (behind > way_points_) {
    way_points_ = behind;
    stage.made_progress();
  }
  if (machine.time() > stage.now()) {
    stage.events.set(task.task, machine.time());
    return Step::pending;
  }
  return end_motion(task, stage);
}

/// A step from now to `to`, or a `wait` of the script, which waits for what was in the way last.
void MotionActivity::count_step(ActiveTask& task, Stage& stage, Ticks to, bool waited) {
  const int tries = machine_->tries();
  if (waited) charge_wait(has_others(stage, task.task) ? tries - tries_before_ - 1 : 0);
  tries_before_ = tries;
  task.account.outcome.overlaps += stage.site.take_overlaps(stage.spec(task.task).robot);
  count_time(task, stage, to, waited);
}

/// What the step that now begins lays of the strip under way, where joints are looked for.
void MotionActivity::note_laid(ActiveTask& task, const Stage& stage,
                               const std::vector<double>& before) {
  const interpreter::TaskSpec& spec = stage.spec(task.task);
  if (!spec.cover || spec.cover->cold_after == 0) return;
  const std::size_t point = goals_dropped_ + machine_->way_point();
  const auto goal = [&](std::size_t i) -> const interpreter::GoalSpec& {
    return i < spec.via.size() ? spec.via[i] : *spec.go;
  };
  if (goal(point).work != interpreter::GoalSpec::Work::working) return;
  const robot::RobotModel& model = stage.robot_spec(spec.robot).robot->model;
  const robot::Mounting& mounting = stage.site.robot(spec.robot).mounting;
  const math::Pose X_AW =
      stage.plan.areas[static_cast<std::size_t>(spec.cover->area)].X_WA.inverse();
  const auto place = [&](const math::Pose& X_WT) {
    const math::Vec3 p = X_AW * X_WT.translation();
    return coverage::Place{p.x(), p.y()};
  };
  strip_.begin(point, place(*goal(point - 1).X_WG), place(*goal(point).X_WG));
  strip_.add(place(robot::tool_pose(model, mounting, before)),
             place(robot::tool_pose(model, mounting, machine_->q())), stage.now(), machine_->time(),
             task.account.outcome.laid);
}

/// The time from now to `to`, in which the robot makes a step, waits as its script says, or comes
/// to a stop.
void MotionActivity::count_time(ActiveTask& task, Stage& stage, Ticks to, bool waited) {
  const Ticks duration = to - stage.now();
  if (waited && !task.hits.given_way().empty()) {
    task.account.outcome.waits.machine += duration;
  } else {
    task.account.outcome.motion_time += duration;
  }
  const std::vector<int>& resources = stage.held_by(task.task);
  for (std::size_t i = 0; i < resources.size(); ++i) {
    task.account.over_time[i] += stage.allocator->hours(resources[i]).idle_between(stage.now(), to);
    task.account.outside[i] += stage.overtime.out_of_shift(resources[i], stage.now(), to);
  }
}

/// A `wait` counts until anybody makes progress; `looks`, what the script tried before it while
/// others are at work, not at all.
void MotionActivity::charge_wait(int looks) {
  const int free = std::min(looks, kFreeTries);
  free_tries_ += free;
  machine_->extend_budget(free);
  ++waits_;
}

/// Somebody has made progress since the script waited: what it waited does not count any more.
void MotionActivity::refund_waits(const Stage& stage) {
  if (progress_seen_ == stage.progress.count) return;
  progress_seen_ = stage.progress.count;
  free_tries_ += waits_;
  machine_->extend_budget(waits_);
  waits_ = 0;
}

/// How often a script waited since anybody made progress, and who waits for whom.
std::string MotionActivity::text_of_waits(const ActiveTask& task, const Stage& stage) const {
  std::vector<std::string> texts;
  std::set<int> seen;
  const ActiveTask* each = &task;
  while (each && seen.insert(each->task).second) {
    std::vector<Blocker> met = blockers_of(each->hits.given_way());
    if (met.empty()) break;
    texts.push_back(text_of_way(stage, each->task, met.front()));
    const int robot = met.front().robot;
    each = stage.active.look_at(robot >= 0 ? stage.allocator->state(robot).holder()
                                           : met.front().zone_task);
  }
  return fmt::format("{} of them waits since {:g} s, when anybody last made progress{}{}", waits_,
                     interpreter::seconds_from_ticks(stage.progress.last),
                     texts.empty() ? "" : ": ", fmt::join(texts, ", "));
}

bool MotionActivity::may_end_short(const RecordedHit* hit) const {
  return leg_ && leg_->may_end_at && hit != nullptr && leg_->may_end_at->contains(hit->pair.met);
}

Step MotionActivity::end_motion(ActiveTask& task, Stage& stage) {
  MotionOutcome made;
  made.purpose = task.now().purpose;
  made.start = machine_start_;
  made.end = machine_->end();
  task.account.outcome.thinking += machine_->thinking();
  task.account.outcome.foreseen += machine_->foreseen();
  task.account.outcome.rounds += machine_->rounds();
  machine_.reset();
  TaskOutcome& outcome = task.account.outcome;
  outcome.tried += made.end.tries;
  outcome.accepted += made.end.accepted;
  budget_ -= made.end.tries - free_tries_;
  if (auto* const trace = stage.trace_of(task.task)) trace->motion_end(made.end);
  const bool enough = is_enough(made.purpose, made.end);
  std::vector<Blocker> blockers;
  if (!made.end.reached && may_try_again(made.end.status)) {
    blockers = blockers_of(enough ? task.hits.open() : task.hits.given_way());
  }
  ++outcome.motions;
  const interpreter::MotionEnd& end = made.end;
  const std::size_t behind =
      blockers.empty() ? goals_.size() : std::min(first_way_point(task.hits), goals_.size() - 1);
  // What it tries again may yet be reached.
  for (const interpreter::MissedWayPoint& each : end.missed) {
    if (static_cast<std::size_t>(each.k) > behind) break;
    outcome.missed.push_back(missed_text(static_cast<int>(goals_dropped_) + each.k, each.off));
  }
  if (blockers.empty()) {
    if (enough) return Step::over;
    const interpreter::TaskSpec& spec = stage.spec(task.task);
    const std::string component = spec.move ? stage.site.component_name(*spec.move) : std::string();
    std::string reason = task_reason(made, task.hits.last(), component, stage.sources);
    if (leg_) reason = leg_->what + ": " + reason;
    // What it met before it waited may have kept it from its goal, though it meets nothing now.
    if (end.status == MotionStatus::done && !waited_for_.empty() && !task.hits.last()) {
      reason += "; before that " + waited_for_;
    }
    if (end.status == MotionStatus::done && may_end_short(task.hits.last())) {
      task.ended_short = std::move(reason);
      return Step::over;
    }
    const bool spent = end.status == MotionStatus::budget;
    if (spent && waits_ > 0) reason += "; " + text_of_waits(task, stage);
    stage.reject(task.task, std::move(reason), stage.in_the_way_of(task));
    return Step::pending;
  }
  goals_.erase(goals_.begin(), goals_.begin() + static_cast<std::ptrdiff_t>(behind));
  goals_dropped_ += behind;
  // Once at a moment, whatever is met then.
  const bool looks_again =
      looked_again_ != stage.now() &&
      std::any_of(blockers.begin(), blockers.end(),
                  [&](const Blocker& blocker) { return has_gone(stage, blocker); });
  if (looks_again) looked_again_ = stage.now();
  wait_for_machine(task, stage, std::move(blockers), enough);
  // What moved while the robot came to its stop will not be told again, nor what left before.
  const bool moved =
      version_at_stop_ && *version_at_stop_ != stage.view(stage.spec(task.task).robot).version();
  return moved || looks_again ? retry(task, stage) : Step::pending;
}

/// A script that evades and comes back to where it waited before, while nobody in its way came any
/// further, would go on for ever: it now waits until one does.
void MotionActivity::wait_for_machine(ActiveTask& task, Stage& stage, std::vector<Blocker> blockers,
                                      bool enough) {
  doing_ = Doing::waiting_for_machine;
  wait_ = {std::move(blockers), stage.now(), stage.site.traffic_changes(), 0, false, enough};
  wait_.others = progress_of(stage, wait_.blockers);
  stage.begins_to_wait(task.task);
  wait_.wait_for_timetables(stage, task.task);
  const std::vector<double>& q = stage.site.configuration(stage.spec(task.task).robot);
  for (WaitPlace& place : places_) {
    if (place.q != q) continue;
    wait_.stubborn = place.others == wait_.others;
    place.others = wait_.others;
    return;
  }
  places_.push_back({q, wait_.others});
  stage.came_further(task);
}

void MotionActivity::wait_for_shift(ActiveTask& task, Stage& stage) {
  doing_ = Doing::waiting_for_shift;
  since_ = stage.now();
  const Ticks next = stage.calendar(task.task).next_working(stage.now());
  if (next >= schedule::kEndOfTime) {
    stage.reject(task.task, "there is no shift any more for all that it needs");
  } else {
    stage.events.set(task.task, next);
  }
}

/// Whether nothing is left of the motion: whoever is due for repair at its very end is repaired
/// then, and holds nobody up who waits for the task.
bool MotionActivity::is_at_goal(const ActiveTask& task, Stage& stage) const {
  const interpreter::TaskSpec& spec = stage.spec(task.task);
  return goals_.size() == 1 &&
         goal_holds(stage.robot_spec(spec.robot).robot->model,
                    stage.site.robot(spec.robot).mounting, stage.site.configuration(spec.robot),
                    goals_.front(), within_of(stage.plan, spec, task.now().purpose),
                    spec.clauses.free);
}

/// The robot is repaired where it stands.
void MotionActivity::wait_for_repair(ActiveTask& task, Stage& stage) {
  doing_ = Doing::under_repair;
  since_ = stage.now();
  const Ticks end = begin_repair(task, stage);
  if (end >= schedule::kEndOfTime) {
    stage.reject(task.task, never_repaired(stage));
  } else {
    stage.events.set(task.task, end);
  }
}

/// What was in the way has moved: the script is tried again. Where it still makes no step, the try
/// leaves no trace and the task goes on waiting.
Step MotionActivity::retry(ActiveTask& task, Stage& stage) {
  const schedule::WorkCalendar& calendar = stage.calendar(task.task);
  const bool hangs = stage.site.load(stage.spec(task.task).robot).has_value();
  if (!hangs && !calendar.works_at(stage.now())) {
    stage.events.set(task.task, calendar.next_working(stage.now()));
    return Step::pending;
  }
  const MotionActivity before = *this;
  const ActiveTask::Account account = task.account;
  const TraceOutput::Mark mark = stage.trace.mark();
  task.account.outcome.waits.machine += stage.now() - wait_.since;
  stage.pause(task.task, "machine", wait_.first_name(stage), wait_.since);
  task.hits.forget();
  waited_for_ = text_of_way(stage, task.task, wait_.blockers.front());
  const Step step = start_machine(task, stage);
  const bool fruitless = doing_ == Doing::waiting_for_machine && !stage.rejection &&
                         task.account.outcome.accepted == account.outcome.accepted;
  if (!fruitless) {
    before.wait_.note_wait(stage, task.task);
    ++task.account.outcome.stops;
    return step;
  }
  std::vector<Blocker> blockers = std::move(wait_.blockers);
  const std::uint64_t traffic = wait_.traffic;
  *this = before;
  wait_.blockers = std::move(blockers);
  wait_.traffic = traffic;
  task.account = account;
  stage.events.cancel(task.task);
  stage.trace.forget_since(mark);
  wait_.wait_for_timetables(stage, task.task);
  return Step::pending;
}

WaitSet MotionActivity::waits(const ActiveTask& task, const Stage& stage) const {
  return doing_ == Doing::waiting_for_machine ? wait_.waits(stage, stage.spec(task.task).robot)
                                              : WaitSet();
}

std::string MotionActivity::text_of(const ActiveTask& task, const Stage& stage,
                                    const WaitTarget& target) const {
  return text_of_way(stage, task.task, wait_.blockers[static_cast<std::size_t>(target.number)]);
}

std::string MotionActivity::standstill_reason(const ActiveTask& task, const Stage& stage) const {
  return doing_ == Doing::waiting_for_machine
             ? wait_.standstill_reason(stage, stage.spec(task.task).robot)
             : std::string();
}

bool MotionActivity::wakes_at(const ActiveTask&, const Stage& stage, const SiteEvent& event) const {
  return doing_ == Doing::waiting_for_machine && wait_.wakes_at(stage, event);
}

std::vector<int> MotionActivity::robots_in_the_way(const Stage& stage) const {
  return doing_ == Doing::waiting_for_machine ? wait_.robots(stage) : std::vector<int>();
}

/// Near enough to the goal: it goes on as it is (carrying may end short).
bool MotionActivity::settle(ActiveTask& task, Stage& stage) {
  if (doing_ != Doing::waiting_for_machine || !wait_.is_enough) return false;
  task.account.outcome.waits.machine += stage.now() - wait_.since;
  stage.pause(task.task, "machine", wait_.blockers.front().met, wait_.since);
  ++task.account.outcome.stops;
  return true;
}

}  // namespace rubicon::taskplan
