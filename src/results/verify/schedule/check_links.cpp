#include "src/results/verify/schedule/check_links.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "src/motion/math/index.hpp"

namespace rubicon::verify {

namespace {

using math::at;

const char* name_of(LinkType type) {
  switch (type) {
    case LinkType::FS:
      return "FS";
    case LinkType::SS:
      return "SS";
    case LinkType::FF:
      return "FF";
    case LinkType::SF:
      return "SF";
  }
  return "";
}

class LinkCheck {
 public:
  LinkCheck(const Trace& trace, const std::vector<TaskRun>& runs, Faults& faults)
      : trace_(trace), runs_(runs), faults_(faults), run_of_(trace.scene.tasks.size(), nullptr) {
    for (const TaskRun& run : runs) {
      if (run.task >= 0) run_of_[at(run.task)] = &run;
    }
  }

  void check() {
    for (const TaskRun& run : runs_) {
      if (run.task < 0) continue;
      const std::vector<SceneLink>& links = trace_.scene.tasks[at(run.task)].after;
      if (run.happened) {
        const Ticks date = trace_.scene.tasks[at(run.task)].not_before;
        if (run.start < date - kTimeSlack) {
          fault(run, TaskEnd::start,
                fmt::format("it starts {:g} s before its not_before",
                            static_cast<double>(date - run.start) / static_cast<double>(kSecond)));
        }
        for (const SceneLink& link : links) check(run, link);
      } else if (run.ended && run.result == TaskResult::not_reached) {
        const bool stopped = std::any_of(links.begin(), links.end(), [&](const SceneLink& link) {
          return !happened(link.task);
        });
        if (!stopped) fault(run, TaskEnd::finish, "it was not reached and all it follows is done");
      }
    }
  }

 private:
  enum class TaskEnd { start, finish };

  bool happened(int task) const { return run_of_[at(task)] && run_of_[at(task)]->happened; }

  void fault(const TaskRun& run, TaskEnd end, std::string text) {
    const bool finish = end == TaskEnd::finish;
    faults_.push_back({FaultKind::link, ResultFile::trace, finish ? run.end_line : run.start_line,
                       trace_.runs[at(run.run)], finish ? run.end : run.start, std::move(text)});
  }

  void check(const TaskRun& run, const SceneLink& link) {
    const std::string& name = trace_.scene.tasks[at(link.task)].name;
    const bool finish = link.type == LinkType::FF || link.type == LinkType::SF;
    const TaskEnd end = finish ? TaskEnd::finish : TaskEnd::start;
    if (!happened(link.task)) {
      // A task that was only held to its finish goes on without the one that is not done.
      if (!finish) fault(run, end, fmt::format("it was done without {}", name));
      return;
    }
    const TaskRun& before = *run_of_[at(link.task)];
    const bool from_start = link.type == LinkType::SS || link.type == LinkType::SF;
    const Ticks earliest = (from_start ? before.start : before.end) + link.lag;
    const Ticks moment = finish ? run.end : run.start;
    if (moment >= earliest - kTimeSlack) return;
    fault(run, end,
          fmt::format("it {} {:g} s too early after {} ({})", finish ? "ends" : "starts",
                      static_cast<double>(earliest - moment) / static_cast<double>(kSecond), name,
                      name_of(link.type)));
  }

  const Trace& trace_;
  const std::vector<TaskRun>& runs_;
  Faults& faults_;
  std::vector<const TaskRun*> run_of_;  ///< by task; null: not in the trace
};

}  // namespace

void check_links(const Trace& trace, const std::vector<TaskRun>& runs, Faults& faults) {
  LinkCheck(trace, runs, faults).check();
}

}  // namespace rubicon::verify
