#include "src/results/verify/schedule/accounts.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "src/motion/math/index.hpp"
#include "src/results/verify/schedule/check_lifts.hpp"

namespace rubicon::verify {

namespace {

using math::at;

class Bookkeeper {
 public:
  Bookkeeper(const Trace& trace, const WorkingHours& hours) : trace_(trace), hours_(hours) {}

  TaskAccount account(const std::vector<TaskRun>& runs, int index) {
    account_ = {};
    steps_.clear();
    works_.clear();
    repairs_.clear();
    nights_.clear();
    foreseen_ = -1;
    may_go_round_ = false;
    const TaskRun& run = runs[at(index)];
    run_robot_ = run.robot;
    if (!run.happened) return account_;
    lift_ = find_lift(trace_, run);
    whole_ = run.task >= 0 && trace_.scene.tasks[at(run.task)].whole;
    now_ = run.start;
    for (const int i : run.records) {
      record_ = &trace_.records[at(i)];
      std::visit([&](const auto& what) { add(what); }, record_->what);
      now_ = record_->time;
    }
    for (const Hold& hold : holds_of(trace_, runs, index)) add_hold(hold);
    return account_;
  }

 private:
  template <typename Other>
  void add(const Other&) {}

  void add(const Try& attempt) {
    may_go_round_ = false;
    if (!attempt.ok) return;
    account_.steps += record_->time - now_;
    steps_.emplace_back(now_, record_->time);
  }

  void add(const Wait&) {
    account_.script_waits += record_->time - now_;
    ++account_.script_wait_count;
    steps_.emplace_back(now_, record_->time);
  }

  void add(const Foreseen&) {
    if (record_->time != foreseen_) ++account_.foreseen;
    foreseen_ = record_->time;
    may_go_round_ = true;
  }

  void add(const WayPoint&) {
    if (std::exchange(may_go_round_, false)) ++account_.rounds;
  }

  void add(const Stop&) {
    account_.steps += record_->time - now_;
    steps_.emplace_back(now_, record_->time);
  }

  void add(const Think&) {
    account_.steps += record_->time - now_;
    account_.thinking += record_->time - now_;
    steps_.emplace_back(now_, record_->time);
  }

  void add(const Work& work) {
    account_.work += work.time;
    account_.shift += record_->time - work.from - work.time;
    const bool lifts = whole_ && work.what != "takes";
    const bool by_machine = work.what == "fill" || work.what == "dump" || work.what == "tip";
    works_.push_back({work.crew, work.from, record_->time, work.time, lifts, by_machine});
  }

  void add(const Pause& pause) {
    const Ticks time = record_->time - pause.from;
    if (pause.why == "machine") account_.machine += time;
    if (pause.why == "crew" || pause.why == "truck") account_.crew += time;
    if (pause.why == "shift" || pause.why == "lift") {
      account_.shift += time;
      nights_.emplace_back(pause.from, record_->time);
    }
    if (pause.why == "held") account_.held += time;
    if (pause.why == "repair") {
      account_.repair += time;
      repairs_.emplace_back(pause.from, record_->time);
    }
  }

  /// Whether a step is part of a lift that is held whole.
  bool is_lifted(Ticks from, Ticks to) const {
    return lift_ && from >= lift_->from && to <= lift_->to;
  }

  /// Its shifts in the time it is held; who holds for the whole task stays for steps after them.
  void add_hold(const Hold& hold) {
    const std::vector<int> calendar = calendar_of_resource(trace_.scene, hold.resource);
    HeldTime held;
    held.resource = hold.resource;
    held.held = hours_.between(calendar, hold.from, hold.to);
    held.people = hold.people;
    held.from = hold.from;
    held.to = hold.to;
    const int robots = static_cast<int>(trace_.scene.robots.size());
    if (hold.whole && !calendar.empty()) {
      for (const auto& [from, to] : steps_) {
        if (is_lifted(from, to)) continue;
        held.held += to - from - hours_.between(calendar, from, to);
      }
    }
    add_overtime(calendar, hold, held);
    if (hold.whole) {
      for (const auto& [from, to] : nights_) held.off += hours_.between(calendar, from, to);
      for (const DoneWork& work : works_) {
        const Ticks there = hours_.between(calendar, work.from, work.to);
        held.off += std::max<Ticks>(there - work.time, 0);
      }
    }
    if (hold.whole && hold.resource == run_robot_) {
      for (const auto& [from, to] : repairs_) held.off += hours_.between(calendar, from, to);
    }
    // As long as something hangs on the hook those who lift it are held, out of their shifts too.
    if (hold.whole && lift_) {
      held.held += lift_->to - lift_->from - hours_.between(calendar, lift_->from, lift_->to);
    }
    for (const DoneWork& work : works_) {
      if (work.lifts && !hold.whole && work.from == hold.from) {
        held.held += work.to - work.from - hours_.between(calendar, work.from, work.to);
      }
      const bool own = work.crew >= 0 && robots + work.crew == hold.resource;
      const bool shared = work.crew < 0 && (!work.by_machine || hold.resource < robots);
      const bool counts = hold.whole ? own || shared : own && work.from == hold.from;
      if (counts) held.work += work.time;
    }
    if (!hold.whole) held.off = std::max<Ticks>(held.held - held.work, 0);
    account_.holds.push_back(held);
  }

  /// What of it lies outside of the hours that its `overtime` names.
  void add_overtime(const std::vector<int>& calendar, const Hold& hold, HeldTime& held) const {
    const SceneCharges& charges = charges_of(trace_.scene, hold.resource);
    if (charges.overtime == 1) return;
    std::vector<int> normal = calendar;
    if (charges.normal >= 0) normal = {charges.normal};
    std::vector<int> both = calendar;
    both.insert(both.end(), normal.begin(), normal.end());
    held.overtime =
        hours_.between(calendar, hold.from, hold.to) - hours_.between(both, hold.from, hold.to);
    const auto add_beyond = [&](Ticks from, Ticks to) {
      held.overtime += to - from - hours_.between(calendar, from, to) -
                       hours_.between(normal, from, to) + hours_.between(both, from, to);
    };
    for (const DoneWork& work : works_) {
      if (work.lifts && !hold.whole && work.from == hold.from) add_beyond(work.from, work.to);
    }
    if (!hold.whole) return;
    if (lift_) add_beyond(lift_->from, lift_->to);
    for (const auto& [from, to] : steps_) {
      if (!is_lifted(from, to)) add_beyond(from, to);
    }
  }

  struct DoneWork {
    int crew = -1;
    Ticks from = 0;
    Ticks to = 0;
    Ticks time = 0;
    bool lifts = false;       ///< part of a lift that is held whole
    bool by_machine = false;  ///< it fills, dumps or tips: nobody else works
  };

  const Trace& trace_;
  const WorkingHours& hours_;
  TaskAccount account_;
  std::vector<std::pair<Ticks, Ticks>> steps_, repairs_, nights_;
  int run_robot_ = -1;
  std::vector<DoneWork> works_;
  const Record* record_ = nullptr;
  std::optional<Lift> lift_;
  bool whole_ = false;
  Ticks now_ = 0;
  Ticks foreseen_ = -1;        ///< when its way met what is foreseen last
  bool may_go_round_ = false;  ///< it has made no step since then
};

}  // namespace

std::vector<TaskAccount> task_accounts(const Trace& trace, const std::vector<TaskRun>& runs,
                                       const WorkingHours& hours) {
  Bookkeeper bookkeeper(trace, hours);
  std::vector<TaskAccount> accounts;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    accounts.push_back(bookkeeper.account(runs, static_cast<int>(i)));
  }
  return accounts;
}

long double share_of(const Scene& scene, const HeldTime& held) {
  return static_cast<long double>(held.people) / size_of_resource(scene, held.resource);
}

const SceneCharges& charges_of(const Scene& scene, int resource) {
  const int robots = static_cast<int>(scene.robots.size());
  return resource < robots ? scene.robots[at(resource)].charges
                           : scene.crews[at(resource - robots)].charges;
}

double cost_of(double rate, Ticks held) {
  return rate * static_cast<double>(held) / static_cast<double>(kSecond) / 3600;
}

double rate_of(const Scene& scene, int resource) {
  const int robots = static_cast<int>(scene.robots.size());
  return resource < robots ? scene.robots[at(resource)].cost_per_hour
                           : scene.crews[at(resource - robots)].cost_per_hour;
}

}  // namespace rubicon::verify
