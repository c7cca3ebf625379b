#pragma once

#include <string>

#include "src/results/why/task_story.hpp"

namespace rubicon::why {

/// The story in plain sentences.
std::string story_text(const TaskStory& story);

/// The story as JSON (docs/commands/why.md); times in seconds.
std::string story_json(const TaskStory& story);

}  // namespace rubicon::why
