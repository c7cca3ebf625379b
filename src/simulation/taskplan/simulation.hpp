#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/machine/machine.hpp"
#include "interpreter/syntax/source.hpp"
#include "src/simulation/schedule/network.hpp"
#include "src/simulation/site/robot_view.hpp"
#include "src/simulation/site/site_world.hpp"
#include "src/simulation/taskplan/active_task.hpp"
#include "src/simulation/taskplan/journal.hpp"
#include "src/simulation/taskplan/link_state.hpp"
#include "src/simulation/taskplan/resource_allocator.hpp"
#include "src/simulation/taskplan/run_plan.hpp"
#include "src/simulation/taskplan/trace_buffer.hpp"
#include "src/simulation/taskplan/wait_graph.hpp"
#include "src/simulation/trace/trace_writer.hpp"

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

/// What a run has found out for good: which tasks are not done, which robots cannot park.
struct Verdicts {
  Excluded tasks;
  std::vector<ParkingFailure> parking_failed;  ///< to each robot
  /// Tasks that were let in again, and the task involved that was not done either.
  std::set<std::pair<int, int>> second_chances;
};

/// A discrete-event simulation of a full plan: tasks start when their links, robots, crews and
/// shifts allow, several machines move in one timeline, and events happen in the order of (time,
/// sequence). A task that cannot be done is rejected: the run goes back to the moment when it
/// started and goes on without it, so that it leaves no mark on the others.
class Simulation : private LinkState::Listener {
 public:
  /// `sink` may be null. All arguments must outlive it. The plan must be without `run_mistakes`.
  /// Tasks of `known` are left out from the beginning.
  Simulation(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
             trace::TraceSink* sink, const RunOptions& options, Verdicts known);

  /// Runs to the end; nothing if the whole must begin anew with the `verdicts` so far, which
  /// happens when a task that was done turns out to be impossible without a later one.
  std::optional<Schedule> run();
  Verdicts verdicts() const { return {excluded_, parking_failed_, second_chances_}; }

 private:
  /// What is copied to go back to a moment; the rest is in the journal.
  struct Moment {
    Ticks now = 0;
    std::uint64_t sequence = 0;
    std::uint64_t progress = 0;  ///< of all tasks: loads taken or set down, work done, way points
    Ticks progress_at = 0;       ///< when it grew last
    std::vector<std::shared_ptr<ActiveTask>> active;  ///< to be changed through `find_active` only
    std::vector<ZoneWait> zone_waits;
  };
  /// The moment before a task started.
  struct Checkpoint {
    int task = -1;
    Journal::Mark mark = 0;
    Journal::Mark links = 0;
    TraceBuffer::Mark trace = 0;
    Moment moment;
    std::vector<ResourceState> resources;
    std::vector<site::MachineState> machines;
  };
  struct Rejection {
    int task = -1;
    std::string reason;
    std::vector<int> involved;  ///< other tasks without which it may be done
  };
  enum class Status : std::uint8_t { pending, asking, active, done };
  /// So often a robot that could not park is asked again.
  static constexpr int kMostParkings = 100;

  // simulation.cpp: the loop
  void prepare();
  Ticks prepare_queue(int task);
  bool process_events();
  bool hand_out();
  void begin_task(const ResourceAllocator::Grant& grant);
  bool zone_is_free(const ResourceAllocator::Grant& grant);
  void ask_again_for_zones();
  ActiveTask& activate(int task);
  void finish_task(ActiveTask& active);
  void complete(ActiveTask& active);
  void hold_all(ActiveTask& active);
  void wake_at(ActiveTask& active, Ticks time);
  std::optional<Ticks> next_event() const;

  // simulation_links.cpp: when tasks may start and finish
  void prepare_links(schedule::Network network, std::vector<Ticks> work);
  void start_plan();
  void may_start(int task, int before) override;
  void may_finish(int task) override;
  void propagate();

  // simulation_phases.cpp: what a task does
  void run_phases(ActiveTask& active);
  void run_phases_after(ActiveTask& active);
  bool begin_phase(ActiveTask& active);
  void go_on(ActiveTask& active);
  bool begin_work(ActiveTask& active);
  bool do_work(ActiveTask& active);
  void end_work(ActiveTask& active);
  void crew_came(ActiveTask& active, const ResourceAllocator::Grant& grant);
  int work_queue(const ActiveTask& active);
  void wait_for_shift(ActiveTask& active, const schedule::WorkCalendar& calendar, Doing then);
  void pause(ActiveTask& active, const char* why, const std::string& whom);
  bool still_there(ActiveTask& active);
  bool attach(ActiveTask& active);
  void detach(ActiveTask& active);
  bool weigh(ActiveTask& active);
  bool remove(ActiveTask& active);
  void keep_component(int component);
  std::string gone(int component) const;

  // simulation_motion.cpp: motions, and waiting for other machines
  bool begin_motion(ActiveTask& active);
  bool start_machine(ActiveTask& active);
  bool move_on(ActiveTask& active);
  void count_step(ActiveTask& active, Ticks to, bool waited);
  void charge_wait(ActiveTask& active, int looks);
  void refund_waits(ActiveTask& active);
  void note_progress();
  void note_way_point(ActiveTask& active);
  std::string text_of_waits(const ActiveTask& active) const;
  bool end_motion(ActiveTask& active);
  bool retry(ActiveTask& active);
  std::uint64_t progress_of(const std::vector<Blocker>& blockers) const;
  void note_place(ActiveTask& active);
  void came_further(ActiveTask& active);
  void wake_those_who_wait_for(int robot, int zone_task);
  bool park_idle_machines();
  bool may_park(int robot) const;

  // simulation_waits.cpp: who waits for whom
  std::optional<WaitSet> waits_of(int task) const;
  WaitTarget move_of(int robot, WaitTarget::Kind kind, int number) const;
  bool may_park_some_day(int robot) const;
  void add_resource(WaitSet& waits, int task, int resource) const;
  void add_links(WaitSet& waits, int task, WaitTarget::Kind kind) const;
  void look_again_who_waits_for(int robot);
  void look_again_at_all();

  // simulation_deadlock.cpp: who wait for each other, and when nobody can go on
  bool find_deadlock();
  void reject_one_of(const WaitCycle& cycle);
  std::string text_of_wait(const WaitLink& link) const;
  std::string who_is(int task) const;
  std::string text_of_way(int task, const Blocker& blocker) const;
  int last_of(const std::vector<int>& tasks) const;
  bool resolve_standstill();
  std::string standstill_reason(int task);
  bool lets_one_go_on(const std::vector<int>& tasks);
  bool is_over(int task) const {
    return status_[index(task)] == Status::done || excluded_.contains(task);
  }

  // simulation_undo.cpp: going back
  void reject(const ActiveTask& active, std::string reason, std::vector<int> involved = {});
  bool apply_rejection();
  void exclude(int task, TaskOutcome outcome, int cause);
  void exclude_followers(int task, int cause);
  std::vector<int> users_of(int component) const;
  std::vector<int> in_the_way_of(const ActiveTask& active) const;
  void give_second_chances(int cause);
  std::set<int> followers_of(int first) const;
  void let_go(ActiveTask& active, int before, schedule::LinkType type);
  TaskOutcome not_reached(int task, int missing) const;
  void go_back(const Checkpoint& checkpoint);
  void drop_checkpoint(int task);
  void add_checkpoint(int task, std::vector<ResourceState> resources);

  ActiveTask* find_active(int task);
  const ActiveTask* look_at_active(int task) const;
  const interpreter::TaskSpec& spec(int task) const { return *specs_[index(task)]; }
  const interpreter::RobotSpec& robot_spec(int robot) const { return plan_.robots[index(robot)]; }
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  int crew_resource(int crew) const { return static_cast<int>(plan_.robots.size()) + crew; }
  bool is_park(int task) const { return task >= static_cast<int>(plan_.tasks.size()); }
  const interpreter::Program& program_of(int robot);
  void own_trace(const ActiveTask& active);
  void trace_start(int task, const schedule::TaskTimes& times);
  void trace_end(int task, Ticks time, const TaskOutcome& outcome);

  // make_schedule.cpp
  Schedule make_schedule();
  void add_critical_chain(Schedule& schedule) const;

  const interpreter::PlanModel& plan_;
  const interpreter::SourceMap& sources_;
  const RunOptions& options_;
  Journal journal_;
  std::optional<TraceBuffer> buffer_;
  std::optional<trace::TraceWriter> trace_;
  site::SiteWorld site_;
  std::deque<site::RobotView> views_;  ///< one a robot
  std::map<const interpreter::CheckedRobot*, interpreter::Program> programs_;
  std::optional<ResourceAllocator> allocator_;
  std::optional<LinkState> links_;

  // to each task: those of the plan, and then one a robot for parking it
  std::vector<interpreter::TaskSpec> parks_;
  std::vector<const interpreter::TaskSpec*> specs_;
  std::vector<int> queue_;  ///< where it asks for what it holds from start to finish
  std::vector<Status> status_;
  std::vector<std::optional<TaskOutcome>> outcomes_;
  std::vector<TaskOutcome> parkings_;
  std::vector<std::vector<int>> tasks_of_;  ///< to each robot: its tasks of the plan
  std::vector<int> new_waits_;              ///< tasks that may have closed a cycle of waiting
  std::vector<int> asked_for_;              ///< tasks for which a robot was asked out of the way

  // for good, whatever the run goes back to
  Excluded excluded_;
  std::vector<TaskOutcome> failed_parkings_;
  std::vector<ParkingFailure> parking_failed_;
  std::set<int> known_before_;  ///< of `excluded_` those rejected before the run began
  std::set<int> doubtful_;  ///< of `excluded_` those in whose rejection other tasks are involved
  std::set<std::pair<int, int>> second_chances_;
  bool must_restart_ = false;

  Moment now_;
  std::vector<Checkpoint> checkpoints_;  ///< of active tasks, oldest first
  std::optional<Rejection> rejection_;
  int done_ = 0;
};

}  // namespace rubicon::taskplan
