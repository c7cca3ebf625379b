#pragma once

#include <string>
#include <vector>

namespace rubicon::verify {

/// What is wrong with ways over cells; without faults they are right.
struct WaysVerdict {
  int agents = 0;
  int makespan = 0;
  long long cost = 0;
  bool solved = false;
  std::vector<std::string> faults;  ///< the first of them
};

/// Whether a text is the result of a network of cells (what `rubicon run --format json` prints of
/// it).
bool is_grid_result(const std::string& text);

/// Walks all agents of such a result over its map, tick by tick, by nothing but its text: each
/// begins at its start, keeps to open cells beside each other, ends at its goal; no two are in one
/// cell, no two pass through each other; the sums are those of the ways. Throws UnreadableInput.
WaysVerdict check_ways(const std::string& text);

/// For people and as JSON; `name` is the file.
std::string ways_text(const WaysVerdict& verdict, const std::string& name);
std::string ways_json(const WaysVerdict& verdict);

}  // namespace rubicon::verify
