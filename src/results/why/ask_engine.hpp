#pragma once

#include "src/results/replay/replay.hpp"
#include "src/results/why/task_story.hpp"

namespace rubicon::why {

/// Asks the collision engine once more what a trace only names: of refused steps where, how deep
/// and from when on they are blocked, who put the obstacle there, what else is on the way to the
/// goal; of a task that was done how near it came to what it did not touch. An answer stands in the
/// story only if the engine blocks the step by the recorded pair. Of a replay that makes no scene
/// the story says why.
void ask_engine(const replay::Replay& replay, TaskStory& story);

}  // namespace rubicon::why
