#include "src/results/verify/schedule/check_resources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "src/results/verify/replay/holds.hpp"

namespace rubicon::verify {

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

class ResourceCheck {
 public:
  ResourceCheck(const Trace& trace, const std::vector<TaskRun>& runs, Faults& faults)
      : trace_(trace), runs_(runs), faults_(faults) {}

  void check() {
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      for (const Hold& hold : holds_of(trace_, runs_, static_cast<int>(i))) {
        holds_[resource_name(trace_.scene, hold.resource)].push_back(hold);
      }
    }
    for (auto& [name, holds] : holds_) check(name, holds);
  }

 private:
  void check(const std::string& name, std::vector<Hold>& holds) {
    std::erase_if(holds, [](const Hold& hold) { return hold.to <= hold.from; });
    std::stable_sort(holds.begin(), holds.end(),
                     [](const Hold& a, const Hold& b) { return a.from < b.from; });
    const Hold* last = nullptr;  // of those before the one that ends last
    for (const Hold& hold : holds) {
      if (last != nullptr && last->run != hold.run && hold.from < last->to - kTimeSlack) {
        faults_.push_back(
            {FaultKind::resource, ResultFile::trace, hold.line,
             trace_.runs[at(runs_[at(hold.run)].run)], hold.from,
             fmt::format("{} is still in {}", name, trace_.runs[at(runs_[at(last->run)].run)])});
      }
      if (last == nullptr || hold.to > last->to) last = &hold;
    }
  }

  const Trace& trace_;
  const std::vector<TaskRun>& runs_;
  Faults& faults_;
  std::map<std::string, std::vector<Hold>> holds_;
};

}  // namespace

void check_resources(const Trace& trace, const std::vector<TaskRun>& runs, Faults& faults) {
  ResourceCheck(trace, runs, faults).check();
}

}  // namespace rubicon::verify
