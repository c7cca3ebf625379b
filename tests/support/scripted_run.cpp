#include "tests/support/scripted_run.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/find_parameter.hpp"

namespace rubicon::test {

using namespace interpreter;

const char* const kGantry = R"(robot gantry {
  time_step 1;
  body trolley {
    param x step(1) range(-10, 60);
    param y step(1) range(-30, 30);
    frame trans(x, y, 0);
    shape box(-0.4, -0.4, 0, 0.4, 0.4, 1);
  }
  tool trolley;
  behaviour "s.motion";
}
)";

void EventLog::goal(int k, int n) { lines.push_back(fmt::format("goal {} of {}", k, n)); }
void EventLog::guide(const interpreter::GuidePlan& plan) {
  const guides::PlanReport& report = *plan.report;
  seeds.push_back(plan.seed);
  lines.push_back(report.found()
                      ? fmt::format("guide {}: {} waypoints", plan.name, report.way.size() - 1)
                      : fmt::format("guide {}: {}", plan.name, plan.cause));
}
void EventLog::way_point(int k, int n) { lines.push_back(fmt::format("waypoint {} of {}", k, n)); }
void EventLog::set(const std::string& variable, double value, Span) {
  lines.push_back(fmt::format("var({}) = {:g}", variable, value));
}
void EventLog::enter(LoopKind kind, Span) { lines.push_back(fmt::format("{} {{", name_of(kind))); }
void EventLog::exit(LoopKind kind, Span, bool reached, int successes) {
  lines.push_back(
      fmt::format("}} {} {} {}", name_of(kind), reached ? "reached" : "exhausted", successes));
}
void EventLog::which(const std::string& label, Span) { lines.push_back("which " + label); }
void EventLog::attempt(const Attempt& attempt) {
  std::string q;
  for (const double value : attempt.q) q += fmt::format(" {:g}", value);
  lines.push_back(fmt::format("{} {} {}{}{}", attempt.n, attempt.accepted ? "+" : "-",
                              attempt.command, q,
                              attempt.accepted ? "" : " " + reason_text(attempt)));
}
void EventLog::wait(int n, Ticks time, Span) {
  lines.push_back(fmt::format("{} + wait t {:g}", n, seconds_from_ticks(time)));
}
void EventLog::stop(Ticks time) {
  lines.push_back(fmt::format("stop t {:g}", seconds_from_ticks(time)));
}

Scenario set_up(const std::string& robot_text, const std::string& script) {
  MemoryFiles files({{"r.robot", robot_text}, {"s.motion", script}});
  SourceMap sources;
  Diagnostics diagnostics;
  Scenario setup;
  setup.robot = load_robot("r.robot", sources, files, nullptr, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.sorted()) {
    if (diagnostic.severity != Severity::error) continue;
    const Position position = sources.position(diagnostic.span);
    ADD_FAILURE() << position.line << ":" << position.column << ": " << diagnostic.message;
  }
  if (!setup.robot || !setup.robot->usable)
    throw std::runtime_error("the robot of this test is wrong");
  setup.program = std::make_unique<Program>(compile(setup.robot));
  return setup;
}

MotionTask Scenario::task(const std::vector<std::pair<std::string, double>>& start,
                          const std::vector<std::pair<std::string, double>>& goal) const {
  MotionTask task;
  task.q = robot->model.start_values();
  for (const auto& [name, value] : start) {
    task.q.at(static_cast<std::size_t>(find_parameter(robot->model, name))) = value;
  }
  task.mounting.starts = task.q;
  robot::update_derived(robot->model, task.mounting, task.q);
  GoalSpec spec;
  for (const auto& [name, value] : goal) {
    spec.values.emplace_back(find_parameter(robot->model, name), value);
  }
  task.goals.push_back(spec);
  return task;
}

MotionEnd run(const Scenario& setup, MotionTask task, World& world, EventSink* log) {
  Machine machine(*setup.program, std::move(task));
  while (machine.advance(world, log)) {
  }
  return machine.end();
}

}  // namespace rubicon::test
