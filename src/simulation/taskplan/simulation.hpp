#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/syntax/source.hpp"
#include "src/simulation/schedule/link_state.hpp"
#include "src/simulation/taskplan/active_tasks.hpp"
#include "src/simulation/taskplan/checkpoint.hpp"
#include "src/simulation/taskplan/run_plan.hpp"
#include "src/simulation/taskplan/stage.hpp"
#include "src/simulation/taskplan/task_records.hpp"
#include "src/simulation/taskplan/wait_graph.hpp"

namespace rubicon::taskplan {

/// A task that is not done, for good.
struct ExcludedTask {
  TaskOutcome outcome;
  int cause = -1;  ///< the rejected task behind it: itself, or one that it depends on
  std::vector<std::string> lines;  ///< of a rejected one: its lines in the trace
  std::vector<int> involved;       ///< of a rejected one: other tasks without which it may be done
};
using Excluded = std::map<int, ExcludedTask>;

/// When a robot could not be parked last, and how often it could not.
struct ParkingFailure {
  Ticks last = -1;
  int count = 0;
};

/// A choice of members with which a task could not be done.
struct FailedChoice {
  int choice = -1;
  std::string reason;
  std::vector<int> involved;
};

/// What a run has found out for good: which tasks are not done, which robots cannot park.
struct Verdicts {
  Excluded tasks;
  std::vector<ParkingFailure> parking_failed;  ///< to each robot
  /// Tasks that were let in again, and the task involved that was not done either.
  std::set<std::pair<int, int>> second_chances;
  std::map<int, std::vector<FailedChoice>> failed_choices;
};

/// How things with a timetable have kept it up to now.
std::vector<TimetableOutcome> timetables_of(const site::SiteWorld& site, Ticks now);

/// A discrete-event simulation of a full plan: tasks start when their links, robots, crews and
/// shifts allow, several machines move in one timeline, and events happen in the order of (time,
/// sequence). A task that cannot be done is rejected: the run goes back to the moment when it
/// started and goes on without it, so that it leaves no mark on the others. What tasks do is in
/// their activities, what they share in the `Stage`; here is when they begin, finish and give way.
class Simulation : private LinkState::Listener {
 public:
  /// `sink` may be null. All arguments must outlive it. The plan must be without preflight errors.
  /// Tasks of `known` are left out from the beginning.
  Simulation(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
             const interpreter::Draws& draws, trace::TraceSink* sink, const RunOptions& options,
             const site::PreparedSite& prepared, Verdicts known);

  /// Runs to the end; nothing if the whole must begin again with the `verdicts` so far, which
  /// happens when a task that was done turns out to be impossible without a later one.
  std::optional<Schedule> run();
  Verdicts verdicts() const {
    return {excluded_, parking_failed_, second_chances_, failed_choices_};
  }

 private:
  using Status = TaskRecords::Status;
  /// So often a robot that could not park is asked again.
  static constexpr int kMostParkings = 100;

  // simulation.cpp: the loop; tasks begin and finish
  void start_plan();
  Ticks next_look_of_movings(Ticks other);
  void look_at_movings();
  bool process_event();
  bool hand_out();
  bool zone_is_free(const ResourceAllocator::Grant& grant);
  void ask_again_for_zones();
  ActiveTask& activate(int task);
  void hold_until_free(schedule::TaskTimes& times,
                       const schedule::ResourceStates::Last& last) const;
  void begin_task(const ResourceAllocator::Grant& grant);
  void go_on(ActiveTask& active, Step step);
  void finish_task(ActiveTask& active);
  void complete(ActiveTask& active);
  void repair_after(ActiveTask& active);
  void hold_all(ActiveTask& active);
  void may_start(int task, int before) override;
  void may_finish(int task) override;
  void propagate();
  void trace_end(int task, Ticks time, const TaskOutcome& outcome);
  void find_cold_joints(int task, TaskOutcome& outcome);

  // simulation_choices.cpp: tasks by pools
  void ask(int task, Ticks from);
  bool is_out(int task, int choice) const;
  bool asks_no_more(int task, int queue) const;
  int choose_queue(int task, const std::vector<int>& queues) const;
  math::Vec3 place_of(int robot, const interpreter::GoalSpec& goal) const;
  double rank_of(const interpreter::TaskSpec& choice, const interpreter::PoolMember& member) const;
  void take_members(const ResourceAllocator::Grant& grant);
  std::string choice_text(int task) const;
  std::string text_of_other(int task, const interpreter::PoolMember& member) const;
  bool try_next_choice(Rejection& rejection);

  // simulation_waits.cpp: who waits for whom, and what happens when nobody can go on
  std::optional<WaitSet> waits_of(int task) const;
  void add_links(WaitSet& waits, int task, WaitTarget::Kind kind) const;
  void look_again_who_waits_for(int robot);
  void look_again_at_all();
  bool find_deadlock();
  void reject_one_of(const WaitCycle& cycle);
  std::string text_of_wait(const WaitLink& link) const;
  bool resolve_standstill();
  std::string standstill_reason(int task) const;
  bool lets_one_go_on(const std::vector<int>& tasks);
  std::vector<Eigen::Vector2d> places_ahead(int robot) const;
  bool untangle_fleets();
  void choose_park(int robot);
  bool park_idle_machines();
  bool may_park(int robot, bool now) const;

  // simulation_undo.cpp: tasks that are not done, and going back
  bool apply_rejection();
  bool repeat_lift();
  void exclude(int task, TaskOutcome outcome, int cause);
  void exclude_followers(int task, int cause);
  void free_groups(bool rejected);
  bool kept_from_others(int resource, int group) const;
  bool may_want(int task, int resource) const;
  bool misses_all_trucks(int task) const;
  void give_second_chances(int cause);
  void let_go(ActiveTask& active, int before, schedule::LinkType type);
  TaskOutcome not_reached(int task, int missing) const;
  bool is_over(int task) const {
    return records_.status(task) == Status::done || excluded_.contains(task);
  }

  // make_schedule.cpp
  Schedule make_schedule();
  void add_lost_days(Schedule& schedule, Ticks end);
  void add_floats(const std::vector<std::size_t>& row_of, Schedule& schedule) const;
  bool gave_back(const schedule::MissedShift& missed, const std::vector<std::size_t>& row_of,
                 const Schedule& schedule) const;
  void add_critical_chain(const std::vector<std::size_t>& row_of, Schedule& schedule) const;

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  const interpreter::PlanModel& plan_;
  const RunOptions& options_;
  Stage stage_;
  TaskRecords records_;
  ZoneWaits zone_waits_;
  Checkpoints checkpoints_;

  // for good, whatever the run goes back to
  Excluded excluded_;
  std::vector<ParkingFailure> parking_failed_;
  std::set<int> known_before_;  ///< of `excluded_` those rejected before the run began
  std::set<int> doubtful_;  ///< of `excluded_` those in whose rejection other tasks are involved
  std::set<std::pair<int, int>> second_chances_;
  std::map<int, std::vector<FailedChoice>> failed_choices_;  ///< to each task by pools
  bool must_restart_ = false;
};

}  // namespace rubicon::taskplan
