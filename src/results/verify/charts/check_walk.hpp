#pragma once

#include <string>
#include <vector>

namespace rubicon::verify {

/// What is wrong with the walks of robots that explored a network; without faults they are right.
struct WalkVerdict {
  int robots = 0;
  long long steps = 0;
  std::vector<std::string> faults;  ///< the first of them
};

/// Whether a text is the result of a network that was explored (what `rubicon run --format json`
/// prints of it).
bool is_walk_result(const std::string& text);

/// Judges such a result by nothing but its text: each walk is one, ends where it began, goes along
/// all ways that can be reached (by a search of its own), by Tarry once in each direction, by
/// Fraenkel at most twice; times and sums. Throws UnreadableInput.
WalkVerdict check_walk(const std::string& text);

/// For people and as JSON; `name` is the file.
std::string walk_verdict_text(const WalkVerdict& verdict, const std::string& name);
std::string walk_verdict_json(const WalkVerdict& verdict);

}  // namespace rubicon::verify
