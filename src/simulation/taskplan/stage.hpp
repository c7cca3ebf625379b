#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/machine/machine.hpp"
#include "interpreter/syntax/source.hpp"
#include "src/simulation/schedule/link_state.hpp"
#include "src/simulation/site/robot_view.hpp"
#include "src/simulation/site/site_world.hpp"
#include "src/simulation/site/support.hpp"
#include "src/simulation/taskplan/active_tasks.hpp"
#include "src/simulation/taskplan/breakdowns.hpp"
#include "src/simulation/taskplan/event_queue.hpp"
#include "src/simulation/taskplan/haulage.hpp"
#include "src/simulation/taskplan/overtime_hours.hpp"
#include "src/simulation/taskplan/resource_allocator.hpp"
#include "src/simulation/taskplan/run_plan.hpp"
#include "src/simulation/taskplan/site_changes.hpp"
#include "src/simulation/taskplan/trace_output.hpp"
#include "src/simulation/taskplan/whole_lift.hpp"

namespace rubicon::taskplan {

using schedule::LinkState;

/// A task that is to be rejected: the run goes back to when it began.
struct Rejection {
  int task = -1;
  std::string reason;
  std::vector<int> involved;  ///< other tasks without which it may be done
};

/// What all tasks have done that is not done twice: loads taken and set down, work, waypoints
/// reached for the first time. A script's own waits count since the last of it.
struct SiteProgress {
  std::uint64_t count = 0;
  Ticks last = 0;
};

/// What tasks share: the site, its robots and crews, time, links and the trace, each a part with
/// its own state; and what activities ask of the run. Tasks are those of the plan, then one for
/// each robot that parks it; resources are the robots, then the crews.
class Stage {
 public:
  Stage(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
        const interpreter::Draws& draws, trace::TraceSink* sink, trace::TraceDetail detail,
        const site::PreparedSite& prepared);

  const interpreter::PlanModel& plan;
  const interpreter::Draws& draws;
  const interpreter::SourceMap& sources;
  TraceOutput trace;
  site::SiteWorld site;                  ///< components are changed through `site_changes`
  std::optional<site::Support> support;  ///< where the plan examines it
  SiteChanges site_changes;
  EventQueue events;
  ActiveTasks active;
  SiteProgress progress;
  std::vector<WholeLift> lifts;       ///< those under way that are held whole
  LiftNotes lift_notes;               ///< whatever the run goes back to
  std::optional<int> lift_to_repeat;  ///< a task that is to begin again: its note says why
  std::optional<ResourceAllocator> allocator;
  Haulage haulage;
  OvertimeHours overtime;
  Breakdowns breakdowns;
  std::vector<BreakdownOutcome> breakdown_outcomes;  ///< by their begin
  std::vector<TaskOutcome> failed_parkings;          ///< as the trace keeps them
  std::optional<LinkState> links;
  std::optional<Rejection> rejection;
  std::vector<int> new_waits;  ///< tasks that may have closed a cycle of waiting

  int tasks() const { return static_cast<int>(specs_.size()); }
  int plan_tasks() const { return static_cast<int>(plan.tasks.size()); }
  int robots() const { return static_cast<int>(plan.robots.size()); }
  /// The task, by pools as it was chosen, before that without a member of them.
  const interpreter::TaskSpec& spec(int task) const {
    const int choice = chosen_[at(task)];
    return choice < 0 ? plan_spec(task) : plan_spec(task).choices[at(choice)];
  }
  /// The task as the plan gives it.
  const interpreter::TaskSpec& plan_spec(int task) const { return *specs_[at(task)]; }
  const interpreter::RobotSpec& robot_spec(int robot) const { return plan.robots[at(robot)]; }
  /// The tasks of the plan that the robot has, or may be chosen for.
  const std::vector<int>& tasks_of(int robot) const { return tasks_of_[at(robot)]; }
  int crew_resource(int crew) const { return robots() + crew; }
  int park_task(int robot) const { return plan_tasks() + robot; }
  bool is_park(int task) const { return task >= plan_tasks(); }
  /// Why the machine went that a task waited for; nothing if it was no parking.
  std::optional<schedule::Parking> parking_of(int task) const;
  /// Where the robot parks from now on.
  void set_park(int robot, std::vector<std::pair<int, double>> values) {
    parks_[at(robot)].go->values = std::move(values);
  }
  /// Where the task parks a vehicle of a fleet; nothing of other tasks.
  std::vector<std::pair<int, double>> place_of_park(int task) const {
    if (!is_park(task) || robot_spec(spec(task).robot).fleet < 0) return {};
    return spec(task).go->values;
  }
  /// "left (go_right)", or the name of a task without a robot.
  std::string who_is(int task) const;

  Ticks now() const { return events.now(); }
  /// Where the task asks for what it holds from start to finish.
  int queue_of(int task) const { return queue_[at(task)]; }
  // of tasks by pools
  bool has_choices(int task) const { return !plan_spec(task).choices.empty(); }
  const std::vector<int>& choice_queues(int task) const { return choice_queues_[at(task)]; }
  /// Which of its choices the task has, -1: none yet.
  int chosen(int task) const { return chosen_[at(task)]; }
  void choose(int task, int choice);
  /// The task as it asks in this queue.
  const interpreter::TaskSpec& spec_in(int task, int queue) const;
  /// The task whose members this one and others share, -1: it is alone.
  int group_of(int task) const { return group_[at(task)]; }
  bool group_is_over(int group) const;
  /// The tasks of a group.
  const std::vector<int>& group(int group) const { return groups_.at(group); }
  Journal& choices() { return choices_; }
  /// What the task holds of robots and crews by this choice; -1: by none.
  std::vector<Share> shares_of(int task, const interpreter::TaskSpec& choice) const;
  /// The hours in which all works that the task holds.
  const schedule::WorkCalendar& calendar(int task) const {
    return allocator->calendar(queue_of(task));
  }
  const std::vector<int>& held_by(int task) const { return allocator->resources(queue_of(task)); }
  /// What the task needs of a robot or crew when it needs it.
  Share share_of(int task, int resource) const;
  site::RobotView& view(int robot) { return views_[at(robot)]; }
  const interpreter::Program& program_of(int robot);

  void reject(int task, std::string reason, std::vector<int> involved = {});
  void made_progress();
  /// The task waits for others from now on.
  void begins_to_wait(int task) { new_waits.push_back(task); }
  /// Those who wait for this go on.
  void announce(const SiteEvent& event);
  /// The task came further: who evaded it may try again.
  void came_further(ActiveTask& task);

  trace::TraceWriter* trace_of(int task) { return trace.of(task, spec(task)); }
  /// The task stood still from `since` until now.
  void pause(int task, const char* why, const std::string& whom, Ticks since);
  /// The task waited on its way for a shift, from `since` until now; `lift`: for the one into which
  /// its lift fits. It had to be there `first_gain` sooner to go on sooner.
  void end_shift_wait(ActiveTask& task, Ticks since, Ticks first_gain,
                      const LiftNote* lift = nullptr);
  /// From then on, to a moment, all that the task has is off, for it is out of the shift of some,
  /// but for the time in which it works.
  void note_off(ActiveTask& task, Ticks from, Ticks to, Ticks works = 0) const;
  /// A part of the task is over that went by the hours of all that it holds.
  void end_part(ActiveTask& task) const;
  /// One that went by the hours of this queue; `whole`: a lift.
  void end_part(ActiveTask& task, int queue, bool whole) const;
  /// Of the task until now, without what it waited for shifts.
  Ticks working_time(const ActiveTask& task) const;

  /// Who may move a robot out of the way: who has it, else the tasks that will have it some day.
  WaitTarget move_of(int robot, WaitTarget::Kind kind, int number) const;
  /// By robot: whether nobody has it, it carries nothing, and works.
  std::vector<bool> idle_robots() const;
  /// For what others hold, or is kept for others, of what a task by pools may have.
  void add_choices(WaitSet& waits, int task) const;
  /// For a robot or crew that others hold or that is kept for others; `choice` that needs it.
  void add_resource(WaitSet& waits, int task, const Share& share, int choice = -1) const;
  /// Whether an idle robot may still be asked to its park position; the tasks of a robot that are
  /// not over: what the run knows, given by it.
  std::function<bool(int robot)> may_park_some_day;
  std::function<bool(int task)> is_over;
  std::function<bool(int task)> has_begun;
  MotionObserver on_motion;  ///< may be empty
  bool traces_graphs = false;

  /// Why the component cannot be taken.
  std::string gone(int component) const;
  /// The tasks, done or under way, that move or remove the component.
  std::vector<int> users_of(int component) const;
  /// The tasks under way whose machines or components the task met.
  std::vector<int> in_the_way_of(const ActiveTask& task) const;

 private:
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }
  Ticks prepare_queue(int task);
  Ticks time_of_part(const ActiveTask& task) const;
  void prepare_choices(int task);
  void set_groups();

  std::vector<interpreter::TaskSpec> parks_;
  std::vector<const interpreter::TaskSpec*> specs_;
  std::vector<int> queue_;
  std::vector<std::vector<int>> choice_queues_;  ///< to each task by pools and each of its choices
  std::vector<int> chosen_;
  std::vector<int> group_;
  std::map<int, std::vector<int>> groups_;
  Journal choices_;
  std::vector<std::vector<int>> tasks_of_;  ///< to each robot: its tasks of the plan
  std::deque<site::RobotView> views_;
  std::map<const interpreter::CheckedRobot*, interpreter::Program> programs_;
};

}  // namespace rubicon::taskplan
