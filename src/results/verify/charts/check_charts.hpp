#pragma once

#include <string>
#include <vector>

namespace rubicon::verify {

/// What is wrong with charts; without faults they are right.
struct ChartsVerdict {
  int robots = 0;
  int plans = 0;           ///< the first, and one for each report
  long long arrivals = 0;  ///< in all charts
  bool settled = true;
  std::vector<std::string> faults;  ///< the first of them
};

/// Whether a text is the result of a network with policy charts (what `rubicon run --format json`
/// prints of it).
bool is_charts_result(const std::string& text);

/// Judges such a result by nothing but its text: travel times from lengths and speeds, ways by a
/// search of its own (Bellman-Ford from the goals), that each chart begins where the one before has
/// the robot at that moment, that nobody enters a closed lane, that no two arrive at a node within
/// the tolerance and none meets one head-on, that who yields has the lower right of way, and the
/// sums. Throws UnreadableInput.
ChartsVerdict check_charts(const std::string& text);

/// For people and as JSON; `name` is the file.
std::string charts_verdict_text(const ChartsVerdict& verdict, const std::string& name);
std::string charts_verdict_json(const ChartsVerdict& verdict);

}  // namespace rubicon::verify
