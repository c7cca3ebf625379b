#include "src/simulation/taskplan/short_run.hpp"

#include <optional>
#include <utility>

#include "interpreter/machine/machine.hpp"
#include "src/simulation/site/make_site.hpp"
#include "src/simulation/site/robot_view.hpp"
#include "src/simulation/taskplan/hit_recorder.hpp"
#include "src/simulation/taskplan/motion_task.hpp"
#include "src/simulation/taskplan/reason.hpp"
#include "src/simulation/taskplan/simulation.hpp"
#include "src/simulation/trace/trace_writer.hpp"

namespace rubicon::taskplan {

Schedule run_short(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
                   trace::TraceSink* sink, const RunOptions& options) {
  std::optional<trace::TraceWriter> trace;
  if (sink) {
    trace.emplace(*sink, plan, sources, options.detail);
    trace->header();
    trace->set_task(plan.name, 0);
    trace->task_start(0);
  }
  site::SiteWorld site =
      options.prepared ? site::make_site(plan, *options.prepared) : site::make_site(plan);
  site::RobotView view(site, 0);
  HitRecorder hits(trace ? &*trace : nullptr);
  const interpreter::Program program = interpreter::compile(plan.robots[0].robot);
  interpreter::MotionTask motion;
  motion.goals = plan.via;
  motion.goals.push_back(*plan.goal);
  motion.situations = plan.situations;
  motion.guides = plan.guides;
  for (guides::GuideSpec& guide : motion.guides) guide.tells_tree = options.traces_graphs;
  motion.within = plan.within;
  motion.clauses = plan.clauses;
  site.let_enter(0, plan.clauses.entered);
  motion.budget = plan.budget;
  motion.q = site.configuration(0);
  motion.mounting = site.robot(0).mounting;
  if (options.on_motion) options.on_motion(plan.name, MotionPurpose::go, program, motion, view);
  interpreter::Machine machine(program, std::move(motion));
  const auto advance_to = [&](Ticks time) {
    site.set_time(time);
    for (const site::MovingEvent& event : site.look_at_movings()) {
      if (!trace) continue;
      trace->moving(site.moving(event.moving).name(),
                    event.stop ? std::string_view(event.stop->by) : std::string_view(), event.delay,
                    event.time);
    }
  };
  advance_to(0);
  do {
    while (site.next_moving_look() < machine.time()) advance_to(site.next_moving_look());
    advance_to(machine.time());
  } while (machine.advance(view, &hits));
  const interpreter::MotionEnd& end = machine.end();

  TaskOutcome outcome;
  outcome.task = plan.name;
  outcome.robot = plan.robots[0].name;
  outcome.duration = outcome.motion_time = end.time;
  outcome.thinking = machine.thinking();
  outcome.tried = end.tries;
  outcome.accepted = end.accepted;
  if (!end.reached) {
    const bool ended = end.status == interpreter::MotionStatus::done;
    outcome.result = ended ? TaskResult::ended_short : TaskResult::rejected;
    outcome.reason = reason_of(end, hits.last(), sources);
  }
  for (const interpreter::MissedWayPoint& each : end.missed) {
    outcome.missed.push_back(missed_text(each.k, each.off));
  }
  outcome.motions = 1;
  if (trace) {
    trace->motion_end(end);
    trace->task_end(end.time, name_of(outcome.result), outcome.reason);
  }
  Schedule schedule;
  schedule.process_time = end.time;
  schedule.feasible = outcome.result == TaskResult::done;
  schedule.tasks.push_back(std::move(outcome));
  schedule.timetables = timetables_of(site, end.time);
  return schedule;
}

}  // namespace rubicon::taskplan
