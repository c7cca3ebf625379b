#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "src/motion/math/pose.hpp"
#include "src/simulation/taskplan/activity.hpp"
#include "src/simulation/taskplan/hit_recorder.hpp"
#include "src/simulation/taskplan/phases.hpp"
#include "src/simulation/taskplan/schedule.hpp"

namespace rubicon::taskplan {

/// A task under way. A value: a run that goes back takes an earlier copy.
struct ActiveTask {
  /// What it comes to; a try that leads nowhere puts it back.
  struct Account {
    TaskOutcome outcome;
    std::vector<Ticks> over_time;  ///< motion out of shift of each robot and crew it holds
    std::vector<Ticks> outside;    ///< of `over_time` what is overtime
    std::vector<Ticks> worked;     ///< crew work of each of these
    std::vector<Ticks> off;      ///< in their shifts, while nothing goes on out of somebody's shift
    Ticks repair = 0;            ///< of its robot, in the shifts of that
    Ticks part_since = 0;        ///< the last of its parts (TaskOutcome) began
    Ticks part_off = 0;          ///< of that, in its own hours, it waited for those of others
    std::uint64_t progress = 0;  ///< grows with every phase done and every new place
  };

  int task = -1;
  Account account;
  std::vector<Phase> phases;
  std::size_t phase = 0;
  Snapshot<Activity> activity;  ///< of the phase; null before the first and after the last
  Ticks held_since = 0;         ///< after the last: when it was done
  HitRecorder hits{nullptr};    ///< of its motions
  std::string ended_short;      ///< why the last leg ended short where it may; empty: it did not
  math::Pose X_WO = math::Pose::Identity();  ///< where the component stood that it set out to take

  const Phase& now() const { return phases[phase]; }
  bool is_held() const { return !activity && phase >= phases.size(); }
};

}  // namespace rubicon::taskplan
