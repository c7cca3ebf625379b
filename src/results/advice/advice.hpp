#pragma once

#include <string>
#include <vector>

#include "interpreter/check/plan_model.hpp"
#include "interpreter/syntax/source.hpp"
#include "src/results/advice/changes.hpp"
#include "src/simulation/schedule/ticks.hpp"

namespace rubicon::advice {

/// So many changes are tried; each is a run of the plan.
inline constexpr std::size_t kMostTrials = 12;

/// How a task and the plan went.
struct RunSummary {
  std::string result;  ///< of the task
  std::string reason;
  schedule::Ticks end = 0;  ///< of the task, if it is done
  int done = 0;             ///< tasks
  schedule::Ticks process_time = 0;
};

/// A changed plan that was run.
struct Trial {
  std::string change;
  RunSummary run;
  std::vector<std::string> lost;  ///< tasks that are done without the change, and not with it
  bool helps = false;  ///< the task is done, or sooner and the whole no longer; nothing is lost
};

struct Advice {
  std::string task;
  std::string waits_for;  ///< a task that is not reached: the rejected one that it comes after
  int tasks = 0;
  RunSummary before;
  std::vector<Trial> trials;  ///< in the order of `changes_for`
  std::vector<LeftOut> left_out;
};

/// Tries what might help the task of the story. Runs the plan, and once more for each change. The
/// plan must be one that can be run.
Advice advise(const interpreter::PlanModel& plan, const interpreter::SourceMap& sources,
              const why::TaskStory& story);

/// Sentences, to come after those of the story.
std::string advice_text(const Advice& advice);

/// The JSON of a story with the advice in it, as `advice` (docs/commands/why.md).
std::string json_with_advice(const std::string& story_json, const Advice& advice);

}  // namespace rubicon::advice
