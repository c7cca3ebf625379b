#include "src/why/wait_chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

namespace rubicon::why {

namespace {

/// Times of a trace are whole nanoseconds: sums of two differ by less than this (s).
constexpr double kSameTime = 1e-6;

/// What let a task begin.
struct Cause {
  double time = 0;  ///< the moment it let go
  std::string task;
  std::string text;
};

std::string link_text(const LinkText& link) {
  std::string text = link.type;
  if (link.lag != 0)
    text += fmt::format(" {} {:g} s", link.lag > 0 ? "+" : "-", std::abs(link.lag));
  return text;
}

/// The link of the task that let go last; those to its finish count from where they move the start.
std::optional<Cause> link_cause(const TaskPlan& plan, const TaskRun& run,
                                const std::map<std::string, TaskRun>& runs) {
  std::optional<Cause> last;
  for (const LinkText& link : plan.after) {
    const auto before = runs.find(link.task);
    if (before == runs.end() || before->second.result != "done") continue;
    const double event = link.type[0] == 'S' ? before->second.start : before->second.end;
    const bool to_finish = link.type[1] == 'F';
    const double time = event + link.lag - (to_finish ? run.end - run.start : 0);
    if (time > run.start + kSameTime || (last && time <= last->time)) continue;
    last = Cause{time, link.task,
                 fmt::format("{} {} ({})", to_finish ? "so that it finishes after" : "after",
                             link.task, link_text(link))};
  }
  return last;
}

/// Who had something last that the task holds, and gave it back before the task began.
std::optional<Cause> holder_cause(const TaskPlan& plan, const TaskRun& run,
                                  const std::map<std::string, TaskPlan>& plans,
                                  const std::map<std::string, TaskRun>& runs) {
  std::optional<Cause> last;
  for (const auto& [name, other] : runs) {
    if (name == plan.name || other.result != "done" || other.end > run.start + kSameTime ||
        (last && other.end <= last->time)) {
      continue;
    }
    const auto its_plan = plans.find(name);
    if (its_plan == plans.end() || (other.start == other.end && other.end == run.start)) continue;
    for (const std::string& resource : plan.holds) {
      const auto& holds = its_plan->second.holds;
      if (std::find(holds.begin(), holds.end(), resource) == holds.end()) continue;
      last = Cause{other.end, name, fmt::format("when {} was free, which {} had", resource, name)};
      break;
    }
  }
  return last;
}

}  // namespace

std::vector<WaitStep> wait_chain(const std::string& task,
                                 const std::map<std::string, TaskPlan>& plans,
                                 const std::map<std::string, TaskRun>& runs) {
  std::vector<WaitStep> chain;
  std::set<std::string> seen;
  std::string name = task;
  while (seen.insert(name).second) {
    const auto plan = plans.find(name);
    const auto run = runs.find(name);
    if (plan == plans.end() || run == runs.end()) break;
    const auto link = link_cause(plan->second, run->second, runs);
    const auto holder = holder_cause(plan->second, run->second, plans, runs);
    Cause cause{0, "", "with the plan"};
    if (link && link->time > cause.time - kSameTime) cause = *link;
    if (holder && holder->time > cause.time) cause = *holder;
    WaitStep step{name, run->second.start, fmt::format("{} began {}", name, cause.text)};
    if (run->second.start > cause.time + kSameTime) {
      step.text += fmt::format(", {:g} s later: the next shift, or its zone was not free",
                               run->second.start - cause.time);
    }
    chain.push_back(std::move(step));
    if (cause.task.empty()) break;
    name = cause.task;
  }
  std::reverse(chain.begin(), chain.end());
  return chain;
}

}  // namespace rubicon::why
