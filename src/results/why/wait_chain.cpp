#include "src/results/why/wait_chain.hpp"

#include <algorithm>
#include <set>

namespace rubicon::why {

std::vector<WaitStep> wait_chain(const std::string& task,
                                 const std::map<std::string, TaskRun>& runs) {
  std::vector<WaitStep> chain;
  std::set<std::string> seen;
  std::string name = task;
  while (seen.insert(name).second) {
    const auto run = runs.find(name);
    if (run == runs.end() || run->second.because.empty()) break;
    chain.push_back({name, run->second.start, run->second.because});
    if (run->second.after.empty()) break;
    name = run->second.after;
  }
  std::reverse(chain.begin(), chain.end());
  return chain;
}

}  // namespace rubicon::why
