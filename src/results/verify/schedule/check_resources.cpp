#include "src/results/verify/schedule/check_resources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "src/motion/math/index.hpp"
#include "src/results/verify/replay/holds.hpp"

namespace rubicon::verify {

namespace {

using math::at;

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
    if (holds.empty()) return;
    const int size = size_of_resource(trace_.scene, holds.front().resource);
    std::vector<const Hold*> open;  // those that have it when the next begins
    for (const Hold& hold : holds) {
      std::erase_if(open, [&](const Hold* other) {
        return other->to <= hold.from + kTimeSlack || other->run == hold.run;
      });
      int people = hold.people;
      for (const Hold* other : open) people += other->people;
      if (people > size) overdrawn(name, size, people, hold, open);
      open.push_back(&hold);
    }
  }

  void overdrawn(const std::string& name, int size, int people, const Hold& hold,
                 const std::vector<const Hold*>& open) {
    const auto task_of = [&](const Hold& each) { return trace_.runs[at(runs_[at(each.run)].run)]; };
    std::string text = fmt::format("{} is still in {}", name, task_of(*open.back()));
    if (size > 1) text += fmt::format(": {} people at once, and it has {}", people, size);
    faults_.push_back({FaultKind::resource, ResultFile::trace, hold.line, task_of(hold), hold.from,
                       std::move(text)});
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
