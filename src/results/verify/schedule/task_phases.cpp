#include "src/results/verify/schedule/task_phases.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <utility>

#include "src/motion/math/index.hpp"

namespace rubicon::verify {

namespace {

using math::at;

/// What a task does, one after the other.
struct Phase {
  enum class Kind { motion, work, attach, detach, remove, dig, haul };
  Kind kind = Kind::motion;
  bool must_reach = false;  ///< of a motion
  SceneWork work;           ///< of a work
  int component = -1;       ///< of all that handle one
};

void add_move(const SceneTask& task, std::vector<Phase>& phases) {
  const auto work = [&](const std::optional<SceneWork>& planned) {
    // Work without time leaves no record.
    if (planned && planned->time > 0) phases.push_back({Phase::Kind::work, false, *planned, -1});
  };
  phases.push_back({Phase::Kind::motion, true, {}, -1});
  work(task.hook);
  phases.push_back({Phase::Kind::attach, false, {}, task.move});
  phases.push_back({Phase::Kind::motion, false, {}, -1});  // carrying may end short of the goal
  work(task.adjust);
  phases.push_back({Phase::Kind::motion, true, {}, -1});
  work(task.release);
  phases.push_back({Phase::Kind::detach, false, {}, task.move});
}

std::vector<Phase> planned_phases(const Trace& trace, const TaskRun& run) {
  std::vector<Phase> phases;
  if (run.task < 0) return {{Phase::Kind::motion, true, {}, -1}};
  const SceneTask& task = trace.scene.tasks[at(run.task)];
  if (task.move >= 0) add_move(task, phases);
  if (task.goes) phases.push_back({Phase::Kind::motion, !trace.scene.short_form, {}, -1});
  if (task.motion_dig) phases.push_back({Phase::Kind::dig, true, {}, task.motion_dig->soil});
  if (task.haul) phases.push_back({Phase::Kind::haul, true, {}, -1});
  for (const SceneWork& work : task.takes) {
    if (work.time > 0) phases.push_back({Phase::Kind::work, false, work, -1});
  }
  for (const int component : task.remove) {
    phases.push_back({Phase::Kind::remove, false, {}, component});
  }
  return phases;
}

std::string describe(const Phase& phase, const Scene& scene) {
  const auto component = [&] { return scene.components[at(phase.component)].name; };
  switch (phase.kind) {
    case Phase::Kind::motion:
      return "the end of a motion";
    case Phase::Kind::work:
      return fmt::format("the work '{}'", phase.work.what);
    case Phase::Kind::attach:
      return fmt::format("taking {}", component());
    case Phase::Kind::detach:
      return fmt::format("putting down {}", component());
    case Phase::Kind::dig:
      return fmt::format("digging {}", component());
    case Phase::Kind::haul:
      return "hauling";
    case Phase::Kind::remove:
      return fmt::format("removing {}", component());
  }
  return "";
}

class PhaseCheck {
 public:
  PhaseCheck(const Trace& trace, const TaskRun& run, Faults& faults)
      : trace_(trace), run_(run), faults_(faults), phases_(planned_phases(trace, run)) {}

  void check() {
    for (const int index : run_.records) {
      record_ = &trace_.records[at(index)];
      if (!std::visit([&](const auto& what) { return follow(what); }, record_->what)) return;
    }
  }

 private:
  void fault(std::string text) {
    faults_.push_back({FaultKind::order, ResultFile::trace, record_->line,
                       trace_.runs[at(run_.run)], record_->time, std::move(text)});
  }

  std::string expected() const {
    return next_ < phases_.size() ? describe(phases_[next_], trace_.scene) : "the end of the task";
  }

  /// The next phase, if it is of this kind; else what was expected instead is reported.
  const Phase* take(Phase::Kind kind, const std::string& found) {
    if (digs()) {
      if (!has_reached()) return nullptr;
      ++next_;
    }
    if (!leave_motions()) return nullptr;
    if (next_ < phases_.size() && phases_[next_].kind == kind) return &phases_[next_++];
    fault(fmt::format("expected {}, found {}", expected(), found));
    return nullptr;
  }

  bool follow(const TaskStart&) { return true; }

  bool follow(const Goal&) { return true; }
  bool follow(const GuidePlan&) { return in_motion("the plan of a guide"); }
  bool follow(const WayPoint&) { return in_motion("a waypoint"); }
  bool follow(const Pause&) { return true; }
  bool follow(const Try&) { return in_motion("an attempt"); }
  bool follow(const Wait&) { return in_motion("an attempt"); }
  bool follow(const Stop&) { return in_motion("a stop"); }
  bool follow(const Think&) { return in_motion("the thinking of a guide"); }
  bool follow(const Forbidden&) { return in_motion("what is forbidden"); }
  bool follow(const Foreseen&) { return in_motion("what is foreseen"); }
  bool follow(const ColdJoint&) { return true; }

  /// Or hauls: motions that the plan does not list.
  bool digs() const { return is_in(Phase::Kind::dig) || is_in(Phase::Kind::haul); }
  bool is_in(Phase::Kind kind) const {
    return next_ < phases_.size() && phases_[next_].kind == kind;
  }

  /// Whether the last motion of a dig has come to its goal.
  bool has_reached() {
    if (last_end_ == nullptr || last_end_->reached) return true;
    fault(fmt::format("the digging goes on and its motion ended with '{}'", last_end_->status));
    return false;
  }

  bool is_blocked() const {
    if (last_end_ == nullptr || last_end_->reached || last_end_->status != "done") return false;
    const auto hits = last_end_->refused_for.find("hit");
    return hits != last_end_->refused_for.end() && hits->second > 0;
  }

  bool follow(const SoilTaken& taken) {
    if (is_in(Phase::Kind::haul)) return has_reached();
    if (!digs() || phases_[next_].component != taken.component) {
      fault(fmt::format("expected {}, found a bucket of soil", expected()));
      return false;
    }
    return has_reached();
  }

  bool dig_work(const Work& work) {
    if (is_in(Phase::Kind::haul)) {
      const auto& tip = trace_.scene.tasks[at(run_.task)].haul->tip;
      if (work.what != "tip" || !tip || work.crew >= 0 ||
          std::llabs(tip->time - work.time) > kTimeSlack) {
        fault(fmt::format("the work '{}' is not one of the hauling, or not as long", work.what));
      }
      return has_reached();
    }
    const SceneMotionDig& dig = *trace_.scene.tasks[at(run_.task)].motion_dig;
    const auto& planned = work.what == "fill" ? dig.fill : dig.dump;
    const bool known = work.what == "fill" || work.what == "dump";
    if (!known || !planned || work.crew >= 0 ||
        std::llabs(planned->time - work.time) > kTimeSlack) {
      fault(fmt::format("the work '{}' is not one of the digging, or not as long", work.what));
    }
    // A cut that meets what stands ends there; the bucket keeps what it has.
    return (work.what == "fill" && is_blocked()) || has_reached();
  }

  bool in_motion(const char* found) {
    if (digs()) return true;
    if (next_ < phases_.size() && phases_[next_].kind == Phase::Kind::motion) return true;
    fault(fmt::format("expected {}, found {}", expected(), found));
    return false;
  }

  bool follow(const MotionEnd& end) {
    if (!in_motion("the end of a motion")) return false;
    turning_.reset();
    if (!digs()) ++ends_;
    last_end_ = &end;
    return true;
  }

  /// Motions that follow one another are over. One that waited for another machine was tried again,
  /// so there may be more ends than motions; the last one counts.
  bool leave_motions() {
    std::size_t planned = 0;
    bool must_reach = false;
    while (next_ < phases_.size() && phases_[next_].kind == Phase::Kind::motion) {
      ++planned;
      must_reach = phases_[next_++].must_reach;
    }
    const std::size_t found = std::exchange(ends_, 0);
    if (found < planned) {
      fault("a motion has no end");
      return false;
    }
    if (planned == 0 || trace_.scene.short_form) return true;
    if (last_end_->status != "done") {
      fault(fmt::format("the task goes on and its motion ended with '{}'", last_end_->status));
    } else if (must_reach && !last_end_->reached) {
      fault("the task goes on and its motion ended short");
    }
    return true;
  }

  bool follow(const Work& work) {
    if (digs()) return dig_work(work);
    const Phase* phase = take(Phase::Kind::work, fmt::format("the work '{}'", work.what));
    if (phase == nullptr) return false;
    if (phase->work.what != work.what) {
      fault(fmt::format("expected the work '{}', found '{}'", phase->work.what, work.what));
    }
    turning_ = {work.from, record_->time};
    if (phase->work.crew != work.crew) fault("the work is not done by the crew of the plan");
    const bool may_break = work.what == "takes" && run_.robot >= 0 &&
                           trace_.scene.robots[at(run_.robot)].breakdown && trace_.scene.sampled;
    done_ += work.time;
    if (may_break && done_ < phase->work.time - kTimeSlack) {
      --next_;  // it goes on when the machine is repaired
      return true;
    }
    if (std::llabs(phase->work.time - std::exchange(done_, 0)) > kTimeSlack) {
      fault("the work does not take as long as planned");
    }
    return true;
  }

  /// Part of the adjusting that turns, and as long.
  bool follow(const LoadTurn& turn) {
    const bool after_work = next_ > 0 && next_ <= phases_.size() && turning_;
    if (!after_work || !phases_[next_ - 1].work.turning || turned_ == next_) {
      fault("a load is turned where the plan turns none");
      return false;
    }
    turned_ = next_;
    if (turn.from != turning_->first || record_->time != turning_->second) {
      fault("the load is not turned while it is adjusted");
    }
    if (turn.component != trace_.scene.tasks[at(run_.task)].move) {
      fault("what is turned is not what the task moves");
    }
    return true;
  }

  bool follow(const LoadChange& change) {
    const Phase::Kind kind = change.kind == LoadChange::Kind::attach   ? Phase::Kind::attach
                             : change.kind == LoadChange::Kind::detach ? Phase::Kind::detach
                                                                       : Phase::Kind::remove;
    const Phase found{kind, false, {}, change.component};
    const Phase* phase = take(kind, describe(found, trace_.scene));
    if (phase == nullptr) return false;
    if (phase->component != change.component) {
      fault(fmt::format("expected {}, found {}", describe(*phase, trace_.scene),
                        describe(found, trace_.scene)));
    }
    return true;
  }

  bool follow(const TaskEnd& end) {
    if (end.result != TaskResult::done) return true;
    if (!leave_motions()) return false;
    if (is_in(Phase::Kind::haul)) {
      if (!has_reached()) return false;
      ++next_;
    }
    if (next_ < phases_.size()) {
      fault(fmt::format("expected {}, found the end of the task", expected()));
    }
    return true;
  }

  const Trace& trace_;
  const TaskRun& run_;
  Faults& faults_;
  const std::vector<Phase> phases_;
  std::size_t next_ = 0;
  std::size_t ends_ = 0;  ///< of the motions that are under way
  Ticks done_ = 0;        ///< of work that a breakdown interrupts
  const MotionEnd* last_end_ = nullptr;
  std::optional<std::pair<Ticks, Ticks>> turning_;  ///< from when to when the last work lasted
  std::size_t turned_ = 0;                          ///< the phase after that in which it was turned
  const Record* record_ = nullptr;
};

}  // namespace

void check_phases(const Trace& trace, const TaskRun& run, Faults& faults) {
  if (run.happened) PhaseCheck(trace, run, faults).check();
}

}  // namespace rubicon::verify
