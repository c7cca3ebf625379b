#include "src/results/why/wait_chain.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace rubicon::why {

namespace {

/// The last run of a task that began by then, else its first: one that is waited for with a lead
/// may begin later. Null: there is none.
const TaskRun* last_run(const std::string& task, const RunsByTask& runs, double by) {
  const auto found = runs.find(task);
  if (found == runs.end()) return nullptr;
  const TaskRun* last = nullptr;
  for (const TaskRun& run : found->second) {
    if (last == nullptr || run.start <= by) last = &run;
  }
  return last;
}

}  // namespace

std::vector<WaitStep> wait_chain(const std::string& task, const RunsByTask& runs) {
  std::vector<WaitStep> chain;
  std::set<const TaskRun*> seen;
  std::string name = task;
  double by = std::numeric_limits<double>::infinity();
  while (true) {
    const TaskRun* const run = last_run(name, runs, by);
    if (run == nullptr || run->because.empty() || !seen.insert(run).second) break;
    chain.push_back({name, run->start, run->because});
    if (run->after.empty()) break;
    name = run->after;
    by = run->start;
  }
  std::reverse(chain.begin(), chain.end());
  return chain;
}

}  // namespace rubicon::why
