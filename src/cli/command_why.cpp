#include <fmt/format.h>

#include <cstdio>
#include <string>

#include "interpreter/syntax/name_suggestion.hpp"
#include "src/cli/commands.hpp"
#include "src/cli/trace_source.hpp"
#include "src/results/why/story_reader.hpp"
#include "src/results/why/story_text.hpp"

namespace rubicon::cli {

namespace {

int fail(const std::string& message) {
  fmt::print(stderr, "rubicon: error: {}\n", message);
  return kWrongInput;
}

}  // namespace

int run_why(const WhyOptions& options) {
  why::StoryReader reader(options.task);
  if (!tell(options.source, reader)) return kWrongInput;
  if (!reader.has_task()) {
    interpreter::NameSuggestions suggestions;
    return fail(fmt::format("there is no task '{}' in {}{}", options.task, options.source,
                            suggestions.ending(options.task, [&] { return reader.tasks(); })));
  }
  const why::TaskStory story = reader.story();
  const std::string text =
      options.format == "json" ? why::story_json(story) : why::story_text(story);
  std::fwrite(text.data(), 1, text.size(), stdout);
  return kFine;
}

}  // namespace rubicon::cli
