#pragma once

#include <string>
#include <vector>

namespace rubicon::verify {

/// What is wrong with jobs on cells; without faults they are right.
struct JobsVerdict {
  int agents = 0;
  int jobs = 0;
  int delivered = 0;
  int ticks = 0;
  int late_moves = 0;
  bool done = false;
  std::vector<std::string> faults;  ///< the first of them
};

/// Whether a text is the result of jobs on a network of cells.
bool is_jobs_result(const std::string& text);

/// Walks all agents of such a result over its map, tick by tick, by nothing but its text: they keep
/// to open cells beside each other, no two are in one cell, no two pass through each other, who is
/// late stands as long as it is said. Each job is taken when it has arrived, in its turn, by the
/// agent without a job that has the fewest steps to it; it is picked up and delivered where and
/// when its agent is there. The sums are those of the ways. Throws UnreadableInput.
JobsVerdict check_jobs(const std::string& text);

/// For people and as JSON; `name` is the file.
std::string jobs_verdict_text(const JobsVerdict& verdict, const std::string& name);
std::string jobs_verdict_json(const JobsVerdict& verdict);

}  // namespace rubicon::verify
