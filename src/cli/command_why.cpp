#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "interpreter/syntax/name_suggestion.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/fail.hpp"
#include "src/cli/load_runnable_plan.hpp"
#include "src/cli/set_option.hpp"
#include "src/cli/trace_source.hpp"
#include "src/results/advice/advice.hpp"
#include "src/results/replay/replay.hpp"
#include "src/results/why/ask_engine.hpp"
#include "src/results/why/story_reader.hpp"
#include "src/results/why/story_text.hpp"
#include "src/simulation/taskplan/run_plan.hpp"

namespace rubicon::cli {

namespace {

/// Reads a trace for the story of a task, and for where everything was. What makes no replay (a
/// trace without steps) still makes a story.
class StoryAndReplay : public trace::TraceSink {
 public:
  explicit StoryAndReplay(const std::string& task) : story_(task) { replay_.emplace(); }

  void line(std::string_view text) override {
    story_.line(text);
    if (!replay_) return;
    try {
      replay_->line(text);
    } catch (const std::invalid_argument&) {
      replay_.reset();
    }
  }
  void restart() override {
    story_.restart();
    replay_.emplace();
  }

  const why::StoryReader& reader() const { return story_; }

  why::TaskStory finish() {
    why::TaskStory story = story_.story();
    if (!replay_) return story;
    try {
      const replay::Replay replay = replay_->finish();
      why::ask_engine(replay, story);
    } catch (const std::invalid_argument& error) {
      story.no_scene = error.what();
    }
    return story;
  }

 private:
  why::StoryReader story_;
  std::optional<replay::ReplayReader> replay_;
};

}  // namespace

int run_why(const WhyOptions& options) {
  StoryAndReplay trace(options.task);
  interpreter::SourceMap sources;
  std::unique_ptr<interpreter::PlanModel> plan;  // of which changes are tried
  if (options.advise) {
    if (!trace_named(options.source).empty()) {
      return fail(
          fmt::format("--advise runs changed plans, so it goes with a plan: rubicon why PLAN {} "
                      "--advise; {} is what a run left",
                      options.task, options.source));
    }
    plan = load_runnable_plan(options.source, sources, parameter_texts(options.set));
    if (!plan) return kWrongInput;
    if (plan->short_form) return fail("--advise is for plans with tasks; this is a short plan");
    taskplan::run_plan(*plan, sources, &trace, {});
  } else if (!stream_trace(options.source, options.set, trace)) {
    return kWrongInput;
  }
  const why::StoryReader& reader = trace.reader();
  if (!reader.has_task()) {
    interpreter::NameSuggestions suggestions;
    return fail(fmt::format("there is no task '{}' in {}{}", options.task, options.source,
                            suggestions.ending(options.task, [&] { return reader.tasks(); })));
  }
  const why::TaskStory story = trace.finish();
  const bool json = options.format == "json";
  std::string text = json ? why::story_json(story) : why::story_text(story);
  if (plan) {
    const advice::Advice advice = advice::advise(*plan, sources, story);
    text = json ? advice::json_with_advice(text, advice) : text + advice::advice_text(advice);
  }
  std::fwrite(text.data(), 1, text.size(), stdout);
  return kFine;
}

}  // namespace rubicon::cli
