#include <fmt/format.h>

#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>

#include "interpreter/syntax/name_suggestion.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/trace_source.hpp"
#include "src/results/replay/replay.hpp"
#include "src/results/why/ask_engine.hpp"
#include "src/results/why/story_reader.hpp"
#include "src/results/why/story_text.hpp"

namespace rubicon::cli {

namespace {

int fail(const std::string& message) {
  fmt::print(stderr, "rubicon: error: {}\n", message);
  return kWrongInput;
}

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
  if (!stream_trace(options.source, options.set, trace)) return kWrongInput;
  const why::StoryReader& reader = trace.reader();
  if (!reader.has_task()) {
    interpreter::NameSuggestions suggestions;
    return fail(fmt::format("there is no task '{}' in {}{}", options.task, options.source,
                            suggestions.ending(options.task, [&] { return reader.tasks(); })));
  }
  const why::TaskStory story = trace.finish();
  const std::string text =
      options.format == "json" ? why::story_json(story) : why::story_text(story);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return kFine;
}

}  // namespace rubicon::cli
