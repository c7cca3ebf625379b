#include "src/results/verify/schedule/check_accounts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/results/verify/schedule/check_costs.hpp"
#include "src/results/verify/schedule/task_clock.hpp"

namespace rubicon::verify {

namespace {

using math::at;

/// Numbers are compared to this, of their own size. Consequence: what is off by less is not seen.
constexpr double kNumberSlack = 1e-9;

bool same_number(double a, double b) {
  return std::fabs(a - b) <= kNumberSlack * std::max({1.0, std::fabs(a), std::fabs(b)});
}

class SplitCheck {
 public:
  SplitCheck(const ScheduleRow& row, ResultFile file, Faults& faults)
      : row_(row), file_(file), faults_(faults) {}

  void fault(std::string text) {
    faults_.push_back(
        {FaultKind::schedule, file_, row_.line, row_.task, row_.start, std::move(text)});
  }

  void exactly(const char* what, Ticks found, Ticks expected) {
    if (std::llabs(found - expected) <= kTimeSlack) return;
    fault(fmt::format("{} is {}, by the trace {}", what, clock_text(found), clock_text(expected)));
  }

  void at_least(const char* what, Ticks found, Ticks least) {
    if (found >= least - kTimeSlack) return;
    fault(fmt::format("{} is {}, by the trace {} or more", what, clock_text(found),
                      clock_text(least)));
  }

  /// Steps, and of the script's `wait`s those that waited for no machine: the trace does not tell
  /// which, but each is one or the other.
  void motion(Ticks found, const TaskAccount& account) {
    Ticks expected = account.steps;
    if (account.script_wait_count > 0) {
      const double one = static_cast<double>(account.script_waits) / account.script_wait_count;
      const double waits = std::round(static_cast<double>(found - expected) / std::max(one, 1.0));
      const double possible = std::clamp<double>(waits, 0, account.script_wait_count);
      expected += static_cast<Ticks>(std::llround(possible * one));
    }
    exactly("motion", found, expected);
  }

 private:
  const ScheduleRow& row_;
  const ResultFile file_;
  Faults& faults_;
};

/// What the accounts of all tasks give for one robot or crew.
struct Use {
  int tasks = 0;
  long double held = 0;  ///< of a crew by the share that a task has
  long double work = 0;
};

class UseCheck {
 public:
  UseCheck(const UseRow& row, Faults& faults) : row_(row), faults_(faults) {}

  void fault(std::string text) {
    faults_.push_back({FaultKind::schedule, ResultFile::schedule_json, row_.line, "", -1,
                       fmt::format("{}: {}", row_.name, text)});
  }

  void time(const char* what, Ticks found, Ticks expected) {
    // Each task adds its own rounding.
    if (std::llabs(found - expected) <= kTimeSlack) return;
    fault(fmt::format("{} is {}, by its tasks {}", what, clock_text(found), clock_text(expected)));
  }

  void number(const char* what, double found, double expected) {
    if (same_number(found, expected)) return;
    fault(fmt::format("{} is {}, expected {}", what, found, expected));
  }

 private:
  const UseRow& row_;
  Faults& faults_;
};

/// When the last task is over, machines on their way out of the way included.
Ticks last_end(const std::vector<TaskRun>& runs) {
  Ticks last = 0;
  for (const TaskRun& run : runs) {
    if (run.happened) last = std::max(last, run.end);
  }
  return last;
}

}  // namespace

void check_split(const TaskRun& run, const TaskAccount& account, const ScheduleRow& row,
                 ResultFile file, Faults& faults) {
  SplitCheck check(row, file, faults);
  const TimeSplit& split = row.split;
  const Ticks sum = split.motion + split.work + split.predecessor + split.resource + split.machine +
                    split.shift + split.repair;
  check.exactly("the sum of motion, work and waits", sum, run.happened ? run.end : 0);
  check.motion(split.motion, account);
  check.exactly("the crew work", split.work, account.work);
  check.at_least("the wait for predecessors", split.predecessor, account.held);
  check.at_least("the wait for robots and crews", split.resource, account.crew);
  check.at_least("the wait for machines", split.machine, account.machine);
  check.at_least("the time out of shift", split.shift, account.shift);
  check.exactly("the time under repair", split.repair, account.repair);
  check.exactly("the thinking of guides", split.thinking, account.thinking);
  if (row.foreseen && *row.foreseen != std::pair(account.foreseen, account.rounds)) {
    check.fault(
        fmt::format("its way met {} times what others are foreseen to sweep and went round "
                    "{} times, by the trace {} and {}",
                    row.foreseen->first, row.foreseen->second, account.foreseen, account.rounds));
  }
}

void check_uses(const Trace& trace, const std::vector<TaskRun>& runs,
                const std::vector<TaskAccount>& accounts, const WorkingHours& hours,
                const ScheduleJson& schedule, Faults& faults) {
  const Scene& scene = trace.scene;
  if (scene.short_form) return;
  const auto whole = [&](std::string text) {
    faults.push_back({FaultKind::schedule, ResultFile::schedule_json, 0, "", -1, std::move(text)});
  };
  const std::size_t robots = scene.robots.size();
  std::vector<Use> uses(robots + scene.crews.size());
  for (std::size_t run = 0; run < accounts.size(); ++run) {
    std::set<int> had;
    for (const HeldTime& held : accounts[run].holds) {
      Use& use = uses[at(held.resource)];
      auto work = static_cast<long double>(held.work);
      const int crew = held.resource - static_cast<int>(robots);
      if (const auto rounds = round_work(trace, runs[run], crew)) {
        work = std::min(*rounds / held.people, static_cast<long double>(held.held));
      }
      use.held += held.held * share_of(scene, held);
      use.work += work * share_of(scene, held);
      if (had.insert(held.resource).second) ++use.tasks;
    }
  }
  if (schedule.uses.size() != uses.size()) {
    whole(fmt::format("{} robots and crews, in the plan {}", schedule.uses.size(), uses.size()));
    return;
  }
  const Ticks end = last_end(runs);
  for (std::size_t i = 0; i < uses.size(); ++i) {
    const int resource = static_cast<int>(i);
    const UseRow& row = schedule.uses[i];
    UseCheck check(row, faults);
    if (row.name != resource_name(scene, resource)) {
      check.fault(fmt::format("expected {} here", resource_name(scene, resource)));
      continue;
    }
    auto busy = static_cast<Ticks>(uses[i].work);
    if (i < robots) {
      for (const ScheduleRow& task : schedule.rows) {
        if (task.robot == row.name) busy += task.split.motion;
      }
    }
    const Ticks shifts = hours.between(calendar_of_resource(scene, resource), 0, end);
    const int people = i < robots ? 0 : scene.crews[i - robots].size;  // a robot has none
    check.number("the size", row.size.value_or(0), people);
    check.number("the number of tasks", row.tasks, uses[i].tasks);
    check.time("the time held", row.held, static_cast<Ticks>(uses[i].held));
    check.time("the time busy", row.busy, busy);
    check.time("the time of its shifts", row.shifts, shifts);
    check.number("the utilisation", row.utilisation,
                 shifts > 0 ? static_cast<double>(row.held) / static_cast<double>(row.shifts) : 0);
    const double rate = rate_of(scene, resource);
    if (schedule.cost || row.rate) check.number("the rate", row.rate.value_or(0), rate);
  }
}

}  // namespace rubicon::verify
