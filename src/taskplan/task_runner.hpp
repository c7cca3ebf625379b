#pragma once

#include <map>
#include <string>
#include <vector>

#include "interpreter/plan_model.hpp"
#include "interpreter/program.hpp"
#include "src/site/site_world.hpp"
#include "src/taskplan/hit_recorder.hpp"
#include "src/taskplan/schedule.hpp"
#include "src/trace/trace_writer.hpp"

namespace rubicon::taskplan {

/// Executes tasks of one plan on one site, one at a time, and writes what happens. The clock is the
/// caller's: each task is given its start and says how long it took.
class TaskRunner {
 public:
  /// `trace` may be null. All arguments must outlive the runner.
  TaskRunner(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
             site::SiteWorld& site, trace::TraceWriter* trace);

  /// A task of a full plan (LANGUAGE section 12). A rejected one leaves the site as it was.
  TaskOutcome run(const interpreter::TaskSpec& task, Ticks start);

  /// The one motion of a short plan. Done when its script ended, reached or short.
  TaskOutcome run_short(Ticks start);

 private:
  /// A task under way.
  struct Run {
    const interpreter::TaskSpec* task = nullptr;
    TaskOutcome outcome;
    Ticks clock = 0;
    bool rejected() const { return outcome.result == TaskResult::rejected; }
  };

  void move_component(Run& run);
  bool grip_component(Run& run);
  bool may_lift(Run& run);
  void go(Run& run);
  void remove_components(Run& run);
  void work(Run& run, const std::optional<interpreter::WorkSpec>& spec);
  /// Makes one motion; false, with the task rejected, if it did not do what the task needs.
  bool motion(Run& run, MotionPurpose purpose, const interpreter::GoalSpec& goal);
  void run_machine(Run& run, int robot, interpreter::MotionTask motion, MotionPurpose purpose);
  void add_motion(Run& run, MotionOutcome motion);
  void reject(Run& run, std::string reason);
  const interpreter::Program& program_of(int robot);
  const interpreter::RobotSpec& robot_spec(int robot) const {
    return plan_.robots[static_cast<std::size_t>(robot)];
  }

  const interpreter::PlanModel& plan_;
  const interpreter::SourceMap& sources_;
  site::SiteWorld& site_;
  trace::TraceWriter* trace_;
  HitRecorder hits_;
  std::map<const interpreter::CheckedRobot*, interpreter::Program> programs_;
};

}  // namespace rubicon::taskplan
