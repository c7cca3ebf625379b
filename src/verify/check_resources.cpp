#include "src/verify/check_resources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace rubicon::verify {

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// A robot or crew is taken by a task.
struct Hold {
  Ticks from = 0;
  Ticks to = 0;
  int run = -1;
  int line = 0;
};

class ResourceCheck {
 public:
  ResourceCheck(const Trace& trace, const std::vector<TaskRun>& runs, Faults& faults)
      : trace_(trace), runs_(runs), faults_(faults) {}

  void check() {
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      if (runs_[i].happened) add_run(static_cast<int>(i));
    }
    for (auto& [name, holds] : holds_) check(name, holds);
  }

 private:
  void add_run(int index) {
    const TaskRun& run = runs_[at(index)];
    const Hold whole{run.start, run.end, index, run.start_line};
    std::set<int> crews;
    if (run.robot >= 0) holds_[trace_.scene.robots[at(run.robot)].name].push_back(whole);
    if (run.task >= 0) {
      const SceneTask& task = trace_.scene.tasks[at(run.task)];
      crews.insert(task.crews.begin(), task.crews.end());
      for (const SceneWork& work : task.takes) {
        if (run.robot < 0 && work.crew >= 0) crews.insert(work.crew);
      }
    }
    for (const int crew : crews) holds_[trace_.scene.crews[at(crew)].name].push_back(whole);
    for (const int i : run.records) {
      const Record& record = trace_.records[at(i)];
      const auto* work = std::get_if<Work>(&record.what);
      if (work == nullptr || work->crew < 0 || crews.contains(work->crew)) continue;
      holds_[trace_.scene.crews[at(work->crew)].name].push_back(
          {work->from, record.time, index, record.line});
    }
  }

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
