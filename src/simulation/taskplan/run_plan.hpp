#pragma once

#include <functional>
#include <string>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/machine/machine.hpp"
#include "interpreter/syntax/source.hpp"
#include "src/simulation/site/make_site.hpp"
#include "src/simulation/taskplan/schedule.hpp"
#include "src/simulation/trace/trace_sink.hpp"

namespace rubicon::taskplan {

/// Looks at a motion that is about to begin, and at the site as it stands then.
using MotionObserver = std::function<void(
    const std::string& task, MotionPurpose purpose, const interpreter::Program& program,
    const interpreter::MotionTask& motion, const interpreter::World& world)>;

struct RunOptions {
  trace::TraceDetail detail = trace::TraceDetail::steps;
  /// Guides put into the trace what they searched through, too.
  bool traces_graphs = false;
  /// Called after every task with how many of how many are behind us.
  std::function<void(int done, int total, const TaskOutcome& last)> on_task;
  /// Called before a motion of a task begins; a plan that is begun again calls it again.
  MotionObserver on_motion;
  /// Of the same plan, with whatever durations; null: it is made for this run.
  const site::PreparedSite* prepared = nullptr;
  /// Of this run, without a trace: its header tells of the plan. Null: all is as the plan has it.
  const interpreter::Draws* draws = nullptr;
};

/// Simulates a plan from its beginning (docs/simulation.md) and writes the trace to `sink` unless
/// it is null. A rejected task is undone and what depends on it is not reached; the rest goes on.
/// The plan must have passed `preflight_errors` without an error. Throws std::invalid_argument for
/// shapes without extent.
Schedule run_plan(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
                  trace::TraceSink* sink, const RunOptions& options = {});

}  // namespace rubicon::taskplan
