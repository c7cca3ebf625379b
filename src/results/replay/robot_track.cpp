#include "src/results/replay/robot_track.hpp"

#include <algorithm>
#include <utility>

#include "src/results/replay/step_values.hpp"

namespace rubicon::replay {

namespace {

class TrackBuilder {
 public:
  TrackBuilder(const Machine& machine, bool carries)
      : machine_(machine), q_(start_values(machine)) {
    if (carries) hang({});
  }

  void follow(const TaskRun& run) {
    stand_until(run.start);
    now_ = run.start;
    for (const Event& event : run.events) {
      time_ = event.time;
      std::visit([&](const auto& what) { follow(what); }, event.what);
      now_ = time_;
    }
  }

  RobotTrack finish(Ticks until) {
    stand_until(until);
    return std::move(track_);
  }

 private:
  void hang(const Hanging& load) {
    hanging_ = static_cast<int>(track_.loads.size());
    track_.loads.push_back(load);
  }

  void stand_until(Ticks time) {
    if (time <= stands_since_) return;
    track_.legs.push_back({stands_since_, time, q_, {}, hanging_});
    stands_since_ = time;
  }

  /// Time goes by while it stands: its run is over.
  void follow(std::monostate) {
    if (time_ > now_) gone_.clear();
  }

  void follow(const Step& step) {
    stand_until(now_);
    ReachedStep reached =
        reached_values(machine_, {q_, step.q, step.moved, hanging_ >= 0, time_ - now_, gone_});
    add_to_run(reached.steps);
    track_.legs.push_back({now_, time_, q_, std::move(reached.values), hanging_});
    q_ = step.q;
    stands_since_ = std::max(stands_since_, time_);
  }

  /// Steps of the same parameters in the same directions make one run.
  void add_to_run(const std::vector<double>& steps) {
    bool goes_on = !gone_.empty();
    for (std::size_t i = 0; i < steps.size() && goes_on; ++i) {
      goes_on = steps[i] == 0 ? gone_[i] == 0 : gone_[i] * steps[i] > 0;
    }
    if (!goes_on) gone_.assign(steps.size(), 0.0);
    for (std::size_t i = 0; i < steps.size(); ++i) gone_[i] += steps[i];
  }

  void follow(const LoadChange& change) {
    if (change.kind == LoadChange::Kind::remove) return;
    stand_until(time_);
    if (change.kind == LoadChange::Kind::attach) {
      hang({change.component, change.X, 0});
    } else {
      hanging_ = -1;
    }
  }

  void follow(const LoadTurn& turn) {
    if (hanging_ < 0) return;
    stand_until(turn.from);
    const Hanging before = track_.loads[static_cast<std::size_t>(hanging_)];
    hang({before.component, before.X_TO, turn.angle_deg});
    stand_until(time_);
    hang({before.component, turn.X_TO, 0});
  }

  const Machine& machine_;
  RobotTrack track_;
  std::vector<double> q_;
  std::vector<double> gone_;  ///< of the run that goes on, by parameter
  int hanging_ = -1;
  Ticks now_ = 0;   ///< before the event
  Ticks time_ = 0;  ///< after it
  Ticks stands_since_ = 0;
};

}  // namespace

RobotTrack follow_robot(const Machine& machine, const std::vector<const TaskRun*>& runs,
                        bool carries, Ticks until) {
  TrackBuilder builder(machine, carries);
  std::vector<const TaskRun*> order = runs;
  std::stable_sort(order.begin(), order.end(),
                   [](const TaskRun* a, const TaskRun* b) { return a->start < b->start; });
  for (const TaskRun* run : order) builder.follow(*run);
  return builder.finish(until);
}

}  // namespace rubicon::replay
