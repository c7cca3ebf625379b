#include "src/taskplan/task_runner.hpp"

#include <fmt/format.h>

#include <utility>

#include "interpreter/machine.hpp"
#include "src/site/load_chart.hpp"
#include "src/site/robot_view.hpp"
#include "src/taskplan/goal_holds.hpp"
#include "src/taskplan/reason.hpp"

namespace rubicon::taskplan {

namespace {

/// Of `within` only the angles: a grip is taken where it is, at whatever angle the task allows.
interpreter::Within angles_of(const interpreter::Within& within, const robot::RobotModel& model) {
  interpreter::Within angles;
  for (const auto& value : within.values) {
    if (model.parameters[static_cast<std::size_t>(value.first)].rotation) {
      angles.values.push_back(value);
    }
  }
  return angles;
}

/// What a task may change, as it was before.
class StateBefore {
 public:
  StateBefore(const site::SiteWorld& site, const interpreter::TaskSpec& task) {
    if (task.robot >= 0) machine_ = site.machine_state(task.robot);
    if (task.move) remember(site, *task.move);
    for (const int component : task.remove) remember(site, component);
  }

  void restore(site::SiteWorld& site, const interpreter::TaskSpec& task) const {
    if (machine_) site.set_machine_state(task.robot, *machine_);
    for (const auto& [component, state] : components_) site.set_component_state(component, state);
  }

 private:
  void remember(const site::SiteWorld& site, int component) {
    components_.emplace_back(component, site.component_state(component));
  }

  std::optional<site::MachineState> machine_;
  std::vector<std::pair<int, site::ComponentState>> components_;
};

}  // namespace

TaskRunner::TaskRunner(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
                       site::SiteWorld& site, trace::TraceWriter* trace)
    : plan_(plan), sources_(sources), site_(site), trace_(trace), hits_(trace) {}

TaskOutcome TaskRunner::run(const interpreter::TaskSpec& task, Ticks start) {
  Run run;
  run.task = &task;
  run.clock = start;
  run.outcome.task = task.name;
  if (task.robot >= 0) run.outcome.robot = robot_spec(task.robot).name;
  run.outcome.crews = crew_names(plan_, task);
  run.outcome.start = start;
  if (trace_) {
    trace_->set_task(task.name, task.robot);
    trace_->task_start(start);
  }
  const StateBefore before(site_, task);
  if (task.move) move_component(run);
  if (task.go && !run.rejected()) go(run);
  if (!run.rejected()) {
    for (const interpreter::WorkSpec& extra : task.takes) work(run, extra);
    remove_components(run);
  }
  if (run.rejected()) {
    before.restore(site_, task);
    // With several machines the others went on meanwhile; with one, the attempt is undone whole.
    if (plan_.robots.size() <= 1) {
      run.clock = start;
      run.outcome.motion_time = 0;
      run.outcome.work_time = 0;
    }
  }
  run.outcome.duration = run.clock - start;
  if (trace_) trace_->task_end(run.clock, name_of(run.outcome.result), run.outcome.reason);
  return std::move(run.outcome);
}

TaskOutcome TaskRunner::run_short(Ticks start) {
  Run run;
  run.clock = start;
  run.outcome.task = plan_.name;
  run.outcome.robot = robot_spec(0).name;
  run.outcome.start = start;
  if (trace_) {
    trace_->set_task(plan_.name, 0);
    trace_->task_start(start);
  }
  interpreter::MotionTask motion;
  motion.goals = plan_.via;
  motion.goals.push_back(*plan_.goal);
  motion.situations = plan_.situations;
  motion.within = plan_.within;
  motion.budget = plan_.budget;
  run_machine(run, 0, std::move(motion), MotionPurpose::go);
  const interpreter::MotionEnd& end = run.outcome.motions.back().end;
  if (!end.reached) run.outcome.reason = reason_of(end, hits_.last(), sources_);
  if (end.status != interpreter::MotionStatus::done) run.outcome.result = TaskResult::rejected;
  run.outcome.duration = run.clock - start;
  if (trace_) trace_->task_end(run.clock, name_of(run.outcome.result), run.outcome.reason);
  return std::move(run.outcome);
}

void TaskRunner::move_component(Run& run) {
  const interpreter::TaskSpec& task = *run.task;
  const int component = *task.move;
  if (!site_.stands(component)) {
    reject(run, fmt::format("{} is not on the site any more", site_.component_name(component)));
    return;
  }
  if (!grip_component(run)) return;

  // The load hangs as it was taken: where the tool must go follows from that, by the fixed grip.
  const math::Pose X_TO = site_.load(task.robot)->X_TO;
  interpreter::GoalSpec goal;
  goal.X_WG = task.X_WO_goal * X_TO.inverse(Eigen::Isometry);
  goal.span = task.move_span;
  if (!motion(run, MotionPurpose::carry, goal)) return;
  work(run, task.adjust);
  if (!motion(run, MotionPurpose::place, goal)) return;
  work(run, task.release);
  site_.detach(task.robot);
  if (trace_) {
    trace_->detach(site_.component_name(component), site_.X_WO(component), run.clock);
  }
}

bool TaskRunner::grip_component(Run& run) {
  const interpreter::TaskSpec& task = *run.task;
  const int component = *task.move;
  const math::Pose& X_OG = plan_.components[static_cast<std::size_t>(component)].X_OG;
  interpreter::GoalSpec grip;
  grip.X_WG = site_.X_WO(component) * X_OG;
  grip.span = task.move_span;
  if (!motion(run, MotionPurpose::grip, grip)) return false;
  if (!may_lift(run)) return false;
  work(run, task.hook);
  site_.attach(task.robot, component);
  if (trace_) {
    trace_->attach(site_.component_name(component), site_.load(task.robot)->X_TO, run.clock);
  }
  return true;
}

bool TaskRunner::may_lift(Run& run) {
  const interpreter::TaskSpec& task = *run.task;
  const interpreter::RobotSpec& spec = robot_spec(task.robot);
  const double mass = plan_.components[static_cast<std::size_t>(*task.move)].mass;
  const double radius = site::chart_radius(spec.X_WM, site_.tool_pose(task.robot).translation());
  const double allowed = site::capacity_at(spec.robot->model.capacity, radius);
  if (mass <= allowed) return true;
  reject(run,
         fmt::format("too heavy: {} has {:g} kg, the load chart of {} allows {:g} kg at {:g} m",
                     site_.component_name(*task.move), mass, spec.name, allowed, radius));
  return false;
}

void TaskRunner::go(Run& run) { motion(run, MotionPurpose::go, *run.task->go); }

void TaskRunner::remove_components(Run& run) {
  for (const int component : run.task->remove) {
    if (!site_.stands(component)) {
      reject(run, fmt::format("{} is not on the site any more", site_.component_name(component)));
      return;
    }
    site_.remove(component);
  }
}

void TaskRunner::work(Run& run, const std::optional<interpreter::WorkSpec>& spec) {
  if (!spec) return;
  const Ticks duration = interpreter::ticks_from_seconds(spec->duration);
  run.clock += duration;
  run.outcome.work_time += duration;
}

bool TaskRunner::motion(Run& run, MotionPurpose purpose, const interpreter::GoalSpec& goal) {
  const interpreter::TaskSpec& task = *run.task;
  const interpreter::RobotSpec& spec = robot_spec(task.robot);
  interpreter::MotionTask motion;
  if (purpose == MotionPurpose::carry || purpose == MotionPurpose::go) motion.goals = task.via;
  motion.goals.push_back(goal);
  motion.situations = plan_.situations;
  if (purpose != MotionPurpose::grip) {
    motion.situations.insert(motion.situations.end(), task.situations.begin(),
                             task.situations.end());
  }
  if (purpose == MotionPurpose::place) motion.situations.emplace_back("place");
  motion.within =
      purpose == MotionPurpose::grip ? angles_of(task.within, spec.robot->model) : task.within;
  motion.budget = task.budget.value_or(plan_.budget);

  const std::vector<double>& q = site_.configuration(task.robot);
  const robot::Mounting& mounting = site_.robot(task.robot).mounting;
  if (motion.goals.size() == 1 && goal_holds(spec.robot->model, mounting, q, goal, motion.within)) {
    MotionOutcome held;
    held.purpose = purpose;
    held.start = run.clock;
    held.end.reached = true;
    held.end.q = q;
    held.end.time = run.clock;
    add_motion(run, std::move(held));
    return true;
  }
  run_machine(run, task.robot, std::move(motion), purpose);
  const MotionOutcome& made = run.outcome.motions.back();
  const bool enough = made.end.reached || (purpose == MotionPurpose::carry &&
                                           made.end.status == interpreter::MotionStatus::done);
  if (enough) return true;
  const std::string component = task.move ? site_.component_name(*task.move) : std::string();
  reject(run, task_reason(made, hits_.last(), component, sources_));
  return false;
}

void TaskRunner::run_machine(Run& run, int robot, interpreter::MotionTask motion,
                             MotionPurpose purpose) {
  site_.set_time(run.clock);
  site::RobotView view(site_, robot);
  motion.first_n = run.outcome.tried + 1;
  motion.start = run.clock;
  motion.q = site_.configuration(robot);
  motion.mounting = site_.robot(robot).mounting;
  MotionOutcome outcome;
  outcome.purpose = purpose;
  outcome.start = run.clock;
  // What stopped the carrying motion still keeps the placing one from its goal.
  if (purpose != MotionPurpose::place) hits_.forget();
  interpreter::Machine machine(program_of(robot), std::move(motion));
  while (machine.advance(view, &hits_)) {
  }
  outcome.end = machine.end();
  add_motion(run, std::move(outcome));
}

void TaskRunner::add_motion(Run& run, MotionOutcome motion) {
  run.outcome.tried += motion.end.tries;
  run.outcome.accepted += motion.end.accepted;
  run.outcome.motion_time += motion.end.time - run.clock;
  run.clock = motion.end.time;
  if (trace_) trace_->motion_end(motion.end);
  run.outcome.motions.push_back(std::move(motion));
}

void TaskRunner::reject(Run& run, std::string reason) {
  run.outcome.result = TaskResult::rejected;
  run.outcome.reason = std::move(reason);
}

const interpreter::Program& TaskRunner::program_of(int robot) {
  const auto& checked = robot_spec(robot).robot;
  const auto found = programs_.find(checked.get());
  if (found != programs_.end()) return found->second;
  return programs_.emplace(checked.get(), interpreter::compile(checked)).first->second;
}

}  // namespace rubicon::taskplan
